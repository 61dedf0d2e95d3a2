#include "curricula/trial_log.h"

#include <cstring>
#include <limits>
#include <random>

#include "curricula/trial_log_format.h"
#include "tests/curricula/temporary_folder.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;
using testing::error_of;

// The layout as written down in trial_log_format.h, told here a second time: a change of the format must fail this
// test.
constexpr std::size_t kFileHead = 12, kBlockHead = 12, kChecksum = 4, kTick = 547;
constexpr int kTicksPerBlock = 256;

class TrialLogFile : public testing::TemporaryFolder {
 protected:
  fs::path path() const { return folder_ / "trial.vtrial"; }
  fs::path part() const { return folder_ / "trial.vtrial.part"; }
};

double any_bits(std::mt19937_64& random) {
  const std::uint64_t bits = random();  // every kind of double: NaN with payload, infinities, subnormals, both zeros
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

LogTick random_tick(std::mt19937_64& random) {
  LogTick t;
  const auto fill = [&](auto& values) {
    for (double& v : values) v = any_bits(random);
  };
  t.tick = static_cast<std::int64_t>(random());
  t.time_s = any_bits(random);
  fill(t.device_pose.position_m), fill(t.device_pose.rotation_wxyz);
  t.buttons = static_cast<std::uint32_t>(random());
  t.device_valid = (random() & 1u) != 0;
  t.step_fed = static_cast<std::int64_t>(random());
  t.step_used = static_cast<std::int64_t>(random());
  fill(t.proxy_pose.position_m), fill(t.proxy_pose.rotation_wxyz);
  t.state = static_cast<LoggedState>(random() % 4);
  fill(t.model_force_n), fill(t.model_torque_nm), fill(t.displayed_force_n);
  for (LogLoad& load : t.loads) {
    fill(load.force_n), fill(load.centre_m);
    load.contacts = static_cast<std::int32_t>(random());
  }
  t.has_sight = (random() & 1u) != 0;
  t.glottis_visible = any_bits(random);
  t.faults = static_cast<std::uint32_t>(random());
  return t;
}

template <class Array>
bool same_bits(const Array& a, const Array& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}
bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same_bits(const LogPose& a, const LogPose& b) {
  return same_bits(a.position_m, b.position_m) && same_bits(a.rotation_wxyz, b.rotation_wxyz);
}
bool same_bits(const LogTick& a, const LogTick& b) {
  bool same = a.tick == b.tick && same_bits(a.time_s, b.time_s) && same_bits(a.device_pose, b.device_pose) &&
              a.buttons == b.buttons && a.device_valid == b.device_valid && a.step_fed == b.step_fed &&
              a.step_used == b.step_used && same_bits(a.proxy_pose, b.proxy_pose) && a.state == b.state &&
              same_bits(a.model_force_n, b.model_force_n) && same_bits(a.model_torque_nm, b.model_torque_nm) &&
              same_bits(a.displayed_force_n, b.displayed_force_n) && a.has_sight == b.has_sight &&
              same_bits(a.glottis_visible, b.glottis_visible) && a.faults == b.faults;
  for (std::size_t i = 0; i < a.loads.size(); ++i) {
    same = same && same_bits(a.loads[i].force_n, b.loads[i].force_n) &&
           same_bits(a.loads[i].centre_m, b.loads[i].centre_m) && a.loads[i].contacts == b.loads[i].contacts;
  }
  return same;
}

LogHeader sample_header() {
  LogHeader h;
  h.software_version = "1.2.3";
  h.build_hash = "abc";
  h.instruction_set = "x86-64";
  h.package_name = "Säugling \"1\"\n";
  h.package_path = "/a/b.patient";
  h.package_sha256 = std::string(64, 'f');
  h.curriculum_path = "c.yaml";
  h.scenario_id = "term";
  h.scenario_yaml = "id: term\ntitle: \"π\"\n";
  h.scenario_sha256 = "00";
  h.device_kind = "scripted";
  h.servo_period_s = 0.001;
  h.device_limit_n = 3.3;
  h.realtime = true;
  std::mt19937_64 random(9);
  for (int i = 0; i < 200; ++i) {
    double value = any_bits(random);
    if (std::isfinite(value)) h.settings["random " + std::to_string(i)] = value;
  }
  h.settings["smallest"] = std::numeric_limits<double>::denorm_min();
  h.settings["largest"] = std::numeric_limits<double>::max();
  h.settings["tenth"] = 0.1;
  h.landmarks_m["vallecula"] = {0.1, -1.0 / 3.0, 2e-17};
  return h;
}

std::vector<LogTick> write_log(const fs::path& path, int ticks, const LogFooter& footer, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::vector<LogTick> written;
  TrialLogWriter writer(path, sample_header());
  for (int i = 0; i < ticks; ++i) {
    written.push_back(random_tick(random));
    writer.append(written.back());
  }
  writer.close(footer);
  return written;
}

LogFooter sample_footer() {
  return {true, "finished", 999.87654321, 3, 4, "servo: ordinary priority", {"unplugged", ""}};
}

TEST_F(TrialLogFile, AToolOfItsOwnIsNamedByItsHashAndOldLogsHaveNone) {
  LogHeader header = sample_header();
  TrialLogWriter(path(), header).close(sample_footer());
  EXPECT_EQ(read_trial_log(path()).header.schema, 1) << "a trial with the scenario's blade is what it always was";
  EXPECT_EQ(read_trial_log(path()).header.tool_sha256, "");
  EXPECT_EQ(log_format::header_to_json(header).find("tool_sha256"), std::string::npos);
  header.tool_sha256 = std::string(64, 'e');
  TrialLogWriter(path(), header).close(sample_footer());
  EXPECT_EQ(read_trial_log(path()).header.schema, 2) << "older programs must not replay it with the blade";
  EXPECT_EQ(read_trial_log(path()).header.tool_sha256, std::string(64, 'e'));
  std::string json = log_format::header_to_json(header);
  json.replace(json.find("tool_sha256"), 11, "tool_sha999");
  EXPECT_THROW(log_format::header_from_json(json), TrialLogError);
  json = log_format::header_to_json(header);
  json.replace(json.find("\"schema\":2"), 10, "\"schema\":3");
  EXPECT_THROW(log_format::header_from_json(json), TrialLogError);
}

TEST_F(TrialLogFile, GivesBackEveryBit) {
  for (const int ticks : {0, 1, kTicksPerBlock - 1, kTicksPerBlock, kTicksPerBlock + 1, 1000}) {
    const auto written = write_log(path(), ticks, sample_footer());
    EXPECT_FALSE(fs::exists(part()));
    for (const fs::path& given : {path(), folder_}) {
      const TrialLog log = read_trial_log(given);
      ASSERT_EQ(log.ticks.size(), written.size());
      for (std::size_t i = 0; i < written.size(); ++i) ASSERT_TRUE(same_bits(log.ticks[i], written[i])) << i;
      EXPECT_TRUE(log.footer.complete);
      EXPECT_EQ(log.footer.ended, "finished");
      EXPECT_EQ(log.footer.loop_rate_hz, 999.87654321);
      EXPECT_EQ(log.footer.deadline_misses, 3);
      EXPECT_EQ(log.footer.pause_faults, (std::vector<std::string>{"unplugged", ""}));
      EXPECT_EQ(log.footer.overruns, 4);
      EXPECT_EQ(log.footer.real_time_setup, "servo: ordinary priority");
      const LogHeader expected = sample_header(), &header = log.header;
      EXPECT_EQ(header.software_version, expected.software_version);
      EXPECT_EQ(header.build_hash, expected.build_hash);
      EXPECT_EQ(header.instruction_set, expected.instruction_set);
      EXPECT_EQ(header.package_name, expected.package_name);
      EXPECT_EQ(header.package_path, expected.package_path);
      EXPECT_EQ(header.package_sha256, expected.package_sha256);
      EXPECT_EQ(header.curriculum_path, expected.curriculum_path);
      EXPECT_EQ(header.scenario_id, expected.scenario_id);
      EXPECT_EQ(header.scenario_yaml, expected.scenario_yaml);
      EXPECT_EQ(header.scenario_sha256, expected.scenario_sha256);
      EXPECT_EQ(header.device_kind, expected.device_kind);
      EXPECT_EQ(header.servo_period_s, expected.servo_period_s);
      EXPECT_EQ(header.device_limit_n, expected.device_limit_n);
      EXPECT_EQ(header.realtime, expected.realtime);
      EXPECT_EQ(header.settings, expected.settings);
      EXPECT_EQ(header.landmarks_m, expected.landmarks_m);
    }
  }
}

TEST_F(TrialLogFile, BytesAreLittleEndianWithTheKnownChecksum) {
  LogTick tick;
  tick.tick = 0x0102030405060708;
  TrialLogWriter writer(path(), sample_header());
  writer.append(tick);
  writer.close(sample_footer());
  const std::string bytes = read(path());
  EXPECT_EQ(bytes.substr(0, 8), "\x89VTRIAL\n");
  const auto tick_block = bytes.find("TICK");
  ASSERT_NE(tick_block, std::string::npos);
  EXPECT_EQ(bytes.substr(tick_block + kBlockHead, 8), "\x08\x07\x06\x05\x04\x03\x02\x01");
  // CRC-32 bit by bit, from its polynomial; the code under test uses a table.
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = tick_block; i < tick_block + kBlockHead + kTick; ++i) {
    crc ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1u) != 0 ? (crc >> 1) ^ 0xedb88320u : crc >> 1;
  }
  crc = ~crc;
  std::uint32_t stored = 0;
  for (int i = 3; i >= 0; --i) {
    stored =
        stored << 8 | static_cast<unsigned char>(bytes[tick_block + kBlockHead + kTick + static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(stored, crc);
  EXPECT_EQ(bytes.substr(tick_block + kBlockHead + kTick + kChecksum, 4), "FOOT");
}

TEST_F(TrialLogFile, WithoutCloseThePartHoldsEverything) {
  std::mt19937_64 random(1);
  {
    TrialLogWriter writer(path(), sample_header());
    for (int i = 0; i < 300; ++i) writer.append(random_tick(random));
  }
  EXPECT_FALSE(fs::exists(path()));
  for (const fs::path& given : {part(), folder_}) {
    const TrialLog log = read_trial_log(given);
    EXPECT_EQ(log.ticks.size(), 300u);
    EXPECT_FALSE(log.footer.complete);
    EXPECT_EQ(log.footer.ended, "interrupted");
  }
}

TEST_F(TrialLogFile, CutAnywhereItIsRecoveredToTheLastWholeBlock) {
  const auto written = write_log(path(), 2 * kTicksPerBlock + 10, sample_footer());
  const std::string whole = read(path());
  const std::size_t first_ticks = whole.find("TICK");
  const std::size_t block = kBlockHead + kTicksPerBlock * kTick + kChecksum;
  const std::size_t third_ticks = first_ticks + 2 * block, footer = third_ticks + kBlockHead + 10 * kTick + kChecksum;
  ASSERT_EQ(whole.substr(third_ticks, 4), "TICK");
  ASSERT_EQ(whole.substr(footer, 4), "FOOT");

  // Every byte near each border, and steps through the insides.
  std::vector<std::size_t> cuts;
  for (const std::size_t border :
       {std::size_t{0}, kFileHead, first_ticks, first_ticks + block, third_ticks, footer, whole.size()}) {
    for (std::size_t d = 0; d <= 20; ++d) {
      if (border >= d) cuts.push_back(border - d);
      if (border + d < whole.size()) cuts.push_back(border + d);
    }
  }
  for (std::size_t cut = 0; cut < whole.size(); cut += 4099) cuts.push_back(cut);

  for (const std::size_t cut : cuts) {
    write("cut.vtrial.part", whole.substr(0, cut));
    write("cut.vtrial", whole.substr(0, cut));
    const auto read_part = [&] { return read_trial_log(folder_ / "cut.vtrial.part"); };
    const auto read_whole = [&] { return read_trial_log(folder_ / "cut.vtrial"); };
    if (cut == whole.size()) {
      EXPECT_TRUE(read_part().footer.complete);  // a crash between the footer and the rename loses nothing
      EXPECT_TRUE(read_whole().footer.complete);
      continue;
    }
    const std::string refusal = error_of<TrialLogError>(read_whole);
    EXPECT_NE(refusal.find("cut.vtrial"), std::string::npos) << cut;
    if (cut < first_ticks) {
      EXPECT_NE(error_of<TrialLogError>(read_part).find("cut.vtrial.part"), std::string::npos) << cut;
      continue;
    }
    const std::size_t expected = cut < first_ticks + block ? 0u
                                 : cut < third_ticks       ? static_cast<std::size_t>(kTicksPerBlock)
                                 : cut < footer            ? static_cast<std::size_t>(2 * kTicksPerBlock)
                                                           : written.size();
    const TrialLog log = read_part();
    ASSERT_EQ(log.ticks.size(), expected) << cut;
    EXPECT_FALSE(log.footer.complete);
    EXPECT_EQ(log.footer.deadline_misses, 0);
    for (std::size_t i = 0; i < expected; ++i) ASSERT_TRUE(same_bits(log.ticks[i], written[i]));
  }
}

TEST_F(TrialLogFile, AnyChangedByteIsNoticed) {
  {
    LogHeader small;
    small.scenario_id = "term";
    TrialLogWriter writer(path(), small);
    for (int i = 0; i < 2; ++i) writer.append(LogTick{});
    writer.close(sample_footer());
  }
  const std::string whole = read(path());
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ (1 << (at % 8)));
    write("changed.vtrial", changed);
    const std::string error = error_of<TrialLogError>([&] { read_trial_log(folder_ / "changed.vtrial"); });
    ASSERT_NE(error.find("changed.vtrial"), std::string::npos) << "byte " << at << " went unnoticed";
  }
}

