#include "pipeline/segment/landmarks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "pipeline/segment/free_line.h"

namespace vallecula::pipeline {
namespace {

bool is_air(std::uint8_t label) { return label == kAirway || label == kBackground; }

/// Calls visit(x, y, z, position) for the voxels of `labels` within `half_mm` of the plane of symmetry.
template <class Visit>
void near_middle(const Segmentation& s, double half_mm, const Visit& visit) {
  const auto& g = s.labels.grid;
  const auto box = box_between(g, {s.frame.mid_x - half_mm, -1e6, -1e6}, {s.frame.mid_x + half_mm, 1e6, 1e6});
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) visit(x, y, z, g.position(x, y, z));
    }
  }
}

/// Height of the tissue's border between a voxel and its neighbour `step` above or below, to a part of a voxel: where
/// the grey value passes through the threshold of air.
double border_height(const Segmentation& s, int x, int y, int z, int step) {
  const auto& g = s.hu.grid;
  const int next = std::clamp(z + step, 0, g.size[2] - 1);
  const double here = s.hu.at(x, y, z);
  const double there = s.hu.at(x, y, next);
  const double part = here > there ? std::clamp((here - s.thresholds.air) / (here - there), 0.0, 1.0) : 0.5;
  return g.origin[2] + (z + step * part) * g.spacing[2];
}

/// Mean over the middle's columns of a border's height, for each y that has one.
class Ridge {
 public:
  explicit Ridge(const Grid& g) : grid_(g), sum_(g.size[1], 0.0), columns_(g.size[1], 0) {}
  void add(int y, double height) {
    sum_[y] += height;
    ++columns_[y];
  }
  bool empty() const {
    return std::all_of(columns_.begin(), columns_.end(), [](int n) { return n == 0; });
  }
  /// Its highest (`up`) or lowest stretch, all within `flat` mm of the extreme: the y of its two ends and the height.
  std::array<double, 3> crest(bool up, double flat) const {
    double best = up ? -1e30 : 1e30;
    for (std::size_t y = 0; y < sum_.size(); ++y) {
      if (columns_[y] > 0) best = up ? std::max(best, sum_[y] / columns_[y]) : std::min(best, sum_[y] / columns_[y]);
    }
    double front = 1e30;
    double back = -1e30;
    for (std::size_t y = 0; y < sum_.size(); ++y) {
      if (columns_[y] == 0 || std::abs(sum_[y] / columns_[y] - best) > flat) continue;
      const double py = grid_.origin[1] + static_cast<double>(y) * grid_.spacing[1];
      front = std::min(front, py);
      back = std::max(back, py);
    }
    return {front, back, best};
  }

 private:
  const Grid& grid_;
  std::vector<double> sum_;
  std::vector<int> columns_;
};

/// Foremost bone of the upper jaw near the middle: the incisive bone between the nose and the mouth.
bool front_of_maxilla(const Segmentation& s, double low_z, double high_z, double back_y, Vector3& front) {
  double best = 1e30;
  near_middle(s, 3.0 * s.frame.scale, [&](int x, int y, int z, const Vector3& p) {
    if (s.labels.at(x, y, z) != kSkull || p[2] < low_z || p[2] > high_z || p[1] > back_y || p[1] >= best) return;
    // A jaw is thick; the wire of a mask on the lip is not.
    const int behind = y + static_cast<int>(std::lround(1.7 * s.frame.scale / s.labels.grid.spacing[1]));
    if (behind >= s.labels.grid.size[1] || s.labels.at(x, behind, z) != kSkull) return;
    best = p[1];
    front = p;
  });
  return best < 1e29;
}

