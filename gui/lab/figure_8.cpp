// The paper's figure 8: a pilot intubation, its contacts, its view, and the ghost where the device's limit is reached.
#include <QApplication>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>

#include "device/haptic_device.h"
#include "engine/haptics/force_limit.h"
#include "engine/haptics/runner.h"
#include "engine/mesh/triangle_bvh.h"
#include "gui/lab/figures.h"
#include "gui/lab/plot.h"
#include "gui/lab/tongue_rig.h"
#include "gui/pages/key_moments.h"
#include "gui/session/device_choice.h"
#include "gui/session/hands_port.h"
#include "gui/session/scene_from_package.h"
#include "gui/views/operator_view.h"
#include "gui/views/patient_look.h"
#include "gui/views/sagittal_view.h"

namespace vallecula::gui {

namespace {

using engine::HapticState;
using engine::Vec3;

constexpr int kChunk = 20;             // ticks between two looks at the scene; sight is judged as often
constexpr double kTouches = 0.0005;    // m: a lip this near to the blade is touched
constexpr double kForceShown = 2.5;    // device limits high: a spike must not make the rest unreadable
constexpr double kGhostParts = 0.006;  // m between hand and blade: the ghost is plain to see

struct Structure {
  engine::Structure id;
  const char* name;
  QColor colour;
};
const Structure kStructures[] = {{engine::Structure::tongue, "tongue", QColor(0x00, 0x72, 0xB2)},
                                 {engine::Structure::epiglottis, "epiglottis", QColor(0x00, 0x9E, 0x73)},
                                 {engine::Structure::gum, "gum", QColor(0xD5, 0x5E, 0x00)},
                                 {engine::Structure::palate, "palate", QColor(0xE6, 0x9F, 0x00)},
                                 {engine::Structure::larynx, "larynx", QColor(0xCC, 0x79, 0xA7)}};
const QColor kModel(0x00, 0x72, 0xB2), kShown(0x11, 0x11, 0x11), kSight(0x38, 0x80, 0xB0), kLip(0xB0, 0x60, 0x70);

/// Area of the lips' surface that lies at the blade. Their force is part of the model force, not recorded alone.
class LipTouch {
 public:
  LipTouch(const pipeline::PatientPackage& package, const engine::TriangleMesh& tool) : tool_(tool) {
    const pipeline::Surface& face = package.surfaces.at("face");
    for (std::size_t t = 0; t < face.triangles.size() && t < face.tissue.size(); ++t) {
      if (static_cast<pipeline::Tissue>(face.tissue[t]) != pipeline::Tissue::lip) continue;
      Vec3 p[3];
      for (int k = 0; k < 3; ++k) {
        const auto& q = face.points[face.triangles[t][k]];
        p[k] = 1e-3 * Vec3(q[0], q[1], q[2]);
      }
      patches_.push_back({(p[0] + p[1] + p[2]) / 3, 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm()});
    }
  }
  double area_mm2(const engine::Pose& pose) const {
    double area = 0.0;
    for (const Patch& patch : patches_)
      if (tool_.signed_distance(pose.to_local(patch.centre), 2 * kTouches) < kTouches) area += patch.area;
    return 1e6 * area;
  }

 private:
  struct Patch {
    Vec3 centre;
    double area;
  };
  engine::TriangleBvh tool_;
  std::vector<Patch> patches_;
};

/// The operator's view and the cut in a dark room: drawn when a picture is asked for, at one moment of the run.
class Camera {
 public:
  Camera(std::shared_ptr<PatientLook> look, const engine::TriangleMesh& tool) {
    room_.setAttribute(Qt::WA_DontShowOnScreen);
    auto* row = new QHBoxLayout(&room_);
    row->setContentsMargins(0, 0, 0, 0);
    view_ = new OperatorView(&room_);
    cut_ = new SagittalView(&room_);
    row->addWidget(view_);
    row->addWidget(cut_);
    row->setSpacing(0);
    room_.resize(1400, 700);
    view_->show_patient(look, tool);
    cut_->show_patient(std::move(look), tool);
    room_.show();
    QElapsedTimer timer;
    timer.start();
    while (!(view_->isValid() && cut_->isValid()) && timer.elapsed() < 5000)
      QApplication::processEvents(QEventLoop::AllEvents, 20);
  }
  QImage take(const engine::Snapshot& snapshot, OperatorView::Zoom zoom) {
    view_->set_zoom(zoom);
    view_->update_from(snapshot);
    return view_->picture();
  }
  QImage take_cut(const engine::Snapshot& snapshot, double sight_percent) {
    cut_->update_from(snapshot, sight_percent);
    return cut_->picture();
  }

