// The tube and the cords as drawn: real diameters, marks where they are on the tube, cords that part around it.
#include "gui/views/tube_look.h"

#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gui/views/airway_marks.h"
#include "gui/views/drape_look.h"
#include "gui/views/larynx_look.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/theme.h"
#include "tests/gui/placed_tube.h"
#include "tests/gui/window_patient.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using engine::Vec3;

const pipeline::PatientPackage& patient() {
  static const pipeline::PatientPackage package = coarse_patient();
  return package;
}

TEST(SweptAxis, FollowsAnArcAndGoesStraightOnBeyondTheGrip) {
  constexpr double kRadius = 0.06, kSegment = 0.0036;
  engine::Snapshot snapshot;
  const auto on_arc = [&](double s) -> Vec3 {
    return kRadius * Vec3(std::sin(s / kRadius), 0.0, 1.0 - std::cos(s / kRadius));
  };
  for (int i = 0; i < engine::kTubeNodes; ++i) snapshot.tube_axis[i] = on_arc(i * kSegment);
  for (int i = 0; i < engine::kTubeSegments; ++i)
    snapshot.tube_frames[i] = Eigen::AngleAxisd(-(i + 0.5) * kSegment / kRadius, Vec3::UnitY());
  const SweptAxis axis(snapshot.tube_axis, snapshot.tube_frames);
  EXPECT_NEAR(axis.length_m(), engine::kTubeSegments * kSegment, 1e-4);
  for (double s = 0.0; s < axis.length_m(); s += 0.0007) {
    const double arc = s * engine::kTubeSegments * kSegment / axis.length_m();  // the chords are a little shorter
    EXPECT_LT((axis.at(s).at - on_arc(arc)).norm(), 5e-5) << s;
    EXPECT_GT(axis.at(s).axes.col(0).dot(Vec3(std::cos(arc / kRadius), 0.0, std::sin(arc / kRadius))), 0.999);
  }
  const auto end = axis.at(axis.length_m()), beyond = axis.at(axis.length_m() + 0.03);
  EXPECT_LT((beyond.at - end.at - 0.03 * end.axes.col(0)).norm(), 1e-12);
}

/// Largest and smallest distance of an actor's points from a straight axis along x, m; and how far they reach.
struct Extent {
  double nearest = 1.0, farthest = 0.0, from = 1.0, to = -1.0;
};
Extent extent(vtkActor* actor) {
  Extent e;
  vtkDataSet* data = actor->GetMapper()->GetInput();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const Vec3 p = 1e-3 * Vec3(data->GetPoint(i));
    e.nearest = std::min(e.nearest, std::hypot(p.y(), p.z()));
    e.farthest = std::max(e.farthest, std::hypot(p.y(), p.z()));
    e.from = std::min(e.from, p.x());
    e.to = std::max(e.to, p.x());
  }
  return e;
}

class TubeLooks : public Screen {
 protected:
  /// Held straight along x from the origin.
  static engine::Snapshot straight(const engine::IntubationDescription& intubation) {
    engine::Snapshot snapshot;
    snapshot.step = 1;
    snapshot.has_intubation = true;
    const double segment = engine::usual_grip_from_tip(intubation.tube) / engine::kTubeSegments;
    for (int i = 0; i < engine::kTubeNodes; ++i) snapshot.tube_axis[i] = i * segment * Vec3::UnitX();
    snapshot.tube_frames.fill(engine::Quat::Identity());
    return snapshot;
  }
  static std::vector<Extent> shown(const TubeLook& look) {
    std::vector<Extent> extents;
    for (const auto& actor : look.actors())
      if (actor->GetVisibility()) extents.push_back(extent(actor));
    return extents;
  }
};

