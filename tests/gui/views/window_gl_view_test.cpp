// A view as a widget: what Qt paints is what VTK drew, wherever the view stands and however large it is.
#include <vtkCallbackCommand.h>
#include <vtkPropCollection.h>
#include <vtkRendererCollection.h>

#include <QHBoxLayout>
#include <QMouseEvent>
#include <vector>

#include "gui/views/gl_view.h"
#include "gui/views/operator_view.h"
#include "gui/views/patient_look.h"
#include "tests/gui/picture_difference.h"
#include "tests/gui/window_patient.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr int kFewColours = 40;

class WindowGlView : public Screen {
 protected:
  ~WindowGlView() override {
    GlView::governor().hold(0);
    GlView::governor().set_mode(QualityGovernor::Mode::automatic);
  }
  static void show_mouth(OperatorView& view) {
    static const pipeline::PatientPackage patient = coarse_patient();
    view.resize(kWidth, kHeight);
    view.show_patient(make_patient_look(patient), plain_blade(), nullptr);
    view.set_zoom(OperatorView::Zoom::mouth);
    view.update_from(lifted_snapshot(patient, 0.7, 3.0));
    view.settle();
  }
  static void draw(GlView& view) {
    view.draw();
    EXPECT_TRUE(wait_for([&] { return !view.making_ready(); }));
  }
  static QImage painted(QWidget& widget) { return widget.grab().toImage().convertToFormat(QImage::Format_RGB32); }
  static void expect_alike(const QImage& a, const QImage& b, const char* when) {
    ASSERT_EQ(a.size(), b.size()) << when;
    EXPECT_GT(colours_in(a), kFewColours) << when << ": nothing is on it";
    EXPECT_LT(picture_difference(a, b).mean_grey, 0.5) << when;  // another pose or patient is off by more than 2
  }
};

TEST_F(WindowGlView, PaintsWhatWasDrawnUprightAndWholeAtItsSize) {
  GlView::governor().hold(0);
  OperatorView view;
  show_mouth(view);
  view.show();
  draw(view);
  expect_alike(painted(view), view.last_picture(), "first");
  // Not upside down and not another place: a lower half of skin and a bright blade above.
  EXPECT_GT(picture_difference(painted(view), view.last_picture().mirrored()).mean_grey, 2.0);
  view.resize(kWidth + 111, kHeight + 57);
  QApplication::processEvents();
  expect_alike(painted(view), view.last_picture(), "enlarged, without being told to draw");
  EXPECT_EQ(view.last_picture().size(), QSize(kWidth + 111, kHeight + 57));
}

// Triangles outside the view are left out; in a view under the monitor, four times as wide as high, none is missing.
TEST_F(WindowGlView, AWideViewShowsTheFaceAsTheFreeCameraDoes) {
  GlView::governor().hold(0);
  static const pipeline::PatientPackage patient = coarse_patient();
  const auto drawn = [](Seen seen, OperatorView::Zoom zoom) {
    OperatorView view;
    view.resize(800, 200);
    view.show_patient(make_patient_look(patient, {}, seen), plain_blade(), nullptr);
    view.set_zoom(zoom);
    view.update_from(lifted_snapshot(patient, 0.7, 3.0));
    view.settle();
    if (seen == Seen::all_round) view.set_free_camera(true);  // from the same place, and leaves nothing out
    view.show();
    QApplication::processEvents();
    return view.picture();
  };
  for (const auto zoom : {OperatorView::Zoom::face, OperatorView::Zoom::mouth})
    EXPECT_LT(picture_difference(drawn(Seen::all_round, zoom), drawn(Seen::from_the_eye, zoom)).mean_grey, 0.3);
}

TEST_F(WindowGlView, AStillNeedsNoScreen) {
  GlView::governor().hold(0);
  OperatorView hidden, shown;
  show_mouth(hidden);
  show_mouth(shown);
  shown.show();
  QApplication::processEvents();
  expect_alike(hidden.picture(), shown.picture(), "never shown");
}

TEST_F(WindowGlView, StaysWhenItIsTakenToAnotherWindow) {
  GlView::governor().hold(0);
  QWidget window, other;
  auto* row = new QHBoxLayout(&window);
  auto* view = new OperatorView(&window);
  row->addWidget(view);
  show_mouth(*view);
  window.resize(kWidth, kHeight);
  window.show();
  QApplication::processEvents();
  draw(*view);
  const QImage before = painted(*view);
  (new QHBoxLayout(&other))->addWidget(view);  // as a dock that is torn off
  other.resize(kWidth, kHeight);
  other.show();
  QApplication::processEvents();
  draw(*view);
  expect_alike(before, painted(*view), "in its new window");
}

// A first picture is made in parts; what is hidden in the middle of them is whole when it is seen again.
TEST_F(WindowGlView, WhatIsHiddenBeforeItWasReadyComesWhenItIsSeenAgain) {
  GlView::governor().hold(0);
  OperatorView view, truth;
  show_mouth(view);
  show_mouth(truth);
  view.set_part_ms(0);
  view.show();
  view.draw();
  ASSERT_TRUE(view.making_ready()) << "one prop of many was made ready";
  view.hide();
  for (int i = 0; i < 50; ++i) QApplication::processEvents();
  ASSERT_TRUE(view.making_ready()) << "nobody sees it, so nothing goes on";
  view.show();
  EXPECT_TRUE(wait_for([&] { return !view.making_ready(); }));
  QApplication::processEvents();
  expect_alike(painted(view), truth.picture(), "seen again");
}

