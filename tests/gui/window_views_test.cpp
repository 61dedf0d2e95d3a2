// What the views show, judged on the pictures themselves.
#include <QLabel>
#include <algorithm>
#include <cmath>
#include <map>
#include <thread>
#include <type_traits>

#include "gui/views/force_bars.h"
#include "gui/views/operator_view.h"
#include "gui/views/patient_look.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"
#include "gui/views/video_view.h"
#include "tests/gui/window_patient.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

std::vector<float> rest_metres(const pipeline::TetMesh& mesh, const engine::Vec3& shift_m = engine::Vec3::Zero()) {
  std::vector<float> points;
  for (const auto& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) points.push_back(static_cast<float>(1e-3 * p[axis] + shift_m[axis]));
  return points;
}

engine::Snapshot at_rest(const pipeline::PatientPackage& package, const engine::Vec3& tip_m) {
  engine::Snapshot snapshot = lifted_snapshot(package, 0.0, 0.0);
  snapshot.proxy_pose.position = snapshot.device_pose.position = tip_m;
  return snapshot;
}

class Views : public Screen {
 protected:
  static const pipeline::PatientPackage& patient() {
    static const pipeline::PatientPackage package = coarse_patient();
    return package;
  }
  template <class View>
  static void show(View& view, int width, int height) {
    view.resize(width, height);
    view.show_patient(make_patient_look(patient()), plain_blade());
    view.show();
    QApplication::processEvents();
    ASSERT_TRUE(view.isValid()) << "OpenGL did not start";
  }
};

TEST(SoftSurface, IsClosedFollowsItsNodesAndKeepsThemInPlace) {
  const auto mesh = coarse_patient().tongue;
  SoftSurface surface(mesh, 2);
  auto* poly = surface.surface();
  std::map<std::array<vtkIdType, 2>, int> edges;
  for (vtkIdType i = 0; i < poly->GetNumberOfCells(); ++i) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    poly->GetCellPoints(i, count, ids);
    for (int c = 0; c < 3; ++c) ++edges[{ids[c], ids[(c + 1) % 3]}];
  }
  // Every directed edge has its opposite as often: closed, and all triangles face the same way.
  for (const auto& [edge, count] : edges) ASSERT_EQ(count, (edges[{edge[1], edge[0]}]));

  const engine::Vec3 shift(0.003, -0.002, 0.005);
  const vtkIdType points = poly->GetNumberOfPoints();
  std::vector<std::array<double, 3>> before(static_cast<std::size_t>(points));
  surface.update(rest_metres(mesh));
  for (vtkIdType i = 0; i < points; ++i) poly->GetPoint(i, before[static_cast<std::size_t>(i)].data());
  surface.update(rest_metres(mesh, shift));
  for (vtkIdType i = 0; i < points; ++i)
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(poly->GetPoint(i)[axis], before[static_cast<std::size_t>(i)][axis] + 1000.0 * shift[axis], 1e-3);

  // The engine's own nodes are drawn where the engine has them: refining only adds points between.
  SoftSurface coarse(mesh, 0);
  coarse.update(rest_metres(mesh, shift));
  for (vtkIdType i = 0; i < coarse.surface()->GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 3; ++axis) ASSERT_FLOAT_EQ(poly->GetPoint(i)[axis], coarse.surface()->GetPoint(i)[axis]);

  surface.update({1.0f, 2.0f, 3.0f});  // another patient's snapshot: not taken
  EXPECT_NEAR(poly->GetPoint(0)[0], before[0][0] + 3.0, 1e-3);
}

