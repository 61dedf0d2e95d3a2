// How long the window's event loop does not answer: asked by a thread of its own, again and again.
#pragma once

#include <pthread.h>
#include <time.h>

#include <QCoreApplication>
#include <QObject>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace vallecula::gui::window_test {

class StallWatch {
 public:
  StallWatch() {
    pthread_getcpuclockid(pthread_self(), &worked_);
    asker_ = std::thread([this] { ask(); });
  }
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
  /// Likewise the most that the window's thread itself worked between a question and its answer, ms: on a crowded
  /// machine the rest of the time it stood in line for a processor.
  double take_most_work_ms() { return 1e-6 * static_cast<double>(most_work_.exchange(0)); }

 private:
  static long long now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }
  long long work() const {
    timespec time{};
    clock_gettime(worked_, &time);
    return 1'000'000'000LL * time.tv_sec + time.tv_nsec;
  }
  void ask() {
    while (!stop_) {
      std::atomic<bool> answered{false};
      asked_at_ = now();
      const long long work_before = work();
      QMetaObject::invokeMethod(&there_, [&answered] { answered = true; }, Qt::QueuedConnection);
      while (!answered) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      most_work_ = std::max<long long>(most_work_, work() - work_before);
      longest_ = std::max<long long>(longest_, now() - asked_at_.exchange(0));
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ended_ = true;
  }

  QObject there_;  ///< lives in the window's thread
  std::atomic<bool> stop_{false}, ended_{false};
  std::atomic<long long> asked_at_{0}, longest_{0}, most_work_{0};
  clockid_t worked_{};  ///< the window thread's own time
  std::thread asker_;
};

}  // namespace vallecula::gui::window_test
