#include "pipeline/dicom/decode.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <thread>

#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {
namespace {

constexpr int kMostWorkers = 8;

/// What the workers share besides the voxels.
struct Board {
  std::atomic<int> next;
  std::atomic<int> done;
  std::atomic<int> doubles;
  std::atomic<std::size_t> clamped;
  std::array<std::atomic<int>, kMostWorkers> file;  ///< being read
  std::array<std::array<char, 1024>, kMostWorkers> error;
};

void decode_place(PictureReader& reader, const FileList& files, const SeriesGroup& group, std::size_t place,
                  std::int16_t* hu, Board& board, int worker) {
  const auto& here = group.plan.places[place];
  const auto& first = group.pictures[here.front()];
  board.file[worker] = first.file;
  board.clamped += reader.read(first, hu);
  std::vector<std::int16_t> other(here.size() > 1 ? static_cast<std::size_t>(first.columns) * first.rows : 0);
  for (std::size_t i = 1; i < here.size(); ++i) {
    const auto& twin = group.pictures[here[i]];
    board.file[worker] = twin.file;
    reader.read(twin, other.data());
    if (!std::equal(other.begin(), other.end(), hu)) {
      throw SeriesError(files.name(first.file) + " and " + files.name(twin.file) +
                        ": lie at the same position with different pictures; keep those of one scan");
    }
    ++board.doubles;
  }
}

[[noreturn]] void work(const FileList& files, const SeriesGroup& group, const std::vector<int>& places, Padding padding,
                       std::int16_t* hu, Board& board, int worker) {
  std::string error;
  try {
    PictureReader reader(files, padding);
    const auto& size = group.plan.geometry.size;
    const std::size_t slice = static_cast<std::size_t>(size[0]) * size[1];
    const int count = static_cast<int>(places.size());
    for (int i = board.next++; i < count; i = board.next++) {
      decode_place(reader, files, group, static_cast<std::size_t>(places[i]), hu + slice * i, board, worker);
      ++board.done;
    }
    ::_exit(0);
  } catch (const std::bad_alloc&) {
    error = files.name(board.file[worker]) + ": asks for more memory than a CT needs; is it damaged?";
  } catch (const std::exception& e) {
    error = e.what();
  }
  std::strncpy(board.error[worker].data(), error.c_str(), board.error[worker].size() - 1);
  ::_exit(1);
}

class Workers {
 public:
  ~Workers() {
    for (const pid_t pid : pids_) {
      if (pid > 0) {
        ::kill(pid, SIGKILL);
        ::waitpid(pid, nullptr, 0);
      }
    }
  }
  void add(pid_t pid) { pids_.push_back(pid); }
  bool all_done() const {
    return std::all_of(pids_.begin(), pids_.end(), [](pid_t pid) { return pid == 0; });
  }
  /// Calls `ended(number, status)` for each that has ended since.
  template <class Ended>
  void look(const Ended& ended) {
    for (std::size_t i = 0; i < pids_.size(); ++i) {
      int status = 0;
      if (pids_[i] <= 0 || ::waitpid(pids_[i], &status, WNOHANG) != pids_[i]) continue;
      pids_[i] = 0;
      ended(static_cast<int>(i), status);
    }
  }

 private:
  std::vector<pid_t> pids_;
};

}  // namespace

SharedMemory::SharedMemory(std::size_t bytes)
    : data_(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)), bytes_(bytes) {
  if (data_ == MAP_FAILED) throw std::bad_alloc();
}
SharedMemory::~SharedMemory() { ::munmap(data_, bytes_); }

Decoded decode(const FileList& files, const SeriesGroup& group, const std::vector<int>& places, Padding padding,
               std::int16_t* hu, const std::function<void(double)>& alive) {
  const SharedMemory memory(sizeof(Board));
  auto& board = *new (memory.data()) Board();
  const int wanted = static_cast<int>(std::clamp<std::size_t>(
      std::min<std::size_t>(std::thread::hardware_concurrency(), places.size()), 1, kMostWorkers));
  Workers workers;
  for (int w = 0; w < wanted; ++w) {
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent) ::_exit(1);
      work(files, group, places, padding, hu, board, w);
    }
    if (pid < 0) throw SeriesError("series: no new process can be started to read it; close other programs");
    workers.add(pid);
  }
  while (!workers.all_done()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    workers.look([&](int worker, int status) {
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
      board.error[worker].back() = '\0';
      const std::string error = board.error[worker].data();
      if (!error.empty()) throw SeriesError(error);
      throw SeriesError(files.name(board.file[worker]) +
                        ": the DICOM library does not survive its picture, which is damaged; copy the file again");
    });
    alive(static_cast<double>(board.done) / static_cast<double>(places.size()));
  }
  return {board.clamped, board.doubles};
}

}  // namespace vallecula::pipeline