TEST(PatientLook, LiesAtRestAgainWhereTheNextSnapshotDoes) {
  const auto package = coarse_patient();
  const auto look = make_patient_look(package);
  const auto place = [](vtkPolyData* surface) {
    std::vector<std::array<double, 3>> points(static_cast<std::size_t>(surface->GetNumberOfPoints()));
    for (std::size_t i = 0; i < points.size(); ++i) surface->GetPoint(static_cast<vtkIdType>(i), points[i].data());
    return points;
  };
  const auto furthest = [](const auto& a, const auto& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]));
    return most;
  };
  const auto face = place(look->face), soft = place(look->soft->surface());
  engine::Snapshot moved = lifted_snapshot(package, 0.7, 4.0);
  moved.body_displacement.assign(4, engine::Vec3(0.001, 0.002, -0.004));
  look->update(moved);
  ASSERT_GT(furthest(soft, place(look->soft->surface())), 1.0);
  ASSERT_GT(furthest(face, place(look->face)), 0.5);
  engine::Snapshot still = at_rest(package, {0, 0, 5});
  still.body_displacement.assign(4, engine::Vec3::Zero());
  look->update(still);
  EXPECT_LT(furthest(soft, place(look->soft->surface())), 1e-3);
  EXPECT_LT(furthest(face, place(look->face)), 1e-3);
}

TEST(PatientLook, NamesWhatIsMissing) {
  auto package = coarse_patient();
  package.landmarks.erase("operator_eye");
  try {
    make_patient_look(package);
    FAIL() << "drawn without an eye";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("operator_eye"), std::string::npos) << error.what();
  }
}

TEST_F(Views, OperatorSeesThePatientsRightOnTheRightAndTheFrontAtTheTop) {
  OperatorView view;
  show(view, 500, 420);
  view.set_zoom(OperatorView::Zoom::face);
  const auto picture = [&](const engine::Vec3& tip) {
    view.update_from(at_rest(patient(), tip));
    return view.picture();
  };
  const QImage away = picture({0, 0, 5});  // far behind the operator
  EXPECT_GT(colours_in(away), 40);
  const engine::Vec3 front(0.0, -0.040, 0.020);
  const Spot patients_right = difference(away, picture(front + engine::Vec3(-0.02, 0, 0)));
  const Spot patients_left = difference(away, picture(front + engine::Vec3(0.02, 0, 0)));
  ASSERT_GT(patients_right.pixels, 200);
  EXPECT_GT(patients_right.x, patients_left.x + 30);
  const Spot anterior = difference(away, picture(front + engine::Vec3(0, -0.012, 0)));
  const Spot posterior = difference(away, picture(front + engine::Vec3(0, 0.012, 0)));
  EXPECT_LT(anterior.y, posterior.y - 10);
  EXPECT_GT(view.screen_right().dot(-engine::Vec3::UnitX()), 0.99);
  EXPECT_GT(view.screen_up().dot(-engine::Vec3::UnitY()), 0.5);
}

TEST_F(Views, APatientThatFollowsIsDrawnWithNoMoreThanTheOneBefore) {
  struct Restored {
    ~Restored() { GlView::governor().set_mode(QualityGovernor::Mode::high); }
  } restored;
  const auto judged = [](auto& view) {
    const auto drawn = [&view] {
      view.update_from(lifted_snapshot(patient(), 0.7, 3.0));
      if constexpr (std::is_same_v<std::decay_t<decltype(view)>, OperatorView>) view.settle();
      view.draw();
      return view.last_picture();
    };
    show(view, 400, 320);
    GlView::governor().set_mode(QualityGovernor::Mode::high);
    const QImage whole = drawn();
    GlView::governor().hold(6);
    drawn();
    QApplication::processEvents();  // its own resolution is another: the framebuffer is made anew
    const QImage first = drawn();
    ASSERT_TRUE(first.size() != whole.size() || difference(whole, first).pixels > 20) << "less is another picture";
    const auto next = make_patient_look(patient());
    const auto cells = next->soft->surface()->GetNumberOfPolys();
    view.show_patient(next, plain_blade());
    const QImage second = drawn();
    ASSERT_EQ(second.size(), first.size());
    EXPECT_EQ(difference(first, second).pixels, 0);
    if (std::is_same_v<std::decay_t<decltype(view)>, OperatorView>) {
      EXPECT_LT(next->soft->surface()->GetNumberOfPolys(), cells);
    }
  };
  OperatorView view;
  view.set_zoom(OperatorView::Zoom::mouth);
  judged(view);
  VideoView video;
  judged(video);
}

