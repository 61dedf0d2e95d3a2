#include "gui/import/check_page.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/import/landmark_panel.h"
#include "gui/import/quality_list.h"
#include "gui/import/structure_panel.h"
#include "gui/import/window_message.h"
#include "gui/import/work_strip.h"
#include "gui/session/recent_files.h"
#include "gui/session/words_from_below.h"
#include "gui/views/label_view.h"
#include "gui/views/slice_view.h"
#include "gui/views/theme.h"
#include "pipeline/package/label_map.h"
#include "pipeline/package/origin.h"
#include "pipeline/quality.h"

namespace vallecula::gui {

CheckPage::CheckPage(ImportWork& work, QWidget* parent) : QWidget(parent), work_(work) {
  views_ = new QGridLayout;
  views_->setSpacing(4);
  const SlicePlane planes[] = {SlicePlane::axial, SlicePlane::sagittal, SlicePlane::coronal};
  QWidget* tools = make_tools();
  for (int i = 0; i < 3; ++i) {
    auto* slice = new SliceView(scene_, planes[i], this);
    slices_[static_cast<std::size_t>(planes[i])] = slice;
    views_->addWidget(slice, i / 2, i % 2);
    connect(slice, &SliceView::alone_wanted, this, [this, slice] { show_alone(slice); });
  }
  frame_3d_ = new QFrame(this);
  view_3d_ = new LabelView(scene_, frame_3d_);
  auto* in_frame = new QVBoxLayout(frame_3d_);
  in_frame->setContentsMargins(1, 1, 1, 1);
  in_frame->addWidget(view_3d_);
  const auto show_focus = [this](bool has) {
    theme::dress(*frame_3d_, has ? "background: @device@;" : "background: @track@;");
  };
  show_focus(false);
  connect(view_3d_, &LabelView::focus_changed, this, show_focus);
  connect(view_3d_, &LabelView::alone_wanted, this, [this] { show_alone(frame_3d_); });
  views_->addWidget(frame_3d_, 1, 1);
  for (int i = 0; i < 2; ++i) {
    views_->setRowStretch(i, 1);
    views_->setColumnStretch(i, 1);
  }
  at_ = new QLabel(this);
  at_->setAccessibleName(tr("Under the pointer"));
  at_->setToolTip(
      tr("Place under the pointer (mm to the patient's left, back and head, as the scan has them), grey value "
         "(HU) and structure"));
  auto* left = new QVBoxLayout;
  left->setSpacing(4);
  left->addWidget(tools);
  left->addLayout(views_, 1);
  left->addWidget(at_);
  auto* columns = new QHBoxLayout;
  columns->addLayout(left, 1);
  side_ = make_side();
  columns->addWidget(side_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addLayout(columns, 1);
  all->addWidget(make_foot());

  connect(&scene_, &SliceScene::hovered, this,
          [this](const pipeline::Point& at) { at_->setText(scene_.describe(at)); });
  connect(&scene_, &SliceScene::crosshair_moved, this, [this] { at_->setText(scene_.describe(scene_.crosshair())); });
  connect(&history_, &EditHistory::changed, this, &CheckPage::show_state);
  connect(&work_, &ImportWork::loaded, this, [this](const QString& what, const EditState& edits) {
    history_.change(what, edits);
    show_message("");
  });
  connect(&work_, &ImportWork::file_failed, this, [this](const QString& message) { show_message(message); });
  connect(&work_, &ImportWork::saved, this,
          [this](const QString& files) { show_message(tr("Saved: %1").arg(files), false); });
  show_state();
}

CheckPage::~CheckPage() = default;

void CheckPage::show_alone(QWidget* view) {
  bool alone = false;  // is it to be, or are all to come back?
  for (int i = 0; i < views_->count(); ++i) {
    QWidget* other = views_->itemAt(i)->widget();
    alone = alone || (other != view && other->isVisible());
  }
  int row = 0, column = 0, rows = 0, columns = 0;
  views_->getItemPosition(views_->indexOf(view), &row, &column, &rows, &columns);
  for (int i = 0; i < views_->count(); ++i) {
    QWidget* other = views_->itemAt(i)->widget();
    other->setVisible(!alone || other == view);
  }
  for (int i = 0; i < 2; ++i) {  // an empty row takes no room
    views_->setRowStretch(i, !alone || i == row ? 1 : 0);
    views_->setColumnStretch(i, !alone || i == column ? 1 : 0);
  }
}

void CheckPage::add_tool(QWidget* bar, const QString& text, const char* key, SliceTool tool, const QString& tip) {
  auto* button = new QToolButton(bar);
  button->setText(text);
  button->setCheckable(true);
  button->setChecked(scene_.tool() == tool);
  button->setShortcut(QKeySequence(key));
  button->setToolTip(QString("%1 (%2)").arg(tip, key));
  button->setFocusPolicy(Qt::TabFocus);
  bar->layout()->addWidget(button);
  connect(button, &QToolButton::clicked, this, [this, tool] { scene_.set_tool(tool); });
  connect(&scene_, &SliceScene::tool_changed, button,
          [this, button, tool] { button->setChecked(scene_.tool() == tool); });
}

QWidget* CheckPage::make_tools() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  add_tool(bar, tr("Crosshair"), "C", SliceTool::crosshair, tr("Take all slices to a point; drag landmarks"));
  add_tool(bar, tr("Window"), "W", SliceTool::window,
           tr("Window and level (HU). Drag: right wider, up darker; the right button does it with any tool"));
  add_tool(bar, tr("Ruler"), "R", SliceTool::ruler,
           tr("Length (mm). Drag, or click two points; Delete takes the last one away"));
  add_tool(bar, tr("Angle"), "A", SliceTool::angle, tr("Angle (degrees). Click three points, the corner second"));
  row->addSpacing(10);
  auto* presets = new QComboBox(bar);
  presets->setAccessibleName(tr("Window and level for"));
  presets->setToolTip(tr("Window and level for these tissues"));
  for (const auto& preset : kGreyPresets) presets->addItem(in_words(preset.name));
  connect(presets, qOverload<int>(&QComboBox::activated), this,
          [this](int i) { scene_.set_grey(kGreyPresets[static_cast<std::size_t>(i)].window); });
  row->addWidget(presets);
  grey_ = new QLabel(bar);
  grey_->setObjectName("faint");
  grey_->setToolTip(tr("Window and level, HU"));
  grey_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a small window has no room for it
  connect(&scene_, &SliceScene::changed, grey_, [this] {
    grey_->setText(QString("W %1  L %2").arg(scene_.grey().width, 0, 'f', 0).arg(scene_.grey().centre, 0, 'f', 0));
  });
  row->addWidget(grey_, 1);
  auto* opacity = new QSlider(Qt::Horizontal, bar);
  opacity->setAccessibleName(tr("Opacity of the labels"));
  opacity->setToolTip(tr("Opacity of the structures' colours in the slices, %"));
  opacity->setRange(0, 100);
  opacity->setValue(static_cast<int>(100.0 * scene_.opacity()));
  opacity->setFixedWidth(70);
  connect(opacity, &QSlider::valueChanged, this, [this](int percent) { scene_.set_opacity(0.01 * percent); });
  row->addWidget(opacity);
  add_step(bar, tr("Undo"), true, QKeySequence::Undo);
  add_step(bar, tr("Redo"), false, QKeySequence::Redo);
  return bar;
}

void CheckPage::add_step(QWidget* bar, const QString& text, bool undo, const QKeySequence& key) {
  QUndoStack& stack = history_.stack();
  auto* button = new QToolButton(bar);
  button->setText(undo ? QString::fromUtf8("\u21b6") : QString::fromUtf8("\u21b7"));
  button->setAccessibleName(text);
  button->setToolTip(QString("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
  button->setShortcut(key);
  button->setFocusPolicy(Qt::TabFocus);
  button->setEnabled(false);
  bar->layout()->addWidget(button);
  connect(button, &QToolButton::clicked, &stack, undo ? &QUndoStack::undo : &QUndoStack::redo);
  connect(&stack, undo ? &QUndoStack::canUndoChanged : &QUndoStack::canRedoChanged, button, &QWidget::setEnabled);
  connect(&stack, undo ? &QUndoStack::undoTextChanged : &QUndoStack::redoTextChanged, button,
          [button, text, key](const QString& what) {
            button->setToolTip(QString("%1 %2 (%3)").arg(text, what, key.toString(QKeySequence::NativeText)));
          });
}

QWidget* CheckPage::make_side() {
  auto* side = new QWidget(this);
  side->setMinimumWidth(330);
  side->setMaximumWidth(400);
  tabs_ = new QTabWidget(side);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setDrawBase(false);
  structures_ = new StructurePanel(scene_, history_, side);
  landmarks_ = new LandmarkPanel(scene_, history_, side);
  quality_ = new QualityList(QualityList::Remarks::below, side);
  tabs_->addTab(structures_, tr("S&tructures"));
  tabs_->addTab(landmarks_, tr("Land&marks"));
  tabs_->addTab(quality_, tr("&Quality"));
  save_ = new QPushButton(tr("Save fo&r 3D Slicer ..."), side);
  load_ = new QPushButton(tr("L&oad ..."), side);
  save_->setToolTip(tr("Labels (.nrrd) and landmarks (.mrk.json beside them), to be painted and moved there"));
  load_->setToolTip(tr("A label map (all structures in it) or landmarks (.mrk.json), as 3D Slicer saves them.\n"
                       "A label map without names (NIfTI) is read by these values: %1")
                        .arg(label_values_text()));
  auto* slicer = new QHBoxLayout;
  slicer->addWidget(save_);
  slicer->addWidget(load_);
  auto* all = new QVBoxLayout(side);
  all->setContentsMargins(4, 0, 0, 0);
  all->addWidget(tabs_, 1);
  all->addLayout(slicer);
  const auto choose = [this](const std::string& structure) {
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Choose a label map"), folder_to_open(),
        tr("Label maps and landmarks (*.nrrd *.nii *.nii.gz *.dcm *.mrk.json);;All files (*)"));
    if (file.isEmpty()) return;
    keep_opened(file);
    load(file.toStdString(), structure);
  };
  connect(structures_, &StructurePanel::load_wanted, this,
          [choose](const QString& structure) { choose(structure.toStdString()); });
  connect(load_, &QPushButton::clicked, this, [choose] { choose({}); });
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save the labels"), "labels.nrrd", tr("Label maps (*.nrrd)"));
    if (!file.isEmpty()) save(file.toStdString());
  });
  return side;
}

