#include "gui/views/gl_view.h"

#include <QVTKInteractor.h>
#include <QVTKInteractorAdapter.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkCameraPass.h>
#include <vtkCullerCollection.h>
#include <vtkFrustumCoverageCuller.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLightsPass.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkOverlayPass.h>
#include <vtkPropCollection.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>
#include <vtkUnsignedCharArray.h>

#include <QMouseEvent>
#include <QPainter>
#include <QSurfaceFormat>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gui/views/drawing_threads.h"

namespace vallecula::gui {
namespace {

constexpr double kCorner = 1.0 / 64;  // of the view's sides: so few pixels cost nothing beside what is made ready

/// One frame of the window: from the first view that is drawn until it is handed to the screen.
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

/// What is seen through is blended over what lies behind it, farthest first. VTK's own way needs no order, at the price
/// of two more pictures to draw to: an eighth of a frame without a graphics card, for a tube and a ghost.
vtkSmartPointer<vtkRenderPass> farthest_first(vtkRenderer& renderer) {
  auto* cullers = renderer.GetCullers();
  cullers->InitTraversal();
  while (vtkCuller* culler = cullers->GetNextItem())
    if (auto* by_distance = vtkFrustumCoverageCuller::SafeDownCast(culler)) by_distance->SetSortingStyleToBackToFront();
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(vtkNew<vtkTranslucentPass>());
  passes->AddItem(vtkNew<vtkOverlayPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

template <class Callback>
void observe(vtkObject* object, unsigned long event, void* client, Callback callback) {
  const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(client);
  command->SetCallback(callback);
  object->AddObserver(event, command);
}

}  // namespace

QualityGovernor& GlView::governor() {
  static QualityGovernor governor;
  return governor;
}

void prepare_opengl() {
  limit_drawing_threads();
  // A CT's millimetres need no shifted origin in single precision; looking for one in all that moves took a tenth of a
  // frame.
  vtkOpenGLVertexBufferObject::GlobalCoordShiftAndScaleEnabledOff();
  auto format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

GlView::GlView(QWidget* parent)
    : QWidget(parent),
      window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      interactor_(vtkSmartPointer<QVTKInteractor>::New()),
      adapter_(std::make_unique<QVTKInteractorAdapter>()) {
  window_->SetMultiSamples(0);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetReadyForRendering(false);
  window_->AddRenderer(renderer_);
  passes_ = farthest_first(*renderer_);
  renderer_->SetPass(passes_);
  observe(window_, vtkCommand::WindowMakeCurrentEvent, this,
          [](vtkObject*, unsigned long, void* view, void*) { static_cast<GlView*>(view)->make_current(); });
  observe(window_, vtkCommand::WindowIsCurrentEvent, this, [](vtkObject*, unsigned long, void* view, void* answer) {
    const auto* context = static_cast<GlView*>(view)->context_.get();
    *static_cast<bool*>(answer) = context != nullptr && QOpenGLContext::currentContext() == context;
  });
  observe(window_, vtkCommand::WindowFrameEvent, this, [](vtkObject*, unsigned long, void* view, void*) {
    auto* self = static_cast<GlView*>(view);
    self->drawn_ = true;
    self->fetched_ = false;
    self->update();
  });
  interactor_->SetRenderWindow(window_);
  interactor_->SetInteractorStyle(vtkSmartPointer<vtkInteractorStyleTrackballCamera>::New());
  interactor_->Initialize();
  interactor_->EnableRenderOff();  // it moves the camera; whoever hears camera_moved() draws
  later_.setSingleShot(true);
  later_.setInterval(0);
  connect(&later_, &QTimer::timeout, this, &GlView::draw_on);
  setFocusPolicy(Qt::NoFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);  // every pixel is the picture's
}

GlView::~GlView() {
  if (!context_) return;
  make_current();
  window_->Finalize();
  context_->doneCurrent();
  window_->SetReadyForRendering(false);
}

void GlView::begin_opengl() {
  if (context_) return;
  auto context = std::make_unique<QOpenGLContext>();
  auto surface = std::make_unique<QOffscreenSurface>();
  if (!context->create()) return;
  surface->setFormat(context->format());
  surface->create();
  if (!surface->isValid() || !context->makeCurrent(surface.get())) return;
  surface_ = std::move(surface);
  context_ = std::move(context);
  window_->SetOwnContext(0);
  window_->SetMapped(1);
  window_->SetIsDirect(1);
  window_->SetSupportsOpenGL(1);
  window_->SetForceMaximumHardwareLineWidth(1);
  window_->OpenGLInit();
  window_->SetReadyForRendering(true);
  put_drawing_threads_behind();
}

void GlView::make_current() {
  if (context_ && QOpenGLContext::currentContext() != context_.get()) context_->makeCurrent(surface_.get());
}

/// VTK draws as many pixels as the view has on the screen, or the share of them that the quality asks for.
void GlView::fit() {
  if (!dragging_) scale_ = resolution_ * devicePixelRatioF();  // the trackball compares places of two moments
  const double scale = scale_;
  const int wide = std::max(1, static_cast<int>(std::lround(scale * width())));
  const int high = std::max(1, static_cast<int>(std::lround(scale * height())));
  window_->SetScreenSize(wide, high);
  window_->SetDPI(static_cast<int>(std::lround(72.0 * scale)));
  interactor_->SetSize(wide, high);
  adapter_->SetDevicePixelRatio(static_cast<float>(scale));
  const int* size = window_->GetSize();
  if (size[0] == wide && size[1] == high) return;
  window_->SetSize(wide, high);
  drawn_ = false;
}

void GlView::render() {
  begin_opengl();
  if (!isValid())
    throw std::runtime_error(
        "OpenGL did not start, so nothing can be drawn: this needs an X display with OpenGL 3.2 (install "
        "libgl1-mesa-dri; "
        "without a screen run `vallecula demo`, which starts its own)");
  fit();
  window_->Render();
  ready_ = true;
}

/// What VTK has drawn in no frame yet.
std::vector<vtkProp*> GlView::new_props() const {
  std::vector<vtkProp*> fresh;
  auto* props = renderer_->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at))
    if (std::find(known_.begin(), known_.end(), prop) == known_.end()) fresh.push_back(prop);
  return fresh;
}

/// What was never drawn is drawn alone into a corner first: its shaders are compiled and its triangles handed over,
/// which without a graphics card takes some ten ms each. What is hidden as yet is as well: it would be missed in
/// mid-trial.
bool GlView::make_new_props_ready() {
  begin_opengl();
  if (!isValid()) return true;  // render() says so
  QElapsedTimer timer;
  timer.start();
  const std::vector<vtkProp*> fresh = new_props();
  if (fresh.empty()) return true;
  known_.erase(std::remove(known_.begin(), known_.end(), nullptr), known_.end());
  std::vector<std::pair<vtkProp*, int>> shown;
  auto* props = renderer_->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at)) {
    shown.emplace_back(prop, prop->GetVisibility());
    prop->VisibilityOff();
  }
  renderer_->SetViewport(0.0, 0.0, kCorner, kCorner);
  fit();
  std::size_t made = 0;
  do {
    vtkProp* prop = fresh[made++];
    prop->VisibilityOn();
    window_->Render();
    prop->VisibilityOff();
    known_.emplace_back(prop);
  } while (made < fresh.size() && timer.elapsed() < part_ms_);
  renderer_->SetViewport(0.0, 0.0, 1.0, 1.0);
  for (const auto& [prop, visible] : shown) prop->SetVisibility(visible);
  drawn_ = false;
  return made == fresh.size();
}

