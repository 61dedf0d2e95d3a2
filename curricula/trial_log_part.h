// A log under way, and a log as far as it is whole (private to the library).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "curricula/trial_log.h"

namespace vallecula::curricula {

/// PATH.part. Whoever writes it holds its lock, which goes with the process, however that ends. Every call throws
/// TrialLogError.
struct OpenPart {
  std::filesystem::path path, part;
  int descriptor = -1;

  explicit OpenPart(const std::filesystem::path& of) : path(of), part(of.string() + ".part") {}
  ~OpenPart();
  OpenPart(const OpenPart&) = delete;
  OpenPart& operator=(const OpenPart&) = delete;

  [[noreturn]] void fail(const std::string& what, const std::string& mend) const;  ///< with errno's words
  bool lock() const;                                                               ///< false: another holds it
  bool in_place() const;  ///< the open file still has the name PATH.part; true under the lock: nobody takes it away
  void write_all(const std::string& bytes);
  void sync();
  /// Syncs, gives the file its own name and lets go of it. Renamed under the lock: nobody takes it for a cut one.
  void finish();
};

/// Makes a new name in `folder` outlast a power cut. Some file systems do not let folders be synced: nothing to mend
/// then.
void sync_folder(const std::filesystem::path& folder);

/// A file as far as it is whole.
struct Reading {
  TrialLog log;
  std::uint32_t blocks = 0;  ///< whole ones
  std::uint64_t bytes = 0;   ///< up to the end of the last of them
  std::string problem;       ///< what follows them; empty: nothing, the footer was the last
  bool ends = false;         ///< the problem is that the file ends, as one does that was cut off
};
/// Throws TrialLogError when not even the header is whole.
Reading read_blocks(const std::filesystem::path& file);

}  // namespace vallecula::curricula
