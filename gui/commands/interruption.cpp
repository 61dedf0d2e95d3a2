#include "gui/commands/interruption.h"

#include <atomic>
#include <csignal>
#include <stdexcept>

namespace vallecula::gui {
namespace {

std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

void raise_flag(int signal) {
  flag = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_for_interruption() {
  for (const int signal : {SIGINT, SIGTERM}) {
    // A program started in the background with SIGINT ignored (nohup, a shell's &) stays deaf to it.
    if (std::signal(signal, raise_flag) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

bool interrupted() noexcept { return flag; }

void stop_when_interrupted(const std::string& work) {
  if (flag) throw std::runtime_error(work + " was interrupted; nothing was written");
}

}  // namespace vallecula::gui
