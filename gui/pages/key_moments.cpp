#include "gui/pages/key_moments.h"

#include <algorithm>

namespace vallecula::gui {
namespace {

constexpr double kAtTheLips = -0.15, kSweeping = 0.42, kLeaving = 0.15;  // of the way from the gums to the glottis
constexpr double kClearlyMore = 0.06;                                    // of the glottis
constexpr double kPastCords = 0.010, kClearlyDeeper = 0.002;             // m
constexpr double kBeforeCords = 0.004;                                   // m: the tip is seen, and so are the cords
constexpr double kValleculaShare = 0.09;  // of the same way: 5 mm in a term infant, there

engine::Vec3 metres(const pipeline::PatientPackage& package, const char* name) {
  const auto& p = package.landmarks.at(name);
  return 1e-3 * engine::Vec3(p[0], p[1], p[2]);
}

}  // namespace

KeyMoments::KeyMoments(const pipeline::PatientPackage& package, double sight_percent)
    : mouth_(0.5 * (metres(package, "upper_gum_midline") + metres(package, "lower_gum_midline"))),
      glottis_(metres(package, "glottis_centre")),
      vallecula_(metres(package, "vallecula")),
      sight_(sight_percent / 100.0),
      reach_m_(kValleculaShare * (glottis_ - mouth_).norm()) {}

double KeyMoments::depth(const engine::Snapshot& snapshot) const {
  const engine::Vec3 way = glottis_ - mouth_;
  return (snapshot.proxy_pose.position - mouth_).dot(way) / way.squaredNorm();
}

std::vector<std::string> KeyMoments::at(const engine::Snapshot& snapshot) {
  std::vector<std::string> moments;
  if (snapshot.step < 0) return moments;
  const double deep = depth(snapshot), seen = snapshot.glottis_visible;
  const auto once = [&moments](bool& done, bool now, const char* name) {
    if (done || !now) return;
    done = true;
    moments.push_back(name);
  };
  once(lips_, deep > kAtTheLips, "1-lips");
  once(sweep_, deep > kSweeping, "2-sweep");
  once(vallecula_reached_, !tip_at_cords_ && (snapshot.proxy_pose.position - vallecula_).norm() < reach_m_,
       "3-vallecula");
  once(seen_, seen >= sight_, "4-first-sight");
  if (seen_ && seen > best_ + (best_ > 0.0 ? kClearlyMore : 0.0)) {
    best_ = seen;
    moments.push_back("5-best-sight");
  }
  if (!snapshot.has_intubation) {
    once(out_, (seen_ || vallecula_reached_) && deep < kLeaving, "6-withdrawal");
    return moments;
  }
  const engine::IntubationRecord& tube = snapshot.intubation;
  const bool in_airway = tube.place == engine::TipPlace::larynx || tube.place == engine::TipPlace::trachea;
  once(tip_at_cords_, in_airway && tube.past_cords_m > -kBeforeCords, "6-tip-at-cords");
  if (in_airway && deep >= kLeaving && tube.past_cords_m > std::max(kPastCords, deepest_m_ + kClearlyDeeper)) {
    deepest_m_ = tube.past_cords_m;
    moments.push_back("7-between-cords");
  }
  once(out_, tip_at_cords_ && deep < kLeaving, "8-withdrawal");
  once(yellow_, tube.detector_yellow, "9-detector-yellow");
  return moments;
}

}  // namespace vallecula::gui