TEST_F(TubeLooks, HaveTheRealDiametersAndTheHandsContent) {
  engine::IntubationDescription intubation = plain_intubation(patient());
  TubeLook look(intubation);
  look.update({});
  EXPECT_TRUE(shown(look).empty()) << "before the first step";
  engine::Snapshot snapshot = straight(intubation);
  snapshot.intubation.in_hand = engine::InHand::tube;
  look.update(snapshot);
  const auto is_wall = [&](const Extent& e) { return std::abs(e.nearest - e.farthest) < 1e-7 && e.to > 0.1; };
  const auto tube = shown(look);
  const auto wall = std::find_if(tube.begin(), tube.end(), is_wall);
  ASSERT_NE(wall, tube.end());
  EXPECT_NEAR(wall->farthest, 0.5 * 0.0049, 1e-7);
  EXPECT_NEAR(wall->from, 0.0, 1e-7);
  EXPECT_NEAR(wall->to, 0.180, 1e-6);
  // The bevel's face: from the tip to where the opening ends, between the inner and the outer wall.
  EXPECT_TRUE(std::any_of(tube.begin(), tube.end(), [](const Extent& e) {
    return std::abs(e.nearest - 0.00175) < 1e-7 && std::abs(e.farthest - 0.00245) < 1e-7 && std::abs(e.from) < 1e-7 &&
           std::abs(e.to - 0.0049 / std::tan(0.654)) < 1e-6;
  }));
  // No stylet once it is out; with it, a thin rod that ends short of the tip.
  const auto is_stylet = [](const Extent& e) {
    return std::abs(e.farthest - 0.0006) < 1e-7 && std::abs(e.from - 0.005) < 1e-6;
  };
  EXPECT_TRUE(std::none_of(tube.begin(), tube.end(), is_stylet));
  snapshot.intubation.in_hand = engine::InHand::tube_with_stylet;
  look.update(snapshot);
  const auto with_stylet = shown(look);
  EXPECT_TRUE(std::any_of(with_stylet.begin(), with_stylet.end(), is_stylet));
  EXPECT_FALSE(look.catheter_shown());
  snapshot.intubation.in_hand = engine::InHand::catheter;
  look.update(snapshot);
  EXPECT_TRUE(look.catheter_shown());
  for (const Extent& e : shown(look)) EXPECT_TRUE(e.farthest < 0.00134 || e.from > 0.1) << "the tube is put away";
  snapshot.has_intubation = false;
  look.update(snapshot);
  EXPECT_TRUE(shown(look).empty());
}

TEST_F(TubeLooks, PrintTheCordMarkAndACentimetreEachWhereTheyAre) {
  for (const char* size : {"2.5", "3.5"}) {
    const engine::TubeDesign tube = engine::tube_design(size);
    const QImage print = tube_print(tube);
    const double per_m = print.width() / tube.length;
    const auto inked = [&](double from_tip_m) {  // share of the way round
      int count = 0;
      for (int y = 0; y < print.height(); ++y)
        count += qAlpha(print.pixel(static_cast<int>(from_tip_m * per_m), y)) > 200;
      return count / static_cast<double>(print.height());
    };
    EXPECT_EQ(inked(tube.cord_mark_from_tip - 0.5 * tube.cord_mark_width), 1.0);
    EXPECT_LT(inked(tube.cord_mark_from_tip + 0.0004), 0.1);
    EXPECT_LT(inked(tube.cord_mark_from_tip - tube.cord_mark_width - 0.0004), 0.1);
    for (int cm = tube.first_cm_mark; cm < static_cast<int>(100.0 * tube.length); ++cm) {
      EXPECT_EQ(inked(0.01 * cm), 1.0) << size << " at " << cm;
      EXPECT_LT(inked(0.01 * cm - 0.001), 0.6) << size << " before " << cm;
    }
    EXPECT_LT(inked(0.01 * (tube.first_cm_mark - 1)), 0.1) << "none before the first";
  }
}

