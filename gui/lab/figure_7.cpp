// The paper's figure 7: the hand goes far past what the device can give, holds, and lets go at once.
#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "engine/lab/experiment.h"
#include "gui/lab/figures.h"
#include "gui/lab/plot.h"
#include "gui/lab/tongue_rig.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;

const QColor kOurs(0x00, 0x72, 0xB2), kPenalty(0xD5, 0x5E, 0x00), kUnlimited(0x00, 0x9E, 0x73), kHand(0x77, 0x77, 0x77);
const QColor kFlesh(0xD9, 0x8C, 0x8C), kSteel(0x9A, 0xA3, 0xAD), kGhost(0x55, 0x55, 0x55);
// As wide as it is long, so that the tongue cannot fold over it: the plate of the engine's static truth.
const char* const kPlate = "box:0.02x0.02x0.003";
constexpr double kClear = 0.0015;    // m off the dorsum at the start
constexpr double kAway = 0.03;       // m off it at the end
constexpr double kDeep = 0.025;      // m below the dorsum
constexpr double kSpeed = 0.1;       // m/s
constexpr double kBefore = 0.1;      // s
constexpr double kHold = 0.7;        // s: longer than the device's limit may last
constexpr double kFree = 1.0;        // s after the hand has let go
constexpr double kInside = 0.8;      // of the tool's half width: what lies under it does not slip off its edge
constexpr double kUnder = 0.004;     // m from the tool at rest: what it presses on
constexpr double kBehind = 0.002;    // m, more than the tool is thick: it has gone through
constexpr double kBroken_mm = 5.0;   // left one second after: it hangs somewhere, it is not on its way
constexpr double kRecovered = 1e-4;  // m: the target one second after

/// Where the hand is: in, held, and off the tongue within one step.
struct Hand {
  explicit Hand(double share) : hold(kHold * share) {}
  double hold;
  double arrives() const { return kBefore + (kClear + kDeep) / kSpeed; }
  double lets_go() const { return arrives() + hold; }
  double end() const { return lets_go() + kFree; }
  double depth(double t) const {
    if (t >= lets_go() - 1e-9) return -kAway;
    return std::clamp(-kClear + kSpeed * (t - kBefore), -kClear, kDeep);
  }
};

struct Run {
  QString name;
  QColor colour;
  engine::ExperimentResult result;
  std::vector<double> time_s, displaced_mm, force_n, depth_mm;
  std::vector<Vec3> deepest_nodes, end_nodes;
  engine::Pose deepest_tool, end_tool;  ///< where the scene held the blade then
  double largest_mm = 0.0, residual_mm = 0.0;
  double penetration_mm = 0.0;  ///< of the deepest point of the tissue's surface inside the blade
  int inverted = 0;
  int under = 0, passed = 0;  ///< nodes of the dorsum under the blade at rest; those behind it before the hand lets go
};

