#include "gui/import/landmark_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/import/import_work.h"
#include "gui/import/structure_panel.h"
#include "gui/session/words_from_below.h"
#include "gui/views/slice_scene.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

QString place_text(const pipeline::Point& at) {
  return QString("%1, %2, %3").arg(tenths_of(at[0]), tenths_of(at[1]), tenths_of(at[2]));
}

}  // namespace

LandmarkPanel::LandmarkPanel(SliceScene& scene, EditHistory& history, QWidget* parent)
    : QWidget(parent), scene_(scene), history_(history) {
  tree_ = new QTreeWidget(this);
  tree_->setAccessibleName(tr("Landmarks"));
  tree_->setHeaderLabels({tr("Landmark"), tr("L, P, H (mm)"), tr("Origin")});
  tree_->setRootIsDecorated(false);
  tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  how_ = new QLabel(this);
  how_->setWordWrap(true);
  how_->setMinimumHeight(36);
  move_ = new QPushButton(tr("Move &it to the crosshair"), this);
  back_ = new QPushButton(tr("Bac&k to where it was found"), this);
  auto* help =
      new QLabel(tr("Choosing one takes all slices to it. Drag its ring in a slice, or its ball in 3D."), this);
  help->setObjectName("faint");
  help->setWordWrap(true);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 6, 0, 0);
  all->addWidget(tree_, 1);
  all->addWidget(how_);
  all->addWidget(help);
  all->addWidget(move_);
  all->addWidget(back_);
  connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
    const auto mark = scene_.landmarks().find(selected());
    if (row != nullptr && mark != scene_.landmarks().end()) scene_.set_crosshair(mark->second.at);
    show_state();
  });
  connect(move_, &QPushButton::clicked, this, [this] { history_.set_landmark(selected(), scene_.crosshair()); });
  connect(back_, &QPushButton::clicked, this, [this] { history_.forget(selected()); });
  connect(&scene_, &SliceScene::landmark_dragged, this, [this](const QString& name, const pipeline::Point& at) {
    for (int i = 0; i < tree_->topLevelItemCount(); ++i)
      if (tree_->topLevelItem(i)->data(0, Qt::UserRole).toString() == name)
        tree_->topLevelItem(i)->setText(1, place_text(at));
  });
  connect(&scene_, &SliceScene::landmark_dropped, this, [this](const QString& name, const pipeline::Point& at) {
    if (is_place(name.toStdString())) history_.set_landmark(name.toStdString(), at);
  });
  connect(&history_, &EditHistory::changed, this, &LandmarkPanel::show_state);
}

std::string LandmarkPanel::selected() const {
  return tree_->currentItem() == nullptr ? std::string()
                                         : tree_->currentItem()->data(0, Qt::UserRole).toString().toStdString();
}

void LandmarkPanel::show_found(const std::map<std::string, pipeline::Point>& found,
                               const std::map<std::string, pipeline::Finding>& findings) {
  found_ = found;
  findings_ = findings;
  const QSignalBlocker quiet(tree_);  // filling it must not move the crosshair
  tree_->clear();
  for (const auto& [name, at] : found_)
    (new QTreeWidgetItem(tree_, {words_of(name)}))->setData(0, Qt::UserRole, QString::fromStdString(name));
  show_state();
}

void LandmarkPanel::show_state() {
  const auto& moved = history_.state().landmarks;
  std::map<std::string, SceneLandmark> shown;
  for (const auto& [name, at] : found_) shown[name] = {at, false};
  for (const auto& [name, at] : moved)
    if (is_place(name)) shown[name] = {at, true};  // a file can give a direction too
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = tree_->topLevelItem(i);
    const std::string name = row->data(0, Qt::UserRole).toString().toStdString();
    const auto& mark = shown.at(name);
    row->setText(1, place_text(mark.at));
    const auto finding = findings_.find(name);
    const QString origin = finding == findings_.end() ? QString() : pipeline::name_of(finding->second.origin);
    row->setText(2, mark.given ? tr("moved") : in_words(origin.toStdString()));
    row->setForeground(2, mark.given || origin == "measured" ? theme::text() : theme::over());
  }
  const std::string name = selected();
  const auto finding = findings_.find(name);
  how_->setText(moved.count(name) != 0       ? tr("moved by hand")
                : finding == findings_.end() ? QString()
                                             : finding_text(finding->second));
  move_->setEnabled(!name.empty());
  back_->setEnabled(moved.count(name) != 0);
  scene_.set_landmarks(std::move(shown));
}

}  // namespace vallecula::gui
