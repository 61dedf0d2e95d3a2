// The paper's figure 6: a blade in persistent contact, found by the sphere tree and by tests of triangles.
#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "engine/lab/experiment.h"
#include "gui/lab/figures.h"
#include "gui/lab/lab_report.h"
#include "gui/lab/plot.h"
#include "gui/lab/tongue_rig.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;

const QColor kSpheres(0x00, 0x72, 0xB2), kTriangles(0xD5, 0x5E, 0x00);
const QColor kFlesh(0xD9, 0x8C, 0x8C), kSteel(0x9A, 0xA3, 0xAD);
// The same with a tool of twelve triangles: the fewest that triangles can be tested against.
const char* const kBox = "box:0.06x0.01x0.003";
constexpr double kClear = 0.0015;                  // m off the dorsum at the start
constexpr double kDepth = 0.004;                   // m pressed in
constexpr double kPress = 0.5;                     // s until it is
constexpr double kSlide = 3.5;                     // s of sliding
constexpr double kAlong = 0.006, kAcross = 0.003;  // m to either side
constexpr double kTurns = 2.0;                     // to and fro along; three times that across
constexpr int kRepeats =
    3;  // equal runs; of each step the median time counts, so that the machine's other work does not
constexpr int kCompareEvery = 20;  // steps between two comparisons of the shapes
constexpr int kSmooth = 25;        // steps over which the drawn line is averaged

struct Motion {
  explicit Motion(double share) : slide(kSlide * share) {}
  double slide;
  double end() const { return kPress + slide; }
  engine::Pose at(const TongueRig& rig, double t) const {
    const double in = std::clamp(t / kPress, 0.0, 1.0), smooth = in * in * (3 - 2 * in);
    const double turn = 2 * M_PI * kTurns * std::max(0.0, t - kPress) / slide;
    return rig.pose(-kClear + smooth * (kClear + kDepth), kAlong * std::sin(turn), kAcross * std::sin(3 * turn));
  }
};

struct Run {
  engine::ExperimentResult result;
  std::vector<double> time_s, work_s, collision_s, force_n, rate_hz;
  std::vector<int> contacts;
  std::vector<std::vector<Vec3>> shapes;  ///< every kCompareEvery steps
  bool repeated_alike = true;             ///< the repeats gave the same forces, bit for bit
};

double median_of(std::vector<double> values) { return percentile(std::move(values), 0.5); }

struct Spread {
  double mean = 0.0, turbulence = 0.0;  ///< standard deviation over mean
};
Spread spread_of(const std::vector<double>& values) {
  Spread s;
  for (double v : values) s.mean += v / static_cast<double>(values.size());
  double square = 0.0;
  for (double v : values) square += (v - s.mean) * (v - s.mean) / static_cast<double>(values.size());
  s.turbulence = s.mean > 0 ? std::sqrt(square) / s.mean : 0.0;
  return s;
}

std::vector<double> smoothed(const std::vector<double>& values) {
  std::vector<double> out(values.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i] - (i >= kSmooth ? values[i - kSmooth] : 0.0);
    out[i] = sum / static_cast<double>(std::min<std::size_t>(i + 1, kSmooth));
  }
  return out;
}

/// Values of the steps from `from` on.
template <class Value>
std::vector<Value> since(const Run& run, const std::vector<Value>& values, double from) {
  std::vector<Value> out;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (run.time_s[i] >= from) out.push_back(values[i]);
  return out;
}

