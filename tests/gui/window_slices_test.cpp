// The slice views as a person uses them, on a volume whose truth is known by construction.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "gui/views/label_view.h"
#include "gui/views/slice_view.h"
#include "pipeline/package/label_map.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using pipeline::Point;

constexpr SlicePlane kPlanes[] = {SlicePlane::axial, SlicePlane::coronal, SlicePlane::sagittal};

void mouse(QWidget& on, QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons,
           Qt::KeyboardModifiers keys = Qt::NoModifier) {
  QMouseEvent event(type, at, on.mapToGlobal(at.toPoint()), button, buttons, keys);
  QApplication::sendEvent(&on, &event);
}
void drag(QWidget& on, QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton) {
  mouse(on, QEvent::MouseButtonPress, from, button, button);
  mouse(on, QEvent::MouseMove, 0.5 * (from + to), Qt::NoButton, button);
  mouse(on, QEvent::MouseMove, to, Qt::NoButton, button);
  mouse(on, QEvent::MouseButtonRelease, to, button, Qt::NoButton);
}
void click(QWidget& on, QPointF at) { drag(on, at, at); }
void press(QWidget& on, Qt::Key key) {
  QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
  QApplication::sendEvent(&on, &event);
}

/// 80 x 100 x 60 voxels of 0.5 x 0.5 x 1 mm; blocks of 3 x 3 x 3 voxels of 3000 HU about the marks.
class WindowSlices : public Screen {
 protected:
  WindowSlices() {
    pipeline::Grid grid;
    grid.size = {80, 100, 60};
    grid.spacing = {0.5, 0.5, 1.0};
    grid.origin = {100.0, -200.0, 50.0};
    scan_ = std::make_shared<pipeline::Hounsfield>(grid, std::int16_t{-1000});
  }
  Point mark(int x, int y, int z) {
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) scan_->at(x + i, y + j, z + k) = 3000;
    return scan_->grid.position(x, y, z);
  }
  void show() {
    scene_.set_scan(scan_);
    scene_.set_grey({1500.0, 100.0});
    for (SlicePlane plane : kPlanes) {
      auto view = std::make_unique<SliceView>(scene_, plane);
      view->resize(400, 360);
      view->show();
      view->fit();
      views_[static_cast<std::size_t>(plane)] = std::move(view);
    }
    QApplication::processEvents();
  }
  SliceView& view(SlicePlane plane) { return *views_[static_cast<std::size_t>(plane)]; }
  /// The middle of the white spot nearest to where it should be, as a person sees it.
  static Spot white_spot(QWidget& on, const QPointF& about, double reach = 14.0) {
    return find_pixels(on.grab().toImage(), [&](QRgb c, int x, int y) {
      return qRed(c) > 200 && qGreen(c) > 200 && qBlue(c) > 200 && std::hypot(x - about.x(), y - about.y()) < reach;
    });
  }

  std::shared_ptr<pipeline::Hounsfield> scan_;
  SliceScene scene_;
  std::array<std::unique_ptr<SliceView>, 3> views_;
};

