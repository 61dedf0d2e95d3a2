#include "gui/pages/remade_window.h"

#include <utility>

#include "gui/pages/main_window.h"

namespace vallecula::gui {

RemadeWindow::RemadeWindow(std::vector<curricula::Curriculum> curricula) : curricula_(std::move(curricula)) { open(); }

RemadeWindow::~RemadeWindow() = default;

void RemadeWindow::open() {
  auto next = std::make_unique<MainWindow>();
  next->show_start(curricula_);
  if (window_) next->take_over(*window_);
  next->show();
  // Once whoever was asked there is gone.
  connect(next.get(), &MainWindow::words_changed, this, &RemadeWindow::remake, Qt::QueuedConnection);
  window_.swap(next);  // the one before goes once this is seen: the program ends with its last window
}

void RemadeWindow::remake(bool first_steps) {
  // What it finds of a program that ended too early it finds once.
  if (window_->looking_back()) {
    connect(
        window_.get(), &MainWindow::looked_back, this, [this, first_steps] { remake(first_steps); },
        Qt::QueuedConnection);
    return;
  }
  // Somebody may have begun something meanwhile: it is in the other language from the next start on.
  if (!window_->may_be_made_anew()) return;
  open();
  if (first_steps) window_->show_first_steps(true);
  emit remade();
}

}  // namespace vallecula::gui