TEST_F(Views, TheBlueAirwayComesIntoSightWhenTheTongueGoes) {
  OperatorView view;
  view.set_blue_trachea(true);
  show(view, 500, 420);
  view.set_zoom(OperatorView::Zoom::mouth);
  auto snapshot = at_rest(patient(), {0, 0, 5});
  ASSERT_TRUE(wait_for(
      [&] {
        view.update_from(snapshot);
        return view.closeness() == 1.0;
      },
      5000));
  const Spot hidden = find_pixels(view.picture(), [](QRgb c, int, int) { return is_airway_blue(c); });
  snapshot.soft_points = rest_metres(patient().tongue, {0, -0.5, 0});  // out of the picture altogether
  view.update_from(snapshot);
  const Spot open = find_pixels(view.picture(), [](QRgb c, int, int) { return is_airway_blue(c); });
  EXPECT_EQ(hidden.pixels, 0);
  EXPECT_GT(open.pixels, 20);
}

TEST_F(Views, TheGhostIsThereOnlyWhereHandAndBladePart) {
  OperatorView view;
  show(view, 500, 420);
  view.set_zoom(OperatorView::Zoom::face);
  auto snapshot = at_rest(patient(), {0.0, -0.04, 0.03});
  view.update_from(snapshot);
  EXPECT_FALSE(view.ghost_shown());
  const QImage together = view.picture();
  snapshot.device_pose.position.x() += 0.0004;
  view.update_from(snapshot);
  EXPECT_FALSE(view.ghost_shown()) << "0.4 mm is within the coupling's play";
  snapshot.device_pose.position.x() += 0.02;
  view.update_from(snapshot);
  EXPECT_TRUE(view.ghost_shown());
  EXPECT_GT(difference(together, view.picture()).pixels, 200);
}

TEST_F(Views, TheViewGoesCloserWithTheBladeInAndBackWithItOut) {
  OperatorView view;
  show(view, 300, 260);
  auto in = lifted_snapshot(patient(), 1.0, 0.0), out = lifted_snapshot(patient(), 0.0, 0.0);
  view.update_from(out);
  const double wide = view.mm_per_pixel();
  EXPECT_DOUBLE_EQ(view.closeness(), 0.0);
  ASSERT_TRUE(wait_for(
      [&] {
        view.update_from(in);
        return view.closeness() == 1.0;
      },
      5000));
  EXPECT_LT(view.mm_per_pixel(), 0.6 * wide);
  ASSERT_TRUE(wait_for(
      [&] {
        view.update_from(out);
        return view.closeness() == 0.0;
      },
      5000));
  EXPECT_NEAR(view.mm_per_pixel(), wide, 1e-9);
}

TEST_F(Views, SagittalCutHasTheFrontOnTheLeftAndFollowsTheTongue) {
  SagittalView view;
  show(view, 400, 360);
  auto rest = at_rest(patient(), {0, -5, 0});  // the blade far in front
  view.update_from(rest, 25.0);
  const QImage before = view.picture();
  const auto ground = [](QRgb c, int, int) { return qRed(c) < 40 && qGreen(c) < 40 && qBlue(c) < 45; };
  EXPECT_LT(find_pixels(before, ground).x, 160) << "the room in front of the face";
  const auto blue = find_pixels(before, [](QRgb c, int, int) { return is_airway_blue(c); });
  EXPECT_GT(blue.pixels, 100);
  EXPECT_GT(blue.y, 180) << "the windpipe is below";

  auto lifted = rest;
  lifted.soft_points = rest_metres(patient().tongue, {0, -0.008, 0.0});
  view.update_from(lifted, 25.0);
  const Spot moved = difference(before, view.picture());
  EXPECT_GT(moved.pixels, 300);

  const auto green = [](QRgb c, int, int) { return qGreen(c) > qRed(c) + 50 && qGreen(c) > qBlue(c) + 30; };
  EXPECT_EQ(find_pixels(before, green).pixels, 0);
  rest.glottis_visible = 0.30;
  view.update_from(rest, 25.0);
  EXPECT_GT(find_pixels(view.picture(), green).pixels, 30) << "the sight line is green from the scenario's share on";
}