// A first picture takes its time, part by part: a key pressed meanwhile is heard between two of them.
TEST_F(WindowGlView, TheNextPartOfAFirstPictureStandsBehindWhatElseIsAsked) {
  GlView::governor().hold(0);
  OperatorView view;
  show_mouth(view);
  int parts = 0, parts_when_asked = -1;
  const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(&parts);
  command->SetCallback([](vtkObject*, unsigned long, void* made, void*) { ++*static_cast<int*>(made); });
  view.renderWindow()->AddObserver(vtkCommand::StartEvent, command);
  view.set_part_ms(0);
  view.show();
  view.draw();
  ASSERT_EQ(parts, 1);
  ASSERT_TRUE(view.making_ready());
  QMetaObject::invokeMethod(
      &view, [&] { parts_when_asked = parts; }, Qt::QueuedConnection);
  ASSERT_TRUE(wait_for([&] { return !view.making_ready() && parts_when_asked >= 0; }));
  EXPECT_EQ(parts_when_asked, 1);
  EXPECT_GT(parts, 2);
}

/// How many props can be seen in each picture that VTK makes of this view from now on.
void watch_frames(GlView& view, std::vector<int>& seen) {
  const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(&seen);
  command->SetCallback([](vtkObject* window, unsigned long, void* frames, void*) {
    auto* props = static_cast<vtkRenderWindow*>(window)->GetRenderers()->GetFirstRenderer()->GetViewProps();
    vtkCollectionSimpleIterator at;
    props->InitTraversal(at);
    int visible = 0;
    while (vtkProp* prop = props->GetNextProp(at)) visible += prop->GetVisibility();
    static_cast<std::vector<int>*>(frames)->push_back(visible);
  });
  view.renderWindow()->AddObserver(vtkCommand::StartEvent, command);
}

// A panel that is opened in mid-trial is painted by Qt before the page's next frame draws it: not with all its shaders.
TEST_F(WindowGlView, WhatQtPaintsBeforeItIsDrawnIsMadeReadyInPartsToo) {
  GlView::governor().hold(0);
  OperatorView view, truth;
  show_mouth(view);
  show_mouth(truth);
  view.set_part_ms(0);
  std::vector<int> frames;
  watch_frames(view, frames);
  bool on_screen = false;
  QObject::connect(&view, &GlView::painted, [&] { on_screen = true; });
  const int props = view.renderWindow()->GetRenderers()->GetFirstRenderer()->GetViewProps()->GetNumberOfItems();
  ASSERT_GT(props, 3);
  view.show();
  view.repaint();
  view.repaint();  // asks for one drawing, not for two
  EXPECT_TRUE(frames.empty()) << "painting draws nothing that is new";
  EXPECT_TRUE(wait_for([&] { return on_screen; })) << "without anybody telling it to draw";
  ASSERT_GT(frames.size(), static_cast<std::size_t>(props));
  for (int i = 0; i < props; ++i) EXPECT_EQ(frames[i], 1) << "part " << i;
  EXPECT_EQ(static_cast<int>(frames.size()), props + 1) << "each of them once, then the whole";
  expect_alike(painted(view), truth.picture(), "painted first");
}

TEST_F(WindowGlView, OfThePatientBeforeNothingIsShown) {
  GlView::governor().hold(0);
  OperatorView view, truth;
  show_mouth(view);
  show_mouth(truth);
  view.show();
  draw(view);
  ASSERT_GT(colours_in(painted(view)), kFewColours);
  QApplication::processEvents();
  QApplication::sendPostedEvents(&view, QEvent::MetaCall);  // what is told of the paintings so far, a late one's too
  bool on_screen = false;
  QObject::connect(&view, &GlView::painted, [&] { on_screen = true; });
  show_mouth(view);  // the next one's
  EXPECT_EQ(colours_in(painted(view)), 1) << "until it is drawn the view is empty";
  ASSERT_FALSE(on_screen);
  EXPECT_TRUE(wait_for([&] { return on_screen; })) << "and then it comes by itself";
  expect_alike(painted(view), truth.picture(), "the next patient");
}

TEST_F(WindowGlView, TheMouseTurnsAFreeCameraAlikeAtEveryResolution) {
  QImage turned[2];
  for (const int step : {0, static_cast<int>(kQualities.size()) - 1}) {
    GlView::governor().hold(step);
    OperatorView view;
    show_mouth(view);
    view.show();
    view.set_free_camera(true);
    draw(view);
    QApplication::processEvents();
    const QImage before = view.picture();
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons held) {
      QMouseEvent event(type, at, view.mapToGlobal(at), button, held, Qt::NoModifier);
      QApplication::sendEvent(&view, &event);
    };
    send(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseMove, {140, 90}, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, {140, 90}, Qt::LeftButton, Qt::NoButton);
    turned[step == 0 ? 0 : 1] = view.picture();
    EXPECT_GT(picture_difference(before, turned[step == 0 ? 0 : 1]).mean_grey, 2.0) << "it turned";
  }
  // A hand's way on the screen turns by so much, however many pixels are drawn (VTK's trackball counts whole ones).
  EXPECT_LT(picture_difference(turned[0], turned[1]).mean_grey, 2.0);
}

}  // namespace
}  // namespace vallecula::gui::window_test
