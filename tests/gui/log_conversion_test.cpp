// Nothing of a tick is lost or overlooked between the engine's words and the log's.
#include "gui/session/log_conversion.h"

#include <gtest/gtest.h>

#include <set>

#include "curricula/trial_log_format.h"

namespace vallecula::gui {
namespace {

using curricula::LogTick;

std::string bytes_of(const LogTick& tick) {
  std::string bytes;
  curricula::log_format::put_tick(bytes, tick, true);
  return bytes;
}

LogTick some_tick(bool intubation) {
  LogTick tick;
  tick.has_areas = true;
  tick.has_intubation = intubation;
  tick.intubation.tip_against = curricula::kTubeTongue;
  tick.intubation.side = 0;  // its last bit changed is 1, a side as well
  return tick;
}

// The log's bytes stand for its fields: whichever of them differs in its last bit, replay must tell, and the way
// through the engine's record must keep it.
TEST(LogConversion, EveryByteOfATickIsKeptAndCompared) {
  for (const bool intubation : {false, true}) {
    const LogTick tick = some_tick(intubation);
    const std::string bytes = bytes_of(tick);
    ASSERT_EQ(bytes.size(), curricula::log_format::tick_bytes(intubation, true));
    EXPECT_EQ(bytes_of(to_log(from_log(tick))), bytes);
    EXPECT_EQ(first_difference(tick, tick).field, "");
    std::set<std::string> names;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string other = bytes;
      other[at] = static_cast<char>(other[at] ^ 1);
      const LogTick changed = curricula::log_format::get_tick(other.data(), intubation, true);
      EXPECT_EQ(bytes_of(to_log(from_log(changed))), other) << "byte " << at;
      const std::string field = first_difference(tick, changed).field;
      EXPECT_NE(field, "") << "byte " << at;
      names.insert(field);
    }
    EXPECT_EQ(names.count("intubation.loads_n[10]"), intubation ? 1u : 0u);
    EXPECT_EQ(names.count("intubation.hand_pose.rotation_wxyz[3]"), intubation ? 1u : 0u);
    EXPECT_EQ(names.count("faults"), 1u);
  }
  EXPECT_EQ(first_difference(some_tick(false), some_tick(true)).field, "has_intubation");
  LogTick older = some_tick(false), again = older;
  again.loads[0].area_m2 = 1e-5;
  EXPECT_EQ(first_difference(older, again).field, "loads.tongue.area_m2");
  older.has_areas = false;
  EXPECT_EQ(first_difference(older, again).field, "") << "an older log knows no areas";
}

TEST(LogConversion, SettingsNameTheTubeAndTheWayToTheCarina) {
  engine::SceneDescription scene;
  EXPECT_EQ(settings_of(scene).count(curricula::kCordsToCarina), 0u) << "laryngoscopy alone is what it was";
  engine::IntubationDescription intubation;
  using engine::AirwayPart;
  const auto ring = [&](double y, double z, AirwayPart part) {
    engine::AirwayRing cut;
    cut.centre = {0.0, y, z};
    cut.part = part;
    intubation.course.airway.push_back(cut);
  };
  ring(0.0, 0.006, AirwayPart::vestibule);
  ring(0.0, 0.0, AirwayPart::cords);
  ring(0.003, -0.004, AirwayPart::subglottis);  // 5 mm on
  ring(0.003, -0.009, AirwayPart::cricoid);     // 5 mm
  ring(0.015, -0.014, AirwayPart::trachea);     // 13 mm
  EXPECT_NEAR(cords_to_carina_m(intubation.course), 0.023, 1e-15);
  EXPECT_EQ(cords_to_carina_m(engine::AirwayCourse{}), 0.0);
  intubation.tube = engine::tube_design("3.0");
  scene.intubation = intubation;
  const auto settings = settings_of(scene);
  EXPECT_NEAR(settings.at("cords_to_carina_m"), 0.023, 1e-15);
  EXPECT_EQ(settings.at("infant_breathes"), 0.0);
  EXPECT_EQ(settings.at("tube_outer_diameter_m"), intubation.tube.outer_diameter);
  EXPECT_EQ(settings.at("stylet_diameter_m"), 0.0);
  EXPECT_EQ(settings.count("step_s"), 1u);
  scene.intubation->stylet.emplace();
  scene.intubation->breathes = true;
  EXPECT_EQ(settings_of(scene).at("infant_breathes"), 1.0);
  EXPECT_EQ(settings_of(scene).at("stylet_diameter_m"), engine::Stylet{}.diameter);
}

}  // namespace
}  // namespace vallecula::gui