TEST(CordsLook, OpensAsTheEngineHasItAndPartsAroundATube) {
  const auto intubation = plain_intubation(patient());
  CordsLook cords(intubation);
  engine::Snapshot snapshot;
  snapshot.step = 1;
  snapshot.has_intubation = true;
  for (auto& node : snapshot.tube_axis) node = {1.0, 1.0, 1.0};  // far away
  for (const double opening : {0.0, 0.4, 1.0}) {
    snapshot.intubation.glottis_opening = opening;
    cords.update(snapshot);
    for (int row = 0; row < CordsLook::kRows; ++row)
      for (int side = 0; side < 2; ++side)
        EXPECT_DOUBLE_EQ(
            cords.free_edges()[row][side],
            half_width(intubation.glottis, opening, intubation.glottis.length_m * row / (CordsLook::kRows - 1)));
  }
  snapshot.intubation.glottis_opening = 0.0;
  lay_tube(snapshot, intubation, way_to_trachea(patient()), 1, 20.0);
  snapshot.intubation.glottis_opening = 0.0;
  cords.update(snapshot);
  const auto& edges = cords.free_edges();
  double widest = 0.0;
  for (const auto& row : edges) widest = std::max(widest, row[0] + row[1]);
  EXPECT_NEAR(widest, 0.0049, 0.0005) << "closed cords lie close to the tube between them";
  for (int side = 0; side < 2; ++side)
    for (int row = 1; row + 1 < CordsLook::kRows; ++row)
      EXPECT_GE(edges[row][side] + 1e-12, 0.5 * (edges[row - 1][side] + edges[row + 1][side])) << "taut, not dented";
}

TEST(AirwayMarks, NeedCords) {
  const engine::AirwayCourse none;
  EXPECT_THROW(airway_marks(none, 0.0, 0.0, 1.0), std::runtime_error);
  EXPECT_FALSE(airway_marks(plain_intubation(patient()).course, 0.0, 0.0, 1.0).props.empty());
}

TEST(AirwayMarks, FollowTheTextsSizeAndLeaveOutNumbersThatHaveNoRoom) {
  const AirwayMarks marks = airway_marks(plain_intubation(patient()).course, 0.0, 0.0, 1.0);
  ASSERT_GE(marks.centimetres.size(), 3u);
  const auto points = [](vtkBillboardTextActor3D& word) { return word.GetTextProperty()->GetFontSize(); };
  const auto seen = [&] {
    std::string numbers;
    for (const auto& one : marks.centimetres)
      if (one->GetVisibility()) numbers += one->GetInput();
    return numbers;
  };
  marks.set_type(1.0, 20.0);
  EXPECT_EQ(points(*marks.good_depth), 14);
  EXPECT_EQ(points(*marks.centimetres[0]), 11);
  EXPECT_EQ(seen().substr(0, 3), "123");
  marks.set_type(1.35, 20.0);
  EXPECT_EQ(points(*marks.good_depth), 19);
  EXPECT_EQ(points(*marks.centimetres[0]), 15);
  EXPECT_EQ(seen().substr(0, 3), "123");
  marks.set_type(1.35, 12.0);  // a low panel: a digit is taller than a centimetre
  EXPECT_EQ(seen().substr(0, 1), "2");
  EXPECT_EQ(seen().find('3'), std::string::npos);
}

TEST(AirwayMarks, TheGoodStretchsWordStandsClearOfTheAirwayHoweverSmallThePicture) {
  const AirwayMarks marks = airway_marks(plain_intubation(patient()).course, 0.0, 0.0, 1.0);
  for (const double px_per_mm : {1.0, 2.0, 4.0, 9.0}) {
    for (const double text_scale : {1.0, 1.35}) {
      marks.set_type(text_scale, 10.0 * px_per_mm);
      ASSERT_TRUE(marks.good_depth->GetVisibility());
      double at[3];
      marks.good_depth->GetPosition(at);
      const double away_px = px_per_mm * (Eigen::Vector2d(at[1], at[2]) - marks.good_front_mm).dot(marks.good_out);
      EXPECT_NEAR(away_px, 16.0, 1e-6) << px_per_mm;
      EXPECT_LT(marks.good_depth->GetDisplayOffset()[0], 0) << "and ends before its line does";
      double end[3];
      vtkPolyData::SafeDownCast(marks.leader->GetMapper()->GetInputDataObject(0, 0))->GetPoint(1, end);
      EXPECT_NEAR(end[1], at[1], 1e-4);
      EXPECT_NEAR(end[2], at[2], 1e-4);
    }
  }
  int box[4];
  marks.set_type(1.0, 20.0);
  ASSERT_TRUE(vtkTextRenderer::GetInstance()->GetBoundingBox(marks.good_depth->GetTextProperty(),
                                                             marks.good_depth->GetInput(), box, 72));
  const double word_px = box[1] - box[0];
  marks.set_type(1.0, 20.0, 2.0 * word_px);
  EXPECT_TRUE(marks.good_depth->GetVisibility() && marks.leader->GetVisibility());
  marks.set_type(1.0, 20.0, word_px);
  EXPECT_FALSE(marks.good_depth->GetVisibility()) << "there is no room for it and its line";
  EXPECT_FALSE(marks.leader->GetVisibility());
}