TEST_F(TrialLogFile, SwappedRepeatedAndTrailingBlocksAreNoticed) {
  write_log(path(), 2 * kTicksPerBlock, sample_footer());
  const std::string whole = read(path());
  const std::size_t first = whole.find("TICK"), size = kBlockHead + kTicksPerBlock * kTick + kChecksum;
  const std::string head = whole.substr(0, first), a = whole.substr(first, size), b = whole.substr(first + size, size),
                    foot = whole.substr(first + 2 * size);
  ASSERT_EQ(head + a + b + foot, whole);
  for (const std::string& bad :
       {head + b + a + foot, head + a + foot, head + a + a + b + foot, head + a + b + b + foot, whole + "x",
        whole + foot, a + b + foot, head + head.substr(kFileHead) + a + b + foot}) {
    write("bad.vtrial", bad);
    EXPECT_NE(error_of<TrialLogError>([&] { read_trial_log(folder_ / "bad.vtrial"); }), "");
  }
}

TEST_F(TrialLogFile, WhatIsNoLogIsNamed) {
  EXPECT_NE(error_of<TrialLogError>([&] { read_trial_log(folder_ / "no.vtrial"); }).find("no.vtrial"),
            std::string::npos);
  EXPECT_NE(error_of<TrialLogError>([&] { read_trial_log(folder_); }).find("trial.vtrial"), std::string::npos);
  write("text.vtrial", "PK\x03\x04 this is something else altogether");
  EXPECT_NE(error_of<TrialLogError>([&] { read_trial_log(folder_ / "text.vtrial"); }).find("not a Vallecula trial log"),
            std::string::npos);
  write_log(path(), 1, sample_footer());
  std::string newer = read(path());
  newer[8] = 2;
  write("newer.vtrial", newer);
  EXPECT_NE(error_of<TrialLogError>([&] { read_trial_log(folder_ / "newer.vtrial"); }).find("format 2"),
            std::string::npos);
}

