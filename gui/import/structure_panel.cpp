#include "gui/import/structure_panel.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/session/words_from_below.h"
#include "gui/views/slice_scene.h"
#include "gui/views/theme.h"
#include "pipeline/package/label_map.h"
#include "pipeline/segment/edits.h"

namespace vallecula::gui {
namespace {

constexpr int kLowestHu = -1024, kHighestHu = 3071;  // 12 bits, as scanners write them
enum Column { kShown, kFound, kAccepted };

QIcon swatch(const std::array<double, 3>& rgb) {
  QPixmap pixmap(14, 14);
  pixmap.fill(QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
  QIcon icon(pixmap);
  for (const auto mode : {QIcon::Selected, QIcon::Disabled}) icon.addPixmap(pixmap, mode);  // the colour is the meaning
  return icon;
}

}  // namespace

QString finding_text(const pipeline::Finding& finding) {
  QString text = pipeline::name_of(finding.origin);
  if (!finding.how.empty()) text += ": " + QString::fromStdString(finding.how);
  return text;
}

StructurePanel::StructurePanel(SliceScene& scene, EditHistory& history, QWidget* parent)
    : QWidget(parent), scene_(scene), history_(history) {
  tree_ = new QTreeWidget(this);
  tree_->setAccessibleName(tr("Structures"));
  tree_->setAccessibleDescription(tr("The tick shows or hides a structure in the pictures"));
  tree_->setHeaderLabels({tr("Show"), tr("Origin"), tr("Accepted")});
  tree_->setRootIsDecorated(false);
  tree_->header()->setSectionResizeMode(kShown, QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(kFound, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(kAccepted, QHeaderView::ResizeToContents);
  tree_->header()->setStretchLastSection(false);
  for (const auto& label : pipeline::kLabelNames) {
    auto* row = new QTreeWidgetItem(tree_, {words_of(label.name)});
    row->setIcon(kShown, swatch(label.rgb));
    row->setData(kShown, Qt::UserRole, QString(label.name));
    row->setData(kFound, Qt::UserRole, static_cast<int>(label.value));
    row->setCheckState(kShown, scene_.visible(label.value) ? Qt::Checked : Qt::Unchecked);
  }

  auto* box = new QFrame(this);
  box->setObjectName("panel");
  name_ = new QLabel(box);
  name_->setObjectName("heading");
  how_ = new QLabel(box);
  how_->setWordWrap(true);
  accept_ = new QPushButton(tr("&Accept"), box);
  accept_->setCheckable(true);
  accept_->setToolTip(tr("It is as it should be"));
  seed_ = new QPushButton(tr("Give a &seed ..."), box);
  seed_->setToolTip(tr("Then click a point inside the structure, in any slice (or Enter at the crosshair)"));
  seed_->setCheckable(true);
  seed_at_ = new QLabel(box);
  seed_at_->setObjectName("faint");
  low_ = new QSpinBox(box);
  high_ = new QSpinBox(box);
  for (QSpinBox* spin : {low_, high_}) {
    spin->setRange(kLowestHu, kHighestHu);
    spin->setSuffix(tr(" HU"));
    spin->setSingleStep(10);
  }
  low_->setToolTip(tr("Lowest grey value of the structure, HU"));
  high_->setToolTip(tr("Highest grey value of the structure, HU"));
  low_->setAccessibleName(tr("Lowest HU of the structure"));
  high_->setAccessibleName(tr("Highest HU of the structure"));
  preview_ = new QCheckBox(tr("&Preview"), box);
  preview_->setToolTip(tr("Tints in the slices what lies between the two (HU)"));
  use_ = new QPushButton(tr("&Use the threshold"), box);
  load_ = new QPushButton(tr("&Load a label map ..."), box);
  load_->setToolTip(tr("Takes this structure from a label map made elsewhere (3D Slicer)"));
  drop_ = new QPushButton(tr("&Drop edits"), box);
  drop_->setToolTip(tr("Takes back seed, threshold and label map of this structure"));

  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(12, 10, 12, 10);
  grid->setVerticalSpacing(7);
  grid->addWidget(name_, 0, 0);
  grid->addWidget(accept_, 0, 1);
  grid->addWidget(how_, 1, 0, 1, 2);
  grid->addWidget(seed_, 2, 0);
  grid->addWidget(seed_at_, 2, 1);
  auto* between = new QHBoxLayout;
  between->setSpacing(8);
  between->addWidget(new QLabel(tr("From"), box));
  between->addWidget(low_, 1);
  between->addWidget(new QLabel(tr("to"), box));
  between->addWidget(high_, 1);
  grid->addLayout(between, 3, 0, 1, 2);
  grid->addWidget(preview_, 4, 0);
  grid->addWidget(use_, 4, 1);
  grid->addWidget(load_, 5, 0);
  grid->addWidget(drop_, 5, 1);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 6, 0, 0);
  all->addWidget(tree_, 1);
  all->addWidget(box);

  connect(tree_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row, int column) {
    if (filling_ || column != kShown) return;
    scene_.set_visible(static_cast<std::uint8_t>(row->data(kFound, Qt::UserRole).toInt()),
                       row->checkState(kShown) == Qt::Checked);
  });
  connect(tree_, &QTreeWidget::currentItemChanged, this, &StructurePanel::show_selected);
  connect(accept_, &QPushButton::clicked, this, [this](bool on) { history_.set_accepted(selected(), on); });
  connect(seed_, &QPushButton::clicked, this,
          [this](bool on) { scene_.set_tool(on ? SliceTool::seed : SliceTool::crosshair); });
  connect(&scene_, &SliceScene::tool_changed, this, [this] {
    seed_->setChecked(scene_.tool() == SliceTool::seed);
    show_seed();
  });
  connect(&scene_, &SliceScene::seed_picked, this, [this](const pipeline::Point& at) {
    history_.set_seed(selected(), at);
    scene_.set_crosshair(at);
    scene_.set_tool(SliceTool::crosshair);
  });
  for (QSpinBox* spin : {low_, high_})
    connect(spin, qOverload<int>(&QSpinBox::valueChanged), this, &StructurePanel::preview);
  connect(preview_, &QCheckBox::toggled, this, &StructurePanel::preview);
  connect(use_, &QPushButton::clicked, this, [this] {
    const double high = selected() == "skin" ? pipeline::kNoHighest : high_->value();
    history_.set_threshold(selected(), {static_cast<double>(low_->value()), high});
  });
  connect(load_, &QPushButton::clicked, this, [this] { emit load_wanted(QString::fromStdString(selected())); });
  connect(drop_, &QPushButton::clicked, this, [this] { history_.forget(selected()); });
  connect(&history_, &EditHistory::changed, this, &StructurePanel::show_state);
  select("tongue");
}

std::string StructurePanel::selected() const {
  return tree_->currentItem()->data(kShown, Qt::UserRole).toString().toStdString();
}

void StructurePanel::select(const std::string& structure) {
  for (int i = 0; i < tree_->topLevelItemCount(); ++i)
    if (tree_->topLevelItem(i)->data(kShown, Qt::UserRole).toString().toStdString() == structure)
      tree_->setCurrentItem(tree_->topLevelItem(i));
}

void StructurePanel::show_findings(const std::map<std::string, pipeline::Finding>& findings) {
  findings_ = findings;
  show_state();
}

QString StructurePanel::how(const std::string& structure) const {
  const auto found = findings_.find(structure);
  if (findings_.empty()) return tr("not looked for yet");
  return found == findings_.end() ? tr("not found") : in_words(pipeline::name_of(found->second.origin));
}

void StructurePanel::show_state() {
  const EditState& state = history_.state();
  filling_ = true;
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = tree_->topLevelItem(i);
    const std::string name = row->data(kShown, Qt::UserRole).toString().toStdString();
    const auto value = static_cast<std::uint8_t>(row->data(kFound, Qt::UserRole).toInt());
    QString text = how(name);
    if (state.seeds.count(name) != 0) text += tr(" + seed");
    if (state.thresholds.count(name) != 0) text += tr(" + threshold");
    if (state.replaced.count(value) != 0) text += tr(" + label map");
    row->setText(kFound, text);
    const auto found = findings_.find(name);
    const bool doubtful = found == findings_.end() || found->second.origin == pipeline::Origin::inferred ||
                          found->second.origin == pipeline::Origin::from_model;
    row->setForeground(kFound, doubtful ? theme::over() : theme::text());
    if (found != findings_.end()) row->setToolTip(kFound, finding_text(found->second));
    row->setText(kAccepted, state.accepted.count(name) != 0 ? tr("yes") : QString());
    row->setForeground(kAccepted, theme::within());
  }
  filling_ = false;
  scene_.set_seeds(state.seeds);
  show_selected();
}

void StructurePanel::show_selected() {
  const std::string name = selected();
  const EditState& state = history_.state();
  const auto found = findings_.find(name);
  name_->setText(words_of(name));
  how_->setText(findings_.empty()          ? tr("not looked for yet")
                : found == findings_.end() ? tr("not found: give a seed, a threshold or a label map")
                                           : finding_text(found->second));
  accept_->setEnabled(found != findings_.end());
  accept_->setChecked(state.accepted.count(name) != 0);
  show_seed();
  const auto threshold = state.thresholds.find(name);
  const bool bone = name.rfind("bone", 0) == 0 || name == "spine";
  const std::array<double, 2> usual = name == "airway" ? std::array<double, 2>{kLowestHu, -400.0}
                                      : name == "skin" ? std::array<double, 2>{-400.0, pipeline::kNoHighest}
                                      : bone           ? std::array<double, 2>{250.0, kHighestHu}
                                                       : std::array<double, 2>{-50.0, 120.0};
  const auto& shown = threshold != state.thresholds.end() ? threshold->second : usual;
  if (name != shown_ || threshold != state.thresholds.end()) {  // what is being tried out stays
    shown_ = name;
    filling_ = true;
    low_->setValue(static_cast<int>(shown[0]));
    high_->setValue(shown[1] < kHighestHu ? static_cast<int>(shown[1]) : kHighestHu);
    high_->setEnabled(name != "skin");  // all that is denser is skin too
    filling_ = false;
  }
  preview();
}

void StructurePanel::show_seed() {
  const auto& seeds = history_.state().seeds;
  const auto seed = seeds.find(selected());
  QString text;
  if (scene_.tool() == SliceTool::seed)
    text = tr("click inside it (Esc: no)");
  else if (seed != seeds.end())
    text = tr("%1, %2, %3 mm").arg(tenths_of(seed->second[0]), tenths_of(seed->second[1]), tenths_of(seed->second[2]));
  seed_at_->setText(text);
}

void StructurePanel::preview() {
  if (filling_) return;
  const bool possible = low_->value() < high_->value();
  use_->setEnabled(possible);
  use_->setToolTip(possible ? tr("Finds this structure anew between these two")
                            : tr("The lowest must lie below the highest"));
  if (preview_->isChecked() && possible)
    scene_.set_threshold_preview(
        std::array<double, 2>{static_cast<double>(low_->value()), static_cast<double>(high_->value())});
  else
    scene_.set_threshold_preview({});
}

}  // namespace vallecula::gui