class TubeViews : public Screen {
 protected:
  engine::IntubationDescription intubation_ = plain_intubation(patient());
  engine::Snapshot rest() const {
    engine::Snapshot snapshot = lifted_snapshot(patient(), 0.0, 0.0);
    snapshot.proxy_pose.position = snapshot.device_pose.position = {0, -5, 0};
    return snapshot;
  }
  void open(SagittalView& view) const {
    view.resize(400, 480);
    view.show_patient(make_patient_look(patient()), plain_blade(), &intubation_);
    view.show();
    QApplication::processEvents();
  }
};

// What of the body's end is not hidden by the cloth from any side: nothing of the skin below the hem.
TEST(Drape, LiesOverAllThatTheSkinHasBelowItsHem) {
  const auto look = make_patient_look(patient());
  const auto cloth = drape(*look);
  ASSERT_TRUE(cloth);
  const double* box = cloth->GetBounds();
  const auto& marks = patient().landmarks;
  const double glottis = marks.at("glottis_centre")[2], carina = marks.at("carina")[2];
  EXPECT_NEAR(box[5], 0.5 * (glottis + carina), 1e-3) << "below the larynx, above the carina";
  int below = 0, outside = 0;
  for (const auto& p : patient().surfaces.at("face").points) {
    if (p[2] > box[5] - 6.0) continue;
    ++below;
    outside += p[0] < box[0] || p[0] > box[1] || p[1] < box[2] || p[1] > box[3] || p[2] < box[4];
  }
  EXPECT_GT(below, 50);
  EXPECT_EQ(outside, 0);
  look->package.landmarks.erase("carina");
  EXPECT_FALSE(drape(*look)) << "where the neck ends is not known";
}

TEST_F(TubeViews, TheTubeIsSeenByTheOperatorOnTheRight) {
  OperatorView view;
  view.resize(500, 420);
  view.show_patient(make_patient_look(patient()), plain_blade(), &intubation_);
  view.set_zoom(OperatorView::Zoom::face);
  view.show();
  QApplication::processEvents();
  ASSERT_TRUE(view.isValid());
  engine::Snapshot snapshot = rest();
  view.update_from(snapshot);
  const QImage without = view.picture();
  lay_tube(snapshot, intubation_, way_to_trachea(patient()), 1, 20.0);
  view.update_from(snapshot);
  const Spot tube = difference(without, view.picture());
  ASSERT_GT(tube.pixels, 800);
  EXPECT_GT(tube.x, 270.0) << "it comes from the patient's right, which is the picture's";
}

TEST_F(TubeViews, TheCutReachesTheCarinaAndHasTheTubeInTheTrachea) {
  SagittalView view;
  open(view);
  ASSERT_TRUE(view.isValid());
  engine::Snapshot snapshot = rest();
  view.update_from(snapshot, 25.0);
  const QImage without = view.picture();
  const auto green = [](QRgb c, int, int) { return qGreen(c) > qRed(c) + 100 && qGreen(c) > qBlue(c) + 30; };
  const auto blue = [](QRgb c, int, int) { return is_airway_blue(c); };
  const Spot good = find_pixels(without, green), trachea = find_pixels(without, blue);
  ASSERT_GT(good.pixels, 200);
  ASSERT_GT(trachea.pixels, 200);
  EXPECT_NEAR(good.y, trachea.y, 25.0) << "the middle third lies in the middle of the windpipe";
  lay_tube(snapshot, intubation_, way_to_trachea(patient()), 1, 20.0);
  view.update_from(snapshot, 25.0);
  const QImage with = view.picture();
  const auto black = [&](QRgb c, int x, int y) {
    return qGray(c) < 45 && qGray(without.pixel(x, y)) > 60;  // the cord mark, on the blue
  };
  const Spot mark = find_pixels(with, black);
  EXPECT_GT(mark.pixels, 8);
  EXPECT_GT(difference(without, with).pixels, 300);
  EXPECT_LT(find_pixels(with, blue).pixels, trachea.pixels) << "it lies before the trachea's cut";
  EXPECT_LT(mark.y, good.y) << "the mark is above the good depth";
}

