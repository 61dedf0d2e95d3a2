#include "gui/pages/device_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"

namespace vallecula::gui {
namespace {

constexpr double kDegree = M_PI / 180.0;

QDoubleSpinBox* number(QWidget* parent, const char* name, double low, double high, double step, double value) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setRange(low, high);
  box->setSingleStep(step);
  box->setDecimals(2);
  box->setSuffix(QString::fromUtf8(" \xc3\x97"));
  box->setValue(value);
  return box;
}

/// A row whose meaning can be read beside it.
void add_row(QFormLayout& form, const QString& name, QWidget* field, const QString& meaning) {
  field->setMinimumWidth(150);
  field->setAccessibleName(name);
  field->setToolTip(meaning);
  auto* about = new QLabel(meaning, field->parentWidget());
  about->setObjectName("faint");
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(field);
  row->addWidget(about, 1);
  form.addRow(name, row);
}

}  // namespace

DeviceDialog::DeviceDialog(const device::DeviceInfo& info, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Device settings"));
  auto* title = new QLabel(capitalised(in_words(info.model)), this);
  title->setObjectName("heading");
  auto* form = new QFormLayout;
  form->setVerticalSpacing(10);
  if (info.kind == "mouse")
    set_mouse(*form);
  else
    set_device(*form, info);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  for (QAbstractButton* button : buttons->buttons()) button->setIcon(QIcon());
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    keep_();
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 16, 20, 16);
  column->addWidget(title);
  column->addSpacing(8);
  column->addLayout(form);
  column->addSpacing(12);
  column->addWidget(buttons);
}

void DeviceDialog::set_mouse(QFormLayout& form) {
  auto* gain = number(this, "gain", kLeastMouseGain, kMostMouseGain, 0.25, mouse_gain());
  add_row(form, tr("Blade's way"), gain, tr("the mouse's way on the picture; + and - change it in a trial"));
  keep_ = [gain] { keep_mouse_gain(gain->value()); };
}

void DeviceDialog::set_device(QFormLayout& form, const device::DeviceInfo& info) {
  const DeviceSettings kept = device_settings(info);
  auto* scale =
      number(this, "motion_scale", device::kLeastMotionScale, device::kMostMotionScale, 0.1, kept.map.motion_scale);
  auto* turned = number(this, "turned", -180.0, 180.0, 5.0, kept.map.turned_rad / kDegree);
  turned->setSuffix(QString::fromUtf8(" \xc2\xb0"));
  turned->setDecimals(0);
  auto* left = new QCheckBox(tr("stands on the other side"), this);
  left->setObjectName("left_handed");
  left->setChecked(kept.map.left_handed);
  auto* clutch = new QSpinBox(this);
  clutch->setObjectName("clutch_button");
  clutch->setRange(0, 16);
  clutch->setSpecialValueText(tr("none"));
  clutch->setValue(button_of(kept.clutch_button));
  add_row(form, tr("Blade's way"), scale, tr("your hand's way"));
  add_row(form, tr("Device turned"), turned, tr("against you, anticlockwise seen from above"));
  add_row(form, tr("Left-handed"), left, tr("turned the other way, first and second button exchanged"));
  add_row(form, tr("Clutch button"), clutch, tr("held, it frees your hand: the blade stays where it is"));
  QDoubleSpinBox* force = nullptr;
  if (info.peak_force_n > 0.0) {
    force = number(this, "force_scale", 0.0, 1.0, kLeastForceScale, kept.force_scale);
    force->setSpecialValueText(tr("automatic"));
    connect(force, &QDoubleSpinBox::editingFinished, force, [force] {  // shown as it will be kept
      if (force->value() > 0.0) force->setValue(std::max(force->value(), kLeastForceScale));
    });
    add_row(form, tr("Force felt"), force,
            tr("the force in the patient; automatic: scaled to what the device can show"));
  }
  keep_ = [=] {
    DeviceSettings chosen = kept;
    chosen.map = {scale->value(), std::min(M_PI, std::max(-M_PI, kDegree * turned->value())), left->isChecked()};
    chosen.clutch_button = bit_of_button(clutch->value());
    if (force != nullptr) chosen.force_scale = force->value();
    keep_device_settings(info, chosen);
  };
}

}  // namespace vallecula::gui