/// The ridge of the upper gum: in the middle, the tissue that hangs lowest under the foremost bone of the upper jaw; of
/// what is as low the foremost.
Vector3 upper_gum(Segmentation& s) {
  const double k = s.frame.scale;
  // The level: about the lips when they are open, else directly above the chin's bone.
  double low = s.airway.glottis.centre[2] + 40.0 * k;
  double high = s.airway.glottis.centre[2] + 62.0 * k;
  double back = s.airway.glottis.centre[1];
  double chin_top = -1e30;
  near_middle(s, 2.0 * k, [&](int x, int y, int z, const Vector3& p) {
    if (s.labels.at(x, y, z) != kMandible || p[2] <= chin_top) return;
    chin_top = p[2];
    back = p[1] + 12.0 * k;
  });
  if (!s.head.lips.empty()) {
    const auto& middle = s.head.lips[s.head.lips.size() / 2];
    low = middle.upper[1] - 6.0 * k;
    high = middle.upper[1] + 10.0 * k;
  } else if (chin_top > -1e29) {
    low = chin_top + 1.0;
    high = chin_top + 25.0 * k;
  }
  Vector3 front{};
  if (!front_of_maxilla(s, low, high, back, front)) {
    s.findings["upper_gum_midline"] = {Origin::from_model,
                                       "no upper jaw seen; placed over the glottis by the term infant's proportions"};
    return s.airway.glottis.centre + k * Vector3{0.0, -33.0, 48.0};
  }
  Vector3 gum = front;
  Ridge ridge(s.labels.grid);
  near_middle(s, 1.2 * k, [&](int x, int y, int z, const Vector3& p) {
    const auto label = s.labels.at(x, y, z);
    if (is_air(label) || label == kTongue || p[1] < front[1] - 2.5 * k || p[1] > front[1] + 5.0 * k ||
        std::abs(p[2] - front[2]) > 7.0 * k)
      return;
    if (z == 0 || !is_air(s.labels.at(x, y, z - 1))) return;
    ridge.add(y, border_height(s, x, y, z, -1));
  });
  if (!ridge.empty()) {
    // The ridge is flat behind its edge: the edge is meant, past which one looks.
    const auto crest = ridge.crest(false, 0.15 * k);
    gum[1] = crest[0];
    gum[2] = crest[2];
  } else {
    s.findings["upper_gum_midline"] = {Origin::inferred,
                                       "the mouth is closed; the lower edge of the upper jaw's bone was taken"};
    near_middle(s, 2.0 * k, [&](int x, int y, int z, const Vector3& p) {
      if (s.labels.at(x, y, z) == kSkull && p[1] < front[1] + 4.0 * k && p[2] > front[2] - 10.0 * k && p[2] < gum[2])
        gum = p;
    });
  }
  gum[0] = s.frame.mid_x;
  return gum;
}

/// The ridge of the lower gum: in the middle, the highest tissue over the bone of the chin.
Vector3 lower_gum(Segmentation& s, const Vector3& upper) {
  const double k = s.frame.scale;
  double bone_top = -1e30;
  Vector3 bone{};
  near_middle(s, 2.0 * k, [&](int x, int y, int z, const Vector3& p) {
    if (s.labels.at(x, y, z) != kMandible || p[2] <= bone_top) return;
    bone_top = p[2];
    bone = p;
  });
  if (bone_top < -1e29) {
    s.findings["lower_gum_midline"] = {Origin::inferred, "no lower jaw seen; placed below the upper gum"};
    return upper + k * Vector3{0.0, 3.2, -20.8};
  }
  Vector3 gum = bone;
  Ridge ridge(s.labels.grid);
  near_middle(s, 1.2 * k, [&](int x, int y, int z, const Vector3& p) {
    const int above = std::min(z + 1, s.labels.grid.size[2] - 1);
    if (s.labels.at(x, y, z) == kSkin && p[1] > bone[1] - 2.0 * k && p[1] < bone[1] + 2.5 * k && p[2] > bone_top - k &&
        p[2] < bone_top + 4.0 * k && is_air(s.labels.at(x, y, above)))
      ridge.add(y, border_height(s, x, y, z, 1));
  });
  if (!ridge.empty()) {
    const auto crest = ridge.crest(true, 0.15 * k);
    gum[1] = 0.5 * (crest[0] + crest[1]);
    gum[2] = crest[2];
  }
  gum[0] = s.frame.mid_x;
  return gum;
}

