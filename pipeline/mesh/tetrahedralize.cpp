#include "pipeline/mesh/tetrahedralize.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "pipeline/helper_program.h"
#include "pipeline/mesh/lattice.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/tetgen_exchange.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

/// A file in memory that the helper is handed: nothing is left on the disk, whoever is killed.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("vallecula-tetgen", MFD_CLOEXEC)) {
    if (descriptor_ < 0)
      throw TetrahedralizeError(std::string("mesh generator: no memory for its files (") + std::strerror(errno) + ")");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return descriptor_; }
  /// The same for this process and, once it may keep the descriptor, for the helper.
  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// Runs the helper under its limits; returns the wait status.
int run_helper(const fs::path& helper, const MemoryFile& input_file, const MemoryFile& output_file,
               const TetrahedralizeOptions& options) {
  const auto input = input_file.name();
  const auto output = output_file.name();
  const std::string program = helper.string();
  char* const arguments[] = {const_cast<char*>(program.c_str()), const_cast<char*>(input.c_str()),
                             const_cast<char*>(output.c_str()), nullptr};
  const rlimit cpu{static_cast<rlim_t>(options.time_limit_s), static_cast<rlim_t>(options.time_limit_s + 1)};
  const rlimit memory{options.memory_limit_bytes, options.memory_limit_bytes};
  const rlimit no_core{0, 0};
  const pid_t child = ::fork();
  if (child < 0)
    throw TetrahedralizeError(std::string("mesh generator: no new process (") + std::strerror(errno) + ")");
  if (child == 0) {
    // Between fork and exec only calls that are safe in a program with threads.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it must not go on for a program that was killed
    ::fcntl(input_file.descriptor(), F_SETFD, 0);
    ::fcntl(output_file.descriptor(), F_SETFD, 0);
    ::setrlimit(RLIMIT_CPU, &cpu);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    ::setrlimit(RLIMIT_AS, &memory);  // sanitizers reserve terabytes of addresses
#else
    (void)memory;
#endif
    ::setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = ::open("/dev/null", O_RDWR);
    if (nowhere >= 0) {
      ::dup2(nowhere, 0);
      ::dup2(nowhere, 1);
      ::dup2(nowhere, 2);
    }
    ::execv(program.c_str(), arguments);
    ::_exit(127);
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(options.time_limit_s);
  int status = 0;
  for (;;) {
    const pid_t done = ::waitpid(child, &status, WNOHANG);
    if (done == child) return status;
    if (done < 0 && errno != EINTR) throw TetrahedralizeError("mesh generator: the helper process was lost");
    if (std::chrono::steady_clock::now() > end) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      throw TetrahedralizeError("mesh generator: not done within " + std::to_string(options.time_limit_s) +
                                " s and stopped");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void check_status(int status) {
  if (WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)
      throw TetrahedralizeError("mesh generator: over its time limit and stopped");
    throw TetrahedralizeError("mesh generator: ended by signal " + std::to_string(WTERMSIG(status)) +
                              "; the surface is not fit for it");
  }
  switch (WEXITSTATUS(status)) {
    case kHelperDone:
      return;
    case kHelperIntersects:
      throw TetrahedralizeError("mesh generator: the surface crosses itself");
    case kHelperEmpty:
      throw TetrahedralizeError("mesh generator: no tetrahedra came out");
    case 127:
      throw TetrahedralizeError("mesh generator: vallecula-tetgen cannot be started; install the program again");
    default:
      throw TetrahedralizeError("mesh generator: failed with code " + std::to_string(WEXITSTATUS(status)));
  }
}

void check_result(const TetMesh& mesh, const Surface& surface) {
  if (mesh.tets.empty()) throw TetrahedralizeError("mesh generator: no tetrahedra came out");
  const auto quality = quality_of(mesh);
  if (!(quality.smallest_volume_mm3 > 0.0))
    throw TetrahedralizeError("mesh generator: a tetrahedron is flat or inverted");
  const double expected = size_of(surface).volume_mm3;
  if (std::abs(quality.volume_mm3 - expected) > 1e-6 * expected) {
    throw TetrahedralizeError("mesh generator: the tetrahedra do not fill the surface");
  }
}

}  // namespace

fs::path find_tetgen_helper() {
  if (const auto helper = find_helper_program("vallecula-tetgen")) return *helper;
  throw TetrahedralizeError(
      "mesh generator: the helper program vallecula-tetgen is not beside vallecula; build or install it, or set "
      "VALLECULA_HELPERS to its folder");
}

TetMesh tetrahedralized(const Surface& surface, const TetrahedralizeOptions& options) {
  try {
    require_solid(surface, "the soft tissue");
  } catch (const std::runtime_error& e) {
    throw TetrahedralizeError(std::string("mesh generator: ") + e.what());
  }
  TetgenInput input;
  input.points = surface.points;
  input.triangles = surface.triangles;
  if (options.edge_mm) input.inner_points = lattice_inside(surface, options.edge_mm);
  // p: fill the surface, Y: keep the surface as it is, i: with these inner points, Q: silent
  input.switches = input.inner_points.empty() ? "pYQ" : "pYiQ";

  const MemoryFile in;
  const MemoryFile out;
  if (!exchange::write(input, in.name()))
    throw TetrahedralizeError("mesh generator: its input cannot be written; is there enough memory?");
  check_status(run_helper(options.helper.empty() ? find_tetgen_helper() : options.helper, in, out, options));
  TetgenOutput output;
  if (!exchange::read(out.name(), output))
    throw TetrahedralizeError("mesh generator: its result cannot be read");

  TetMesh mesh;
  mesh.points = output.points;
  mesh.tets = output.tets;
  for (auto& t : mesh.tets) {
    for (const int corner : t) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.points.size())
        throw TetrahedralizeError("mesh generator: its result is damaged");
    }
    if (signed_volume(mesh, t) < 0.0) std::swap(t[2], t[3]);  // TetGen orients the other way round
  }
  mesh.tissue.assign(mesh.tets.size(), 0);
  mesh.anchor.assign(mesh.points.size(), static_cast<std::uint8_t>(Anchor::free));
  check_result(mesh, surface);
  return mesh;
}

}  // namespace vallecula::pipeline
