// The paper's figures 2 and 3: the inner spheres in the tongue.
#include <QJsonArray>
#include <algorithm>

#include "engine/aist/sphere_tree.h"
#include "engine/mesh/soft_mesh.h"
#include "gui/lab/figures.h"
#include "gui/lab/plot.h"
#include "gui/lab/tongue_rig.h"

namespace vallecula::gui {

namespace {

constexpr int kSamples = 20000;
// The paper's colours: blue the coarse level, green the split cells', orange what `full` adds at the surface.
const QColor kLevels[] = {QColor(0x2F, 0x6F, 0xB5), QColor(0x2E, 0xA0, 0x5C), QColor(0xE6, 0x9F, 0x00),
                          QColor(0xCC, 0x79, 0xA7)};
const QColor kWire(0x7A, 0x3B, 0x8F);  // purple, as in figure 3
constexpr int kLevelColours = 4;

int colour_of(int level) { return std::min(level, kLevelColours - 1); }

QImage picture_of(const TongueRig& rig, const engine::SphereTree& tree, bool half) {
  TissuePicture picture(900, 620);
  for (int level = 0; level < kLevelColours; ++level) {
    std::vector<TissuePicture::Ball> balls;
    for (const engine::InnerSphere& s : tree.spheres)
      if (colour_of(s.level) == level && (!half || s.centre.x() > 0)) balls.push_back({s.centre, s.radius});
    if (!balls.empty()) picture.add_balls(balls, kLevels[level]);
  }
  picture.add_wireframe(rig.description().soft.nodes, rig.skin(), kWire, half ? 0.25 : 0.5);
  rig.aim(picture, 0.043, -0.001);
  return picture.still();
}

QJsonObject write_one(const FigureSetting& setting, const TongueRig& rig, engine::Coverage coverage,
                      const std::string& name, const QString& title, FigureResult& result) {
  const auto& soft = rig.description().soft;
  const engine::SoftSurface surface = engine::extract_surface(soft.tets);
  engine::FillSettings fill;
  fill.coverage = coverage;
  const engine::SphereTree tree = engine::fill_spheres(soft, surface, fill);
  const engine::CoverageReport covered = engine::measure_coverage(tree, soft, surface, kSamples);

  Sheet sheet;
  sheet.title = title;
  sheet.pictures = {{picture_of(rig, tree, false), QStringLiteral("all spheres; the tongue's surface as wires")},
                    {picture_of(rig, tree, true), QStringLiteral("the left half only: cut open in the midline")}};
  QJsonArray per_level;
  for (std::size_t level = 0; level < tree.spheres_per_level.size(); ++level) {
    double low = 1.0, high = 0.0;
    for (const engine::InnerSphere& s : tree.spheres)
      if (s.level == static_cast<int>(level)) {
        low = std::min(low, s.radius);
        high = std::max(high, s.radius);
      }
    const int count = tree.spheres_per_level[level];
    per_level.append(QJsonObject{{"spheres", count}, {"radius_min_mm", 1e3 * low}, {"radius_max_mm", 1e3 * high}});
    if (count == 0) continue;
    const QString radius =
        high - low < 1e-6 ? said(1e3 * high) : said(1e3 * low) + QStringLiteral(" to ") + said(1e3 * high);
    sheet.keys.push_back({kLevels[colour_of(static_cast<int>(level))],
                          QStringLiteral("level %1: %2 spheres, radius %3 mm").arg(level).arg(count).arg(radius)});
  }
  sheet.seen = QStringLiteral(
                   "%1 tetrahedra of %2 mm3 on average. Of the surface %3 % lies within 0.25 mm of a sphere; the gap "
                   "is %4 mm on average and %5 mm at most.")
                   .arg(soft.tets.size())
                   .arg(said(1e9 * tree.mean_tet_volume), said(100 * covered.covered_fraction),
                        said(1e3 * covered.mean_gap_m), said(1e3 * covered.uncovered_depth_m));
  write_figure_png(setting, name, draw_sheet(sheet), result);
  result.seen += (result.seen.isEmpty() ? "" : "\n") + title + ": " + sheet.seen;
  return {{"levels", per_level},
          {"covered_surface_fraction", covered.covered_fraction},
          {"mean_gap_mm", 1e3 * covered.mean_gap_m},
          {"uncovered_depth_mm", 1e3 * covered.uncovered_depth_m}};
}

}  // namespace

FigureResult write_figure_spheres(const FigureSetting& setting) {
  const TongueRig rig(setting);
  FigureResult result;
  const QJsonObject paper = write_one(setting, rig, engine::Coverage::paper, "spheres-paper.png",
                                      QStringLiteral("Figures 2 and 3: inner spheres by the paper's rule"), result);
  const QJsonObject full = write_one(setting, rig, engine::Coverage::full, "spheres-full.png",
                                     QStringLiteral("The same tongue, covered in full (the default)"), result);
  write_figure_json(
      setting, "spheres.json",
      {{"figure", "spheres"}, {"settings", rig.about()}, {"paper", paper}, {"full", full}, {"seen", result.seen}},
      result);
  return result;
}

}  // namespace vallecula::gui
