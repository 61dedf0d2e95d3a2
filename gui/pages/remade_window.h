// The program's main window. In another language all of it is made anew, with the first steps where it was chosen
// there.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "curricula/scenario.h"

namespace vallecula::gui {

class MainWindow;

class RemadeWindow : public QObject {
  Q_OBJECT
 public:
  /// Shows a window with these to choose from.
  explicit RemadeWindow(std::vector<curricula::Curriculum> curricula);
  ~RemadeWindow() override;
  /// The one that is shown: another after remade().
  MainWindow& window() { return *window_; }

 signals:
  void remade();

 private:
  void open();
  void remake(bool first_steps);

  std::vector<curricula::Curriculum> curricula_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace vallecula::gui
