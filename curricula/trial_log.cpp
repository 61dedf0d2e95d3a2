// Writing and reading trial logs; the bytes are in trial_log_format.h.
#include "curricula/trial_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "curricula/trial_log_format.h"
#include "curricula/trial_log_part.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;
using namespace log_format;

constexpr const char* kFileName = "trial.vtrial";
constexpr std::uint32_t kBlocksPerSync = 4;  ///< a power cut takes the last second at most

fs::path part_of(const fs::path& path) { return fs::path(path.string() + ".part"); }

/// One block as it stands in a file; ok is false with the reason in `problem`.
struct Block {
  bool ok = false;
  bool ends = false;  ///< not ok: the file ends there
  std::string problem;
  std::string kind, payload;
};

Block read_block(std::istream& in, std::uint32_t expected_number) {
  Block block;
  std::string bytes(kBlockHeadBytes, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.gcount() == 0) {
    block.ends = true;
    block.problem = "it ends before its footer";
    return block;
  }
  if (in.gcount() != static_cast<std::streamsize>(bytes.size())) {
    block.ends = true;
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
    block.ends = true;
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

struct TrialLogWriter::Impl : OpenPart {
  using OpenPart::OpenPart;
  std::uint32_t blocks = 0;
  std::int64_t ticks = 0;
  bool events = false, intubation = false, areas = false;  ///< of the trial, by its header
  std::string pending;      ///< encoded ticks of the block being filled

  /// A recovery may rename the old file between the two calls: what is then open is a kept trial, not ours to empty.
  void open_and_lock() {
    for (;;) {
      descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
      if (descriptor < 0) fail("cannot be created", "check that its folder exists and may be written to");
      if (!lock()) fail("is being written by another trial", "choose another folder");
      if (in_place()) return;
      ::close(descriptor);
    }
  }

  void flush_ticks() {
    if (pending.empty()) return;
    const std::string bytes = block("TICK", blocks, pending);
    pending.clear();
    write_all(bytes);
    if (++blocks % kBlocksPerSync == 0) sync();
  }
};

TrialLogWriter::TrialLogWriter(const fs::path& path, const LogHeader& header) : impl_(std::make_unique<Impl>(path)) {
  std::string json;
  try {
    json = header_to_json(header);
  } catch (const TrialLogError& error) {
    throw TrialLogError("trial log " + path.string() + ": header: " + error.what());
  }
  impl_->events = header.has_events;
  impl_->intubation = header.has_intubation;
  impl_->areas = header.has_contact_areas;
  impl_->pending.reserve(kTicksPerBlock * tick_bytes(header.has_intubation, header.has_contact_areas));
  impl_->open_and_lock();
  if (::ftruncate(impl_->descriptor, 0) != 0 && errno != EINVAL) impl_->fail("cannot be written", "check the disk");
  impl_->write_all(file_head() + block("HEAD", impl_->blocks++, json));
  impl_->sync();
  sync_folder(path.parent_path());
}

TrialLogWriter::~TrialLogWriter() {
  if (impl_->descriptor < 0) return;
  try {
    impl_->flush_ticks();  // not closed: the .part stays, whole up to here
  } catch (const TrialLogError&) {
    // The disk is full or gone: the blocks before are kept, and a destructor has nobody to tell.
  }
}

void TrialLogWriter::append(const LogTick& tick) {
  if (impl_->descriptor < 0) throw TrialLogError("trial log " + impl_->path.string() + ": is closed already");
  if (tick.has_intubation != impl_->intubation) {
    throw TrialLogError("trial log " + impl_->path.string() + ": tick " + std::to_string(tick.tick) +
                        (impl_->intubation ? " lacks the intubation its header names"
                                           : " has an intubation that its header does not name"));
  }
  put_tick(impl_->pending, tick, impl_->areas);
  ++impl_->ticks;
  if (impl_->pending.size() >= kTicksPerBlock * tick_bytes(impl_->intubation, impl_->areas)) impl_->flush_ticks();
}

void TrialLogWriter::append(const LogEvent& event) {
  Impl& log = *impl_;
  if (log.descriptor < 0) throw TrialLogError("trial log " + log.path.string() + ": is closed already");
  if (!log.events || event.tick < 0 || event.tick >= log.ticks) {
    throw TrialLogError("trial log " + log.path.string() + ": event of tick " + std::to_string(event.tick) +
                        (log.events ? ": that tick has not been written" : ", but its header names no events"));
  }
  log.flush_ticks();
  log.write_all(block("EVNT", log.blocks++, event_to_json(event)));
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
  log.finish();
}

Reading read_blocks(const fs::path& path) {
  const std::string name = "trial log " + path.string() + ": ";
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

  Reading reading;
  TrialLog& log = reading.log;
  std::uint32_t& number = reading.blocks;
  std::string& problem = reading.problem;
  reading.bytes = head.size();
  std::size_t bytes_of_tick = 1;  // by the header, which comes first
  bool footer_seen = false;
  try {
    while (problem.empty() && !footer_seen) {
      Block block = read_block(in, number);
      if (!block.ok) {
        problem = block.problem;
        reading.ends = block.ends;
      } else if ((number == 0) != (block.kind == "HEAD")) {
        problem = "its header is missing or stands twice";
      } else if (block.kind == "HEAD") {
        log.header = header_from_json(block.payload);
        bytes_of_tick = tick_bytes(log.header.has_intubation, log.header.has_contact_areas);
      } else if (block.kind == "TICK" && block.payload.size() % bytes_of_tick == 0) {
        for (std::size_t at = 0; at < block.payload.size(); at += bytes_of_tick) {
          log.ticks.push_back(
              get_tick(block.payload.data() + at, log.header.has_intubation, log.header.has_contact_areas));
        }
      } else if (block.kind == "EVNT" && log.header.has_events) {
        const LogEvent event = event_from_json(block.payload);
        if (event.tick >= static_cast<std::int64_t>(log.ticks.size()) ||
            (!log.events.empty() && event.tick < log.events.back().tick)) {
          problem = "an event is out of order";
        } else {
          log.events.push_back(event);
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
      if (problem.empty()) {
        ++number;
        reading.bytes += kBlockHeadBytes + block.payload.size() + kChecksumBytes;
      }
    }
  } catch (const TrialLogError& error) {
    throw TrialLogError(name + error.what());
  }
  if (number == 0) {
    throw TrialLogError(name + "is damaged in its header (" + problem + "): nothing can be recovered; use a copy");
  }
  if (!problem.empty()) {
    log.footer = LogFooter{};
    log.footer.ended = "interrupted";
  }
  return reading;
}

TrialLog read_trial_log(const fs::path& given) {
  const fs::path path = find_file(given);
  Reading reading = read_blocks(path);
  if (!reading.problem.empty() && path.extension() != ".part") {
    throw TrialLogError("trial log " + path.string() + ": is damaged: " + reading.problem + ", after block " +
                        std::to_string(reading.blocks) + " (" + std::to_string(reading.log.ticks.size()) +
                        " ticks); use a copy, or rename it to end in .part to recover the ticks before the damage");
  }
  return std::move(reading.log);
}

}  // namespace vallecula::curricula
