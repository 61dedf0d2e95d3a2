#include "pipeline/pose/resample.h"

#include <algorithm>
#include <cmath>

namespace vallecula::pipeline {
namespace {

constexpr std::int16_t kAirHu = -1000;

/// The share of a voxel that belongs to a mask, smooth over about a voxel, on the mask's own box.
class Share {
 public:
  explicit Share(const Mask& mask) {
    const auto& s = mask.grid.spacing;
    const double sigma = std::max(0.8 * std::max(s[0], s[1]), 0.45 * s[2]);
    const auto part = cropped(mask, bounds_of(mask, 4.0 * sigma));
    if (part.voxels.empty()) return;
    share_ = smoothed(to_float(part), sigma);
  }
  double at(const Vector3& p) const {
    if (share_.voxels.empty()) return 0.0;
    const auto& g = share_.grid;
    for (int a = 0; a < 3; ++a) {
      if (p[a] < g.origin[a] || p[a] > g.origin[a] + (g.size[a] - 1) * g.spacing[a]) return 0.0;
    }
    return std::clamp(0.5 + 1.6 * (value_at(share_, p) - 0.5), 0.0, 1.0);
  }
  const Volume<float>& volume() const { return share_; }

 private:
  Volume<float> share_;
};

class Carrier {
 public:
  Carrier(const Segmentation& s, const Aim& aim, const Parts& parts, const Sheets& sheets)
      : s_(s), aim_(aim), parts_(parts), sheets_(sheets), lower_(parts.lower), jaw_(s.bones.mandible) {
    out_.hu = Hounsfield(grid_for(), kAirHu);
    const auto& g = out_.hu.grid;
    out_.labels = Labels(g);
    out_.opened = Mask(g);
    filled_.assign(g.count(), 0);
    best_.assign(g.count(), 0);
    seen_.assign(g.count(), 0);
  }

  Carried run() {
    carry_jaw();
    carry_sheet(kLower);
    carry_sheet(kUpper);
    copy_above();
    finish();
    return std::move(out_);
  }

 private:
  enum Seen : std::uint8_t { kByUpper = 1, kByLower = 2, kByJaw = 4, kLeftByJaw = 8 };

  /// The scan's own grid, with as many voxels more behind and in front as the tissue moves there.
  Grid grid_for() const {
    const auto& g = s_.hu.grid;
    const auto& l = sheets_.lattice();
    double front = 0.0;
    double back = 0.0;
    for (int z = 0; z < l.size[2]; ++z) {
      if (l.origin[2] + z * l.spacing[2] < g.origin[2]) continue;
      for (int x = 0; x < l.size[0]; ++x) {
        front = std::min(front, sheets_.displacement(kUpper, l.index(x, 1, z))[1]);
        back = std::max(back, sheets_.displacement(kUpper, l.index(x, l.size[1] - 2, z))[1]);
      }
    }
    Grid out = g;
    const int before = static_cast<int>(std::ceil(-front / g.spacing[1]));
    out.origin[1] -= before * g.spacing[1];
    out.size[1] += before + static_cast<int>(std::ceil(back / g.spacing[1]));
    return out;
  }

  /// Puts `hu` there with weight `w`, as far as there is room left.
  void put(std::size_t i, double w, double hu, std::uint8_t label) {
    const double room = 1.0 - filled_[i] / 255.0;
    const double kept = std::min(w, room);
    if (kept < w - 0.02 && label != kAirway && label != kBackground && hu > s_.thresholds.air)
      out_.overlap_mm3 += (w - kept) * out_.hu.grid.voxel_mm3();
    if (kept <= 0.0) return;
    const double before = filled_[i] / 255.0;
    out_.hu.voxels[i] = static_cast<std::int16_t>(std::lround((before * out_.hu.voxels[i] + kept * hu) / (before + kept)));
    filled_[i] = static_cast<std::uint8_t>(std::min(255L, std::lround((before + kept) * 255.0)));
    const auto share = static_cast<std::uint8_t>(std::lround(kept * 255.0));
    if (share > best_[i]) {
      best_[i] = share;
      out_.labels.voxels[i] = label;
    }
  }

  /// Grey value of a place in the scan. Tissue given by a person over voxels as dark as air stays tissue where it goes.
  double tissue_at(const Vector3& p, std::size_t j) const {
    return drawn_over_air(j) ? s_.thresholds.soft : grey_at(s_.hu, p);
  }
  bool drawn_over_air(std::size_t j) const {
    return s_.head.body.voxels[j] != 0 && s_.hu.voxels[j] <= s_.thresholds.air;
  }

  std::size_t nearest(const Vector3& p) const {
    auto c = s_.hu.grid.nearest(p);
    for (int a = 0; a < 3; ++a) c[a] = std::clamp(c[a], 0, s_.hu.grid.size[a] - 1);
    return s_.hu.grid.index(c[0], c[1], c[2]);
  }