 private:
  QWidget room_;
  OperatorView* view_ = nullptr;
  SagittalView* cut_ = nullptr;
};

struct Record {
  std::vector<double> time_s, model_n, shown_n;
  std::vector<double> contacts[std::size(kStructures)], peak_n;  ///< every kChunk ticks
  std::vector<double> look_time_s, sight_percent, lip_mm2, tongue_n, gum_n;
  double limited_s = 0.0, lost_s = 0.0, ghost_max_mm = 0.0;
  std::uint32_t faults = engine::kFaultNone;
};

/// A whole scripted trial as fast as it goes; `each` sees every kChunk-th snapshot.
Record play(const FigureSetting& setting, const engine::SceneDescription& wanted, const std::string& hand,
            const LipTouch& lips, const std::function<void(const engine::Snapshot&)>& each) {
  const std::unique_ptr<device::HapticDevice> device = make_device(hand, {setting.package, setting.scenario, nullptr});
  engine::SceneDescription description = wanted;
  const device::GuardSettings settings = device::guard_for(device->info());
  if (settings.limits.peak_force_n > 0) description.haptics.device_limit_n = device::largest_model_force_n(settings);
  device::GuardedDevice guard(*device, settings);
  HandsPort port(guard);
  engine::Runner runner(engine::build_scene(description), port);
  Record record;
  double now_s = 0.0;
  while (!device->finished(now_s) && now_s < setting.scenario.max_attempt_s * setting.time_share) {
    if (setting.pulse) setting.pulse();
    engine::TickRecord last;
    int contacts[std::size(kStructures)] = {};
    runner.run(kChunk, [&](const engine::TickRecord& tick) {
      record.time_s.push_back(tick.time_s);
      record.model_n.push_back(tick.model_force_n.norm());
      record.shown_n.push_back(tick.displayed_force_n.norm());
      record.limited_s += tick.state == HapticState::limited ? 1e-3 : 0.0;
      record.lost_s += tick.state == HapticState::lost ? 1e-3 : 0.0;
      record.faults |= tick.faults;
      if (engine::proxy_held(tick.state))
        record.ghost_max_mm =
            std::max(record.ghost_max_mm, 1e3 * (tick.device_pose.position - tick.proxy_pose.position).norm());
      for (std::size_t s = 0; s < std::size(kStructures); ++s)
        contacts[s] = std::max(contacts[s], tick.loads[static_cast<std::size_t>(kStructures[s].id)].contacts);
      last = tick;
    });
    now_s = last.time_s;
    const engine::Snapshot& snapshot = runner.latest();
    record.look_time_s.push_back(now_s);
    for (std::size_t s = 0; s < std::size(kStructures); ++s) record.contacts[s].push_back(contacts[s]);
    record.sight_percent.push_back(100 * snapshot.glottis_visible);
    record.lip_mm2.push_back(lips.area_mm2(snapshot.proxy_pose));
    record.tongue_n.push_back(last.loads[static_cast<std::size_t>(engine::Structure::tongue)].force_n.norm());
    record.gum_n.push_back(last.loads[static_cast<std::size_t>(engine::Structure::gum)].force_n.norm());
    each(snapshot);
  }
  return record;
}

double most(const std::vector<double>& v) { return v.empty() ? 0.0 : *std::max_element(v.begin(), v.end()); }

QJsonObject json_of(const Record& r, const curricula::Scenario& scenario) {
  QJsonObject contacts;
  for (std::size_t s = 0; s < std::size(kStructures); ++s)
    contacts[kStructures[s].name] =
        QJsonObject{{"max", most(r.contacts[s])},
                    {"time_s", 1e-3 * kChunk *
                                   static_cast<double>(std::count_if(r.contacts[s].begin(), r.contacts[s].end(),
                                                                     [](double c) { return c > 0; }))}};
  double change = 0.0;
  for (std::size_t i = 1; i < r.shown_n.size(); ++i)
    change = std::max(change, std::abs(r.shown_n[i] - r.shown_n[i - 1]));
  const auto seen = std::find_if(r.sight_percent.begin(), r.sight_percent.end(),
                                 [&](double p) { return p >= scenario.sight_percent; });
  return {
      {"duration_s", r.time_s.empty() ? 0.0 : r.time_s.back()},
      {"contacts", contacts},
      {"lip_touched_max_mm2", most(r.lip_mm2)},
      {"glottis_visible_max_percent", most(r.sight_percent)},
      {"in_sight_from_s", seen == r.sight_percent.end()
                              ? QJsonValue()
                              : QJsonValue(r.look_time_s[static_cast<std::size_t>(seen - r.sight_percent.begin())])},
      {"tongue_force_max_n", most(r.tongue_n)},
      {"gum_force_max_n", most(r.gum_n)},
      {"model_force_max_n", most(r.model_n)},
      {"shown_force_max_n", most(r.shown_n)},
      {"shown_force_change_per_tick_max_n", change},
      {"time_limited_s", r.limited_s},
      {"time_lost_s", r.lost_s},
      {"hand_from_blade_max_mm", r.ghost_max_mm},
      {"faults", static_cast<double>(r.faults)}};
}

}  // namespace

FigureResult write_figure_8(const FigureSetting& setting) {
  const engine::SceneDescription description = scene_from_package(setting.package, setting.scenario);
  const LipTouch lips(setting.package, description.tool.surface);
  Camera camera(make_patient_look(setting.package), description.tool.surface);
  QImage entering, in_sight, ghost, ghost_cut;
  double entering_s = 0.0, best_s = 0.0, ghost_s = 0.0, ghost_mm = 0.0;

  KeyMoments moments(setting.package, setting.scenario.sight_percent);
  const Record expert = play(setting, description, "scripted:expert", lips, [&](const engine::Snapshot& now) {
    for (const std::string& moment : moments.at(now)) {
      if (moment == "2-sweep") {
        entering = camera.take(now, OperatorView::Zoom::face);
        entering_s = now.time_s;
      } else if (moment == "5-best-sight") {
        in_sight = camera.take(now, OperatorView::Zoom::mouth);
        best_s = now.time_s;
      }
    }
  });
  const Record novice = play(setting, description, "scripted:novice", lips, [&](const engine::Snapshot& now) {
    const double parts = (now.device_pose.position - now.proxy_pose.position).norm();
    if (!engine::proxy_held(now.state) || parts < std::max(kGhostParts, 1e-3 * ghost_mm + 0.002)) return;
    ghost = camera.take(now, OperatorView::Zoom::mouth);
    ghost_cut = camera.take_cut(now, setting.scenario.sight_percent);
    ghost_s = now.time_s;
    ghost_mm = 1e3 * parts;
  });

  FigureResult result;
  Sheet sheet;
  sheet.title = QStringLiteral("Figure 8: pilot intubation of the term manikin");
  const auto blank = [](const QImage& image) {
    if (!image.isNull()) return image;
    QImage nothing(700, 700, QImage::Format_RGB32);
    nothing.fill(QColor(0xEE, 0xEE, 0xEE));
    return nothing;
  };
  sheet.pictures = {
      {blank(entering), entering.isNull()
                            ? QStringLiteral("(a) the blade never came far enough in")
                            : QStringLiteral("(a) the blade comes in at the right corner, %1 s").arg(said(entering_s))},
      {blank(in_sight), in_sight.isNull()
                            ? QStringLiteral("(b) the trachea did not come into sight")
                            : QStringLiteral("(b) best view, %1 s: the trachea (blue) in sight").arg(said(best_s))},
      {blank(ghost),
       ghost.isNull()
           ? QStringLiteral("(c) the novice never went past the device's limit")
           : QStringLiteral("(c) the novice past the device's limit, %1 s: the blade stays, the grey ghost is "
                            "where the hand is, %2 mm off")
                 .arg(said(ghost_s), said(ghost_mm))},
      {blank(ghost_cut), QStringLiteral("(d) the same moment in the midline: steel the blade, grey the hand")}};

  PlotPanel contacts{QStringLiteral("contacts,\nexpert"), {}, {}, 0.0, 0.0, 1.1};
  QStringList touched;
  for (std::size_t s = 0; s < std::size(kStructures); ++s) {
    if (most(expert.contacts[s]) == 0) continue;
    contacts.lines.push_back(
        {kStructures[s].name, kStructures[s].colour, expert.look_time_s, expert.contacts[s], 0.14});
    touched << QStringLiteral("%1 (up to %2 contacts)").arg(kStructures[s].name).arg(most(expert.contacts[s]));
  }
  PlotPanel lip{QStringLiteral("lip at the\nblade (mm2)"),
                {{QString(), kLip, expert.look_time_s, expert.lip_mm2, 0.14}},
                {},
                0.0,
                0.0,
                0.6};
  PlotPanel sight{QStringLiteral("glottis\nseen (%)"),
                  {{QString(), kSight, expert.look_time_s, expert.sight_percent, 0.17}},
                  {{setting.scenario.sight_percent, QStringLiteral("counts as in sight"), kSight}},
                  100.0,
                  0.0,
                  0.7};
  PlotPanel force{QStringLiteral("force,\nexpert (N)"),
                  {{QStringLiteral("model"), kModel, expert.time_s, expert.model_n, 0.17},
                   {QStringLiteral("shown by the device"), kShown, expert.time_s, expert.shown_n, 0.15, Qt::DotLine}},
                  {},
                  0.0,
                  0.0,
                  0.9};
  const double limit_n = description.haptics.device_limit_n;
  const bool cut_off = most(novice.model_n) > kForceShown * limit_n;
  PlotPanel beyond{QStringLiteral("force,\nnovice (N)"),
                   {{QStringLiteral("model"), kModel, novice.time_s, novice.model_n, 0.17},
                    {QStringLiteral("shown by the device"), kShown, novice.time_s, novice.shown_n, 0.15, Qt::DotLine}},
                   {{limit_n, QStringLiteral("device limit %1 N").arg(limit_n), QColor(0xCC, 0x79, 0xA7)}},
                   cut_off ? kForceShown * limit_n : 0.0,
                   0.0,
                   0.9};
  sheet.plot = {
      QStringLiteral("time since the hand began (s)"),
      std::max(expert.time_s.empty() ? 1.0 : expert.time_s.back(), novice.time_s.empty() ? 1.0 : novice.time_s.back()),
      {contacts, lip, sight, force, beyond},
      {}};
  sheet.plot_height = 1080;
  result.seen =
      QStringLiteral(
          "The scripted expert's blade touches %1; up to %2 mm2 of the lips lie at the blade (their force is not "
          "recorded alone). Up to %3 % of the glottis is seen; the model force reaches %4 N. The novice "
          "presses past the device's limit for %5 s (%6 s of it lost); the hand goes up to %7 mm beyond the blade, "
          "the force shown stays at %8 N at most (the model's reaches %9 N%11), and the run goes on: %10.")
          .arg(touched.isEmpty() ? QStringLiteral("nothing") : touched.join(QStringLiteral(", ")),
               said(most(expert.lip_mm2)), said(most(expert.sight_percent)), said(most(expert.model_n)),
               said(novice.limited_s + novice.lost_s), said(novice.lost_s), said(novice.ghost_max_mm),
               said(most(novice.shown_n)))
          .arg(said(most(novice.model_n)),
               (novice.faults & (engine::kFaultTissue | engine::kFaultForce)) != 0
                   ? QStringLiteral("with a fault of the tissue, which was put back to rest")
                   : QStringLiteral("no fault of the tissue"),
               cut_off ? QStringLiteral(", cut off in the plot") : QString());
  sheet.seen = result.seen;
  write_figure_png(setting, "figure-8.png", draw_sheet(sheet), result);
  write_figure_json(setting, "figure-8.json",
                    {{"figure", "8"},
                     {"settings", TongueRig(setting).about()},
                     {"expert", json_of(expert, setting.scenario)},
                     {"novice", json_of(novice, setting.scenario)},
                     {"seen", result.seen}},
                    result);
  return result;
}

}  // namespace vallecula::gui
