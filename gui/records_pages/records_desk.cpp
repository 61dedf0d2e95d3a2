#include "gui/records_pages/records_desk.h"

#include <exception>

#include "gui/session/trial_record.h"

namespace vallecula::gui {
namespace {

constexpr double kPatienceS = 3.0;  ///< somebody sits there and waits

}  // namespace

RecordsDesk::RecordsDesk(QObject* parent) : QObject(parent), there_(std::make_unique<QObject>()) {
  there_->moveToThread(&thread_);
  // A connection belongs to the thread that made it.
  connect(
      &thread_, &QThread::finished, there_.get(), [this] { records_.reset(); }, Qt::DirectConnection);
  thread_.start();
}

RecordsDesk::~RecordsDesk() {
  thread_.quit();
  thread_.wait();
}

void RecordsDesk::sign_in(const curricula::SignedIn& who, const curricula::Person& person) {
  who_ = who;
  person_ = person;
  emit changed();
}

void RecordsDesk::sign_out() {
  who_.reset();
  person_ = {};
  emit changed();
}

void RecordsDesk::renamed(const std::string& name) {
  person_.name = name;
  emit changed();
}

void RecordsDesk::ask_again() {
  if (const auto again = std::exchange(again_, {})) again();
}

void RecordsDesk::post(QObject* receiver, Question question, std::function<void(const QString&)> failed) {
  const QPointer<QObject> to(receiver);
  if (++open_questions_ == 1) emit waiting(true);
  const auto back = [this, to](std::function<void()> what) {
    QMetaObject::invokeMethod(
        this,
        [this, to, what] {
          if (--open_questions_ == 0) emit waiting(false);
          if (to) what();
        },
        Qt::QueuedConnection);
  };
  QMetaObject::invokeMethod(
      there_.get(),
      [this, to, question, failed, back] {
        try {
          if (!records_) {
            curricula::RecordsLocation location = records_location();
            location.patience_s = kPatienceS;
            records_ = std::make_unique<curricula::Records>(location);
          }
          const std::function<void()> done = question(*records_);
          back([this, done] {
            emit answered();
            done();
          });
        } catch (const std::exception& error) {
          const QString message = QString::fromUtf8(error.what());
          back([this, to, question, failed, message] {
            if (failed) {
              failed(message);
              return;
            }
            again_ = [this, to, question] {
              if (to) post(to, question, {});
            };
            emit trouble(message);
          });
        }
      },
      Qt::QueuedConnection);
}

}  // namespace vallecula::gui
