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
constexpr std::size_t kFileHead = 12, kBlockHead = 12, kChecksum = 4, kTick = 547, kTickWithIntubation = 882;
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

LogTick random_tick(std::mt19937_64& random, bool intubation = false) {
  LogTick t;
  const auto fill = [&](auto& values) {
    for (double& v : values) v = any_bits(random);
  };
  const auto yes = [&] { return (random() & 1u) != 0; };
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
  t.has_intubation = intubation;
  if (!intubation) return t;
  LogIntubation& i = t.intubation;
  fill(i.hand_pose.position_m), fill(i.hand_pose.rotation_wxyz);
  i.hand_valid = yes();
  i.in_hand = static_cast<LoggedInHand>(random() % 3);
  fill(i.tip_m), fill(i.tip_direction);
  i.place = static_cast<LoggedPlace>(random() % 6);
  i.side = static_cast<std::int8_t>(static_cast<int>(random() % 3) - 1);
  for (double* v : {&i.past_cords_m, &i.at_mouth_m, &i.buckled_m, &i.tip_load_n, &i.glottis_opening, &i.secretions_ml,
                    &i.sao2, &i.spo2, &i.heart_per_min, &i.given_per_min})
    *v = any_bits(random);
  fill(i.model_force_n), fill(i.displayed_force_n), fill(i.loads_n);
  i.tip_against = static_cast<std::uint8_t>(random() % 12);
  if (i.tip_against == kTubeLoads) i.tip_against = kNothingAgainstTip;
  i.spasm = yes(), i.detector_yellow = yes();
  i.breaths_given = static_cast<std::int32_t>(random());
  i.faults = static_cast<std::uint32_t>(random());
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
  const LogIntubation &i = a.intubation, &j = b.intubation;
  return same && a.has_intubation == b.has_intubation && same_bits(i.hand_pose, j.hand_pose) &&
         i.hand_valid == j.hand_valid && i.in_hand == j.in_hand && same_bits(i.tip_m, j.tip_m) &&
         same_bits(i.tip_direction, j.tip_direction) && i.place == j.place && i.side == j.side &&
         same_bits(i.past_cords_m, j.past_cords_m) && same_bits(i.at_mouth_m, j.at_mouth_m) &&
         same_bits(i.buckled_m, j.buckled_m) && same_bits(i.model_force_n, j.model_force_n) &&
         same_bits(i.displayed_force_n, j.displayed_force_n) && same_bits(i.loads_n, j.loads_n) &&
         same_bits(i.tip_load_n, j.tip_load_n) && i.tip_against == j.tip_against &&
         same_bits(i.glottis_opening, j.glottis_opening) && i.spasm == j.spasm &&
         same_bits(i.secretions_ml, j.secretions_ml) && same_bits(i.sao2, j.sao2) && same_bits(i.spo2, j.spo2) &&
         same_bits(i.heart_per_min, j.heart_per_min) && i.detector_yellow == j.detector_yellow &&
         i.breaths_given == j.breaths_given && same_bits(i.given_per_min, j.given_per_min) && i.faults == j.faults;
}