/// Both methods in turn, over and over, so that a busier minute of the machine meets both alike.
std::array<Run, 2> run_both(const TongueRig& rig, const Motion& motion) {
  const std::shared_ptr<const engine::Scene> scenes[2] = {
      rig.scene(engine::Response::compliant, engine::Collision::aist),
      rig.scene(engine::Response::compliant, engine::Collision::triangles)};
  std::array<Run, 2> runs;
  std::array<std::array<engine::ExperimentResult, kRepeats>, 2> results;
  for (int repeat = 0; repeat < kRepeats; ++repeat)
    for (int method = 0; method < 2; ++method) {
      engine::ExperimentSettings settings;
      settings.duration_s = motion.end();
      settings.measure_tissue = repeat == 0;
      int step = 0;
      results[method][repeat] = engine::run_experiment(
          *scenes[method], [&](double t) { return motion.at(rig, t); }, settings,
          [&](const engine::ExperimentStep&, const std::vector<Vec3>& nodes) {
            rig.pulse();
            if (repeat == 0 && step++ % kCompareEvery == 0) runs[method].shapes.push_back(nodes);
          });
      if (!results[method][repeat].finite)
        throw std::runtime_error("figure 6: the run diverged; this is a fault of the engine, please report it");
    }
  for (int method = 0; method < 2; ++method) {
    Run& run = runs[method];
    run.result = results[method][0];
    for (std::size_t i = 0; i < run.result.steps.size(); ++i) {
      std::vector<double> work, collision;
      for (const auto& repeated : results[method]) {
        work.push_back(repeated.steps[i].step_s);
        collision.push_back(repeated.steps[i].stages.collision_s);
        run.repeated_alike &= repeated.steps[i].force_n == run.result.steps[i].force_n;
      }
      run.time_s.push_back(run.result.steps[i].time_s);
      run.work_s.push_back(median_of(work));
      run.collision_s.push_back(median_of(collision));
      run.rate_hz.push_back(1.0 / run.work_s.back());
      run.force_n.push_back(run.result.steps[i].force_n.norm());
      run.contacts.push_back(run.result.steps[i].contacts);
    }
  }
  return runs;
}

struct Difference {
  std::vector<double> at_end_mm;  ///< per node
  double largest_mm = 0.0, mean_mm = 0.0, end_largest_mm = 0.0, end_mean_mm = 0.0, rms_displacement_mm = 0.0;
};

Difference compare(const Run& a, const Run& b, const std::vector<Vec3>& rest) {
  Difference d;
  std::size_t count = 0;
  for (std::size_t s = 0; s < std::min(a.shapes.size(), b.shapes.size()); ++s)
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const double off = 1e3 * (a.shapes[s][i] - b.shapes[s][i]).norm();
      d.largest_mm = std::max(d.largest_mm, off);
      d.mean_mm += off;
      ++count;
    }
  d.mean_mm /= std::max<double>(1.0, static_cast<double>(count));
  for (std::size_t i = 0; i < rest.size(); ++i) {
    d.at_end_mm.push_back(1e3 * (a.result.final_nodes[i] - b.result.final_nodes[i]).norm());
    d.end_largest_mm = std::max(d.end_largest_mm, d.at_end_mm.back());
    d.end_mean_mm += d.at_end_mm.back() / static_cast<double>(rest.size());
    d.rms_displacement_mm += 1e6 * (a.result.final_nodes[i] - rest[i]).squaredNorm() / static_cast<double>(rest.size());
  }
  d.rms_displacement_mm = std::sqrt(d.rms_displacement_mm);
  return d;
}

QJsonObject json_of(const Run& run) {
  const auto rate = spread_of(since(run, run.rate_hz, kPress)), work = spread_of(since(run, run.work_s, kPress));
  const auto contacts = since(run, run.contacts, kPress);
  std::vector<double> counts(contacts.begin(), contacts.end()), depth;
  int inverted = 0;
  for (const auto& s : run.result.steps) {
    if (s.time_s >= kPress) depth.push_back(s.penetration_m);
    inverted = std::max(inverted, s.inverted);
  }
  return {{"rate_hz", QJsonObject{{"mean", rate.mean},
                                  {"turbulence", rate.turbulence},
                                  {"p50", median_of(since(run, run.rate_hz, kPress))},
                                  {"p1", percentile(since(run, run.rate_hz, kPress), 0.01)}}},
          {"step_ms", QJsonObject{{"mean", 1e3 * work.mean}, {"turbulence", work.turbulence}}},
          {"collision_us", QJsonObject{{"p50", 1e6 * median_of(since(run, run.collision_s, kPress))},
                                       {"p99", 1e6 * percentile(since(run, run.collision_s, kPress), 0.99)}}},
          {"contacts", QJsonObject{{"p50", percentile(counts, 0.5)}, {"max", percentile(counts, 1.0)}}},
          {"force_n",
           QJsonObject{{"p50", median_of(since(run, run.force_n, kPress))}, {"max", percentile(run.force_n, 1.0)}}},
          {"penetration_m", QJsonObject{{"p50", percentile(depth, 0.5)}, {"max", percentile(depth, 1.0)}}},
          {"inverted_max", inverted},
          {"repeats_bit_identical", run.repeated_alike}};
}