/// Nodes that a blade should have before it and has left behind it.
void count_passed(const TongueRig& rig, Run& r) {
  const auto& rest = rig.description().soft.nodes;
  const engine::Pose on = rig.pose(0.0);
  Vec3 low = rig.description().tool.surface.points.front(), high = low;
  for (const Vec3& p : rig.description().tool.surface.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto over = [&](const Vec3& p) {
    return p.x() > low.x() && p.x() < high.x() && p.y() > kInside * low.y() && p.y() < kInside * high.y();
  };
  std::vector<char> seen(rest.size(), 0);
  for (const auto& triangle : rig.skin())
    for (int node : triangle) {
      if (seen[node]++ != 0) continue;
      const Vec3 before = on.to_local(rest[node]), now = r.deepest_tool.to_local(r.deepest_nodes[node]);
      if (!over(before) || std::abs(before.z()) > kUnder) continue;
      ++r.under;
      r.passed += over(now) && now.z() < -kBehind ? 1 : 0;
    }
}

Run run(const TongueRig& rig, const Hand& hand, engine::Response response, double limit_n, const QString& name,
        const QColor& colour) {
  Run r;
  r.name = name;
  r.colour = colour;
  const auto scene = rig.scene(response, engine::Collision::aist);
  engine::ExperimentSettings settings;
  settings.duration_s = hand.end();
  settings.force_limit_n = limit_n;
  const auto& rest = scene->model.rest;
  r.end_nodes = r.deepest_nodes = rest;
  r.result = engine::run_experiment(
      *scene, [&](double t) { return rig.pose(hand.depth(t)); }, settings,
      [&](const engine::ExperimentStep& s, const std::vector<Vec3>& nodes) {
        rig.pulse();
        double largest = 0.0;
        for (std::size_t i = 0; i < nodes.size(); ++i) largest = std::max(largest, (nodes[i] - rest[i]).norm());
        r.time_s.push_back(s.time_s);
        r.displaced_mm.push_back(1e3 * largest);
        r.force_n.push_back(s.force_n.norm());
        const Vec3 into = rig.pose(1.0).position - rig.pose(0.0).position;
        r.depth_mm.push_back(1e3 * (s.proxy_m - rig.pose(0.0).position).dot(into));
        r.inverted = std::max(r.inverted, s.inverted);
        r.penetration_mm = std::max(r.penetration_mm, 1e3 * s.penetration_m);
        r.largest_mm = std::max(r.largest_mm, 1e3 * largest);
        if (s.time_s < hand.lets_go() - 1e-9) {
          r.deepest_nodes = nodes;
          r.deepest_tool = rig.pose(0.0);
          r.deepest_tool.position = s.proxy_m;
        }
        r.end_nodes = nodes;
        r.end_tool = rig.pose(0.0);
        r.end_tool.position = s.proxy_m;
      });
  count_passed(rig, r);
  r.residual_mm = r.result.finite ? 1e3 * r.result.residual_m : r.displaced_mm.empty() ? 0.0 : r.displaced_mm.back();
  return r;
}

/// After the hand has gone: the first time from which on no node is further than the target from its rest; -1: never.
double recovered_after_s(const Run& r, const Hand& hand) {
  if (!r.result.finite) return -1.0;
  double since = -1.0;
  for (std::size_t i = 0; i < r.time_s.size(); ++i) {
    if (r.time_s[i] < hand.lets_go()) continue;
    if (r.displaced_mm[i] > 1e3 * kRecovered)
      since = -1.0;
    else if (since < 0)
      since = r.time_s[i] - hand.lets_go();
  }
  return since;
}

double most(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

QJsonObject json_of(const Run& r, const Hand& hand) {
  double change = 0.0, volume = 0.0;
  for (std::size_t i = 1; i < r.force_n.size(); ++i)
    change = std::max(change, (r.result.steps[i].force_n - r.result.steps[i - 1].force_n).norm());
  for (const auto& s : r.result.steps) volume = std::max(volume, std::abs(s.volume_change));
  const double after = recovered_after_s(r, hand);
  return {{"finite", r.result.finite},
          {"stopped_at_s", r.result.finite ? QJsonValue() : QJsonValue(r.result.steps.back().time_s)},
          {"residual_mm", r.result.finite ? QJsonValue(r.residual_mm) : QJsonValue()},
          {"recovered", r.result.finite && r.residual_mm < 1e3 * kRecovered},
          {"recovered_after_s", after < 0 ? QJsonValue() : QJsonValue(after)},
          {"largest_displacement_mm", r.largest_mm},
          {"tool_depth_max_mm", most(r.depth_mm)},
          {"penetration_max_mm", r.penetration_mm},
          {"dorsum_nodes_under_the_blade", r.under},
          {"dorsum_nodes_gone_through", r.passed},
          {"force_max_n", most(r.force_n)},
          {"force_change_per_step_max_n", change},
          {"inverted_max", r.inverted},
          {"volume_change_max", volume},
          {"limit", QJsonObject{{"entered", r.result.limit_entered},
                                {"time_limited_s", r.result.time_limited_s},
                                {"time_lost_s", r.result.time_lost_s}}}};
}

QImage picture_of(const TongueRig& rig, const std::vector<Vec3>& nodes, const engine::Pose& tool,
                  const engine::Pose* hand) {
  TissuePicture picture(760, 620);
  picture.add_surface(nodes, rig.skin(), kFlesh);
  picture.add_wireframe(nodes, rig.skin(), kFlesh.darker(150), 0.35);
  picture.add_tool(rig.description().tool.surface, tool, kSteel);
  if (hand != nullptr) picture.add_tool(rig.description().tool.surface, *hand, kGhost, 0.3);
  rig.aim(picture, 0.058, 0.005);
  return picture.still();
}

PlotLine line_of(const Run& r, const std::vector<double>& values, bool named) {
  return {named ? r.name : QString(), r.colour, r.time_s, values, 0.17};
}

QString left_of(const Run& r) {
  if (!r.result.finite) return QStringLiteral("is not finite");
  return r.residual_mm < 1e-3 ? QStringLiteral("less than 0.001 mm is left")
                              : QStringLiteral("%1 mm is left").arg(said(r.residual_mm));
}

/// What came of a run, in words.
QString outcome_of(const Run& r, const Hand& hand) {
  if (!r.result.finite) return QStringLiteral("breaks: not finite after %1 s").arg(said(r.result.steps.back().time_s));
  const double after = recovered_after_s(r, hand);
  QString verdict;
  if (after >= 0) {
    verdict = QStringLiteral("recovers: below 0.1 mm %1 s after, ").arg(said(after));
  } else {
    verdict =
        r.residual_mm > kBroken_mm ? QStringLiteral("does not come back: ") : QStringLiteral("has not come back: ");
  }
  return verdict + left_of(r) +
         QStringLiteral(
             " after one second; at most %1 N, at worst %2 tetrahedra inside out, %3 of the %4 surface nodes "
             "under the tool gone through it")
             .arg(said(most(r.force_n)))
             .arg(r.inverted)
             .arg(r.passed)
             .arg(r.under);
}

}  // namespace

FigureResult write_figure_7(const FigureSetting& setting) {
  const TongueRig rig(setting, kPlate), blade_rig(setting);
  const Hand hand(setting.time_share);
  const double limit_n = rig.description().haptics.device_limit_n, none = std::numeric_limits<double>::infinity();
  const Run penalty = run(rig, hand, engine::Response::penalty, none, QStringLiteral("penalty, no limit"), kPenalty);
  const Run unlimited =
      run(rig, hand, engine::Response::compliant, none, QStringLiteral("compliant, no limit"), kUnlimited);
  const Run ours = run(rig, hand, engine::Response::compliant, limit_n,
                       QStringLiteral("ours: compliant, force limit %1 N").arg(limit_n), kOurs);

  const Run blade = run(blade_rig, hand, engine::Response::compliant, limit_n, QString(), kOurs);

  FigureResult result;
  result.seen =
      QStringLiteral(
          "The hand goes %1 mm below the dorsum at %2 mm/s with a plate of 20 x 20 mm, holds for %3 s and "
          "lets go within one step.\nPenalty without a limit %4.\nCompliant without a limit %5.\n"
          "Ours stops %6 mm deep, where the device's limit is reached (held for too long, the device "
          "counts as lost and shows no force); it %7.\nOurs with the narrow blade of the scenario (%8), which "
          "the tongue folds over: it stops %9 mm deep and %10.")
          .arg(said(1e3 * kDeep), said(1e3 * kSpeed), said(hand.hold), outcome_of(penalty, hand),
               outcome_of(unlimited, hand), said(most(ours.depth_mm)), outcome_of(ours, hand),
               QString::fromStdString(setting.scenario.blade), said(most(blade.depth_mm)))
          .arg(outcome_of(blade, hand));

  Sheet sheet;
  sheet.title = QStringLiteral("Figure 7: a hand overshoots and lets go");
  const engine::Pose deep = rig.pose(kDeep);
  sheet.pictures = {
      {picture_of(rig, penalty.deepest_nodes, deep, nullptr), QStringLiteral("penalty, before the hand lets go")},
      {picture_of(rig, penalty.end_nodes, penalty.end_tool, nullptr),
       penalty.result.finite ? QStringLiteral("penalty, one second after")
                             : QStringLiteral("penalty, its last finite shape")},
      {picture_of(rig, ours.deepest_nodes, ours.deepest_tool, &deep),
       QStringLiteral("ours, before the hand lets go; grey: where the hand is")},
      {picture_of(rig, ours.end_nodes, ours.end_tool, nullptr), QStringLiteral("ours, one second after")}};
  std::vector<double> hand_mm;
  for (double t : ours.time_s) hand_mm.push_back(1e3 * hand.depth(t));
  PlotPanel depth{QStringLiteral("depth (mm)"),
                  {{QStringLiteral("hand"), kHand, ours.time_s, hand_mm, 0.12, Qt::DashLine},
                   {QStringLiteral("plate, ours (without a limit it is where the hand is)"), kOurs, ours.time_s,
                    ours.depth_mm, 0.17}},
                  {},
                  0.0,
                  -1e3 * kAway,
                  0.8};
  PlotPanel displaced{QStringLiteral("largest node\ndisplacement (mm)"),
                      {line_of(penalty, penalty.displaced_mm, true), line_of(unlimited, unlimited.displaced_mm, true),
                       line_of(ours, ours.displaced_mm, true)},
                      {{1e3 * kRecovered, QStringLiteral("target one second after: 0.1 mm"), kHand}},
                      0.0,
                      1e-3,
                      1.3,
                      true};
  PlotPanel force{QStringLiteral("force shown (N)"),
                  {line_of(penalty, penalty.force_n, true), line_of(unlimited, unlimited.force_n, true),
                   line_of(ours, ours.force_n, true)},
                  {{limit_n, QStringLiteral("device limit %1 N").arg(limit_n), QColor(0xCC, 0x79, 0xA7)}},
                  0.0,
                  0.0,
                  1.2};
  sheet.plot = {
      QStringLiteral("time (s)"),
      hand.end(),
      {depth, displaced, force},
      {{kBefore, hand.arrives(), QStringLiteral("in")}, {hand.lets_go(), hand.end(), QStringLiteral("hand is off")}}};
  sheet.plot_height = 900;
  sheet.seen = result.seen;
  write_figure_png(setting, "figure-7.png", draw_sheet(sheet), result);

  QJsonObject settings = rig.about();
  settings["blade"] = QString::fromStdString(setting.scenario.blade);
  settings["depth_mm"] = 1e3 * kDeep;
  settings["speed_mm_s"] = 1e3 * kSpeed;
  settings["hold_s"] = hand.hold;
  settings["free_s"] = kFree;
  settings["force_limit_n"] = limit_n;
  settings["recovered_below_mm"] = 1e3 * kRecovered;
  write_figure_json(setting, "figure-7.json",
                    {{"figure", "7"},
                     {"settings", settings},
                     {"penalty", json_of(penalty, hand)},
                     {"compliant_without_limit", json_of(unlimited, hand)},
                     {"ours", json_of(ours, hand)},
                     {"ours_with_blade", json_of(blade, hand)},
                     {"seen", result.seen}},
                    result);
  return result;
}

}  // namespace vallecula::gui