TEST_F(WindowSlices, AMarkedVoxelShowsAtTheRightPlaceInAllThreeViews) {
  const Point left_front_high = mark(65, 20, 48);
  show();
  scene_.set_crosshair(left_front_high);
  scene_.scroll(SlicePlane::axial, 0);
  struct Quadrant {
    SlicePlane plane;
    int right, below;  // of the picture's middle
  };
  for (const Quadrant& q : {Quadrant{SlicePlane::axial, 1, -1}, Quadrant{SlicePlane::coronal, 1, -1},
                            Quadrant{SlicePlane::sagittal, -1, -1}}) {
    SliceView& on = view(q.plane);
    const QImage image = on.grab().toImage();
    const Spot spot = white_spot(on, on.pixel_of(left_front_high));
    ASSERT_GT(spot.pixels, 10) << axes_of(q.plane).name;
    EXPECT_NEAR(spot.x + 0.5, on.pixel_of(left_front_high).x(), 1.0);
    EXPECT_NEAR(spot.y + 0.5, on.pixel_of(left_front_high).y(), 1.0);
    // Independently of the view's own mapping: 80 x 100 voxels fill 40 x 50 (60 high) mm about the middle.
    const SliceAxes axes = axes_of(q.plane);
    const auto& g = scan_->grid;
    const double share_across = (left_front_high[axes.across] - g.origin[axes.across] + 0.5 * g.spacing[axes.across]) /
                                (g.size[axes.across] * g.spacing[axes.across]);
    const double wide = 0.98 *
                        std::min(400.0 / (g.size[axes.across] * g.spacing[axes.across]),
                                 360.0 / (g.size[axes.down] * g.spacing[axes.down])) *
                        g.size[axes.across] * g.spacing[axes.across];
    EXPECT_NEAR(spot.x + 0.5, 200.0 + (share_across - 0.5) * wide, 1.0) << axes.name;
    EXPECT_GT(q.right * (spot.x - 200.0), 20.0) << axes.name;
    EXPECT_GT(q.below * (spot.y - 180.0), 20.0) << axes.name;
    EXPECT_EQ(image.size(), QSize(400, 360));
  }
}

TEST_F(WindowSlices, AClickTakesAllSlicesToThePoint) {
  const Point there = mark(30, 70, 20);
  show();
  SliceView& axial = view(SlicePlane::axial);
  click(axial, axial.pixel_of(there));
  EXPECT_EQ(scene_.slice_index(SlicePlane::sagittal), 30);
  EXPECT_EQ(scene_.slice_index(SlicePlane::coronal), 70);
  EXPECT_EQ(scene_.slice_index(SlicePlane::axial), 30) << "the slice itself stays";
  SliceView& coronal = view(SlicePlane::coronal);
  click(coronal, coronal.pixel_of(there));
  EXPECT_EQ(scene_.slice_index(SlicePlane::axial), 20);
  for (SlicePlane plane : kPlanes)
    EXPECT_GT(white_spot(view(plane), view(plane).pixel_of(there)).pixels, 10) << axes_of(plane).name;
  EXPECT_NE(scene_.describe(there).indexOf("3000 HU"), -1) << scene_.describe(there).toStdString();
  EXPECT_NE(scene_.describe(there).indexOf("L 115.0   P -165.0   H 70.0 mm"), -1)
      << scene_.describe(there).toStdString();
}

