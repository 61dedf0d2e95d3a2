// Writing and reading trial logs; the bytes are in trial_log_format.h.
#include "curricula/trial_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "curricula/trial_log_format.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;
using namespace log_format;

constexpr const char* kFileName = "trial.vtrial";

std::string system_reason() { return std::strerror(errno); }

fs::path part_of(const fs::path& path) { return fs::path(path.string() + ".part"); }

/// Makes a rename in `folder` outlast a power cut. Some file systems do not let folders be synced: nothing to mend
/// then.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

/// One block as it stands in a file; ok is false with the reason in `problem`.
struct Block {
  bool ok = false;
  std::string problem;
  std::string kind, payload;
};

Block read_block(std::istream& in, std::uint32_t expected_number) {
  Block block;
  std::string bytes(kBlockHeadBytes, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.gcount() == 0) {
    block.problem = "it ends before its footer";
    return block;
  }
  if (in.gcount() != static_cast<std::streamsize>(bytes.size())) {
    block.problem = "it ends inside a block";
    return block;
  }
  const std::uint32_t number = get_u32(bytes.data() + 4), size = get_u32(bytes.data() + 8);
  if (size > kLargestPayload) {
    block.problem = "a block's length is damaged";
    return block;
  }
  bytes.resize(kBlockHeadBytes + size + kChecksumBytes);
  in.read(bytes.data() + kBlockHeadBytes, static_cast<std::streamsize>(size + kChecksumBytes));
  if (in.gcount() != static_cast<std::streamsize>(size + kChecksumBytes)) {
    block.problem = "it ends inside a block";
    return block;
  }
  const std::size_t checked = kBlockHeadBytes + size;
  if (crc32(bytes.data(), checked) != get_u32(bytes.data() + checked)) {
    block.problem = "a block's checksum does not fit its content";
    return block;
  }
  if (number != expected_number) {
    block.problem = "a block is missing or out of order";
    return block;
  }
  block.ok = true;
  block.kind = bytes.substr(0, 4);
  block.payload = bytes.substr(kBlockHeadBytes, size);
  return block;
}

fs::path find_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return path;
  if (fs::exists(path / kFileName, error)) return path / kFileName;
  if (fs::exists(part_of(path / kFileName), error)) return part_of(path / kFileName);
  throw TrialLogError("trial log " + path.string() + ": the folder holds no " + kFileName +
                      "; give the folder of a trial, or the file itself");
}

}  // namespace

struct TrialLogWriter::Impl {
  fs::path path, part;
  int descriptor = -1;
  std::uint32_t blocks = 0;
  std::int64_t ticks = 0;
  bool intubation = false;  ///< of the trial, by its header
  std::string pending;      ///< encoded ticks of the block being filled

  [[noreturn]] void fail(const std::string& what, const std::string& mend) const {
    throw TrialLogError("trial log " + part.string() + ": " + what + " (" + system_reason() + "); " + mend);
  }

  void write_all(const std::string& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t wrote = ::write(descriptor, bytes.data() + done, bytes.size() - done);
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote < 0) fail("cannot be written", "free some space on the disk; what was written before is kept");
      done += static_cast<std::size_t>(wrote);
    }
  }

  void flush_ticks() {
    if (pending.empty()) return;
    const std::string bytes = block("TICK", blocks, pending);
    pending.clear();
    write_all(bytes);
    ++blocks;
  }
};

