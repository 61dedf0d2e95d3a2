#include "gui/views/gl_view.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>

#include <QEvent>
#include <QSurfaceFormat>
#include <stdexcept>

namespace vallecula::gui {
namespace {

/// One frame of the window: from the first view that is drawn until it is on the screen, which a software driver's own
/// thread needs time for after VTK is done.
class FrameWatch {
 public:
  void begins() {
    if (!since_.isValid() || since_.elapsed() > 1000) since_.start();  // one that never came to the screen counts not
  }
  bool ends() {
    if (!since_.isValid()) return false;
    const double busy_s = 1e-9 * static_cast<double>(since_.nsecsElapsed());
    since_.invalidate();
    return GlView::governor().frame(1e-9 * static_cast<double>(clock_.nsecsElapsed()), busy_s);
  }
  FrameWatch() { clock_.start(); }

 private:
  QElapsedTimer since_, clock_;
};

FrameWatch& frame_watch() {
  static FrameWatch watch;
  return watch;
}

}  // namespace

QualityGovernor& GlView::governor() {
  static QualityGovernor governor;
  return governor;
}

void prepare_opengl() {
  // llvmpipe starts a drawing thread per core, which takes the 1 kHz loop's turn away (PLATFORM: 14 % late against 0.06
  // %).
  if (!qEnvironmentVariableIsSet("LP_NUM_THREADS")) qputenv("LP_NUM_THREADS", "1");
  auto format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

GlView::GlView(QWidget* parent)
    : QVTKOpenGLNativeWidget(parent),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()) {
  window_->SetMultiSamples(0);
  setRenderWindow(window_);
  window_->AddRenderer(renderer_);
  interactor()->SetInteractorStyle(vtkSmartPointer<vtkInteractorStyleTrackballCamera>::New());
  setFocusPolicy(Qt::NoFocus);
  setEnableHiDPI(true);
  connect(this, &QOpenGLWidget::frameSwapped, this, [] { frame_watch().ends(); });
}

void GlView::render() {
  if (!isValid())
    throw std::runtime_error(
        "OpenGL did not start, so nothing can be drawn: this needs an X display with OpenGL 3.2 (install "
        "libgl1-mesa-dri; "
        "without a screen run `vallecula demo`, which starts its own)");
  window_->Render();
}

void GlView::draw() {
  if (!isVisible()) return;
  if (!(used_ == governor().quality())) use_present();
  frame_watch().begins();
  QElapsedTimer timer;
  timer.start();
  render();
  last_draw_ms_ = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

void GlView::use_present() {
  used_ = governor().quality();
  use(used_);
}

void GlView::use(const Quality& quality) {
  setCustomDevicePixelRatio(quality.resolution < 1.0 ? quality.resolution * devicePixelRatioF() : 0.0);
}

QImage GlView::picture() {
  use({});
  renderer_->UseFXAAOn();  // smooth edges: worth a pass for a still, not for every frame
  if (isVisible()) render();
  const QImage image = grabFramebuffer();
  renderer_->UseFXAAOff();
  use_present();
  return image;
}

void GlView::add_marks(const std::vector<vtkSmartPointer<vtkProp>>& marks) {
  for (const auto& mark : marks) renderer_->AddViewProp(mark);
}

bool GlView::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
      if (mouse_camera_) {
        const bool taken = QVTKOpenGLNativeWidget::event(event);
        emit camera_moved();
        return taken;
      }
      return QOpenGLWidget::event(event);
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return QOpenGLWidget::event(event);  // up to the page
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
}

}  // namespace vallecula::gui