TEST_F(TrialLogFile, WhatCannotBeWrittenIsNamed) {
  const fs::path nowhere = folder_ / "missing" / "trial.vtrial";
  EXPECT_NE(error_of<TrialLogError>([&] { TrialLogWriter(nowhere, sample_header()); }).find(nowhere.string()),
            std::string::npos);
  LogHeader broken = sample_header();
  broken.settings["young_pa"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(error_of<TrialLogError>([&] { TrialLogWriter(path(), broken); }).find("young_pa"), std::string::npos);
  EXPECT_FALSE(fs::exists(part()));
  broken = sample_header();
  broken.servo_period_s = 0.0;
  EXPECT_NE(error_of<TrialLogError>([&] { TrialLogWriter(path(), broken); }).find("servo_period_s"), std::string::npos);

  TrialLogWriter writer(path(), sample_header());
  writer.close(sample_footer());
  EXPECT_NE(error_of<TrialLogError>([&] { writer.append(LogTick{}); }), "");
  EXPECT_NE(error_of<TrialLogError>([&] { writer.close(sample_footer()); }), "");
}

TEST_F(TrialLogFile, AFullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "/dev/full is not there";
  fs::create_symlink("/dev/full", part());
  EXPECT_NE(error_of<TrialLogError>([&] { TrialLogWriter(path(), sample_header()); }).find("free some space"),
            std::string::npos);
}

}  // namespace
}  // namespace vallecula::curricula