QWidget* CheckPage::make_foot() {
  auto* foot = new QWidget(this);
  message_ = new QLabel(foot);
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  strip_ = new WorkStrip(work_, foot);
  again_ = new QPushButton(tr("Run a&gain with the edits"), foot);
  again_->setToolTip(tr("Finds the structures anew with the seeds, thresholds, label maps and landmarks given"));
  back_ = new QPushButton(tr("L&eave"), foot);
  build_ = new QPushButton(tr("&Build the patient"), foot);
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(back_);
  row->addWidget(message_, 1);
  row->addWidget(strip_, 1);
  row->addWidget(again_);
  row->addWidget(build_);
  connect(back_, &QPushButton::clicked, this, &CheckPage::left);
  connect(again_, &QPushButton::clicked, this, &CheckPage::segment_wanted);
  connect(build_, &QPushButton::clicked, this, &CheckPage::build_wanted);
  return foot;
}

void CheckPage::clear() {
  show_scan({});
  at_->clear();
}

void CheckPage::show_scan(std::shared_ptr<const pipeline::Hounsfield> scan) {
  found_ = {};
  scene_.set_scan(std::move(scan));
  scene_.set_tool(SliceTool::crosshair);
  history_.clear();
  structures_->show_findings({});
  landmarks_->show_found({}, {});
  report_.clear();
  quality_->show_items({});
  tabs_->setTabText(2, tr("&Quality"));
  message_->clear();
}