QImage picture_of(const TongueRig& rig, const std::vector<Vec3>& nodes, const engine::Pose& tool,
                  const std::vector<QColor>& colours) {
  TissuePicture picture(1000, 700);
  if (colours.empty()) {
    picture.add_surface(nodes, rig.skin(), kFlesh);
    picture.add_wireframe(nodes, rig.skin(), kFlesh.darker(150), 0.4);
    picture.add_tool(rig.description().tool.surface, tool, kSteel);
  } else {
    picture.add_coloured(nodes, rig.skin(), colours);
    picture.add_tool(rig.description().tool.surface, tool, kSteel, 0.35);
  }
  rig.aim(picture, 0.048, -0.001);
  return picture.still();
}

void write_shapes(const FigureSetting& setting, const TongueRig& rig, const Motion& motion,
                  const std::array<Run, 2>& runs, const Difference& difference, FigureResult& result) {
  std::vector<QColor> colours;
  for (double mm : difference.at_end_mm)
    colours.push_back(scale_colour(mm / std::max(1e-9, difference.end_largest_mm)));
  const engine::Pose tool = motion.at(rig, motion.end());
  Sheet sheet;
  sheet.title = QStringLiteral("Figure 6 (a, b): the tongue under the same blade, by both ways to find contact");
  sheet.pictures = {
      {picture_of(rig, runs[1].result.final_nodes, tool, {}),
       QStringLiteral("(a) triangles: primitives against primitives")},
      {picture_of(rig, runs[0].result.final_nodes, tool, {}), QStringLiteral("(b) adaptive inner sphere tree")},
      {picture_of(rig, runs[0].result.final_nodes, tool, colours),
       QStringLiteral("difference of the two, coloured on (b); blade see-through")}};
  sheet.scale = {QStringLiteral("distance between the same nodes (mm)"), 0.0, difference.end_largest_mm};
  sheet.seen =
      QStringLiteral(
          "After sliding, blade %1 mm in: the nodes lie %2 mm apart at most and %3 mm on average, where the "
          "tongue is moved by %4 mm (root mean square). Over the whole slide: %5 mm at most, %6 mm on average.")
          .arg(said(1e3 * kDepth), said(difference.end_largest_mm), said(difference.end_mean_mm),
               said(difference.rms_displacement_mm), said(difference.largest_mm), said(difference.mean_mm));
  write_figure_png(setting, "figure-6-shapes.png", draw_sheet(sheet), result);
  result.seen = sheet.seen;
}

}  // namespace

