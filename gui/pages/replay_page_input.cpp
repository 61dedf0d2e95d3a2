// The replay page's keys, and the pictures and clips it gives away.
#include <QBuffer>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QTabWidget>
#include <algorithm>
#include <stdexcept>

#include "gui/pages/clip_export.h"
#include "gui/pages/notes_panel.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/timeline.h"
#include "gui/session/files.h"
#include "gui/session/words_from_below.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"

namespace vallecula::gui {

namespace {

constexpr double kTurn_deg = 5.0;

}  // namespace

void ReplayPage::keyPressEvent(QKeyEvent* event) {
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  const bool turning = shift && operator_view_->free_camera();
  const auto turn = [&](double right, double up) {
    operator_view_->turn_camera(right, up);
    dirty_ = true;
  };
  const int way = event->key() == Qt::Key_Left ? -1 : 1;
  switch (event->key()) {
    case Qt::Key_Space:
      return play(!playing_);
    case Qt::Key_Left:
    case Qt::Key_Right:
      return turning ? turn(kTurn_deg * way, 0.0) : shift ? seek(at_s_ + way) : step(way);
    case Qt::Key_Up:
    case Qt::Key_Down:
      if (turning) return turn(0.0, event->key() == Qt::Key_Up ? kTurn_deg : -kTurn_deg);
      return QWidget::keyPressEvent(event);
    case Qt::Key_PageUp:
      return to_previous_event();
    case Qt::Key_PageDown:
      return to_next_event();
    case Qt::Key_Home:
      return seek(0.0);
    case Qt::Key_End:
      return seek(trial_ ? trial_->end_s() : 0.0);
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      return rate_->setCurrentIndex(
          std::clamp(rate_->currentIndex() + (event->key() == Qt::Key_Plus ? 1 : -1), 0, rate_->count() - 1));
    case Qt::Key_A:
      return arrows_->toggle();
    case Qt::Key_P:
      return path_->toggle();
    case Qt::Key_X:
      if (expert_->isEnabled()) expert_->toggle();
      return;
    case Qt::Key_C:
      return heat_->toggle();
    case Qt::Key_F:
      return free_->toggle();
    case Qt::Key_H:
      if (half_->isEnabled()) half_->toggle();
      return;
    case Qt::Key_L:
      return show_large_chart(!views_->isHidden());
    case Qt::Key_N:
      play(false);
      lists_->setCurrentWidget(notes_);
      return notes_->write();
    case Qt::Key_S:
      if (event->modifiers().testFlag(Qt::ControlModifier)) return ask_for_picture();
      return QWidget::keyPressEvent(event);
    case Qt::Key_Escape:
      if (notes_->isAncestorOf(focusWidget())) return setFocus();  // out of the note, not out of the replay
      emit left();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void ReplayPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  dirty_ = true;
  if (trial_) timer_.start();
}

void ReplayPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  play(false);
  timer_.stop();
}

QImage ReplayPage::picture() {
  const QImage eye = operator_view_->picture(), cut = sagittal_view_->picture();
  const int high = std::max(eye.height(), cut.height()), gap = 8, line = 34;
  QImage whole(eye.width() + gap + cut.width(), high + line, QImage::Format_RGB32);
  whole.fill(palette().color(QPalette::Window));
  QPainter painter(&whole);
  painter.drawImage(0, (high - eye.height()) / 2, eye);
  painter.drawImage(eye.width() + gap, (high - cut.height()) / 2, cut);
  painter.setPen(palette().color(QPalette::WindowText));
  QString words = clock_text(at_s_) + QString::fromUtf8("  \u00b7  ") + figures_->text();
  if (trial_) {
    const curricula::LogTick& tick = trial_->tick_at(at_s_);
    words += tr("  \u00b7  tongue %1 N, gum %2 N")
                 .arg(decimal(load_n(tick, curricula::kTongue), 1))
                 .arg(decimal(load_n(tick, curricula::kGum), 1));
  }
  painter.drawText(QRect(10, high, whole.width() - 20, line), Qt::AlignVCenter | Qt::AlignLeft, words);
  return whole;
}

void ReplayPage::save_picture(const QString& png) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture().save(&buffer, "PNG"))
    throw std::runtime_error(tr("%1: the picture could not be encoded as PNG").arg(png).toStdString());
  write_file_whole(png.toStdString(), bytes.toStdString());
  tell_saved(png);
}

void ReplayPage::tell_saved(const QString& file) {
  saved_ = tr("Saved: %1").arg(QDir::toNativeSeparators(QFileInfo(file).absoluteFilePath()));
}

QImage ReplayPage::picture_of(double at_s) {
  seek(at_s);
  return picture();
}

double ReplayPage::computed_s() const {
  const std::size_t frames = trial_ ? trial_->film->computed() : 0;
  return frames == 0 ? 0.0 : trial_->film->time_s(frames - 1);
}

void ReplayPage::ask_for_clip() {
  if (!trial_) return;
  play(false);
  const double back_to_s = at_s_;
  ClipExport dialog([this](double at_s) { return picture_of(at_s); }, std::min(at_s_, computed_s()), computed_s(),
                    std::max(trial_->film->frame_s(), 1.0 / kFilmRateHz), this);
  const bool saved = dialog.exec() == QDialog::Accepted;
  seek(back_to_s);
  if (saved) tell_saved(dialog.file());
}

void ReplayPage::ask_for_picture() {
  if (!trial_) return;
  play(false);
  const auto folder = trial_->log_file.parent_path() / ("replay-" + std::to_string(static_cast<int>(at_s_)) + "s.png");
  const QString png = QFileDialog::getSaveFileName(this, tr("Save a picture"), QString::fromStdString(folder.string()),
                                                   tr("Pictures (*.png)"));
  if (png.isEmpty()) return;
  try {
    save_picture(png);
  } catch (const std::exception& error) {
    QMessageBox::warning(this, tr("The picture was not saved"), QString::fromUtf8(error.what()));
  }
}

}  // namespace vallecula::gui