// Out beside the cheek it would be drawn through windpipe and spine: a cut shows what lies about its plane.
TEST_F(TubeViews, TheCutShowsNoTubeThatLiesBesideTheHead) {
  SagittalView view;
  open(view);
  ASSERT_TRUE(view.isValid());
  engine::Snapshot snapshot = rest();
  view.update_from(snapshot, 25.0);
  const QImage without = view.picture();
  lay_tube(snapshot, intubation_, way_to_trachea(patient()), 1, 20.0);
  snapshot.intubation.place = engine::TipPlace::outside;
  const auto seen_at = [&](double aside_mm) {
    snapshot.intubation.tip_m.x() = 1e-3 * (patient().landmarks.at("glottis_centre")[0] + aside_mm);
    view.update_from(snapshot, 25.0);
    return difference(without, view.picture()).pixels;
  };
  EXPECT_GT(seen_at(5.0), 300) << "before the mouth it is seen";
  EXPECT_LT(seen_at(25.0), 30);
  EXPECT_GT(seen_at(5.0), 300) << "and is there again";
}

TEST_F(TubeViews, TheCutsWordsFollowTheTextsSizeWhileItIsOpen) {
  SagittalView view;
  open(view);
  ASSERT_TRUE(view.isValid());
  const auto white = [&](double scale) {
    theme::apply(*qApp, {theme::Ground::dark, scale});
    view.update_from(rest(), 25.0);
    const QImage picture = view.picture();
    keep_picture(view, "cut-words-" + std::to_string(static_cast<int>(100 * scale + 0.5)) + ".png");
    return find_pixels(picture, [](QRgb c, int, int) { return qRed(c) > 200 && qGreen(c) > 200 && qBlue(c) > 200; })
        .pixels;
  };
  const int usual = white(1.0), large = white(1.35);
  theme::apply(*qApp, {});
  ASSERT_GT(usual, 100);
  EXPECT_GT(large, 1.3 * usual) << "ink grows with the square of the type's size, lines between the marks stay";
}

TEST_F(TubeViews, SecretionsCoverAndSuctionClears) {
  OperatorView view;
  view.set_blue_trachea(true);
  view.resize(500, 420);
  view.show_patient(make_patient_look(patient()), plain_blade(), &intubation_);
  view.show();
  QApplication::processEvents();
  ASSERT_TRUE(view.isValid());
  engine::Snapshot snapshot = rest();
  snapshot.soft_points.assign(snapshot.soft_points.size(), -1.0f);  // the tongue is out of the way
  lay_tube(snapshot, intubation_, way_to_trachea(patient()), 1, -200.0);
  view.set_zoom(OperatorView::Zoom::mouth);
  ASSERT_TRUE(wait_for(
      [&] {
        view.update_from(snapshot);
        return view.closeness() == 1.0;
      },
      5000));
  const auto blue_at = [&](double ml) {
    snapshot.intubation.secretions_ml = ml;
    view.update_from(snapshot);
    return find_pixels(view.picture(), [](QRgb c, int, int) { return is_airway_blue(c); }).pixels;
  };
  const int dry = blue_at(0.0), full = blue_at(3.5);
  EXPECT_GT(dry, 20);
  EXPECT_LT(full, dry / 3);
  EXPECT_EQ(blue_at(0.0), dry);
}

}  // namespace
}  // namespace vallecula::gui::window_test