  void carry_jaw() {
    const auto& from = jaw_.volume();
    if (from.voxels.empty() || aim_.jaw.angle_rad == 0.0) return;
    Vector3 low{1e30, 1e30, 1e30};
    Vector3 high{-1e30, -1e30, -1e30};
    for (int k = 0; k < 8; ++k) {
      const auto p = aim_.jaw(from.grid.position((k & 1) * (from.grid.size[0] - 1), ((k >> 1) & 1) * (from.grid.size[1] - 1),
                                                 (k >> 2) * (from.grid.size[2] - 1)));
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
    }
    const auto& g = out_.hu.grid;
    const auto box = box_between(g, low, high);
    for (int z = box.low[2]; z <= box.high[2]; ++z) {
      for (int y = box.low[1]; y <= box.high[1]; ++y) {
        for (int x = box.low[0]; x <= box.high[0]; ++x) {
          const auto p = aim_.jaw.back(g.position(x, y, z));
          const double w = jaw_.at(p);
          if (w < 0.01) continue;
          const auto i = g.index(x, y, z);
          seen_[i] |= kByJaw;
          const auto j = nearest(p);
          const bool own = s_.bones.mandible.voxels[j] != 0;
          put(i, w, tissue_at(p, j), own ? kMandible : kSkin);
          // Voxel by voxel: a share smoothed over thin plates of bone is nowhere the larger one.
          if (!own) continue;
          out_.labels.voxels[i] = kMandible;
          best_[i] = 255;
        }
      }
    }
  }

  void carry_sheet(Sheet sheet) {
    const auto& l = sheets_.lattice();
    for (int z = 0; z + 1 < l.size[2]; ++z) {
      for (int y = 0; y + 1 < l.size[1]; ++y) {
        for (int x = 0; x + 1 < l.size[0]; ++x) {
          if (sheet == kUpper ? has_upper(x, y, z) : has_lower(x, y, z)) carry_cell(sheet, x, y, z);
        }
      }
    }
  }

