#include "gui/views/drawing_threads.h"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QThread>
#include <algorithm>
#include <thread>

namespace vallecula::gui {
namespace {

constexpr int kMost = 4;   // more gain little for a view of half a million pixels
constexpr int kNice = 10;  // a tenth of the weight of a thread that is left alone: late ticks stay as without drawing
const char* const kCount = "LP_NUM_THREADS";

/// Whether threads of this process may have real-time priority (engine/haptics/runner asks for it): tried, by one that
/// does nothing else.
bool haptics_go_first() {
  bool granted = false;
  std::thread([&granted] {
    sched_param least{};
    least.sched_priority = sched_get_priority_min(SCHED_FIFO);
    granted = pthread_setschedparam(pthread_self(), SCHED_FIFO, &least) == 0;
  }).join();
  return granted;
}

}  // namespace

void limit_drawing_threads() {
  if (qEnvironmentVariableIsSet(kCount)) return;
  qputenv(kCount, QByteArray::number(std::clamp(QThread::idealThreadCount() / 2, 1, kMost)));
}

void put_drawing_threads_behind() {
  if (haptics_go_first()) return;
  const QDir threads("/proc/self/task");
  for (const QString& id : threads.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    QFile name(threads.filePath(id + "/comm"));
    if (name.open(QIODevice::ReadOnly) && name.readAll().startsWith("llvmpipe"))
      setpriority(PRIO_PROCESS, static_cast<id_t>(id.toUInt()), kNice);
  }
}

}  // namespace vallecula::gui
