// A trial's log, read when it is first asked for and shared by all who draw of it.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>

#include "curricula/trial_log.h"

namespace vallecula::gui {

/// Any thread.
class LogOnDemand {
 public:
  explicit LogOnDemand(std::filesystem::path file) : file_(std::move(file)) {}
  /// Throws as curricula::read_trial_log.
  std::shared_ptr<const curricula::TrialLog> get() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!log_) log_ = std::make_shared<const curricula::TrialLog>(curricula::read_trial_log(file_));
    return log_;
  }
  /// Whoever has it keeps it; the next one reads it anew. Returns at once while it is being read.
  void forget() {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (lock.owns_lock()) log_.reset();
  }

 private:
  const std::filesystem::path file_;
  std::mutex mutex_;
  std::shared_ptr<const curricula::TrialLog> log_;
};

}  // namespace vallecula::gui
