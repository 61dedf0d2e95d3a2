// A VTK view inside a Qt window. VTK's own mouse handling is off unless asked for: the mouse belongs to the blade.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkProp.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QImage>
#include <vector>

#include "gui/views/quality.h"

namespace vallecula::gui {

/// To be called before the QApplication is made: the OpenGL format VTK needs, and as few drawing threads as leave the
/// haptic threads their cores.
void prepare_opengl();

class GlView : public QVTKOpenGLNativeWidget {
  Q_OBJECT
 public:
  explicit GlView(QWidget* parent = nullptr);

  /// Draws now if the view can be seen. Throws std::runtime_error when OpenGL did not come up: Qt itself would go on
  /// with an empty picture and say nothing.
  void draw();
  /// What is on the view, drawn anew with everything, whatever is left out in motion.
  QImage picture();
  double last_draw_ms() const { return last_draw_ms_; }
  /// Draws these beside what is shown, until another patient is.
  void add_marks(const std::vector<vtkSmartPointer<vtkProp>>& marks);

   /// Of all views of the window: they share its time.
  static QualityGovernor& governor();

 signals:
  void camera_moved();  ///< by the mouse
  /// What is left out is another from now on; `words` are QualityGovernor::reduced().
  void quality_changed(const QString& words);

 protected:
  bool event(QEvent* event) override;
  vtkRenderer* renderer() const { return renderer_; }
  /// Draws with this from the next frame on; a view with effects of its own takes those as well.
  virtual void use(const Quality& quality);
  /// To be called once another patient is shown, which begins with everything: use() of what all views have now.
  void use_present_quality();
  /// VTK's trackball: left turns, middle or Shift moves, right or wheel goes nearer.
  void set_mouse_camera(bool on) { mouse_camera_ = on; }

 private:
  void render();
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> renderer_;
  bool mouse_camera_ = false;
  double last_draw_ms_ = 0.0;
  Quality used_;
};

}  // namespace vallecula::gui
