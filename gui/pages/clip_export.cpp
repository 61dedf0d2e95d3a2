#include "gui/pages/clip_export.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <cmath>

namespace vallecula::gui {

namespace {

constexpr double kUsual_s = 10.0;

}  // namespace

ClipExport::ClipExport(Picture picture, double from_s, double until_s, double step_s, QWidget* parent)
    : QDialog(parent), picture_(std::move(picture)), step_s_(step_s) {
  setWindowTitle(tr("Save a clip"));
  const auto second = [&](const QString& name) {
    auto* box = new QDoubleSpinBox(this);
    box->setRange(0.0, until_s);
    box->setDecimals(1);
    box->setSuffix(" s");
    box->setAccessibleName(name);
    return box;
  };
  from_ = second(tr("From"));
  to_ = second(tr("To"));
  told_ = new QLabel(tr("Both views as they are set now, as MP4 (H.264): slide programs, browsers and players show it."), this);
  told_->setObjectName("faint");
  told_->setWordWrap(true);
  bar_ = new QProgressBar(this);
  bar_->setTextVisible(false);
  bar_->setValue(0);
  auto* form = new QFormLayout(this);
  form->addRow(tr("From"), from_);
  form->addRow(tr("To"), to_);
  form->addRow(told_);
  form->addRow(bar_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  save_ = buttons->addButton(tr("Save ..."), QDialogButtonBox::ActionRole);
  save_->setObjectName("primary");
  form->addRow(buttons);
  connect(save_, &QPushButton::clicked, this, &ClipExport::ask);
  connect(buttons, &QDialogButtonBox::rejected, this, &ClipExport::reject);
  connect(&timer_, &QTimer::timeout, this, &ClipExport::add_one);
  set_span(from_s, std::min(until_s, from_s + kUsual_s));
}

ClipExport::~ClipExport() = default;

void ClipExport::set_span(double from_s, double to_s) {
  from_->setValue(from_s);
  to_->setValue(to_s);
}

void ClipExport::ask() {
  QString file = QFileDialog::getSaveFileName(this, tr("Save a clip"), "replay.mp4", tr("Clips (*.mp4)"));
  if (file.isEmpty()) return;
  if (!file.endsWith(".mp4")) file += ".mp4";
  start(file);
}

void ClipExport::start(const QString& file) {
  if (writer_) return;
  const double span_s = to_->value() - from_->value();
  if (span_s <= 0.0) return stop(tr("The clip ends before it begins: choose a later end."));
  try {
    writer_ = std::make_unique<ClipWriter>(file.toStdString(), static_cast<int>(std::lround(1.0 / step_s_)));
  } catch (const std::exception& error) {
    return stop(QString::fromUtf8(error.what()));
  }
  file_ = file;
  done_ = 0;
  all_ = static_cast<int>(std::floor(span_s / step_s_ + 1e-6)) + 1;
  bar_->setRange(0, all_);
  for (QWidget* part : {static_cast<QWidget*>(from_), static_cast<QWidget*>(to_), static_cast<QWidget*>(save_)})
    part->setEnabled(false);
  told_->setText(tr("Drawing ..."));
  timer_.start(0);  // a picture for each turn of the event loop: the window goes on
}

void ClipExport::add_one() {
  try {
    writer_->add(picture_(from_->value() + done_ * step_s_));
    bar_->setValue(++done_);
    if (done_ < all_) return;
    timer_.stop();
    writer_->finish();
    writer_.reset();
    accept();
  } catch (const std::exception& error) {
    stop(QString::fromUtf8(error.what()));
  }
}

void ClipExport::stop(const QString& message) {
  timer_.stop();
  writer_.reset();
  bar_->setValue(0);
  told_->setText(message);
  for (QWidget* part : {static_cast<QWidget*>(from_), static_cast<QWidget*>(to_), static_cast<QWidget*>(save_)})
    part->setEnabled(true);
}

void ClipExport::reject() {
  timer_.stop();
  writer_.reset();
  QDialog::reject();
}

}  // namespace vallecula::gui
