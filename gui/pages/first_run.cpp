#include "gui/pages/first_run.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "gui/pages/devices_page.h"
#include "gui/session/device_rows.h"
#include "gui/session/languages.h"
#include "gui/session/user_settings.h"

namespace vallecula::gui {
namespace {

constexpr const char* kDoneKey = "first_run/done";
constexpr int kLastStep = 2;

}  // namespace

bool is_first_run() {
  const auto kept = user_settings();
  QStringList keys = kept->allKeys();
  keys.removeAll("language/code");  // chosen in the first steps, which then begin anew
  return keys.isEmpty();
}

FirstRun::FirstRun(QWidget* parent) : QDialog(parent), look_(look_settings()) {
  setWindowTitle(tr("Welcome to Vallecula"));
  steps_ = new QStackedWidget(this);
  steps_->addWidget(make_hands());
  steps_->addWidget(make_senses());
  steps_->addWidget(make_begin());
  where_ = new QLabel(this);
  where_->setProperty("role", "faint");
  auto* skip = new QPushButton(tr("&Skip"), this);
  skip->setObjectName("skip");
  skip->setToolTip(tr("Straight to the first page (Esc); Help > First steps comes back here"));
  skip->setAutoDefault(false);
  connect(skip, &QPushButton::clicked, this, &QDialog::reject);
  back_ = new QPushButton(tr("&Back"), this);
  back_->setAutoDefault(false);
  connect(back_, &QPushButton::clicked, this, [this] { go(steps_->currentIndex() - 1); });
  next_ = new QPushButton(this);
  next_->setObjectName("primary");
  next_->setDefault(true);
  connect(next_, &QPushButton::clicked, this, [this] {
    if (steps_->currentIndex() < kLastStep) return go(steps_->currentIndex() + 1);
    accept();
    emit begin_wanted(device());
  });
  auto* foot = new QHBoxLayout;
  foot->addWidget(skip);
  foot->addWidget(where_, 1, Qt::AlignCenter);
  foot->addWidget(back_);
  foot->addWidget(next_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(26, 22, 26, 18);
  column->setSpacing(18);
  column->addWidget(steps_, 1);
  column->addLayout(foot);
  resize(640, 440);
  go(0);
}

QWidget* FirstRun::make_step(const QString& title, const QString& text, QVBoxLayout** column) {
  auto* page = new QWidget(this);
  auto* heading = new QLabel(title, page);
  heading->setObjectName("title");
  heading->setWordWrap(true);
  auto* about = new QLabel(text, page);
  about->setWordWrap(true);
  *column = new QVBoxLayout(page);
  (*column)->setContentsMargins(0, 0, 0, 0);
  (*column)->setSpacing(12);
  (*column)->addWidget(heading);
  (*column)->addWidget(about);
  return page;
}

QWidget* FirstRun::make_hands() {
  QVBoxLayout* column = nullptr;
  QWidget* page =
      make_step(tr("How will you steer?"),
                tr("A mouse is enough: the force of your blade is drawn beside the picture. A haptic device lets "
                   "you feel it."),
                &column);
  column->insertLayout(0, make_language(page));
  hands_ = new QButtonGroup(this);
  hands_column_ = new QVBoxLayout;
  column->addLayout(hands_column_);
  none_found_ =
      new QLabel(tr("No other device was found. One that is plugged in later is chosen under Devices."), page);
  none_found_->setWordWrap(true);
  none_found_->setProperty("role", "faint");
  column->addWidget(none_found_);
  column->addStretch(1);
  offer(tr("The &mouse and the keyboard"), "mouse");
  hands_->buttons().front()->setChecked(true);
  return page;
}

/// Each by its own name: whoever cannot read the rest finds it.
QLayout* FirstRun::make_language(QWidget* page) {
  auto* box = new QComboBox(page);
  box->setObjectName("language");
  for (const Language& one : available_languages()) box->addItem(one.name, one.code);
  box->setCurrentIndex(std::max(0, box->findData(language())));
  box->setToolTip(tr("Of all words of the window; to be changed in the settings as well (Ctrl+,)"));
  auto* label = new QLabel(tr("&Language / Sprache"), page);
  label->setBuddy(box);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(label);
  row->addWidget(box);
  connect(box, qOverload<int>(&QComboBox::activated), this, [this, box] {
    if (box->currentData().toString() != language()) emit language_chosen(box->currentData().toString());
  });
  return row;
}

void FirstRun::offer(const QString& label, const QString& device) {
  auto* button = new QRadioButton(label, this);
  button->setProperty("device", device);
  hands_->addButton(button);
  hands_column_->addWidget(button);
}

void FirstRun::set_found_devices(const std::vector<device::FoundDevice>& devices) {
  for (const device::FoundDevice& one : devices) {
    const QString name = QString::fromStdString(one.name);
    bool offered = false;
    for (const QAbstractButton* button : hands_->buttons()) offered = offered || button->property("device") == name;
    if (!offered && usable(one)) offer(device_label(one).replace('&', "&&"), name);
  }
  none_found_->setVisible(hands_->buttons().size() == 1);
}

QString FirstRun::device() const { return hands_->checkedButton()->property("device").toString(); }

QWidget* FirstRun::make_senses() {
  QVBoxLayout* column = nullptr;
  QWidget* page = make_step(
      tr("Can you read and hear well?"),
      tr("Both can be changed at any time: Ctrl++ and Ctrl+- for the text, Ctrl+, for all settings."), &column);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(12);
  auto* text = new QSlider(Qt::Horizontal, page);
  text->setObjectName("text_scale");
  text->setRange(static_cast<int>(std::lround(100 * theme::kLeastTextScale)),
                 static_cast<int>(std::lround(100 * theme::kMostTextScale)));
  text->setValue(static_cast<int>(std::lround(100 * look_.text_scale)));
  text->setPageStep(20);
  text->setToolTip(tr("Size of all text, 80 to 160 per cent"));
  auto* ground = new QComboBox(page);
  ground->setObjectName("ground");
  ground->addItem(tr("Dark"), "dark");
  ground->addItem(tr("Light"), "light");
  ground->addItem(tr("As the desktop"), "system");
  ground->setCurrentIndex(std::max(0, ground->findData(look_.ground)));
  ground->setToolTip(tr("Colours of the whole window"));
  auto* sound = new QCheckBox(tr("The monitor bee&ps: lower as the saturation falls"), page);
  sound->setObjectName("monitor_sound");
  sound->setChecked(user_settings()->value("sound/monitor", true).toBool());
  form->addRow(tr("Te&xt size"), text);
  form->addRow(tr("C&olours"), ground);
  form->addRow(sound);
  column->addLayout(form);
  column->addStretch(1);
  auto* soon = new QTimer(this);  // the whole window is laid out anew: not at every step of a drag
  soon->setSingleShot(true);
  soon->setInterval(150);
  connect(text, &QSlider::valueChanged, this, [this, soon](int share) {
    look_.text_scale = 0.01 * share;
    soon->start();
  });
  connect(soon, &QTimer::timeout, this, [this] { apply_look(look_); });
  connect(ground, qOverload<int>(&QComboBox::activated), this, [this, ground] {
    look_.ground = ground->currentData().toString();
    apply_look(look_);
  });
  connect(sound, &QCheckBox::toggled, this, [](bool on) { user_settings()->setValue("sound/monitor", on); });
  return page;
}

QWidget* FirstRun::make_begin() {
  QVBoxLayout* column = nullptr;
  QWidget* page = make_step(
      tr("Your first laryngoscopy"),
      tr("A newborn lies before you, its head towards you. You hold the laryngoscope in your left hand: bring the "
         "blade "
         "over the tongue into the vallecula, lift along the handle, and see the glottis. The key G shows an expert "
         "doing it, "
         "at this very infant.\n\n"
         "Nothing can break, and every try is a new one. Before it begins a card tells what mouse and keys do."),
      &column);
  column->addStretch(1);
  return page;
}

void FirstRun::go(int step) {
  steps_->setCurrentIndex(step);
  where_->setText(tr("Step %1 of %2").arg(step + 1).arg(kLastStep + 1));
  back_->setVisible(step > 0);
  next_->setText(step == kLastStep ? tr("Be&gin") : tr("&Next"));
  next_->setFocus();
}

void FirstRun::done(int result) {
  keep_look(look_);
  apply_look(look_);
  user_settings()->setValue(kDoneKey, true);
  if (device() != "mouse") emit device_chosen(device(), hands_->checkedButton()->text().replace("&&", "&"));
  QDialog::done(result);
}

}  // namespace vallecula::gui