void CheckPage::show_segmentation(const SegmentedScan& scan) {
  const bool first = !found_.labels;
  const auto before = report_;
  found_ = scan;
  scene_.set_labels(scan.labels);
  scene_.set_focus(scan.bounds[0], scan.bounds[1]);
  structures_->show_findings(scan.findings);
  landmarks_->show_found(scan.landmarks, scan.findings);
  report_ = scan.quality;
  for (auto& item : pipeline::finding_items(scan.findings)) report_.push_back(std::move(item));
  quality_->show_items(report_, before);
  tabs_->setTabText(2, quality_->to_check() > 0 ? tr("&Quality (%1)").arg(quality_->to_check()) : tr("&Quality"));
  tabs_->setTabToolTip(2, tr("To be checked first: %1").arg(quality_->to_check()));
  show_message("");
  const auto glottis = scan.landmarks.find("glottis_centre");
  const auto vallecula = scan.landmarks.find("vallecula");
  // The middle of the throat tells more than the middle of the scan.
  if (first && vallecula != scan.landmarks.end())
    scene_.set_crosshair(vallecula->second);
  else if (first && glottis != scan.landmarks.end())
    scene_.set_crosshair(glottis->second);
  if (first) slice(SlicePlane::sagittal).setFocus();
  show_state();
}

void CheckPage::show_message(const QString& message, bool problem) {
  theme::dress(*message_, problem ? "color: @over@;" : "color: @text@;");
  message_->setText(message);
  show_state();
}

void CheckPage::show_failure(const QString& message) {
  for (const auto& label : pipeline::kLabelNames)
    if (message.contains(QString::fromStdString(pipeline::words_of(label.name)))) structures_->select(label.name);
  show_message(message + '\n' +
               tr("Choose a structure on the right and give it a seed, a threshold or a label map, then run again."));
}

bool CheckPage::edits_waiting() const {
  const EditState& now = history_.state();
  return !now.same_segmentation(found_.from) || !now.same_landmarks(found_.from);
}

void CheckPage::show_busy(const QString& what) {
  if (work_.busy()) strip_->begin(what);
  show_state();
}

void CheckPage::show_state() {
  const bool busy = work_.busy(), waiting = edits_waiting(), found = found_.labels != nullptr;
  const bool again_first = !found || !history_.state().same_segmentation(found_.from);
  strip_->setVisible(busy);
  message_->setVisible(!busy);
  side_->setEnabled(!busy);
  again_->setEnabled(!busy && waiting);
  build_->setEnabled(!busy && found);
  save_->setEnabled(found);
  // The next step is the blue one.
  again_->setObjectName(again_first ? "primary" : "");
  build_->setObjectName(again_first ? "" : "primary");
  for (QPushButton* button : {again_, build_}) {
    button->style()->unpolish(button);
    button->style()->polish(button);
  }
}

void CheckPage::load(const std::filesystem::path& file, const std::string& structure) {
  if (work_.load(file, structure, history_.state())) show_busy(tr("Reading what was made elsewhere"));
}

void CheckPage::save(const std::filesystem::path& file) {
  if (work_.save(file, history_.state())) show_busy(tr("Saving for 3D Slicer"));
}

}  // namespace vallecula::gui