TrialLogWriter::TrialLogWriter(const fs::path& path, const LogHeader& header) : impl_(std::make_unique<Impl>()) {
  impl_->path = path;
  impl_->part = part_of(path);
  std::string json;
  try {
    json = header_to_json(header);
  } catch (const TrialLogError& error) {
    throw TrialLogError("trial log " + path.string() + ": header: " + error.what());
  }
  impl_->intubation = header.has_intubation;
  impl_->pending.reserve(kTicksPerBlock * tick_bytes(header.has_intubation));
  impl_->descriptor = ::open(impl_->part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (impl_->descriptor < 0) impl_->fail("cannot be created", "check that its folder exists and may be written to");
  try {
    impl_->write_all(file_head() + block("HEAD", impl_->blocks++, json));
  } catch (...) {
    ::close(impl_->descriptor);
    throw;
  }
}

TrialLogWriter::~TrialLogWriter() {
  if (impl_->descriptor < 0) return;
  try {
    impl_->flush_ticks();  // not closed: the .part stays, whole up to here
  } catch (const TrialLogError&) {
    // The disk is full or gone: the blocks before are kept, and a destructor has nobody to tell.
  }
  ::close(impl_->descriptor);
}

void TrialLogWriter::append(const LogTick& tick) {
  if (impl_->descriptor < 0) throw TrialLogError("trial log " + impl_->path.string() + ": is closed already");
  if (tick.has_intubation != impl_->intubation) {
    throw TrialLogError("trial log " + impl_->path.string() + ": tick " + std::to_string(tick.tick) +
                        (impl_->intubation ? " lacks the intubation its header names"
                                           : " has an intubation that its header does not name"));
  }
  put_tick(impl_->pending, tick);
  ++impl_->ticks;
  if (impl_->pending.size() >= kTicksPerBlock * tick_bytes(impl_->intubation)) impl_->flush_ticks();
}

void TrialLogWriter::close(const LogFooter& footer) {
  Impl& log = *impl_;
  if (log.descriptor < 0) throw TrialLogError("trial log " + log.path.string() + ": is closed already");
  std::string json;
  try {
    json = footer_to_json(footer, log.ticks);
  } catch (const TrialLogError& error) {
    throw TrialLogError("trial log " + log.path.string() + ": footer: " + error.what());
  }
  log.flush_ticks();
  log.write_all(block("FOOT", log.blocks++, json));
  if (::fsync(log.descriptor) != 0) log.fail("cannot be synced to the disk", "check the disk");
  const int descriptor = log.descriptor;
  log.descriptor = -1;
  if (::close(descriptor) != 0) log.fail("cannot be closed", "check the disk");
  if (::rename(log.part.c_str(), log.path.c_str()) != 0) {
    log.fail("cannot be renamed to " + log.path.string(), "the file is whole; rename it by hand");
  }
  sync_folder(log.path.parent_path());
}

TrialLog read_trial_log(const fs::path& given) {
  const fs::path path = find_file(given);
  const std::string name = "trial log " + path.string() + ": ";
  const bool may_be_cut = path.extension() == ".part";
  std::ifstream in(path, std::ios::binary);
  if (!in) throw TrialLogError(name + "cannot be opened; check the name and the permission");

  std::string head(kFileHeadBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (in.gcount() != static_cast<std::streamsize>(head.size()) ||
      head.compare(0, kMagicBytes, kMagic, kMagicBytes) != 0) {
    throw TrialLogError(name + "is not a Vallecula trial log; give a .vtrial file or its folder");
  }
  const std::uint32_t version = get_u32(head.data() + kMagicBytes);
  if (version != kVersion) {
    throw TrialLogError(name + "has format " + std::to_string(version) + ", this version reads " +
                        std::to_string(kVersion) + "; use the Vallecula that wrote it");
  }

  TrialLog log;
  log.footer.ended = "interrupted";
  std::uint32_t number = 0;
  std::string problem;
  bool footer_seen = false;
  try {
    while (problem.empty() && !footer_seen) {
      Block block = read_block(in, number);
      if (!block.ok) {
        problem = block.problem;
      } else if ((number == 0) != (block.kind == "HEAD")) {
        problem = "its header is missing or stands twice";
      } else if (block.kind == "HEAD") {
        log.header = header_from_json(block.payload);
      } else if (block.kind == "TICK" && block.payload.size() % tick_bytes(log.header.has_intubation) == 0) {
        for (std::size_t at = 0; at < block.payload.size(); at += tick_bytes(log.header.has_intubation)) {
          log.ticks.push_back(get_tick(block.payload.data() + at, log.header.has_intubation));
        }
      } else if (block.kind == "FOOT") {
        std::int64_t ticks = 0;
        const LogFooter footer = footer_from_json(block.payload, ticks);
        if (ticks != static_cast<std::int64_t>(log.ticks.size())) {
          problem =
              "its footer names " + std::to_string(ticks) + " ticks, but it holds " + std::to_string(log.ticks.size());
        } else {
          log.footer = footer;
          footer_seen = true;
          if (in.peek() != std::char_traits<char>::eof()) problem = "something follows its footer";
        }
      } else {
        problem = "a block's kind or length is unknown";
      }
      if (problem.empty()) ++number;
    }
  } catch (const TrialLogError& error) {
    throw TrialLogError(name + error.what());
  }
  if (problem.empty()) return log;

  const std::string where =
      ", after block " + std::to_string(number) + " (" + std::to_string(log.ticks.size()) + " ticks)";
  if (number == 0) {
    throw TrialLogError(name + "is damaged in its header (" + problem + "): nothing can be recovered; use a copy");
  }
  if (!may_be_cut) {
    throw TrialLogError(name + "is damaged: " + problem + where +
                        "; use a copy, or rename it to end in .part to recover the ticks before the damage");
  }
  log.footer = LogFooter{};
  log.footer.ended = "interrupted";
  return log;
}

}  // namespace vallecula::curricula
