#include "gui/import/source_page.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>
#include <utility>

#include "gui/import/import_work.h"
#include "gui/import/window_message.h"
#include "gui/import/work_strip.h"
#include "gui/session/recent_files.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr int kThumbnailHeight = 116;

QString about_face() {
  return QCoreApplication::translate(
      "SourcePage",
      "Name, number, dates and all other text of the scan are left out of the new patient. The surface of the face is "
      "the patient's own, though, and whoever knows the patient may recognise it: treat the package as patient data.");
}

}  // namespace

SourcePage::SourcePage(ImportWork& work, QWidget* parent) : QWidget(parent), work_(work) {
  source_ = new QLineEdit(this);
  source_->setPlaceholderText(tr("Folder with the CT's DICOM files"));
  source_->setAccessibleName(tr("Where the CT is"));
  folder_ = new QPushButton(tr("Fol&der ..."), this);
  file_ = new QPushButton(tr("F&ile ..."), this);
  table_ = new QTableWidget(0, 4, this);
  table_->setAccessibleName(tr("Series found"));
  table_->setHorizontalHeaderLabels({tr("No."), tr("Picture"), tr("Series"), tr("Remarks")});
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kThumbnailHeight + 8);
  table_->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
  table_->setColumnWidth(0, 46);
  table_->setColumnWidth(1, kThumbnailHeight + 50);
  table_->setColumnWidth(2, 330);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(true);
  name_ = new QLineEdit(this);
  name_->setAccessibleName(tr("Name of the new patient"));
  name_->setMaximumWidth(320);
  name_problem_ = new QLabel(this);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  for (QLabel* label : {name_problem_, message_}) theme::dress(*label, "color: @over@;");
  generic_face_ = new QCheckBox(tr("&Use the shipped generic face instead"), this);
  auto* about = new QLabel(about_face(), this);
  about->setWordWrap(true);
  about->setObjectName("faint");
  go_ = new QPushButton(tr("&Read and find the structures"), this);
  go_->setObjectName("primary");
  go_->setDefault(true);
  auto* cancel = new QPushButton(tr("&Back to the start"), this);
  strip_ = new WorkStrip(work_, this);

  auto* where = new QHBoxLayout;
  where->setSpacing(8);
  where->addWidget(source_, 1);
  where->addWidget(folder_);
  where->addWidget(file_);
  auto* name_name = new QLabel(tr("&Name of the new patient"), this);
  name_name->setBuddy(name_);
  auto* naming = new QHBoxLayout;
  naming->setSpacing(10);
  naming->addWidget(name_name);
  naming->addWidget(name_);
  naming->addWidget(name_problem_, 1);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(10);
  auto* where_name = new QLabel(tr("&CT scan"), this);
  where_name->setBuddy(source_);
  form->addRow(where_name, where);
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  auto* panel_column = new QVBoxLayout(panel);
  panel_column->setContentsMargins(16, 12, 16, 12);
  panel_column->setSpacing(8);
  panel_column->addLayout(naming);
  panel_column->addWidget(about);
  panel_column->addWidget(generic_face_);
  auto* foot = new QHBoxLayout;
  foot->addWidget(cancel);
  foot->addStretch(1);
  foot->addWidget(go_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(10);
  all->addLayout(form);
  all->addWidget(strip_);
  all->addWidget(table_, 1);
  all->addWidget(panel);
  all->addWidget(message_);
  all->addLayout(foot);

  connect(folder_, &QPushButton::clicked, this, [this] {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Choose the folder with the CT"), folder_to_open());
    if (folder.isEmpty()) return;
    keep_opened(folder);
    look_at(folder);
  });
  connect(file_, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose a file of the CT"), folder_to_open());
    if (file.isEmpty()) return;
    keep_opened(file);
    look_at(file);
  });
  // What was listed elsewhere says nothing of another place: its numbers would choose another patient's series.
  connect(source_, &QLineEdit::textChanged, this, &SourcePage::forget_rows);
  connect(source_, &QLineEdit::returnPressed, this, [this] { look_at(source_->text()); });
  connect(name_, &QLineEdit::textChanged, this, &SourcePage::show_state);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SourcePage::show_state);
  connect(table_, &QTableWidget::itemActivated, this, [this] { go_->click(); });
  connect(go_, &QPushButton::clicked, this, [this] { emit chosen(choice()); });
  connect(cancel, &QPushButton::clicked, this, [this] {
    wanted_.clear();
    work_.cancel();
    emit left();
  });
  connect(&work_, &ImportWork::listed, this, &SourcePage::show_rows);
  // Queued: whoever else hears of the end is to be done with it.
  connect(&work_, &ImportWork::cancelled, this, &SourcePage::look_at_wanted, Qt::QueuedConnection);
  connect(&work_, &ImportWork::failed, this, &SourcePage::look_at_wanted, Qt::QueuedConnection);
}

