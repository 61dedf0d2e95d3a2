#include "gui/pages/settings_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "gui/session/languages.h"
#include "gui/session/user_settings.h"

namespace vallecula::gui {
namespace {

QHBoxLayout* with_share(QSlider* slider, QLabel* share) {
  auto* row = new QHBoxLayout;
  row->addWidget(slider, 1);
  row->addWidget(share);
  share->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return row;
}

/// As wide for one figure as for three: the slider stays where it is.
void show_share_of(const QSlider& slider, QLabel& share) {
  share.setText(SettingsDialog::tr("%1 %").arg(slider.value()));
  share.setMinimumWidth(share.fontMetrics().horizontalAdvance("0000 %"));
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName("heading");
  return label;
}

}  // namespace

SettingsDialog::SettingsDialog(QWidget* parent) : QDialog(parent), before_(look_settings()) {
  setWindowTitle(tr("Settings"));
  auto* form = new QFormLayout;
  form->setVerticalSpacing(10);
  form->setHorizontalSpacing(16);
  add_look(form);
  add_sound(form);
  add_language(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(22, 18, 22, 16);
  column->setSpacing(16);
  column->addLayout(form);
  column->addStretch(1);
  column->addWidget(buttons);
  setMinimumWidth(480);
}

void SettingsDialog::add_look(QFormLayout* form) {
  const auto choice = [this](const char* name, const std::initializer_list<std::pair<QString, const char*>>& entries,
                             const QString& now) {
    auto* box = new QComboBox(this);
    box->setObjectName(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // also when the text grows while it is open
    for (const auto& [text, value] : entries) box->addItem(text, QString(value));
    box->setCurrentIndex(std::max(0, box->findData(now)));
    return box;
  };
  ground_ = choice("ground", {{tr("Dark"), "dark"}, {tr("Light"), "light"}, {tr("As the desktop"), "system"}},
                   before_.ground);
  ground_->setToolTip(tr("Colours of the whole window; pictures of CTs stay on black"));
  text_ = new QSlider(Qt::Horizontal, this);
  text_->setObjectName("text_scale");
  text_->setRange(static_cast<int>(std::lround(100 * theme::kLeastTextScale)),
                  static_cast<int>(std::lround(100 * theme::kMostTextScale)));
  text_->setSingleStep(5);
  text_->setPageStep(20);
  text_->setValue(static_cast<int>(std::lround(100 * before_.text_scale)));
  text_->setToolTip(tr("Size of all text in per cent (Ctrl++ and Ctrl+- on every page)"));
  text_share_ = new QLabel(this);
  trachea_ = choice("trachea", {{tr("Natural"), "natural"}, {tr("Blue, as in the paper"), "blue"}}, before_.trachea);
  trachea_->setToolTip(tr("Colour of the windpipe in the views of the airway"));
  quality_ = choice("quality",
                    {{tr("Automatic: effects give way to fluency"), "auto"},
                     {tr("High, whatever it costs"), "high"},
                     {tr("Low, for slow computers"), "low"}},
                    before_.quality);
  quality_->setToolTip(tr("How the patient is drawn"));
  form->addRow(heading(tr("Look"), this));
  form->addRow(tr("C&olours"), ground_);
  // No T, no V: underlined they are drawn apart from what stands close to them, and the word is longer than its label.
  form->addRow(tr("Te&xt size"), with_share(text_, text_share_));
  qobject_cast<QLabel*>(form->itemAt(form->rowCount() - 1, QFormLayout::LabelRole)->widget())->setBuddy(text_);
  form->addRow(tr("Tra&chea"), trachea_);
  form->addRow(tr("&Quality"), quality_);
  // The whole window is laid out anew: not at every step of a drag.
  auto* soon = new QTimer(this);
  soon->setSingleShot(true);
  soon->setInterval(150);
  connect(soon, &QTimer::timeout, this, &SettingsDialog::preview);
  const auto show_share = [this] { show_share_of(*text_, *text_share_); };
  connect(text_, &QSlider::valueChanged, this, [soon, show_share] {
    show_share();
    soon->start();
  });
  show_share();
  connect(ground_, qOverload<int>(&QComboBox::currentIndexChanged), this, &SettingsDialog::preview);
}

void SettingsDialog::add_sound(QFormLayout* form) {
  const auto kept = user_settings();
  monitor_ = new QCheckBox(tr("&Monitor's beep: its pitch falls with the saturation"), this);
  monitor_->setObjectName("monitor_sound");
  monitor_->setChecked(kept->value("sound/monitor", true).toBool());
  volume_ = new QSlider(Qt::Horizontal, this);
  volume_->setObjectName("volume");
  volume_->setRange(0, 100);
  volume_->setPageStep(10);
  volume_->setValue(
      static_cast<int>(std::lround(100 * std::clamp(kept->value("sound/volume", 0.5).toDouble(), 0.0, 1.0))));
  volume_->setToolTip(tr("Loudness of the monitor in per cent"));
  volume_share_ = new QLabel(this);
  form->addRow(heading(tr("Sound"), this));
  form->addRow(monitor_);
  form->addRow(tr("Vol&ume"), with_share(volume_, volume_share_));
  qobject_cast<QLabel*>(form->itemAt(form->rowCount() - 1, QFormLayout::LabelRole)->widget())->setBuddy(volume_);
  const auto show_share = [this] { show_share_of(*volume_, *volume_share_); };
  connect(volume_, &QSlider::valueChanged, this, show_share);
  connect(monitor_, &QCheckBox::toggled, volume_, &QWidget::setEnabled);
  volume_->setEnabled(monitor_->isChecked());
  show_share();
}

void SettingsDialog::add_language(QFormLayout* form) {
  language_ = new QComboBox(this);
  language_->setObjectName("language");
  language_->setToolTip(
      tr("Of the window's words: followed at once, or from the next start on where something is under way"));
  language_->addItem(tr("As the system"), QString());
  for (const Language& one : available_languages()) language_->addItem(one.name, one.code);
  language_->setCurrentIndex(std::max(0, language_->findData(chosen_language())));
  form->addRow(heading(tr("Words"), this));
  form->addRow(tr("&Language"), language_);
}

LookSettings SettingsDialog::chosen() const {
  LookSettings look;
  look.ground = ground_->currentData().toString();
  look.text_scale = 0.01 * text_->value();
  look.trachea = trachea_->currentData().toString();
  look.quality = quality_->currentData().toString();
  return look;
}

void SettingsDialog::preview() {
  apply_look(chosen());
  show_share_of(*text_, *text_share_);
  show_share_of(*volume_, *volume_share_);
  QTimer::singleShot(0, this, [this] {  // larger words need more room
    layout()->invalidate();             // rows keep what their words needed
    layout()->activate();
    resize(size().expandedTo(sizeHint()));
  });
}

void SettingsDialog::done(int result) {
  bool another = false;
  if (result == Accepted) {
    keep_look(chosen());
    const auto kept = user_settings();
    kept->setValue("sound/monitor", monitor_->isChecked());
    kept->setValue("sound/volume", 0.01 * volume_->value());
    another = language_->currentData().toString() != chosen_language();
    if (another) keep_language(language_->currentData().toString());
  }
  apply_look(result == Accepted ? chosen() : before_);
  QDialog::done(result);
  if (result == Accepted) emit kept();
  if (another) emit language_chosen();
}

}  // namespace vallecula::gui