  /// Cells beside those with the sheet hold the rim of its smooth border.
  template <class Test>
  bool around(int x, int y, int z, const Test& test) const {
    const auto& l = sheets_.lattice();
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (l.contains(x + dx, y + dy, z + dz) && test(l.index(x + dx, y + dy, z + dz))) return true;
        }
      }
    }
    return false;
  }
  bool has_upper(int x, int y, int z) const {
    return around(x, y, z, [&](std::size_t i) { return sheets_.content(kUpper, i) > 0.0; });
  }
  bool has_lower(int x, int y, int z) const {
    return around(x, y, z, [&](std::size_t i) { return sheets_.content(kLower, i) > 0.0; });
  }

  void carry_cell(Sheet sheet, int x, int y, int z) {
    const auto& l = sheets_.lattice();
    std::array<Vector3, 8> at{};
    std::array<Vector3, 8> to{};
    for (int k = 0; k < 8; ++k) {
      const int cx = x + (k & 1);
      const int cy = y + ((k >> 1) & 1);
      const int cz = z + (k >> 2);
      at[k] = l.position(cx, cy, cz);
      to[k] = at[k] + sheets_.displacement(sheet, l.index(cx, cy, cz));
    }
    for (const auto& t : kCellTets) carry_tet(sheet, {at[t[0]], at[t[1]], at[t[2]], at[t[3]]},
                                              {to[t[0]], to[t[1]], to[t[2]], to[t[3]]});
  }

  void carry_tet(Sheet sheet, const std::array<Vector3, 4>& at, const std::array<Vector3, 4>& to) {
    const auto& g = out_.hu.grid;
    const Vector3 e1 = to[1] - to[0];
    const Vector3 e2 = to[2] - to[0];
    const Vector3 e3 = to[3] - to[0];
    const double det = dot(cross(e1, e2), e3);
    if (!(det > 1e-9)) return;
    const Vector3 r1 = (1.0 / det) * cross(e2, e3);
    const Vector3 r2 = (1.0 / det) * cross(e3, e1);
    const Vector3 r3 = (1.0 / det) * cross(e1, e2);
    const bool still = to == at;
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    for (int a = 0; a < 3; ++a) {
      const auto [min, max] = std::minmax({to[0][a], to[1][a], to[2][a], to[3][a]});
      low[a] = std::max(0, static_cast<int>(std::ceil((min - g.origin[a]) / g.spacing[a] - 1e-9)));
      high[a] = std::min(g.size[a] - 1, static_cast<int>(std::floor((max - g.origin[a]) / g.spacing[a] + 1e-9)));
    }
    const std::uint8_t mine = sheet == kUpper ? kByUpper : kByLower;
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int x = low[0]; x <= high[0]; ++x) {
          const auto i = g.index(x, y, z);
          if ((seen_[i] & mine) != 0) continue;
          const Vector3 p = g.position(x, y, z);
          const Vector3 d = p - to[0];
          const double b1 = dot(r1, d);
          const double b2 = dot(r2, d);
          const double b3 = dot(r3, d);
          constexpr double kEdge = -1e-9;
          if (b1 < kEdge || b2 < kEdge || b3 < kEdge || b1 + b2 + b3 > 1.0 - kEdge) continue;
          const Vector3 from = still ? p : at[0] + b1 * (at[1] - at[0]) + b2 * (at[2] - at[0]) + b3 * (at[3] - at[0]);
          if (sheet == kUpper ? put_upper(i, from) : put_lower(i, from)) seen_[i] |= mine;
        }
      }
    }
  }

  bool put_lower(std::size_t i, const Vector3& from) {
    const double w = lower_.at(from);
    if (w < 0.01) return false;
    // At the rim the grey values of what it lay against are not its own.
    const double hu = std::clamp(grey_at(s_.hu, from), s_.thresholds.soft - 150.0, s_.thresholds.soft + 120.0);
    put(i, w, hu, lower_label(from));
    return true;
  }

  /// Tongue or lip; at the rim what the nearest of them is.
  std::uint8_t lower_label(const Vector3& from) const {
    const auto i = nearest(from);
    if (parts_.lower.voxels[i] != 0) return s_.labels.voxels[i];
    const auto& spacing = s_.hu.grid.spacing;
    for (int a = 0; a < 3; ++a) {
      for (const double side : {-1.0, 1.0}) {
        Vector3 p = from;
        p[a] += side * spacing[a];
        if (s_.labels.voxels[nearest(p)] == kTongue) return kTongue;
      }
    }
    return kSkin;
  }

  bool put_upper(std::size_t i, const Vector3& from) {
    const double below = lower_.at(from);
    const double jaw = aim_.jaw.angle_rad != 0.0 ? jaw_.at(from) : 0.0;
    if (jaw > 0.3) seen_[i] |= kLeftByJaw;
    const double w = 1.0 - std::min(1.0, below + jaw);
    if (w < 0.01) return false;
    const auto j = nearest(from);
    auto label = s_.labels.voxels[j];
    double hu = tissue_at(from, j);
    if (label == kTongue || label == kMandible) label = kSkin;  // their rims
    if (s_.head.body.voxels[j] == 0 && hu > s_.thresholds.air) hu = kAirHu;  // couch, mask
    // The scan ends, the neck does not; but the airways end there.
    if (from[2] < s_.hu.grid.origin[2] - 0.5 * s_.hu.grid.spacing[2] && s_.head.inside.voxels[j] != 0) {
      hu = s_.thresholds.soft;
      label = kSkin;
    }
    put(i, w, hu, label);
    return true;
  }

  /// Above the lattice nothing moves.
  void copy_above() {
    const auto& from = s_.hu.grid;
    const auto& g = out_.hu.grid;
    const int dy = static_cast<int>(std::lround((from.origin[1] - g.origin[1]) / g.spacing[1]));
    const double top = parts_.top_z;
    for (int z = 0; z < from.size[2]; ++z) {
      if (from.origin[2] + z * from.spacing[2] < top) continue;
      for (int y = 0; y < from.size[1]; ++y) {
        for (int x = 0; x < from.size[0]; ++x) {
          const auto i = g.index(x, y + dy, z);
          const auto j = from.index(x, y, z);
          if (filled_[i] != 0 && (seen_[i] & kByJaw) != 0) continue;
          out_.hu.voxels[i] = s_.hu.voxels[j];
          if (drawn_over_air(j)) out_.hu.voxels[i] = static_cast<std::int16_t>(std::lround(s_.thresholds.soft));
          if (s_.head.body.voxels[j] == 0 && s_.hu.voxels[j] > s_.thresholds.air) out_.hu.voxels[i] = kAirHu;
          const bool left = s_.labels.voxels[j] == kMandible && aim_.jaw.angle_rad != 0.0;
          out_.labels.voxels[i] = left ? static_cast<std::uint8_t>(kSkin) : s_.labels.voxels[j];
          filled_[i] = 255;
        }
      }
    }
  }

  void finish() {
    for (std::size_t i = 0; i < filled_.size(); ++i) {
      const double w = filled_[i] / 255.0;
      if (filled_[i] >= 250) continue;
      auto& hu = out_.hu.voxels[i];
      if ((seen_[i] & kLeftByJaw) != 0) {
        hu = static_cast<std::int16_t>(std::lround(w * hu + (1.0 - w) * s_.thresholds.soft));
        if (w < 0.5) out_.labels.voxels[i] = kSkin;
        continue;
      }
      hu = static_cast<std::int16_t>(std::lround(w * hu + (1.0 - w) * kAirHu));
      if (hu < s_.thresholds.air) {
        out_.opened.voxels[i] = 1;
        out_.labels.voxels[i] = kBackground;
      }
    }
  }

  const Segmentation& s_;
  const Aim& aim_;
  const Parts& parts_;
  const Sheets& sheets_;
  Share lower_;
  Share jaw_;
  Carried out_;
  std::vector<std::uint8_t> filled_;  ///< share of the voxel that is known, of 255
  std::vector<std::uint8_t> best_;    ///< share of the label's own part
  std::vector<std::uint8_t> seen_;
};

}  // namespace

Carried carry(const Segmentation& s, const Aim& aim, const Parts& parts, const Sheets& sheets) {
  return Carrier(s, aim, parts, sheets).run();
}

}  // namespace vallecula::pipeline