FigureResult write_figure_6(const FigureSetting& setting) {
  const TongueRig rig(setting), box_rig(setting, kBox);
  const Motion motion(setting.time_share);
  const std::array<Run, 2> runs = run_both(rig, motion);
  const std::array<Run, 2> box = run_both(box_rig, motion);
  const Difference difference = compare(runs[0], runs[1], rig.description().soft.nodes);
  FigureResult result;
  write_shapes(setting, rig, motion, runs, difference, result);

  const auto mean_rate = [](const Run& r) { return spread_of(since(r, r.rate_hz, kPress)); };
  const Spread spheres = mean_rate(runs[0]), triangles = mean_rate(runs[1]);
  const auto collision_us = [](const Run& r) { return 1e6 * median_of(since(r, r.collision_s, kPress)); };
  const double ratio = collision_us(runs[1]) / collision_us(runs[0]);
  const double box_ratio = collision_us(box[1]) / collision_us(box[0]);
  const auto forces = [](const Run& r) {
    return QStringLiteral("%1 N in the middle and %2 N at most")
        .arg(said(median_of(since(r, r.force_n, kPress))), said(percentile(r.force_n, 1.0)));
  };
  const QString seen =
      QStringLiteral(
          "In persistent contact (from %1 s on) the sphere tree gives %2 steps a second (turbulence %3 %), "
          "triangles %4 (%5 %): turbulence is the standard deviation over the mean. Finding contacts takes %6 us "
          "a step by spheres and %7 us by triangles, %8 times as long. ")
          .arg(said(kPress), said(spheres.mean), said(100 * spheres.turbulence), said(triangles.mean),
               said(100 * triangles.turbulence), said(collision_us(runs[0])), said(collision_us(runs[1])),
               said(ratio)) +
      QStringLiteral(
          "The force on the blade is %1 by spheres, %2 by triangles. With a plain box of 60 x 10 x 3 mm in place of "
          "the blade (%3 triangles): %4 and %5 us, %6 times as long; %7 and %8 steps a second; %9 by spheres, %10 "
          "by triangles. Each time is the median of %11 equal runs.")
          .arg(forces(runs[0]), forces(runs[1]))
          .arg(box_rig.description().tool.surface.triangles.size())
          .arg(said(collision_us(box[0])), said(collision_us(box[1])), said(box_ratio), said(mean_rate(box[0]).mean),
               said(mean_rate(box[1]).mean), forces(box[0]))
          .arg(forces(box[1]))
          .arg(kRepeats);

  Sheet sheet;
  sheet.title = QStringLiteral("Figure 6 (c): update rate in persistent contact");
  const auto thousands = [](std::vector<double> v) {
    for (double& x : v) x *= 1e-3;
    return v;
  };
  const auto millionths = [](std::vector<double> v) {
    for (double& x : v) x *= 1e6;
    return v;
  };
  const QString names[2] = {QStringLiteral("sphere tree"), QStringLiteral("triangles")};
  const QColor colours[2] = {kSpheres, kTriangles};
  PlotPanel rate, find, force;
  double high = 0.0;
  for (int i : {1, 0}) {
    QColor pale = colours[i];
    pale.setAlpha(60);
    rate.lines.push_back({QString(), pale, runs[i].time_s, thousands(runs[i].rate_hz), 0.08});
    high = std::max(high, percentile(since(runs[i], runs[i].rate_hz, kPress), 0.999));
  }
  for (int i : {0, 1}) {
    rate.lines.push_back({names[i] + QStringLiteral(", mean of %1 steps (pale: every step)").arg(kSmooth), colours[i],
                          runs[i].time_s, thousands(smoothed(runs[i].rate_hz)), 0.17});
    find.lines.push_back({names[i], colours[i], runs[i].time_s, millionths(runs[i].collision_s), 0.12});
  }
  for (int i : {1, 0})
    force.lines.push_back({names[i] + (i == 1 ? QStringLiteral(" (what lies above is cut off)") : QString()),
                           colours[i], runs[i].time_s, runs[i].force_n, i == 1 ? 0.09 : 0.17});
  rate.axis = QStringLiteral("update rate\n(1000 steps/s)");
  rate.high = 1.3e-3 * high;
  rate.weight = 1.4;
  rate.levels = {{1.0, QStringLiteral("1 kHz"), QColor(0x77, 0x77, 0x77)}};
  find.axis = QStringLiteral("finding contacts\n(us a step)");
  find.logarithmic = true;
  find.low = 1.0;
  force.axis = QStringLiteral("force on the\nblade (N)");
  force.weight = 0.9;
  force.high = std::max(3 * percentile(runs[0].force_n, 1.0), 2 * median_of(since(runs[1], runs[1].force_n, kPress)));
  sheet.plot = {QStringLiteral("time (s)"),
                motion.end(),
                {rate, find, force},
                {{kPress, motion.end(), QStringLiteral("sliding in contact")}}};
  sheet.plot_height = 860;
  sheet.seen = seen;
  write_figure_png(setting, "figure-6-rate.png", draw_sheet(sheet), result);

  QJsonObject settings = rig.about();
  settings["tool_triangles"] = static_cast<double>(rig.description().tool.surface.triangles.size());
  settings["depth_mm"] = 1e3 * kDepth;
  settings["slide_along_mm"] = 1e3 * kAlong;
  settings["slide_across_mm"] = 1e3 * kAcross;
  settings["slide_s"] = motion.slide;
  settings["repeats"] = kRepeats;
  write_figure_json(setting, "figure-6.json",
                    {{"figure", "6"},
                     {"settings", settings},
                     {"aist", json_of(runs[0])},
                     {"triangles", json_of(runs[1])},
                     {"collision_time_ratio", ratio},
                     {"box", QJsonObject{{"tool", kBox},
                                         {"aist", json_of(box[0])},
                                         {"triangles", json_of(box[1])},
                                         {"collision_time_ratio", box_ratio}}},
                     {"shape_difference_mm", QJsonObject{{"max", difference.largest_mm},
                                                         {"mean", difference.mean_mm},
                                                         {"max_at_end", difference.end_largest_mm},
                                                         {"mean_at_end", difference.end_mean_mm},
                                                         {"rms_displacement_at_end", difference.rms_displacement_mm}}},
                     {"seen", result.seen + " " + seen}},
                    result);
  result.seen += "\n" + seen;
  return result;
}

}  // namespace vallecula::gui