/// Half way between the two condyles: on each side the top of the mandible's hindmost part.
Vector3 condyles(Segmentation& s, const Vector3& upper) {
  const double k = s.frame.scale;
  const auto& g = s.labels.grid;
  constexpr double kHalfHeight = 2.2;  // of the condyle's head as the threshold shows it, term
  Vector3 sum{};
  for (const double side : {-1.0, 1.0}) {
    double back = -1e30;
    for (std::size_t i = 0; i < g.count(); ++i) {
      if (s.labels.voxels[i] != kMandible) continue;
      const auto p = g.position(i);
      if ((p[0] - s.frame.mid_x) * side > 10.0 * k) back = std::max(back, p[1]);
    }
    if (back < -1e29) {
      s.findings["condyle_axis"] = {Origin::from_model,
                                    "no lower jaw seen; placed behind the upper gum by the term infant's proportions"};
      return upper + k * Vector3{0.0, 46.7, -6.3};
    }
    double top = -1e30;
    const auto hind = [&](const Vector3& p) {
      return (p[0] - s.frame.mid_x) * side > 10.0 * k && p[1] > back - 7.0 * k;
    };
    for (std::size_t i = 0; i < g.count(); ++i) {
      if (s.labels.voxels[i] == kMandible && hind(g.position(i))) top = std::max(top, g.position(i)[2]);
    }
    Vector3 mean{};
    double n = 0.0;
    for (std::size_t i = 0; i < g.count(); ++i) {
      if (s.labels.voxels[i] != kMandible) continue;
      const auto p = g.position(i);
      // The upper half of its head; below, the neck leans forwards.
      if (!hind(p) || p[2] < top - kHalfHeight * k) continue;
      mean = mean + p;
      n += 1.0;
    }
    mean = (1.0 / n) * mean;
    mean[2] = top - kHalfHeight * k;
    sum = sum + 0.5 * mean;
  }
  sum[0] = s.frame.mid_x;
  return sum;
}

/// Mean of the hyoid's body, without its horns; false when none of its bone lies near the middle.
bool middle_of_hyoid(const Segmentation& s, Vector3& middle) {
  Vector3 sum{};
  double n = 0.0;
  const auto& g = s.bones.hyoid.grid;
  for (std::size_t i = 0; i < g.count(); ++i) {
    if (s.bones.hyoid.voxels[i] == 0) continue;
    const auto p = g.position(i);
    if (std::abs(p[0] - s.frame.mid_x) > 2.5 * s.frame.scale) continue;
    sum = sum + p;
    n += 1.0;
  }
  if (n == 0.0) return false;
  middle = (1.0 / n) * sum;
  middle[0] = s.frame.mid_x;
  return true;
}

/// Where the operator's eye is when the line from the glottis passes the upper gum `turn` (rad) clear of it. 320 mm from
/// the gum whatever the patient's size: that is the operator's own measure.
Vector3 eye_past(const Vector3& gum, const Vector3& glottis, double turn) {
  constexpr double kEyeToGum = 320.0;
  const double gy = gum[1] - glottis[1];
  const double gz = gum[2] - glottis[2];
  const double length = std::hypot(gy, gz);
  // Turned away from the gum, towards the tongue: forwards.
  const double dy = (std::cos(turn) * gy - std::sin(turn) * gz) / length;
  const double dz = (std::sin(turn) * gy + std::cos(turn) * gz) / length;
  const double along = dy * gy + dz * gz;
  const double off2 = length * length - along * along;
  const double t = along + std::sqrt(std::max(0.0, kEyeToGum * kEyeToGum - off2));
  return {gum[0], glottis[1] + t * dy, glottis[2] + t * dz};
}