TEST_F(Views, BarsTurnOverTheTargetAndKeepThePeak) {
  ForceBars bars;
  bars.resize(420, 132);
  bars.set_marks({5.0, 2.0, 7.9});
  const auto over = [](QRgb c, int, int) { return QColor(c) == theme::over(); };
  bars.show_forces({4.9, 0.0, 4.9, 0.0});
  const QImage below = bars.grab().toImage();
  EXPECT_EQ(find_pixels(below, over).pixels, 0);
  const auto within = [](QRgb c, int, int) { return QColor(c) == theme::within(); };
  const int at_4_9 = find_pixels(below, within).pixels;
  bars.show_forces({5.1, 0.0, 5.1, 0.0});
  EXPECT_GT(find_pixels(bars.grab().toImage(), over).pixels, 500);
  bars.show_forces({2.45, 0.0, 2.45, 0.0});
  EXPECT_NEAR(find_pixels(bars.grab().toImage(), within).pixels, 0.5 * at_4_9, 0.03 * at_4_9) << "length is force";
  EXPECT_DOUBLE_EQ(bars.tongue_peak_n(), 5.1);
  bars.show_forces({0.0, 2.5, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(bars.gum_peak_n(), 2.5);
  PeaksSoFar between_pictures;
  between_pictures.tongue_n = 6.0f;
  between_pictures.gum_n = 2.0f;
  bars.show_forces({1.0, 1.0, 1.0, 0.0}, between_pictures);
  EXPECT_DOUBLE_EQ(bars.tongue_peak_n(), 6.0) << "of a tick that no picture showed";
  EXPECT_DOUBLE_EQ(bars.gum_peak_n(), 2.5) << "the higher is kept";
  bars.clear();
  EXPECT_DOUBLE_EQ(bars.tongue_peak_n(), 0.0);
}

TEST_F(Views, AComputerThatIsTooSlowGivesNobodyTime) {
  TrialReadings readings;
  readings.set_scenario({}, std::nullopt);
  engine::Snapshot snapshot;
  snapshot.time_s = 18.0;  // of the newest step
  snapshot.ticks = 20000;  // the hand's
  readings.show_snapshot(snapshot);
  const auto labels = readings.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) { return label->text() == "20.0 s"; }))
      << "as its log and result have it";
}

TEST_F(Views, WhatTheLoopCouldNotDoIsInSight) {
  TrialReadings readings;
  readings.set_scenario({}, std::nullopt);
  engine::Snapshot snapshot;
  snapshot.loop_rate_hz = 1000.0;
  snapshot.ticks = 9000;
  snapshot.deadline_misses = 11;
  snapshot.overruns = 250;
  readings.show_snapshot(snapshot);
  const auto* computer = readings.findChild<QLabel*>("computer");
  ASSERT_NE(computer, nullptr);
  EXPECT_EQ(computer->text(), "too slow: forces come late") << "250 of 9000 steps are more than one in a hundred";
  for (const char* figure : {"1000 Hz", "9000 forces 11 were", "for 250 the tissue's step"})
    EXPECT_TRUE(computer->toolTip().contains(figure)) << figure << ": " << computer->toolTip().toStdString();
  snapshot.overruns = 90;
  readings.show_snapshot(snapshot);
  EXPECT_EQ(computer->text(), "keeps up with the hand");
  snapshot.deadline_misses = 91;
  readings.show_snapshot(snapshot);
  EXPECT_EQ(computer->text(), "too slow: forces come late");
}

