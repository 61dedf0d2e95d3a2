// What is asked, what sounds and what is said beside the hands: questions with their answers, alarms to silence, talk,
// and what an instructor has the team say.
#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>
#include <vector>

#include "gui/pages/key_list.h"
#include "gui/session/dual_task.h"

class QKeyEvent;
class QLabel;
class QProgressBar;
class QVBoxLayout;

namespace vallecula::gui {

class DistractionPanel : public QFrame {
  Q_OBJECT
 public:
  explicit DistractionPanel(QWidget* parent = nullptr);
  /// Whose distractions are shown from now on; null: nobody's.
  /// `by_person`: false where a script answers, or nobody does.
  void serve(DualTask* task, bool by_person);
  /// True when the key is one of these: 1 to 6 answer the question that is open longest, M silences the alarm that is.
  bool key(QKeyEvent* event, bool pressed);
  /// To be called for every frame.
  void refresh();
  /// An instructor's sentence, for kSaidMs, below whatever waits for an answer; the next one takes its place.
  /// Read, it stays paler as said before, where nothing waits.
  void say(const QString& line);
  static constexpr int kSaidMs = 8000;
  void set_said_for(int ms) { said_for_.setInterval(ms); }  ///< kSaidMs unless set
  std::vector<KeyRow> keys() const;
  /// As high as all of it is, as wide as it is now.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 signals:
  void silent();  ///< the instructor's sentence has been read

 private:
  struct Row {
    int distraction = 0;
    QWidget* widget = nullptr;
    QProgressBar* left = nullptr;  ///< null: of talk
  };
  Row make_row(const DualTask::Open& open, bool has_keys);
  /// The longest open of this kind; 0: none.
  int first_of(curricula::Distraction::Kind kind) const;

  DualTask* task_ = nullptr;
  bool by_person_ = false;
  std::vector<Row> rows_;
  QLabel *idle_, *said_;
  QString line_, asked_;  ///< the last that was said; what stands here before anything is
  QTimer said_for_;
  QVBoxLayout* column_;
  QElapsedTimer since_beep_;
};

}  // namespace vallecula::gui