void GlView::draw() {
  if (!isVisible()) return;
  if (!(used_ == governor().quality())) use_present();
  making_ready_ = !make_new_props_ready();
  if (making_ready_) return draw_later();
  frame_watch().begins();
  QElapsedTimer timer;
  timer.start();
  render();
  last_draw_ms_ = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

/// Once, however often it is asked for until then, and behind whatever waits: a page that was just opened and its first
/// picture are two pieces of work, with room for a key between them.
void GlView::draw_later() {
  if (!later_.isActive()) later_.start();
}

/// Unless somebody else has drawn meanwhile.
void GlView::draw_on() {
  if (isValid() && (!drawn_ || !ready_ || making_ready_)) draw();
}

void GlView::forget_picture() {
  pixels_ = {};
  drawn_ = fetched_ = ready_ = false;
  update();
}

/// From the driver, which may still be drawing: as late as possible, so that several views are drawn together.
void GlView::fetch() {
  if (fetched_) return;
  const int* size = window_->GetSize();
  if (pixels_.size() != QSize(size[0], size[1])) pixels_ = QImage(size[0], size[1], QImage::Format_RGBX8888);
  const auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetNumberOfComponents(4);
  bytes->SetArray(pixels_.bits(), 4LL * size[0] * size[1], 1);
  window_->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, bytes);
  fetched_ = true;
}

void GlView::use_present() {
  used_ = governor().quality();
  use(used_);
}

void GlView::use(const Quality& quality) { resolution_ = std::min(1.0, quality.resolution); }

QImage GlView::picture() {
  use({});
  vtkNew<vtkOpenGLFXAAPass> smooth_edges;  // worth a pass for a still, not for every frame
  smooth_edges->SetDelegatePass(passes_);
  renderer_->SetPass(smooth_edges);
  render();
  const QImage image = last_picture();
  smooth_edges->ReleaseGraphicsResources(window_);
  renderer_->SetPass(passes_);
  use_present();
  return image;
}

QImage GlView::last_picture() {
  if (!drawn_) render();
  fetch();
  QImage upright = pixels_.mirrored();  // OpenGL begins at the bottom
  const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
  if (upright.size() != size) upright = upright.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  return upright.convertToFormat(QImage::Format_RGB32);
}

void GlView::add_marks(const std::vector<vtkSmartPointer<vtkProp>>& marks) {
  for (const auto& mark : marks) renderer_->AddViewProp(mark);
}

void GlView::showEvent(QShowEvent* event) {
  begin_opengl();
  QWidget::showEvent(event);
}

void GlView::resizeEvent(QResizeEvent* event) {
  fit();
  QWidget::resizeEvent(event);
}

void GlView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  // Nothing new is drawn from here: all shaders at once would hold the window up. What was hidden before it was ready
  // goes on now, and so does a view that is seen before anybody has drawn it.
  if (!isValid() || !ready_ || (!drawn_ && !new_props().empty())) {
    if (pixels_.isNull())
      painter.fillRect(rect(), palette().window());
    else
      painter.drawImage(rect(), pixels_.mirrored());  // of the same patient: what is new comes to it
    if (isValid()) draw_later();                      // draw() says what is wrong where it is not
    return;
  }
  if (!drawn_) render();
  fetch();
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(rect(), pixels_.mirrored());
  // Qt hands the window's picture to the screen when all views have painted: what is asked for here comes after that.
  QMetaObject::invokeMethod(
      this,
      [this] {
        frame_watch().ends();
        emit painted();
      },
      Qt::QueuedConnection);
}

bool GlView::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
      if (!mouse_camera_) break;
      if (event->type() != QEvent::Wheel) dragging_ = static_cast<QMouseEvent*>(event)->buttons() != Qt::NoButton;
      adapter_->ProcessEvent(event, interactor_);
      event->accept();
      emit camera_moved();
      return true;
    default:
      break;
  }
  return QWidget::event(event);
}

}  // namespace vallecula::gui