/// The operator looks past the upper gum as steeply as it allows: 3.6 mm (term) clear of it, which is how the manikin's
/// line of sight was designed (ANATOMY). Where the mouth was opened or the neck extended after the scan and a lip or a tooth stands before the
/// gum, from where most can be seen; past a gum that a person placed (`gum_given`) as the rule has it.
Vector3 operator_eye(Segmentation& s, const Vector3& gum, bool gum_given) {
  constexpr double kClearEnough = 0.8;
  constexpr double kStep = 0.25 * 3.14159265358979323846 / 180.0;
  constexpr int kLower = 60;  ///< steps: 15 degrees
  const auto& glottis = s.airway.glottis.centre;
  const double length = std::hypot(gum[1] - glottis[1], gum[2] - glottis[2]);
  const double turn = std::asin(std::clamp(3.6 * s.frame.scale / length, 0.0, 0.5));
  const auto planned = eye_past(gum, glottis, turn);
  if (gum_given || (s.pose.mouth_opened_deg == 0.0 && s.pose.extension_deg == 0.0)) return planned;
  double most = free_share(s, planned);
  if (most >= kClearEnough) return planned;
  double chosen = turn;
  for (int n = -static_cast<int>(turn / kStep); n <= kLower; ++n) {
    const double share = free_share(s, eye_past(gum, glottis, turn + n * kStep));
    if (share <= most) continue;
    most = share;
    chosen = turn + n * kStep;
  }
  if (chosen == turn) return planned;
  s.findings["operator_eye"] = {Origin::inferred,
                                "a lip, a tooth or the throat stands in the usual line past the upper gum; placed where "
                                "most of the glottis could be seen past what does not give way"};
  return eye_past(gum, glottis, chosen);
}

}  // namespace

void find_landmarks(Segmentation& s, const std::map<std::string, Point>& given) {
  const double k = s.frame.scale;
  auto& m = s.landmarks;
  /// The landmark given under a name, else what is found.
  const auto or_found = [&](const char* name, const auto& find) -> Vector3 {
    const auto there = given.find(name);
    return there != given.end() ? there->second : Vector3(find());
  };
  const auto upper = or_found("upper_gum_midline", [&] { return upper_gum(s); });
  const auto glottis = s.airway.glottis.centre;
  m["upper_gum_midline"] = upper;
  m["lower_gum_midline"] = or_found("lower_gum_midline", [&] { return lower_gum(s, upper); });
  m["glottis_centre"] = glottis;
  m["glottis_normal"] = s.airway.glottis.normal;
  m["carina"] = s.airway.carina;
  if (!s.airway.carina_seen) {
    char how[160];
    std::snprintf(how, sizeof how,
                  "below the scan; continued along the trachea, in the scan %.1f mm below the cords (a term infant's "
                  "50.4 mm, grown with the head)",
                  norm(Vector3(s.airway.carina) - Vector3(glottis)));
    s.findings["carina"] = {Origin::inferred, how};
  }
  if (s.epiglottis.seen) {
    m["vallecula"] = s.epiglottis.vallecula;
    m["epiglottis_tip"] = s.epiglottis.tip;
  } else {
    const auto by_proportion = [&](const char* name, const Vector3& from_commissure) {
      return or_found(name, [&] {
        s.findings[name] = {Origin::from_model,
                            "no free leaf seen; placed above the front commissure by the term infant's proportions"};
        return s.airway.front_commissure + k * from_commissure;
      });
    };
    m["vallecula"] = by_proportion("vallecula", {0.0, -1.1, 7.4});
    m["epiglottis_tip"] = by_proportion("epiglottis_tip", {0.0, 6.9, 14.1});
  }
  m["hyoid"] = or_found("hyoid", [&]() -> Vector3 {
    Vector3 middle{};
    if (s.bones.hyoid_seen && middle_of_hyoid(s, middle)) return middle;
    s.findings["hyoid"] = {Origin::from_model,
                           "no bone seen; placed in front of the vallecula by the term infant's proportions"};
    return Vector3(m["vallecula"]) + k * Vector3{0.0, -6.0, 0.0};
  });
  m["condyle_axis"] = or_found("condyle_axis", [&] { return condyles(s, upper); });
  m["operator_eye"] = or_found("operator_eye", [&] { return operator_eye(s, upper, given.count("upper_gum_midline") > 0); });
  for (const auto* name : kLandmarks) {
    for (const double v : m.at(name)) {
      if (!std::isfinite(v))
        throw std::runtime_error(std::string("the landmark ") + name +
                                 " could not be found; the series must show the head from above the palate to the "
                                 "trachea");
    }
  }
}

}  // namespace vallecula::pipeline
