// Runs the reading helper vallecula-ct under its limits, whatever it is asked to read.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "pipeline/dicom/limits.h"

namespace vallecula::pipeline {

struct HelperLimits {
  std::size_t memory_bytes = kHelperMemoryBytes;
  int stall_seconds = kHelperStallSeconds;
};

/// The helper gave no answer. `what()` says why and how to mend it, without naming what was read.
class HelperError : public std::runtime_error {
 public:
  HelperError(std::string file, const std::string& why) : std::runtime_error(why), file_(std::move(file)) {}
  /// The file it was at, as a person is told it; empty when at none.
  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

/// What the helper's end or an answer without sense comes to.
constexpr const char* kHelperFailed = "the reading program failed at it; copy the file again";

/// Memory without a name that can be handed to another process. Throws HelperError.
class NamelessMemory {
 public:
  NamelessMemory();
  ~NamelessMemory();
  NamelessMemory(const NamelessMemory&) = delete;
  NamelessMemory& operator=(const NamelessMemory&) = delete;
  int descriptor() const { return descriptor_; }
  std::size_t bytes() const;

 private:
  int descriptor_;
};

struct Handed {
  std::string letter;  ///< ct_exchange: to be believed only after checks
  std::string file;    ///< the last file it was at, as a person is told it
};

/// Whatever becomes of the helper, this process goes on: its death, its silence, its limits are a HelperError. What it
/// reads is left in `voxels`. What `progress` (0..1) throws ends the helper and reaches the caller.
Handed run_reading_helper(const std::string& request, const NamelessMemory& voxels,
                          const std::function<void(double)>& progress, const HelperLimits& limits);

}  // namespace vallecula::pipeline