TEST_F(WindowSlices, WheelAndKeysScrollMoveZoomAndStayInside) {
  show();
  SliceView& axial = view(SlicePlane::axial);
  const int before = scene_.slice_index(SlicePlane::axial);
  QWheelEvent wheel(QPointF(200, 180), axial.mapToGlobal(QPoint(200, 180)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&axial, &wheel);
  EXPECT_EQ(scene_.slice_index(SlicePlane::axial), before + 1);
  press(axial, Qt::Key_PageDown);
  press(axial, Qt::Key_PageDown);
  EXPECT_EQ(scene_.slice_index(SlicePlane::axial), before - 1);
  const Point from = scene_.crosshair();
  press(axial, Qt::Key_Right);
  press(axial, Qt::Key_Up);
  EXPECT_DOUBLE_EQ(scene_.crosshair()[0], from[0] + 0.5) << "right on the screen is the patient's left";
  EXPECT_DOUBLE_EQ(scene_.crosshair()[1], from[1] - 0.5) << "up is the front";
  press(view(SlicePlane::sagittal), Qt::Key_Up);
  EXPECT_DOUBLE_EQ(scene_.crosshair()[2], from[2] + 1.0) << "up is the head";
  const double scale = axial.pixels_per_mm();
  press(axial, Qt::Key_Plus);
  EXPECT_NEAR(axial.pixels_per_mm(), 1.2 * scale, 1e-9);
  press(axial, Qt::Key_0);
  EXPECT_NEAR(axial.pixels_per_mm(), scale, 1e-9);
  for (int i = 0; i < 200; ++i) press(axial, Qt::Key_PageUp);
  EXPECT_EQ(scene_.slice_index(SlicePlane::axial), 59);
  drag(axial, {100, 100}, {160, 130}, Qt::MiddleButton);
  EXPECT_NEAR(axial.pixel_of(from).x() - 200.0, 60.0 + scale * (from[0] - 119.75), 1e-9)
      << "panned by the pointer's way";
}

TEST_F(WindowSlices, RulerAndAngleMeasureWhatIsThere) {
  // 3-4-5: 15 mm along x, 20 mm along y; and straight up from the corner, in another plane.
  const Point corner = mark(20, 30, 30), along = mark(50, 30, 30), across = mark(20, 70, 30);
  show();
  scene_.set_crosshair(corner);
  SliceView& axial = view(SlicePlane::axial);
  const double pixel_mm = 1.0 / axial.pixels_per_mm();
  const auto seen = [&](const Point& p) {
    const Spot spot = white_spot(axial, axial.pixel_of(p));
    EXPECT_GT(spot.pixels, 10);
    return QPointF(spot.x + 0.5, spot.y + 0.5);
  };
  const QPointF a = seen(along), c = seen(corner), b = seen(across);
  scene_.set_tool(SliceTool::ruler);
  drag(axial, a, b);
  ASSERT_EQ(scene_.measures().size(), 1u);
  EXPECT_FALSE(scene_.measuring());
  EXPECT_NEAR(length_mm(scene_.measures()[0].points[0], scene_.measures()[0].points[1]), 25.0, 2.0 * pixel_mm);
  click(axial, c);
  EXPECT_TRUE(scene_.measuring());
  click(axial, a);
  ASSERT_EQ(scene_.measures().size(), 2u);
  EXPECT_NEAR(length_mm(scene_.measures()[1].points[0], scene_.measures()[1].points[1]), 15.0, 2.0 * pixel_mm);
  scene_.set_tool(SliceTool::angle);
  for (const QPointF& p : {c, a, b}) click(axial, p);
  ASSERT_EQ(scene_.measures().size(), 3u);
  const auto& angle = scene_.measures()[2].points;
  EXPECT_NEAR(angle_deg(angle[0], angle[1], angle[2]), std::atan2(20.0, 15.0) * 180.0 / M_PI, 1.0);

  const auto yellow = [&] {
    return find_pixels(axial.grab().toImage(),
                       [](QRgb q, int, int) { return qRed(q) > 200 && qGreen(q) > 190 && qBlue(q) < 120; })
        .pixels;
  };
  EXPECT_GT(yellow(), 50);
  scene_.scroll(SlicePlane::axial, 5);
  EXPECT_EQ(yellow(), 0) << "a measure belongs to its slice";
  scene_.scroll(SlicePlane::axial, -5);
  for (int i = 0; i < 3; ++i) press(axial, Qt::Key_Delete);
  EXPECT_EQ(yellow(), 0);
  EXPECT_TRUE(scene_.measures().empty());
  // Without a mouse: from the crosshair, 10 voxels of 0.5 mm to the right.
  scene_.set_tool(SliceTool::ruler);
  press(axial, Qt::Key_Return);
  for (int i = 0; i < 10; ++i) press(axial, Qt::Key_Right);
  press(axial, Qt::Key_Return);
  ASSERT_EQ(scene_.measures().size(), 1u);
  EXPECT_NEAR(length_mm(scene_.measures()[0].points[0], scene_.measures()[0].points[1]), 5.0, 1e-9);
}

TEST_F(WindowSlices, DraggingALandmarkMovesItByThePointersWayAndNothingElse) {
  show();
  const Point at = scan_->grid.position(30.3, 42.7, 25.2);
  scene_.set_landmarks({{"vallecula", {at, false}}});
  scene_.set_crosshair(scan_->grid.position(10, 10, 25));
  QString name;
  Point dropped{};
  int drops = 0;
  QObject::connect(&scene_, &SliceScene::landmark_dropped, [&](const QString& which, const Point& where) {
    name = which;
    dropped = where;
    ++drops;
  });
  SliceView& axial = view(SlicePlane::axial);
  // The scale from outside: 50 mm of y fill 98 % of 360 pixels.
  const double pixels_per_mm = 0.98 * 360.0 / 50.0;
  const QPointF grab = axial.pixel_of(at) + QPointF(2, -3);  // not quite on it
  click(axial, grab);
  EXPECT_EQ(drops, 0) << "touched, not moved";
  drag(axial, grab, grab + QPointF(40, -25));
  ASSERT_EQ(drops, 1);
  EXPECT_EQ(name, "vallecula");
  EXPECT_NEAR(dropped[0] - at[0], 40.0 / pixels_per_mm, 1e-9);
  EXPECT_NEAR(dropped[1] - at[1], -25.0 / pixels_per_mm, 1e-9);
  EXPECT_DOUBLE_EQ(dropped[2], at[2]) << "a drag in the slice keeps the height, even off the slice's middle";
  EXPECT_EQ(scene_.crosshair(), scan_->grid.position(10, 10, 25));
  scene_.set_crosshair(scan_->grid.position(10, 10, 40));  // 15 mm above
  drag(axial, axial.pixel_of(dropped), axial.pixel_of(dropped) + QPointF(30, 0));
  EXPECT_EQ(drops, 1) << "what is not shown in this slice is not dragged in it";
}

TEST_F(WindowSlices, TheRightButtonDragsWindowAndLevel) {
  show();
  scene_.set_grey({40.0, 400.0});
  drag(view(SlicePlane::coronal), {100, 100}, {150, 80}, Qt::RightButton);
  EXPECT_DOUBLE_EQ(scene_.grey().width, 500.0);
  EXPECT_DOUBLE_EQ(scene_.grey().centre, 80.0);
  drag(view(SlicePlane::coronal), {390, 100}, {0, 100}, Qt::RightButton);
  EXPECT_DOUBLE_EQ(scene_.grey().width, 1.0) << "never below the least there is";
}

TEST_F(WindowSlices, TheSeedToolPicksThePointClicked) {
  const Point there = mark(60, 50, 30);
  show();
  scene_.set_tool(SliceTool::seed);
  Point picked{};
  QObject::connect(&scene_, &SliceScene::seed_picked, [&](const Point& at) { picked = at; });
  SliceView& sagittal = view(SlicePlane::sagittal);
  scene_.set_crosshair(scan_->grid.position(60, 10, 10));
  click(sagittal, sagittal.pixel_of(there));
  const auto c = scan_->grid.nearest(picked);
  EXPECT_EQ(c, (std::array<int, 3>{60, 50, 30}));
}

TEST_F(WindowSlices, ALandmarkIsSeenThroughWhatHidesItAndGoesAlongWhileItIsDraggedInASlice) {
  scene_.set_scan(scan_);
  auto labels = std::make_shared<pipeline::Labels>(scan_->grid);
  for (int z = 5; z < 55; ++z)
    for (int y = 10; y < 90; ++y)
      for (int x = 10; x < 70; ++x) labels->at(x, y, z) = pipeline::kTongue;
  LabelView view(scene_);
  view.resize(500, 400);
  view.show();
  scene_.set_labels(labels);
  const Point inside = scan_->grid.position(40, 50, 30);
  scene_.set_landmarks({{"vallecula", {inside, false}}});
  ASSERT_TRUE(wait_for([&] { return view.up_to_date(); }));
  const auto ball = [&] {
    return find_pixels(view.picture(), [](QRgb c, int, int) { return qRed(c) > 90 && qBlue(c) > 9 * qRed(c) / 10; });
  };
  const auto expect_at = [&](const Point& at) {
    const Spot seen = ball();
    EXPECT_GT(seen.pixels, 20);
    EXPECT_NEAR(seen.x, view.pixel_of(at).x(), 2.0);
    EXPECT_NEAR(seen.y, view.pixel_of(at).y(), 2.0);
  };
  expect_at(inside);
  const Point moved{inside[0], inside[1] - 8.0, inside[2] + 6.0};
  scene_.drag_landmark("vallecula", moved);  // as a slice does it, before it is let go
  expect_at(moved);
}

TEST_F(WindowSlices, EscapePutsTheToolAway) {
  show();
  scene_.set_tool(SliceTool::seed);
  press(view(SlicePlane::axial), Qt::Key_Escape);
  EXPECT_EQ(scene_.tool(), SliceTool::crosshair);
}

TEST_F(WindowSlices, PlacesAreNeverMinusNought) {
  EXPECT_EQ(tenths_of(-0.04), "0.0");
  EXPECT_EQ(tenths_of(-0.06), "-0.1");
  EXPECT_EQ(tenths_of(12.25), "12.3");
  EXPECT_EQ(words_of("bone_mandible"), "mandible");
  EXPECT_EQ(words_of("upper_gum_midline"), "upper gum midline");
}

TEST_F(WindowSlices, TheLabelsStandInThreeDimensionsAndLandmarksAreDraggedThere) {
  scene_.set_scan(scan_);
  auto labels = std::make_shared<pipeline::Labels>(scan_->grid);
  for (int z = 20; z < 40; ++z)
    for (int y = 30; y < 70; ++y)
      for (int x = 20; x < 60; ++x) labels->at(x, y, z) = pipeline::kTongue;
  LabelView view(scene_);
  view.resize(500, 400);
  view.show();
  scene_.set_labels(labels);
  scene_.set_landmarks({{"vallecula", {scan_->grid.position(40, 20, 45), false}}});
  ASSERT_TRUE(wait_for([&] { return view.up_to_date(); }));
  view.draw();
  const auto reddish = [&] {
    return find_pixels(view.picture(), [](QRgb c, int, int) { return qRed(c) > 80 && qRed(c) > 3 * qGreen(c) / 2; });
  };
  const Spot tongue = reddish();
  EXPECT_GT(tongue.pixels, 3000);
  const QPointF middle = view.pixel_of(scan_->grid.position(39.5, 49.5, 29.5));
  // The faces that are seen lie about the middle, not evenly: within a tenth of the widget.
  EXPECT_NEAR(tongue.x, middle.x(), 40.0);
  EXPECT_NEAR(tongue.y, middle.y(), 40.0);
  scene_.set_visible(pipeline::kTongue, false);
  EXPECT_EQ(reddish().pixels, 0);

  Point dropped{};
  QObject::connect(&scene_, &SliceScene::landmark_dropped, [&](const QString&, const Point& at) { dropped = at; });
  const QPointF from = view.pixel_of(scene_.landmarks().at("vallecula").at);
  drag(view, from, from + QPointF(30, 20));
  const QPointF to = view.pixel_of(dropped);
  EXPECT_NEAR(to.x() - from.x(), 30.0, 0.5);
  EXPECT_NEAR(to.y() - from.y(), 20.0, 0.5);
}

TEST_F(WindowSlices, OfTheScanBeforeNoStructureIsShown) {
  scene_.set_scan(scan_);
  auto labels = std::make_shared<pipeline::Labels>(scan_->grid);
  for (int z = 20; z < 40; ++z)
    for (int y = 30; y < 70; ++y)
      for (int x = 20; x < 60; ++x) labels->at(x, y, z) = pipeline::kTongue;
  LabelView view(scene_);
  view.resize(300, 240);
  view.show();
  scene_.set_labels(labels);
  const auto colours = [&] { return colours_in(view.grab().toImage().convertToFormat(QImage::Format_RGB32)); };
  ASSERT_TRUE(wait_for([&] { return view.up_to_date() && !view.making_ready() && colours() > 5; }));
  scene_.set_scan(scan_);  // the next patient's; nothing of it is labelled yet
  EXPECT_EQ(colours(), 1) << "not even until it is drawn anew";
}

}  // namespace
}  // namespace vallecula::gui::window_test