TEST_F(Views, TheAttemptsClockStandsInAPauseAndNeverGoesBack) {
  TrialReadings readings;
  readings.set_scenario({}, std::nullopt);
  const auto shows = [&](const QString& text) {
    const auto labels = readings.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->text() == text; });
  };
  engine::Snapshot snapshot;
  snapshot.time_s = 2.0;
  readings.show_snapshot(snapshot, 0.0);
  EXPECT_TRUE(shows("2.0 s"));
  readings.show_snapshot(snapshot, 0.2);  // the pause is told before the snapshot that has it
  EXPECT_TRUE(shows("2.0 s"));
  snapshot.time_s = 5.0;
  readings.show_snapshot(snapshot, 3.0);
  EXPECT_TRUE(shows("2.0 s"));
  snapshot.time_s = 6.0;
  readings.show_snapshot(snapshot, 3.0);
  EXPECT_TRUE(shows("3.0 s"));
  readings.clear();
  EXPECT_TRUE(shows("0.0 s"));
}

TEST_F(Views, WhereTheMouthIsNotKnownTheClockSaysWhatItCounts) {
  TrialReadings readings;
  const auto shows = [](const TrialReadings& panel, const QString& text) {
    const auto labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->text() == text; });
  };
  curricula::Scenario scenario;
  scenario.pass.attempt_time_s = 30.0;
  readings.set_scenario(scenario, std::nullopt);
  EXPECT_TRUE(shows(readings, "From Start"));
  EXPECT_FALSE(shows(readings, "Attempt"));
  EXPECT_FALSE(shows(readings, "at most 30 s")) << "no attempt's limit beside what is none";
  const auto mouth = curricula::mouth_from_landmarks({{"upper_gum_midline", {0.0, 0.0, 0.01}},
                                                      {"lower_gum_midline", {0.0, 0.0, -0.01}},
                                                      {"vallecula", {0.0, 0.05, 0.0}}});
  readings.set_scenario(scenario, mouth);
  EXPECT_TRUE(shows(readings, "Attempt") && shows(readings, "at most 30 s"));
  // A panel that comes later goes on from where the other is.
  engine::Snapshot snapshot;
  for (const auto& [time_s, depth_m] : {std::pair{1.0, -0.03}, {2.0, 0.02}, {7.5, 0.02}}) {
    snapshot.time_s = time_s;
    snapshot.proxy_pose.position = {0.0, depth_m, 0.0};
    readings.show_snapshot(snapshot);
  }
  EXPECT_TRUE(shows(readings, "5.5 s"));
  TrialReadings later;
  later.set_scenario(scenario, mouth);
  later.go_on_from(readings);
  const auto at = [&](double time_s, double depth_m) {
    snapshot.time_s = time_s;
    snapshot.proxy_pose.position = {0.0, depth_m, 0.0};
    later.show_snapshot(snapshot);
  };
  at(8.0, 0.02);
  EXPECT_TRUE(shows(later, "6.0 s"));
  at(12.0, -0.03);
  EXPECT_TRUE(shows(later, "6.0 s")) << "out again: the attempt is over, as in the score";
  at(12.5, 0.02);
  EXPECT_TRUE(shows(later, "10.5 s")) << "without a tube all ways in are one attempt, from the first to the last";
  snapshot.has_intubation = true;
  at(14.0, 0.02);
  EXPECT_TRUE(shows(later, "0.0 s")) << "with a tube each is one";
  later.clear();
  later.set_led(true);
  at(15.0, 0.02);
  at(16.0, 0.02);
  EXPECT_TRUE(shows(later, "0.0 s")) << "led there: no hand's attempt yet";
  later.set_led(false);
  at(17.0, 0.02);
  at(18.0, 0.02);
  EXPECT_TRUE(shows(later, "1.0 s"));
}

