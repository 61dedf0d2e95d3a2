#include "gui/pages/main_menu.h"

#include <QActionGroup>
#include <QMenuBar>

#include "gui/pages/look_settings.h"

namespace vallecula::gui {

MainMenu::MainMenu(QMainWindow& window) : QObject(&window), window_(window) {
  make_file(window);
  make_view(window);
  make_help(window);
}

QAction* MainMenu::add(QMenu* to, const QString& text, const QKeySequence& key, void (MainMenu::*wanted)(),
                       const QString& name) {
  QAction* action = to->addAction(text);
  action->setObjectName(name);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, wanted);
  return action;
}

void MainMenu::make_file(QMainWindow& window) {
  file_ = window.menuBar()->addMenu(tr("&File"));
  leaving_.push_back(add(file_, tr("&Open ..."), QKeySequence::Open, &MainMenu::open_wanted, "open"));
  recent_ = file_->addMenu(tr("Open &recent"));
  leaving_.push_back(recent_->menuAction());
  file_->addSeparator();
  leaving_.push_back(
      add(file_, tr("&New patient from a CT ..."), QKeySequence::New, &MainMenu::import_wanted, "import"));
  leaving_.push_back(add(file_, tr("&Write a course ..."), tr("Ctrl+E"), &MainMenu::writing_wanted, "write"));
  file_->addSeparator();
  add(file_, tr("&Settings ..."), tr("Ctrl+,"), &MainMenu::settings_wanted, "settings");
  file_->addSeparator();
  add(file_, tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), &MainMenu::quit_wanted, "quit");
}

void MainMenu::make_view(QMainWindow& window) {
  view_ = window.menuBar()->addMenu(tr("&View"));
  leaving_.push_back(add(view_, tr("&Home"), tr("Ctrl+1"), &MainMenu::home_wanted, "go_home"));
  leaving_.push_back(add(view_, tr("&Course"), tr("Ctrl+2"), &MainMenu::course_wanted, "go_course"));
  leaving_.push_back(add(view_, tr("&Records"), tr("Ctrl+3"), &MainMenu::records_wanted, "go_records"));
  leaving_.push_back(add(view_, tr("&Devices"), tr("Ctrl+4"), &MainMenu::devices_wanted, "go_devices"));
  view_->addSeparator();
  QMenu* ground = view_->addMenu(tr("C&olours"));
  auto* grounds = new QActionGroup(this);
  for (const auto& [text, value] : std::initializer_list<std::pair<QString, QString>>{
           {tr("&Dark"), "dark"}, {tr("&Light"), "light"}, {tr("As the &desktop"), "system"}}) {
    QAction* action = ground->addAction(text);
    action->setObjectName("ground_" + value);
    action->setCheckable(true);
    grounds->addAction(action);
    connect(action, &QAction::triggered, this, [this, wanted = value] { emit ground_wanted(wanted); });
  }
  connect(ground, &QMenu::aboutToShow, this, [grounds] {
    const QString now = "ground_" + look_settings().ground;
    for (QAction* action : grounds->actions()) action->setChecked(action->objectName() == now);
  });
  const auto text = [this](const QString& what, const QList<QKeySequence>& keys, int steps, const QString& name) {
    QAction* action = view_->addAction(what);
    action->setObjectName(name);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, [this, steps] { emit text_wanted(steps); });
  };
  text(tr("&Larger text"), {QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)}, 1, "larger");
  text(tr("&Smaller text"), {QKeySequence(Qt::CTRL | Qt::Key_Minus)}, -1, "smaller");
  text(tr("Text as it &was"), {QKeySequence(Qt::CTRL | Qt::Key_0)}, 0, "text_as_it_was");
  view_->addSeparator();
  QAction* full = view_->addAction(tr("&Full screen"));
  full->setObjectName("full_screen");
  full->setShortcut(Qt::Key_F11);
  connect(full, &QAction::triggered, this, [this] { window_.setWindowState(window_.windowState() ^ Qt::WindowFullScreen); });
}

void MainMenu::make_help(QMainWindow& window) {
  help_ = window.menuBar()->addMenu(tr("&Help"));
  add(help_, tr("&Contents"), QKeySequence::HelpContents, &MainMenu::help_wanted, "contents");
  leaving_.push_back(add(help_, tr("&First steps ..."), {}, &MainMenu::first_steps_wanted, "first_steps"));
  help_->addSeparator();
  add(help_, tr("Save a &log to send ..."), {}, &MainMenu::log_wanted, "save_log");
  help_->addSeparator();
  add(help_, tr("&About Vallecula"), {}, &MainMenu::about_wanted, "about");
}

void MainMenu::set_state(bool hidden, bool may_leave) {
  window_.menuBar()->setVisible(!hidden);
  for (QAction* action : leaving_) action->setEnabled(may_leave && !hidden);
  recent_->menuAction()->setEnabled(may_leave && !hidden && !recent_->isEmpty());
}

void MainMenu::set_recent(const std::vector<RecentEntry>& recent) {
  recent_->clear();
  for (const RecentEntry& entry : recent) {
    QAction* action = recent_->addAction(QString(entry.words).replace('&', "&&"));
    connect(action, &QAction::triggered, this,
            [this, path = QString::fromStdString(entry.file.path.string())] { emit recent_wanted(path); });
  }
  recent_->menuAction()->setEnabled(!recent.empty() && leaving_.front()->isEnabled());
}

}  // namespace vallecula::gui
