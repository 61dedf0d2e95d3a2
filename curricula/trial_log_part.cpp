#include "curricula/trial_log_part.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "curricula/trial_log_format.h"

namespace vallecula::curricula {

namespace fs = std::filesystem;

void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

OpenPart::~OpenPart() {
  if (descriptor >= 0) ::close(descriptor);
}

void OpenPart::fail(const std::string& what, const std::string& mend) const {
  throw TrialLogError("trial log " + part.string() + ": " + what + " (" + std::strerror(errno) + "); " + mend);
}

bool OpenPart::lock() const { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool OpenPart::in_place() const {
  struct stat opened {
  }, there{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(part.c_str(), &there) == 0 && opened.st_ino == there.st_ino &&
         opened.st_dev == there.st_dev;
}

void OpenPart::write_all(const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t wrote = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) fail("cannot be written", "free some space on the disk; what was written before is kept");
    done += static_cast<std::size_t>(wrote);
  }
}

void OpenPart::sync() {
  if (::fdatasync(descriptor) != 0 && errno != EINVAL && errno != EROFS)  // devices and pipes have nothing to sync
    fail("cannot be synced to the disk", "check the disk");
}

void OpenPart::finish() {
  sync();
  if (::rename(part.c_str(), path.c_str()) != 0)
    fail("cannot be renamed to " + path.string(), "the file is whole; rename it by hand");
  sync_folder(path.parent_path());
  ::close(descriptor);
  descriptor = -1;
}

bool is_being_written(const fs::path& path) {
  OpenPart log(path);
  log.descriptor = ::open(log.part.c_str(), O_RDONLY | O_CLOEXEC);
  return log.descriptor >= 0 && !log.lock() && errno == EWOULDBLOCK;
}

namespace {

/// More than a cut leaves behind the last whole block: some of it may be worth a look.
bool damaged(const Reading& reading, const fs::path& file) {
  using namespace log_format;
  if (reading.problem.empty()) return false;
  const LogHeader& header = reading.log.header;
  const std::size_t one_block = kBlockHeadBytes + kChecksumBytes +
                                kTicksPerBlock * tick_bytes(header.has_intubation, header.has_contact_areas);
  std::error_code error;
  return !reading.ends || fs::file_size(file, error) - reading.bytes > one_block;
}

}  // namespace

CutLog close_cut_log(const fs::path& path) {
  OpenPart cut(path);
  cut.descriptor = ::open(cut.part.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (cut.descriptor < 0) {
    if (errno != ENOENT && errno != ENOTDIR) cut.fail("cannot be opened", "check its permission");
    std::error_code error;
    if (fs::exists(path, error)) return CutLog::whole;
    const fs::path folder = path.parent_path();
    return folder.empty() || fs::is_directory(folder, error) ? CutLog::nothing : CutLog::no_folder;
  }
  if (!cut.lock()) return CutLog::being_written;
  if (!cut.in_place()) return CutLog::being_written;  // its writer has just given it its own name
  const Reading reading = read_blocks(cut.part);
  const bool more = damaged(reading, cut.part);
  if (more && reading.log.ticks.empty())
    throw TrialLogError("trial log " + cut.part.string() + ": is damaged (" + reading.problem +
                        ") before its first whole block of ticks: nothing can be recovered; use a copy");
  if (reading.log.ticks.empty()) {
    ::unlink(cut.part.c_str());
    return CutLog::nothing;
  }
  if (!reading.problem.empty()) {
    if (more) {
      std::error_code error;
      fs::copy_file(cut.part, path.string() + ".damaged", fs::copy_options::overwrite_existing, error);
      if (error)
        throw TrialLogError("trial log " + cut.part.string() + ": is damaged and cannot be copied (" + error.message() +
                            "); free some space on the disk");
    }
    const auto ticks = static_cast<std::int64_t>(reading.log.ticks.size());
    if (::ftruncate(cut.descriptor, static_cast<off_t>(reading.bytes)) != 0)
      cut.fail("cannot be cut", "check the disk");
    cut.write_all(log_format::block("FOOT", reading.blocks, log_format::footer_to_json(reading.log.footer, ticks)));
  }
  cut.finish();
  return CutLog::kept;
}

}  // namespace vallecula::curricula
