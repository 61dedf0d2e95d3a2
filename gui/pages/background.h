// Work that would block the window runs on a thread of its own and comes back as an event.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThread>
#include <exception>
#include <functional>
#include <memory>

namespace vallecula::gui {

/// Runs `work` on a new thread; then, on the window's thread and only if `receiver` still lives, `done` with what it
/// returned or `failed` with the message of what it threw.
template <class Result>
QThread* run_in_background(QObject* receiver, std::function<Result()> work, std::function<void(Result)> done,
                           std::function<void(const QString&)> failed) {
  struct Outcome {
    std::unique_ptr<Result> result;
    QString error;
  };
  auto outcome = std::make_shared<Outcome>();
  QThread* thread = QThread::create([work = std::move(work), outcome] {
    try {
      outcome->result = std::make_unique<Result>(work());
    } catch (const std::exception& error) {
      outcome->error = QString::fromUtf8(error.what());
    } catch (...) {
      outcome->error = "an unknown failure";
    }
  });
  QObject::connect(thread, &QThread::finished, receiver, [outcome, done = std::move(done), failed = std::move(failed)] {
    if (outcome->result)
      done(std::move(*outcome->result));
    else
      failed(outcome->error);
  });
  QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
  thread->start();
  return thread;
}

}  // namespace vallecula::gui