LogHeader sample_header(bool intubation = false) {
  LogHeader h;
  h.has_intubation = intubation;
  if (intubation) h.settings[kCordsToCarina] = 0.05;
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

std::vector<LogTick> write_log(const fs::path& path, int ticks, const LogFooter& footer, bool intubation = false) {
  std::mt19937_64 random(1);
  std::vector<LogTick> written;
  TrialLogWriter writer(path, sample_header(intubation));
  for (int i = 0; i < ticks; ++i) {
    written.push_back(random_tick(random, intubation));
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
  json.replace(json.find("\"schema\":2"), 10, "\"schema\":5");
  EXPECT_NE(error_of<TrialLogError>([&] { log_format::header_from_json(json); }).find("reads 1 to 4; use the newer"),
            std::string::npos);
}

TEST_F(TrialLogFile, AnIntubationIsSchema3AndAnotherKindOfTickIsRefused) {
  LogHeader header = sample_header(true);
  TrialLogWriter(path(), header).close(sample_footer());
  EXPECT_EQ(read_trial_log(path()).header.schema, 3) << "older programs must not take its ticks for theirs";
  EXPECT_TRUE(read_trial_log(path()).header.has_intubation);
  EXPECT_EQ(read_trial_log(path()).header.tool_sha256, "");
  header.tool_sha256 = std::string(64, 'e');
  TrialLogWriter(path(), header).close(sample_footer());
  EXPECT_EQ(read_trial_log(path()).header.schema, 3);
  EXPECT_EQ(read_trial_log(path()).header.tool_sha256, std::string(64, 'e'));
  std::mt19937_64 random(1);
  for (const bool intubation : {false, true}) {
    TrialLogWriter writer(path(), sample_header(intubation));
    EXPECT_NE(error_of<TrialLogError>([&] { writer.append(random_tick(random, !intubation)); }).find("tick "),
              std::string::npos);
    writer.append(random_tick(random, intubation));
  }
}

TEST_F(TrialLogFile, ContactAreasAreKeptWhereTheHeaderNamesThem) {
  std::mt19937_64 random(6);
  for (const bool intubation : {false, true})
    for (const bool areas : {false, true}) {
      LogHeader header;
      header.has_contact_areas = areas;
      header.has_intubation = intubation;
      header.settings[kCordsToCarina] = 0.04;
      std::vector<LogTick> written;
      {
        TrialLogWriter log(path(), header);
        for (int i = 0; i < kTicksPerBlock + 3; ++i) {
          written.push_back(random_tick(random, intubation));
          for (LogLoad& load : written.back().loads) load.area_m2 = any_bits(random);
          log.append(written.back());
        }
        log.close(sample_footer());
      }
      const TrialLog log = read_trial_log(path());
      EXPECT_EQ(log.header.schema, areas ? 4 : intubation ? 3 : 1) << "older programs must not take its ticks for theirs";
      EXPECT_EQ(log.header.has_contact_areas, areas);
      EXPECT_FALSE(log.header.has_events);
      ASSERT_EQ(log.ticks.size(), written.size());
      for (std::size_t i = 0; i < written.size(); ++i) {
        ASSERT_TRUE(same_bits(log.ticks[i], written[i])) << i;
        EXPECT_EQ(log.ticks[i].has_areas, areas);
        for (std::size_t s = 0; s < kStructures; ++s)
          EXPECT_TRUE(same_bits(log.ticks[i].loads[s].area_m2, areas ? written[i].loads[s].area_m2 : 0.0));
      }
    }
}

TEST_F(TrialLogFile, EventsStandBetweenTheTicksTheyNameAndOutliveACut) {
  std::mt19937_64 random(5);
  for (const bool intubation : {false, true}) {
    LogHeader header;
    header.has_events = true;
    header.has_intubation = intubation;
    header.settings[kCordsToCarina] = 0.04;
    {
      TrialLogWriter log(path(), header);
      for (int i = 0; i < 3; ++i) log.append(random_tick(random, intubation));
      log.append(LogEvent{1, LogEvent::Kind::shown, 2, 0});
      log.append(LogEvent{2, LogEvent::Kind::answered, 2, 3});
      EXPECT_NE(error_of<TrialLogError>([&] {
                  log.append(LogEvent{3, LogEvent::Kind::silenced, 1, 0});
                }).find("has not been written"),
                std::string::npos);
    }  // cut off: what stands in the part is all there is
    const TrialLog log = read_trial_log(part());
    EXPECT_EQ(log.header.schema, 4) << "older programs must not miss them";
    EXPECT_EQ(log.header.has_intubation, intubation);
    ASSERT_EQ(log.ticks.size(), 3u);
    ASSERT_EQ(log.events.size(), 2u);
    EXPECT_EQ(log.events[0].kind, LogEvent::Kind::shown);
    EXPECT_EQ(log.events[1].kind, LogEvent::Kind::answered);
    EXPECT_EQ(log.events[1].tick, 2);
    EXPECT_EQ(log.events[1].distraction, 2);
    EXPECT_EQ(log.events[1].answer, 3);
  }
  TrialLogWriter log(path(), LogHeader{});
  log.append(random_tick(random));
  EXPECT_NE(error_of<TrialLogError>([&] {
              log.append(LogEvent{0, LogEvent::Kind::shown, 1, 0});
            }).find("names no events"),
            std::string::npos);
  EXPECT_NE(error_of<TrialLogError>([] {
              log_format::event_from_json(R"({"tick":1,"kind":"sung","distraction":1,"answer":0})");
            }).find("'sung' is unknown"),
            std::string::npos);
  EXPECT_NE(error_of<TrialLogError>([] {
              log_format::event_from_json(R"({"tick":1,"kind":"shown","distraction":0,"answer":0})");
            }).find("out of range"),
            std::string::npos);
}

TEST_F(TrialLogFile, AnIntubationsDepthMustBeKnown) {
  for (const double wrong : {0.0, -0.05}) {
    LogHeader header = sample_header(true);
    header.settings[kCordsToCarina] = wrong;
    EXPECT_NE(error_of<TrialLogError>([&] { TrialLogWriter(path(), header); }).find("cords_to_carina_m"),
              std::string::npos);
  }
  std::string json = log_format::header_to_json(sample_header(true));
  json.replace(json.find("cords_to_carina_m"), 17, "cords_to_carina_n");
  EXPECT_NE(error_of<TrialLogError>([&] { log_format::header_from_json(json); }).find("cords_to_carina_m"),
            std::string::npos);
}

TEST_F(TrialLogFile, WhatAnIntubationDoesNotKnowIsRefused) {
  LogTick tick;
  tick.has_intubation = true;
  std::string good;
  log_format::put_tick(good, tick, false);
  ASSERT_EQ(good.size(), kTickWithIntubation);
  // Places by the layout: pose 56, valid 1, in hand 1, tip and direction 48, place 1, side 1, ... what is before the
  // tip 276.
  const struct {
    std::size_t at;
    int first_unknown;
    const char* what;
  } cases[] = {
      {57, 3, "thing in hand"}, {106, 6, "place"}, {107, 2, "main bronchus"}, {276, 11, "thing before the tip"}};
  for (const auto& c : cases) {
    std::string bytes = good;
    bytes[kTick + c.at] = static_cast<char>(c.first_unknown - 1);
    EXPECT_NO_THROW(log_format::get_tick(bytes.data(), true, false)) << c.what;
    bytes[kTick + c.at] = static_cast<char>(c.first_unknown);
    EXPECT_NE(error_of<TrialLogError>([&] { log_format::get_tick(bytes.data(), true, false); }).find(c.what),
              std::string::npos);
  }
  EXPECT_NO_THROW(log_format::get_tick(good.data(), true, false));  // 255: nothing is before the tip
}

TEST_F(TrialLogFile, GivesBackEveryBit) {
  for (const int ticks : {0, 1, kTicksPerBlock - 1, kTicksPerBlock, kTicksPerBlock + 1, 1000, -1000}) {
    const bool intubation = ticks < 0;
    const auto written = write_log(path(), std::abs(ticks), sample_footer(), intubation);
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
      const LogHeader expected = sample_header(intubation), &header = log.header;
      EXPECT_EQ(header.has_intubation, intubation);
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

class TrialLogOfEitherKind : public TrialLogFile, public ::testing::WithParamInterface<bool> {
 protected:
  std::size_t tick_bytes() const { return GetParam() ? kTickWithIntubation : kTick; }
};
INSTANTIATE_TEST_SUITE_P(Intubation, TrialLogOfEitherKind, ::testing::Bool());

TEST_P(TrialLogOfEitherKind, CutAnywhereItIsRecoveredToTheLastWholeBlock) {
  const auto written = write_log(path(), 2 * kTicksPerBlock + 10, sample_footer(), GetParam());
  const std::string whole = read(path());
  const std::size_t first_ticks = whole.find("TICK"), tick = tick_bytes();
  const std::size_t block = kBlockHead + kTicksPerBlock * tick + kChecksum;
  const std::size_t third_ticks = first_ticks + 2 * block, footer = third_ticks + kBlockHead + 10 * tick + kChecksum;
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

TEST_P(TrialLogOfEitherKind, AnyChangedByteIsNoticed) {
  {
    LogHeader small;
    small.scenario_id = "term";
    small.has_intubation = GetParam();
    small.settings[kCordsToCarina] = 0.05;
    TrialLogWriter writer(path(), small);
    LogTick tick;
    tick.has_intubation = GetParam();
    for (int i = 0; i < 2; ++i) writer.append(tick);
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

TEST_P(TrialLogOfEitherKind, SwappedRepeatedAndTrailingBlocksAreNoticed) {
  write_log(path(), 2 * kTicksPerBlock, sample_footer(), GetParam());
  const std::string whole = read(path());
  const std::size_t first = whole.find("TICK"), size = kBlockHead + kTicksPerBlock * tick_bytes() + kChecksum;
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
