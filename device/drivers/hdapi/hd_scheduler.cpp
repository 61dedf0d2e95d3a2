#include "device/drivers/hdapi/hd_scheduler.h"

#include <locale.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "device/drivers/hdapi/hd_library.h"
#include "device/drivers/hdapi/hd_properties.h"

namespace vallecula::device::hdapi {
namespace {

constexpr std::chrono::milliseconds kLookAfter{500};
constexpr std::chrono::seconds kOpenPatience{15};
constexpr std::chrono::milliseconds kLastTurnPatience{100};  // of a loop that turns each millisecond

std::mutex shared_mutex;
std::weak_ptr<Scheduler> shared_scheduler;
std::shared_future<void> last_gone;  ///< of the newest scheduler: its tending thread has ended

double clock_s() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

HdError no_answer() {
  return {"the device's library does not answer",
          "Unplug the device, wait five seconds, plug it in again, and start the program anew"};
}

/// Numbers with a decimal point on this thread.
class PointLocale {
 public:
  PointLocale() : locale_(newlocale(LC_NUMERIC_MASK, "C", duplocale(LC_GLOBAL_LOCALE))) {
    if (locale_ != nullptr) uselocale(locale_);
  }
  ~PointLocale() {
    if (locale_ == nullptr) return;
    uselocale(LC_GLOBAL_LOCALE);
    freelocale(locale_);
  }
  PointLocale(const PointLocale&) = delete;
  PointLocale& operator=(const PointLocale&) = delete;

 private:
  locale_t locale_;
};

}  // namespace

/// Lives as long as the tending thread or the scheduler, whichever is longer: a library that hangs may still call back.
struct Scheduler::Core {
  explicit Core(const Functions& functions) : hd(functions) {}

  const Functions hd;
  // The tending thread's; the loop reads `channels`, which change only while it stands.
  struct Member {
    std::shared_ptr<Channel> channel;
    std::string name;
    DeviceInfo info;
    int looks_lost = 0;
  };
  std::vector<Member> members;
  unsigned long callback = 0;
  bool turning = false, scheduled = false;
  // Between threads.
  std::atomic<bool> halting{false}, halted{false};  ///< every device is to show no force; they do
  mutable std::mutex mutex;
  std::condition_variable wake;
  std::deque<std::function<void()>> requests;
  bool leave = false;
  std::vector<Opened> list;  ///< of `members`
  std::promise<void> left;
  std::shared_future<void> gone = left.get_future();

