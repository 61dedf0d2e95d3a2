// A VTK view inside a Qt window: VTK draws into a buffer of its own, and Qt paints that as a picture. So the window
// stays one of Qt's own drawing, which without a graphics card costs a tenth of having OpenGL compose it. VTK's own
// mouse handling is off unless asked for: the mouse belongs to the blade.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkProp.h>
#include <vtkRenderPass.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <QElapsedTimer>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "gui/views/quality.h"

class QVTKInteractor;
class QVTKInteractorAdapter;

namespace vallecula::gui {

/// To be called before the QApplication is made: the OpenGL format VTK needs, and how many threads a software driver
/// draws with.
void prepare_opengl();

class GlView : public QWidget {
  Q_OBJECT
 public:
  explicit GlView(QWidget* parent = nullptr);
  ~GlView() override;

  /// Draws now if the view can be seen; it is on the screen when Qt has painted next. What is new to the view is made
  /// ready first, in parts between which the window answers; then it is drawn by itself. Throws std::runtime_error when
  /// OpenGL did not come up.
  void draw();
  /// What is on the view, drawn anew with everything, whatever is left out in motion.
  QImage picture();
  /// What was drawn last, as large as it is on the screen.
  QImage last_picture();
  /// Whether OpenGL is there; asked before the view was ever shown, it is not yet.
  bool isValid() const { return context_ != nullptr; }
  /// Parts of its first picture are still to be made; it is not on the screen yet.
  bool making_ready() const { return making_ready_; }
  /// How long the window waits for one of them, if no single prop takes longer; 0: each prop is a part.
  void set_part_ms(int ms) { part_ms_ = ms; }
  double last_draw_ms() const { return last_draw_ms_; }  ///< until VTK was done; the driver may draw on
  /// Draws these beside what is shown, until another patient is.
  void add_marks(const std::vector<vtkSmartPointer<vtkProp>>& marks);
  vtkGenericOpenGLRenderWindow* renderWindow() const { return window_; }

  /// Of all views of the window: they share its time.
  static QualityGovernor& governor();

 signals:
  void camera_moved();  ///< by the mouse
  void painted();       ///< what was drawn last is handed to the screen

 protected:
  bool event(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  vtkRenderer* renderer() const { return renderer_; }
  /// What of the scene goes must be released in the view's own context, not in that of the view drawn last.
  void make_current();
  /// Another patient comes: until it is drawn nothing of the one before is shown.
  void forget_picture();
  /// Draws with this from the next frame on; a view with effects of its own takes those as well.
  virtual void use(const Quality& quality);
  /// Uses what the governor says now: for what has just come into the view, which begins with everything.
  void use_present();
  /// VTK's trackball: left turns, middle or Shift moves, right or wheel goes nearer.
  void set_mouse_camera(bool on) { mouse_camera_ = on; }

 private:
  void begin_opengl();
  std::vector<vtkProp*> new_props() const;
  bool make_new_props_ready();
  void draw_later();
  void draw_on();
  void fit();
  void render();
  void fetch();

  // In this order: VTK lets go of what it has in the context before that goes.
  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderPass> passes_;
  vtkSmartPointer<QVTKInteractor> interactor_;
  std::unique_ptr<QVTKInteractorAdapter> adapter_;
  std::vector<vtkWeakPointer<vtkProp>> known_;  ///< have been drawn
  bool making_ready_ = false;
  QTimer later_;        ///< zero: runs out when nothing else is to be done
  bool ready_ = false;  ///< all of it was drawn once since the view was made, or got another patient
  int part_ms_ = 30;
  QImage pixels_;  ///< as VTK drew them
  bool drawn_ = false, fetched_ = false;
  bool mouse_camera_ = false, dragging_ = false;
  double resolution_ = 1.0;  ///< pixels drawn per pixel of the screen, a side, from the next frame on
  double scale_ = 1.0;       ///< pixels drawn per one of Qt's, as the window has it now
  double last_draw_ms_ = 0.0;
  Quality used_;
};

}  // namespace vallecula::gui
