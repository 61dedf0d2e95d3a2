// Who sits at the window, and its way to the records: on a thread of its own, so that no database makes it wait.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThread>
#include <functional>
#include <memory>

#include "curricula/records/people.h"

namespace vallecula::gui {

class RecordsDesk : public QObject {
  Q_OBJECT
 public:
  explicit RecordsDesk(QObject* parent = nullptr);
  ~RecordsDesk() override;  ///< waits for the question under way, patience_s of the records at most

  /// Empty, and a person of number 0: nobody is signed in, and trials belong to nobody.
  const curricula::Who& who() const { return who_; }
  const curricula::Person& person() const { return person_; }
  bool instructor() const { return who_ && person_.role == curricula::Role::instructor; }
  void sign_in(const curricula::SignedIn& who, const curricula::Person& person);
  void sign_out();
  void renamed(const std::string& name);  ///< whoever is signed in

  /// Asks `question` of the records (connection made at the first question and kept); questions are answered in order.
  /// Then, in the window's thread and only if `receiver` still lives, `done` with the answer, or `failed` with the one
  /// message. Without `failed` the trouble is told by trouble() and can be asked again.
  template <class Answer>
  void ask(QObject* receiver, std::function<Answer(curricula::Records&)> question, std::function<void(Answer)> done,
           std::function<void(const QString&)> failed = {}) {
    post(
        receiver,
        [question, done](curricula::Records& records) -> std::function<void()> {
          auto answer = std::make_shared<Answer>(question(records));
          return [answer, done] { done(std::move(*answer)); };
        },
        std::move(failed));
  }
  void ask_again();  ///< what was in trouble last

 signals:
  void changed();  ///< somebody signed in or out
  void trouble(const QString& message);
  void answered();
  void waiting(bool for_an_answer);

 private:
  using Question = std::function<std::function<void()>(curricula::Records&)>;
  void post(QObject* receiver, Question question, std::function<void(const QString&)> failed);

  curricula::Who who_;
  curricula::Person person_;
  QThread thread_;
  std::unique_ptr<QObject> there_;               ///< lives in the thread: what is posted to it runs there
  std::unique_ptr<curricula::Records> records_;  ///< the thread's
  std::function<void()> again_;
  int open_questions_ = 0;
};

}  // namespace vallecula::gui
