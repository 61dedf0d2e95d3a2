#include "pipeline/dicom/ct_helper.h"

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
#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/series_error.h"
#include "pipeline/helper_program.h"

namespace vallecula::pipeline {
namespace {

using ct_exchange::Control;

constexpr const char* kName = "vallecula-ct";

/// Memory without a name that can be handed to another process.
class Memory {
 public:
  Memory() {
    const int low = ::memfd_create(kName, MFD_CLOEXEC);
    // Above the numbers that the helper is given, so that handing over cannot overwrite one not yet handed over.
    descriptor_ = low < 0 ? -1 : ::fcntl(low, F_DUPFD_CLOEXEC, 16);
    if (low >= 0) ::close(low);
    if (descriptor_ < 0) throw SeriesError("series: no memory to hand to the reading program; close other programs");
  }
  ~Memory() { ::close(descriptor_); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

class ControlView {
 public:
  explicit ControlView(const Memory& memory) {
    void* data = MAP_FAILED;
    if (::ftruncate(memory.descriptor(), sizeof(Control)) == 0)
      data = ::mmap(nullptr, sizeof(Control), PROT_READ | PROT_WRITE, MAP_SHARED, memory.descriptor(), 0);
    if (data == MAP_FAILED) throw SeriesError("series: no memory to hand to the reading program; close other programs");
    control_ = new (data) Control();
  }
  ~ControlView() { ::munmap(control_, sizeof(Control)); }
  ControlView(const ControlView&) = delete;
  ControlView& operator=(const ControlView&) = delete;
  const Control& operator*() const { return *control_; }
  /// The file at hand; the helper may have died while writing it.
  std::string file() const {
    const auto* end = std::find(control_->file, control_->file + sizeof control_->file, '\0');
    const std::string name(static_cast<const char*>(control_->file), end);
    return name.empty() ? "series" : name;
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
    if (pid_ < 0) throw SeriesError("series: no new process can be started to read it; close other programs");
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
      throw SeriesError(control.file() + ": reading did not get on for " + std::to_string(stall_seconds) +
                        " s and was stopped; copy the file again, from a faster place if it lies on a network");
    }
    if (const auto done = (*control).millionths.load(); progress && done != told) {
      told = done;
      progress(std::min(1.0, 1e-6 * done));
    }
  }
}

std::shared_ptr<const std::int16_t> view_of(const Memory& memory, std::size_t count) {
  const std::size_t bytes = count * sizeof(std::int16_t);
  struct stat facts {};
  if (::fstat(memory.descriptor(), &facts) != 0 || static_cast<std::size_t>(facts.st_size) != bytes)
    throw std::runtime_error("damaged");
  void* data = ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, memory.descriptor(), 0);
  if (data == MAP_FAILED) throw std::bad_alloc();
  return {static_cast<const std::int16_t*>(data),
          [bytes](const std::int16_t* p) { ::munmap(const_cast<std::int16_t*>(p), bytes); }};
}

}  // namespace

HelperResult run_ct_helper(const ReadRequest& request, const std::function<void(double)>& progress,
                           const HelperLimits& limits) {
  const auto program = find_helper_program(kName);
  if (!program) {
    throw SeriesError(
        "series: the helper program vallecula-ct is not beside vallecula; build or install it, or set "
        "VALLECULA_HELPERS to its folder");
  }
  const Memory letters;
  const Memory control_memory;
  const Memory voxels;
  const ControlView control(control_memory);
  if (!ct_exchange::write_all(letters.descriptor(), ct_exchange::packed(request)))
    throw SeriesError("series: no memory to hand to the reading program; close other programs");
  HelperProcess helper(program->string(), {letters.descriptor(), control_memory.descriptor(), voxels.descriptor()},
                       limits.memory_bytes);
  wait_for(helper, control, limits.stall_seconds, progress);
  const int status = helper.status();
  if (WIFSIGNALED(status)) {
    throw SeriesError(control.file() + ": " +
                      (WTERMSIG(status) == SIGXCPU ? "reading took more than its time and was stopped"
                                                   : "the DICOM library does not survive this file") +
                      "; it is damaged: copy it again or take it out of the folder");
  }
  if (WEXITSTATUS(status) == 127)
    throw SeriesError("series: the helper program vallecula-ct cannot be started; install the program again");
  HelperResult result;
  try {
    if (WEXITSTATUS(status) != 0) throw std::runtime_error("failed");
    result.answer = ct_exchange::unpacked_answer(ct_exchange::read_all(letters.descriptor()));
    if (!request.list) result.voxels = view_of(voxels, result.answer.geometry.count());
  } catch (const SeriesError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::runtime_error&) {
    throw SeriesError(control.file() + ": the reading program failed at it; copy the file again");
  }
  return result;
}

}  // namespace vallecula::pipeline
