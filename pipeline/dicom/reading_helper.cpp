#include "pipeline/dicom/reading_helper.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include "pipeline/dicom/ct_exchange.h"
#include "pipeline/helper_program.h"

namespace vallecula::pipeline {
namespace {

using ct_exchange::Control;

constexpr const char* kName = "vallecula-ct";

constexpr const char* kNoMemory = "no memory to hand to the reading program; close other programs";

class ControlView {
 public:
  explicit ControlView(const NamelessMemory& memory) {
    void* data = MAP_FAILED;
    if (::ftruncate(memory.descriptor(), sizeof(Control)) == 0)
      data = ::mmap(nullptr, sizeof(Control), PROT_READ | PROT_WRITE, MAP_SHARED, memory.descriptor(), 0);
    if (data == MAP_FAILED) throw HelperError("", kNoMemory);
    control_ = new (data) Control();
  }
  ~ControlView() { ::munmap(control_, sizeof(Control)); }
  ControlView(const ControlView&) = delete;
  ControlView& operator=(const ControlView&) = delete;
  const Control& operator*() const { return *control_; }
  /// The file at hand; the helper may have died while writing it.
  std::string file() const {
    const auto* end = std::find(control_->file, control_->file + sizeof control_->file, '\0');
    return {static_cast<const char*>(control_->file), end};
  }

 private:
  Control* control_;
};

/// The helper and the processes it starts: one group, ended together on every way out.
class HelperProcess {
 public:
  HelperProcess(const std::string& program, const std::array<int, 3>& descriptors, std::size_t memory_bytes) {
    char* const arguments[] = {const_cast<char*>(program.c_str()), nullptr};
    const rlimit cpu{kHelperCpuSeconds, kHelperCpuSeconds + 1};
    const rlimit memory{memory_bytes, memory_bytes};
    const rlimit no_core{0, 0};
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ < 0) throw HelperError("", "no new process can be started to read it; close other programs");
    if (pid_ > 0) {
      ::setpgid(pid_, pid_);  // also done by the child: whoever comes first
      return;
    }
    // Between fork and exec only calls that are safe in a program with threads.
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    ::setrlimit(RLIMIT_CPU, &cpu);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    ::setrlimit(RLIMIT_AS, &memory);  // sanitizers reserve terabytes of addresses
#else
    (void)memory;
#endif
    ::setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (int standard = 0; nowhere >= 0 && standard < 3; ++standard) ::dup2(nowhere, standard);
    ::dup2(descriptors[0], ct_exchange::kLetters);
    ::dup2(descriptors[1], ct_exchange::kControl);
    ::dup2(descriptors[2], ct_exchange::kVoxels);
    ::execv(program.c_str(), arguments);
    ::_exit(127);
  }
  ~HelperProcess() { end(); }
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  bool ended() {
    if (pid_ == 0) return true;
    const pid_t done = ::waitpid(pid_, &status_, WNOHANG);
    if (done != pid_) return false;
    ::kill(-pid_, SIGKILL);  // what it left behind
    pid_ = 0;
    return true;
  }
  void end() {
    if (pid_ == 0) return;
    ::kill(-pid_, SIGKILL);
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, &status_, 0);
    pid_ = 0;
  }
  int status() const { return status_; }

 private:
  pid_t pid_ = 0;
  int status_ = 0;
};

void wait_for(HelperProcess& helper, const ControlView& control, int stall_seconds,
              const std::function<void(double)>& progress) {
  using Clock = std::chrono::steady_clock;
  auto moved = Clock::now();
  std::uint32_t beat = 0;
  std::uint32_t told = 0;
  while (!helper.ended()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (const auto now = (*control).beat.load(); now != beat) {
      beat = now;
      moved = Clock::now();
    } else if (Clock::now() - moved > std::chrono::seconds(stall_seconds)) {
      throw HelperError(control.file(),
                        "reading did not get on for " + std::to_string(stall_seconds) +
                            " s and was stopped; copy the file again, from a faster place if it lies on a network");
    }
    if (const auto done = (*control).millionths.load(); progress && done != told) {
      told = done;
      progress(std::min(1.0, 1e-6 * done));
    }
  }
}

}  // namespace

NamelessMemory::NamelessMemory() {
  const int low = ::memfd_create(kName, MFD_CLOEXEC);
  // Above the numbers that the helper is given, so that handing over cannot overwrite one not yet handed over.
  descriptor_ = low < 0 ? -1 : ::fcntl(low, F_DUPFD_CLOEXEC, 16);
  if (low >= 0) ::close(low);
  if (descriptor_ < 0) throw HelperError("", kNoMemory);
}

NamelessMemory::~NamelessMemory() { ::close(descriptor_); }

std::size_t NamelessMemory::bytes() const {
  struct stat facts {};
  return ::fstat(descriptor_, &facts) == 0 ? static_cast<std::size_t>(facts.st_size) : 0;
}

Handed run_reading_helper(const std::string& request, const NamelessMemory& voxels,
                          const std::function<void(double)>& progress, const HelperLimits& limits) {
  const auto program = find_helper_program(kName);
  if (!program) {
    throw HelperError("",
                      "the helper program vallecula-ct is not beside vallecula; build or install it, or set "
                      "VALLECULA_HELPERS to its folder");
  }
  const NamelessMemory letters;
  const NamelessMemory control_memory;
  const ControlView control(control_memory);
  if (!ct_exchange::write_all(letters.descriptor(), request)) throw HelperError("", kNoMemory);
  HelperProcess helper(program->string(), {letters.descriptor(), control_memory.descriptor(), voxels.descriptor()},
                       limits.memory_bytes);
  wait_for(helper, control, limits.stall_seconds, progress);
  const int status = helper.status();
  if (WIFSIGNALED(status)) {
    throw HelperError(control.file(),
                      std::string(WTERMSIG(status) == SIGXCPU ? "reading took more than its time and was stopped"
                                                              : "the DICOM library does not survive this file") +
                          "; it is damaged: copy it again or leave it out");
  }
  if (WEXITSTATUS(status) == 127)
    throw HelperError("", "the helper program vallecula-ct cannot be started; install the program again");
  if (WEXITSTATUS(status) != 0) throw HelperError(control.file(), kHelperFailed);
  return {ct_exchange::read_all(letters.descriptor()), control.file()};
}

}  // namespace vallecula::pipeline
