// A VTK view inside a Qt window, without VTK's own mouse handling: the mouse belongs to the blade.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QImage>

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
  /// What is on the view, drawn anew.
  QImage picture();
  double last_draw_ms() const { return last_draw_ms_; }

 protected:
  bool event(QEvent* event) override;
  vtkRenderer* renderer() const { return renderer_; }

 private:
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> renderer_;
  double last_draw_ms_ = 0.0;
};

}  // namespace vallecula::gui