  static unsigned int turn(void* data) noexcept;
  void route_errors(Channel& from) noexcept;
  void start();
  void stop() noexcept;
  void update_list();
  void join(const std::shared_ptr<Channel>& channel, const std::string& name);
  void part(const std::shared_ptr<Channel>& channel) noexcept;
  void look_after() noexcept;
  void tend() noexcept;
  std::future<void> ask(std::function<void()> work);
};

unsigned int Scheduler::Core::turn(void* data) noexcept {
  Core& core = *static_cast<Core*>(data);
  const double now_s = clock_s();
  const bool halting = core.halting.load(std::memory_order_relaxed);
  for (const Member& member : core.members) {
    Channel& channel = *member.channel;
    if (channel.handle() == kNoDevice) continue;
    channel.begin(core.hd, now_s);
    core.route_errors(channel);
    channel.exchange(core.hd, !halting);
    core.route_errors(channel);
    channel.settle(core.hd);
  }
  if (halting) core.halted.store(true, std::memory_order_relaxed);
  return kGoOn;
}

/// An error names its device; one of no known device is taken as the one's that was spoken to.
void Scheduler::Core::route_errors(Channel& from) noexcept {
  for (int i = 0; i < kMostErrors; ++i) {
    const ErrorInfo error = hd.get_error();
    if (error.code == kSuccess) return;
    Channel* of = &from;
    for (const Member& member : members) {
      if (member.channel->handle() == error.device && error.device != kNoDevice) of = member.channel.get();
    }
    of->note(fault_of(error.code));
  }
}

void Scheduler::Core::start() {
  const bool any = std::any_of(members.begin(), members.end(),
                               [](const Member& member) { return member.channel->handle() != kNoDevice; });
  if (!any || turning) return;
  take_errors(hd);
  if (!scheduled) {
    callback = hd.schedule(&Core::turn, this, kUsualPriority);
    scheduled = true;
  }
  hd.start_scheduler();
  turning = true;
}

/// A device keeps its last force while the loop stands: so one turn without force first, unless the loop hangs.
void Scheduler::Core::stop() noexcept {
  if (!turning) return;
  halting = true;
  const auto until = std::chrono::steady_clock::now() + kLastTurnPatience;
  while (!halted && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  hd.stop_scheduler();
  halting = halted = false;
  turning = false;
}

void Scheduler::Core::update_list() {
  std::vector<Opened> now;
  for (const Member& member : members) now.push_back({member.channel, member.name, member.info});
  const std::lock_guard<std::mutex> lock(mutex);
  list = std::move(now);
}

void Scheduler::Core::join(const std::shared_ptr<Channel>& channel, const std::string& name) {
  stop();
  take_errors(hd);
  try {
    const Properties properties = open_device(hd, name, *channel);
    members.push_back({channel, name, properties.info, 0});
  } catch (...) {
    start();
    throw;
  }
  start();
  if (const ErrorInfo error = take_errors(hd); error.code == kTimerError || error.code == kInvalidLicense) {
    part(channel);
    throw HdError("the library's loop does not start (" + name_of(error.code) + ")", mend_of(error.code));
  }
  update_list();
}

void Scheduler::Core::part(const std::shared_ptr<Channel>& channel) noexcept {
  stop();
  if (channel->handle() != kNoDevice) {
    hd.make_current(channel->handle());
    hd.disable(kForceOutput);
    hd.disable_device(channel->handle());
    channel->detach();
  }
  members.erase(std::remove_if(members.begin(), members.end(), [&](const Member& m) { return m.channel == channel; }),
                members.end());
  update_list();
  start();
}

/// Reopens what is lost at two looks running; lets go of what nobody owns any more.
void Scheduler::Core::look_after() noexcept {
  for (std::size_t i = 0; i < members.size(); ++i) {
    Member& member = members[i];
    if (member.channel->silent()) {  // its owner gave up waiting
      part(std::shared_ptr<Channel>(member.channel));
      return;
    }
    member.looks_lost = member.channel->lost() ? member.looks_lost + 1 : 0;
    if (member.looks_lost < 2) continue;
    stop();
    if (member.channel->handle() != kNoDevice) hd.disable_device(member.channel->handle());
    member.channel->detach();
    take_errors(hd);
    try {
      open_device(hd, member.name, *member.channel);
      member.looks_lost = 0;
    } catch (const HdError&) {  // not back yet: the channel says so
    }
    start();
  }
}

void Scheduler::Core::tend() noexcept {
  {
    const PointLocale point;
    std::unique_lock<std::mutex> lock(mutex);
    while (!leave) {
      if (requests.empty() && !wake.wait_for(lock, kLookAfter, [&] { return leave || !requests.empty(); })) {
        lock.unlock();
        look_after();
        lock.lock();
        continue;
      }
      if (requests.empty()) continue;
      const auto request = std::move(requests.front());
      requests.pop_front();
      lock.unlock();
      request();
      lock.lock();
    }
    lock.unlock();
    while (!members.empty()) part(std::shared_ptr<Channel>(members.front().channel));
    if (scheduled) hd.unschedule(callback);
  }
  left.set_value();
}

std::future<void> Scheduler::Core::ask(std::function<void()> work) {
  const auto task = std::make_shared<std::packaged_task<void()>>(std::move(work));
  std::future<void> done = task->get_future();
  {
    const std::lock_guard<std::mutex> lock(mutex);
    requests.emplace_back([task] { (*task)(); });
  }
  wake.notify_one();
  return done;
}

Scheduler::Scheduler(const Functions& hd) : core_(std::make_shared<Core>(hd)) {
  std::thread([core = core_] { core->tend(); }).detach();
}

Scheduler::~Scheduler() {
  {
    const std::lock_guard<std::mutex> lock(core_->mutex);
    core_->leave = true;
  }
  core_->wake.notify_one();
  core_->gone.wait_for(kPatience);
}

std::shared_ptr<Scheduler> Scheduler::shared() {
  const std::lock_guard<std::mutex> lock(shared_mutex);
  if (auto running = shared_scheduler.lock()) return running;
  // One that nobody owns any more may still turn: two loops would drive the same devices.
  if (last_gone.valid() && last_gone.wait_for(kPatience) != std::future_status::ready) throw no_answer();
  const std::shared_ptr<Scheduler> made(new Scheduler(load_library(library_paths())));
  shared_scheduler = made;
  last_gone = made->core_->gone;
  return made;
}

std::shared_ptr<Scheduler> Scheduler::running() {
  const std::lock_guard<std::mutex> lock(shared_mutex);
  return shared_scheduler.lock();
}

Scheduler::Opened Scheduler::open(const std::string& name) {
  auto channel = std::make_shared<Channel>();
  std::future<void> done = core_->ask([core = core_.get(), channel, name] { core->join(channel, name); });
  if (done.wait_for(kOpenPatience) != std::future_status::ready) {
    channel->silence();
    throw no_answer();
  }
  done.get();
  for (const Opened& open : opened()) {
    if (open.channel == channel) return open;
  }
  throw HdError("the device was closed while it was being opened", "Try again");
}

void Scheduler::close(const std::shared_ptr<Channel>& channel) noexcept {
  channel->silence();
  try {
    core_->ask([core = core_.get(), channel] { core->part(channel); }).wait_for(kPatience);
  } catch (const std::exception&) {  // no memory for the request: the tending thread sees that it is silent
  }
}

std::vector<Scheduler::Opened> Scheduler::opened() const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  return core_->list;
}

}  // namespace vallecula::device::hdapi
