// dev only
#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include "curricula/trial_log.h"
#include "engine/haptics/runner.h"
#include "gui/session/replay.h"
namespace vallecula::gui::test {
TEST(PlayDump, Dump) {
  const auto log = curricula::read_trial_log(std::getenv("LOG"));
  const int every = std::getenv("EVERY") ? std::atoi(std::getenv("EVERY")) : 500;
  std::printf("carina at %.1f\n", 1e3 * log.header.settings.at("cords_to_carina_m"));
  for (const auto& t : log.ticks) {
    if (t.tick % every) continue;
    const auto& i = t.intubation;
    std::printf("%6.2f v%d%d place %d past %6.2f mouth %5.1f tip %6.1f %6.1f %6.1f buck %4.1f F %5.2f tipload %5.2f ag %3d see %3.0f open %.2f sp %.0f hr %.0f y%d br %d in %d ton %.2f gum %.2f |", t.time_s, t.device_valid, i.hand_valid, int(i.place), 1e3*i.past_cords_m, 1e3*i.at_mouth_m, 1e3*i.tip_m[0], 1e3*i.tip_m[1], 1e3*i.tip_m[2], 1e3*i.buckled_m, std::sqrt(i.model_force_n[0]*i.model_force_n[0]+i.model_force_n[1]*i.model_force_n[1]+i.model_force_n[2]*i.model_force_n[2]), i.tip_load_n, i.tip_against, 100*t.glottis_visible, i.glottis_opening, 100*i.spo2, i.heart_per_min, i.detector_yellow, i.breaths_given, int(i.in_hand), std::abs(t.loads[0].force_n[1]), std::abs(t.loads[2].force_n[1]));
    for (double l : i.loads_n) std::printf(" %.2f", l);
    std::printf("\n");
  }
}

TEST(PlayDump, Axis) {
  const auto log = curricula::read_trial_log(std::getenv("LOG"));
  const auto rs = recorded_scene(log, std::getenv("LOG"), {});
  engine::Replayer replayer(engine::build_scene(rs.description));
  const auto& course = rs.description.intubation->course;
  for (const auto& t : log.ticks) {
    replayer.replay(from_log(t));
    if (t.tick % 500 || t.time_s < std::atof(std::getenv("FROM"))) continue;
    if (t.time_s > std::atof(std::getenv("TO"))) break;
    const auto& s = replayer.snapshot();
    const auto& h = s.body_displacement[1];
    std::printf("%.2f larynx way %.2f %.2f %.2f\n", t.time_s, 300 * h.x(), 300 * h.y(), 300 * h.z());
    for (int i = 0; i < 26; ++i) {
      const auto& p = s.tube_axis[i];
      // nearest ring plane
      double best = 1e9; int k = -1;
      for (std::size_t j = 0; j < course.airway.size(); ++j) {
        const double d = std::abs(course.airway[j].along.dot(p - course.airway[j].centre - course.airway[j].larynx_share * h));
        if (d < best) best = d, k = int(j);
      }
      const auto& r = course.airway[k];
      const engine::Vec3 off = p - r.centre - r.larynx_share * h;
      const engine::Vec3 front = r.along.cross(r.left);
      std::printf("   node %d at %.1f %.1f %.1f ring %d part %d off left %.2f front %.2f along %.2f\n", i, 1e3*p.x(), 1e3*p.y(), 1e3*p.z(), k, int(r.part), 1e3*off.dot(r.left), 1e3*off.dot(front), 1e3*off.dot(r.along));
    }
  }
}
}
