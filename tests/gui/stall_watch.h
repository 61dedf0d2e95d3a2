// How long the window's event loop does not answer: asked by a thread of its own, again and again.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace vallecula::gui::window_test {

class StallWatch {
 public:
  StallWatch() : asker_([this] { ask(); }) {}
  ~StallWatch() {
    stop_ = true;
    while (!ended_) QCoreApplication::processEvents(QEventLoop::AllEvents, 5);  // the last question is answered
    asker_.join();
  }
  StallWatch(const StallWatch&) = delete;
  StallWatch& operator=(const StallWatch&) = delete;

  /// The longest time from a question to its answer since the last call, ms; one that waits now counts.
  double take_longest_ms() {
    const double waiting = asked_at_ == 0 ? 0.0 : 1e-6 * static_cast<double>(now() - asked_at_);
    return std::max(1e-6 * static_cast<double>(longest_.exchange(0)), waiting);
  }

 private:
  static long long now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }
  void ask() {
    while (!stop_) {
      std::atomic<bool> answered{false};
      asked_at_ = now();
      QMetaObject::invokeMethod(&there_, [&answered] { answered = true; }, Qt::QueuedConnection);
      while (!answered) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      longest_ = std::max<long long>(longest_, now() - asked_at_.exchange(0));
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ended_ = true;
  }

  QObject there_;  ///< lives in the window's thread
  std::atomic<bool> stop_{false}, ended_{false};
  std::atomic<long long> asked_at_{0}, longest_{0};
  std::thread asker_;
};

}  // namespace vallecula::gui::window_test