TEST(StateWords, ALimitIsTheDevicesAndNeverTissueGivingWay) {
  EXPECT_TRUE(words_for(engine::HapticState::tracking, false).banner.isEmpty());
  for (const auto state : {engine::HapticState::limited, engine::HapticState::lost, engine::HapticState::recovering}) {
    const QString banner = words_for(state, false).banner;
    EXPECT_FALSE(banner.isEmpty());
    EXPECT_FALSE(banner.contains("tissue", Qt::CaseInsensitive)) << banner.toStdString();
  }
  EXPECT_TRUE(words_for(engine::HapticState::limited, false).banner.contains("device limit", Qt::CaseInsensitive));
  EXPECT_NE(words_for(engine::HapticState::lost, false).banner, words_for(engine::HapticState::lost, true).banner);
}

TEST(StateWords, AFaultHidesNoLimit) {
  engine::Snapshot snapshot;
  snapshot.state = engine::HapticState::tracking;
  EXPECT_EQ(banner_for(snapshot, "").toStdString(), "");
  EXPECT_EQ(banner_for(snapshot, "one").toStdString(), "A fault: one. Reset to begin anew; what led to it is kept.");
  snapshot.state = engine::HapticState::limited;
  EXPECT_TRUE(banner_for(snapshot, "").startsWith("Device limit reached"));
  EXPECT_TRUE(banner_for(snapshot, "one").startsWith("Device limit reached"));
  EXPECT_TRUE(banner_for(snapshot, "one").contains(" A fault: one."));
  snapshot.state = engine::HapticState::lost;
  snapshot.faults = engine::kFaultDeviceInvalid;
  EXPECT_TRUE(banner_for(snapshot, "").startsWith("The device stopped answering."));
}

TEST_F(Views, TheGlottisIsPointedOutAndTheExpertsWayGoesRound) {
  OperatorView view;
  show(view, 500, 420);
  view.set_zoom(OperatorView::Zoom::mouth);
  view.update_from(at_rest(patient(), {0, 0, 5}));
  for (int i = 0; i < 3; ++i) view.picture();
  const auto settled = [&] {  // the view zooms for 0.8 s
    for (int i = 0; i < 30 && view.closeness() < 1.0; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      view.update_from(at_rest(patient(), {0, 0, 5}));
    }
    return view.picture();
  };
  const auto yellow = [](QRgb c, int, int) { return qRed(c) > qBlue(c) + 60 && qGreen(c) > qBlue(c) + 60; };
  const QImage plain = settled();
  view.highlight_glottis();
  const QImage marked = view.picture();
  const Spot outline = difference(plain, marked);
  EXPECT_GT(outline.pixels, 10) << "seen even where the tongue hides it";
  EXPECT_GT(find_pixels(marked, yellow).pixels, find_pixels(plain, yellow).pixels);
  EXPECT_NEAR(outline.x, 250.0, 25.0) << "in the middle";

  const engine::Pose before_lips{{0.0, -0.060, 0.045}, engine::Quat::Identity()},
      inside{{0.0, 0.0, 0.010}, engine::Quat::Identity()};
  const auto key = [](double time_s, const engine::Pose& pose) {
    device::Keyframe k;
    k.time_s = time_s;
    for (int axis = 0; axis < 3; ++axis) k.position_m[axis] = pose.position[axis];
    return k;
  };
  view.show_ghost_path(plain_blade(), device::Trajectory({key(0.0, before_lips), key(2.0, inside)}));
  view.set_ghost_time(0.0);
  const QImage begin = view.picture();
  view.set_ghost_time(2.0);
  const QImage end = view.picture();
  EXPECT_GT(difference(begin, end).pixels, 100) << "it moves";
  view.set_ghost_time(3.4);
  EXPECT_LT(difference(view.picture(), end).pixels, 5) << "rests at its end";
  view.set_ghost_time(3.5);
  EXPECT_LT(difference(view.picture(), begin).pixels, 5) << "and begins again after 1.5 s";
  view.show_patient(make_patient_look(patient()), plain_blade());
  view.update_from(at_rest(patient(), {0, 0, 5}));
  EXPECT_LE(find_pixels(settled(), yellow).pixels, find_pixels(plain, yellow).pixels + 5) << "gone with the patient";
}

}  // namespace
}  // namespace vallecula::gui::window_test
