#include "gui/session/low_priority.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace vallecula::gui {

void take_low_priority(int nice) {
  // Of this thread alone: Linux gives each its own.
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), nice);
}

}  // namespace vallecula::gui