void SourcePage::begin() {
  wanted_.clear();
  work_.cancel();
  source_->clear();
  forget_rows();
  name_->setText(free_patient_name());
  generic_face_->setChecked(false);
  show_message("");
  source_->setFocus();
}

void SourcePage::forget_rows() {
  rows_.clear();
  table_->setRowCount(0);
  show_state();
}

void SourcePage::look_at(const QString& source) {
  if (source.trimmed().isEmpty()) return;
  source_->setText(source.trimmed());
  forget_rows();
  message_->clear();
  if (work_.busy()) {
    wanted_ = source_->text();
    work_.cancel();
  } else if (work_.list_series(source_->text().toStdString()))
    strip_->begin(tr("Looking at what is there"));
  show_state();
}

void SourcePage::look_at_wanted() {
  if (!wanted_.isEmpty()) look_at(std::exchange(wanted_, {}));
}

void SourcePage::show_rows(const std::vector<SeriesRow>& rows) {
  rows_ = rows;
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int r = 0; r < table_->rowCount(); ++r) {
    const SeriesRow& row = rows_[static_cast<std::size_t>(r)];
    auto* picture = new QTableWidgetItem(row.thumbnail.isNull() ? tr("no picture") : "");
    if (!row.thumbnail.isNull()) {
      auto* shown = new QLabel(table_);
      shown->setAlignment(Qt::AlignCenter);
      shown->setPixmap(
          QPixmap::fromImage(row.thumbnail)
              .scaled(kThumbnailHeight + 40, kThumbnailHeight, Qt::KeepAspectRatio, Qt::SmoothTransformation));
      table_->setCellWidget(r, 1, shown);
    }
    const std::array<QTableWidgetItem*, 4> items = {
        new QTableWidgetItem(row.number > 0 ? QString::number(row.number) : QString()), picture,
        new QTableWidgetItem(row.description),
        new QTableWidgetItem(row.usable && row.why.isEmpty() ? tr("can be imported") : window_sentence(row.why))};
    for (int c = 0; c < 4; ++c) {
      QTableWidgetItem* item = items[static_cast<std::size_t>(c)];
      if (!row.usable) item->setForeground(theme::faint());
      item->setToolTip(window_sentence(row.why));
      table_->setItem(r, c, item);
    }
  }
  for (int r = 0; r < table_->rowCount(); ++r)
    if (rows_[static_cast<std::size_t>(r)].usable) {
      table_->selectRow(r);
      go_->setFocus();
      break;
    }
  show_state();
}

void SourcePage::show_message(const QString& message) {
  message_->setText(message);
  show_state();
}

ImportChoice SourcePage::choice() const {
  ImportChoice choice;
  choice.source = source_->text().toStdString();
  choice.name = name_->text();
  const int row = table_->currentRow();
  if (row >= 0 && row < static_cast<int>(rows_.size()))
    choice.series = QString::number(rows_[static_cast<std::size_t>(row)].number);
  choice.generic_face = generic_face_->isChecked();
  return choice;
}

void SourcePage::show_state() {
  const QString problem = problem_with_name(name_->text());
  name_problem_->setText(problem);
  const int row = table_->currentRow();
  const bool usable = row >= 0 && row < static_cast<int>(rows_.size()) && rows_[static_cast<std::size_t>(row)].usable;
  go_->setEnabled(usable && problem.isEmpty() && !work_.busy());
  strip_->setVisible(work_.busy());
  for (QWidget* widget : {static_cast<QWidget*>(source_), static_cast<QWidget*>(folder_), static_cast<QWidget*>(file_)})
    widget->setEnabled(!work_.busy());
}

}  // namespace vallecula::gui
