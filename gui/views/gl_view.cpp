#include "gui/views/gl_view.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>

#include <QEvent>
#include <QSurfaceFormat>
#include <stdexcept>

namespace vallecula::gui {

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
}

void GlView::draw() {
  if (!isVisible()) return;
  if (!isValid())
    throw std::runtime_error(
        "OpenGL did not start, so nothing can be drawn: this needs an X display with OpenGL 3.2 (install "
        "libgl1-mesa-dri; "
        "without a screen run `vallecula demo`, which starts its own)");
  QElapsedTimer timer;
  timer.start();
  window_->Render();
  last_draw_ms_ = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

QImage GlView::picture() {
  renderer_->UseFXAAOn();  // smooth edges: worth a pass for a still, not for every frame
  draw();
  const QImage image = grabFramebuffer();
  renderer_->UseFXAAOff();
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
