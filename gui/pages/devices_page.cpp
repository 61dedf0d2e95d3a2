#include "gui/pages/devices_page.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/pages/background.h"
#include "gui/session/device_rows.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr int kRefreshMs = 1000;

/// The same device in two lists, whether it can be used or not.
bool same_device(const device::FoundDevice& a, const device::FoundDevice& b) {
  return a.info.kind == b.info.kind && a.info.model == b.info.model && a.info.serial == b.info.serial &&
         a.name == b.name;
}

/// What is wrong with it, and how to mend it: two sentences that the row has as one. `whole`: also the places that were
/// tried, which the driver has in brackets at the end.
QString trouble_in_words(const device::FoundDevice& found, const DeviceRow& row, bool whole) {
  if (!found.problem.empty()) {
    const std::size_t tried = std::min(found.mend.find(" (tried "), found.mend.size());
    const QString mend = in_words(found.mend.substr(0, tried));
    return in_words(found.problem) + (mend.isEmpty() ? mend : "; " + mend) +
           (whole ? QString::fromStdString(found.mend.substr(tried)) : QString());
  }
  const std::string calibration = "calibration " + row.calibration + ": ";
  if (row.trouble.rfind(calibration, 0) != 0) return in_words(row.trouble);
  return QString("%1 %2: %3").arg(in_words("calibration"), in_words(row.calibration),
                                  in_words(row.trouble.substr(calibration.size())));
}

}  // namespace

QString device_label(const device::FoundDevice& device) { return capitalised(in_words(device_row(device).model)); }

DevicesPage::DevicesPage(QWidget* parent, Finder find) : QWidget(parent), find_(std::move(find)) {
  auto* title = new QLabel(tr("Devices"), this);
  title->setObjectName("title");
  auto* sub = new QLabel(tr("What is plugged in. The list follows: plug a device in and it appears."), this);
  sub->setObjectName("faint");
  table_ = new QTableWidget(0, static_cast<int>(kDeviceColumns.size()) + 1, this);
  table_->setAccessibleName(tr("Devices"));
  QStringList headings;
  for (const char* column : kDeviceColumns) headings << capitalised(in_words(column));
  headings << tr("Needs");
  table_->setHorizontalHeaderLabels(headings);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // what is needed is read whole
  about_ = new QLabel(tr("Looking for devices ..."), this);
  about_->setWordWrap(true);
  about_->setMinimumHeight(3 * about_->fontMetrics().lineSpacing());
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  about_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* back = new QPushButton(tr("Back"), this);
  back->setShortcut(Qt::Key_Escape);
  use_ = new QPushButton(tr("Use this one"), this);
  use_->setObjectName("primary");
  use_->setEnabled(false);
  check_ = new QPushButton(tr("&Check this one ..."), this);
  check_->setToolTip(tr("Rate, calibration, directions, reach, force and buttons, step by step"));
  check_->setEnabled(false);

  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back);
  buttons->addStretch(1);
  buttons->addWidget(check_);
  buttons->addWidget(use_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(26, 20, 26, 18);
  all->addWidget(title);
  all->addWidget(sub);
  all->addSpacing(10);
  all->addWidget(table_, 1);
  all->addWidget(about_);
  all->addLayout(buttons);

  connect(back, &QPushButton::clicked, this, &DevicesPage::left);
  connect(use_, &QPushButton::clicked, this, [this] {
    if (const auto* device = selected()) emit chosen(device::FoundDevice(*device));
  });
  connect(check_, &QPushButton::clicked, this, [this] {
    if (const auto* device = selected()) emit check_wanted(device::FoundDevice(*device));
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, &DevicesPage::show_selected);
  clock_.setInterval(kRefreshMs);
  connect(&clock_, &QTimer::timeout, this, &DevicesPage::refresh);
}

DevicesPage::~DevicesPage() {
  if (worker_) worker_->wait();
}

void DevicesPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
  clock_.start();
}

void DevicesPage::hideEvent(QHideEvent* event) {
  clock_.stop();
  QWidget::hideEvent(event);
}

void DevicesPage::refresh() {
  if (QApplication::activeModalWidget() != nullptr) return;  // a check may have one of them
  if (worker_) return;  // the last answer is still to come
  worker_ = run_in_background<std::vector<device::FoundDevice>>(
      this, find_, [this](std::vector<device::FoundDevice> devices) { show_list(devices); },
      [this](const QString& message) { about_->setText(tr("The devices cannot be listed: %1").arg(message)); });
}

void DevicesPage::show_list(const std::vector<device::FoundDevice>& devices) {
  const auto* before = selected();
  const device::FoundDevice kept = before != nullptr ? *before : device::FoundDevice();
  const bool had = before != nullptr;
  devices_ = devices;
  int row_of_kept = -1;
  {
    const QSignalBlocker quiet(table_);
    table_->setRowCount(static_cast<int>(devices_.size()));
    for (std::size_t r = 0; r < devices_.size(); ++r) {
      const DeviceRow row = device_row(devices_[r]);
      const auto known = cells_of(row);
      QStringList cells;
      for (const std::string& cell : known) cells << in_words(cell);
      cells << (row.trouble.empty() ? tr("nothing: ready") : trouble_in_words(devices_[r], row, false));
      for (int c = 0; c < cells.size(); ++c) {
        auto* item = new QTableWidgetItem(cells[c]);
        item->setToolTip(item->text());
        if (!usable(devices_[r])) item->setForeground(theme::faint());
        table_->setItem(static_cast<int>(r), c, item);
      }
      if (had && same_device(devices_[r], kept)) row_of_kept = static_cast<int>(r);
    }
    // A column of which nothing is known takes no room from what is needed.
    for (int c = 1; c + 1 < table_->columnCount(); ++c) {
      bool said = false;
      for (int r = 0; r < table_->rowCount(); ++r)
        said = said || table_->item(r, c)->text().size() > 1;  // "-": nothing
      table_->setColumnHidden(c, !said);
    }
    if (row_of_kept >= 0)
      table_->selectRow(row_of_kept);
    else
      table_->clearSelection();
  }
  show_selected();
  emit found(devices_);
}

const device::FoundDevice* DevicesPage::selected() const {
  const auto rows = table_->selectionModel()->selectedRows();
  if (rows.isEmpty() || rows.front().row() >= static_cast<int>(devices_.size())) return nullptr;
  return &devices_[static_cast<std::size_t>(rows.front().row())];
}

void DevicesPage::show_selected() {
  const auto* device = selected();
  use_->setEnabled(device != nullptr && usable(*device));
  check_->setEnabled(use_->isEnabled());
  if (device == nullptr) {
    about_->setText(tr("Choose one to see what it needs."));
    return;
  }
  const DeviceRow row = device_row(*device);
  about_->setText(row.trouble.empty() ? tr("%1: ready.").arg(device_label(*device))
                                      : QString("%1: %2.").arg(device_label(*device),
                                                               trouble_in_words(*device, row, true)));
}

}  // namespace vallecula::gui
