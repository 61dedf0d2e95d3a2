#include "gui/pages/about_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/pages/versions.h"

namespace vallecula::gui {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("About Vallecula"));
  auto* title = new QLabel(tr("Vallecula %1").arg(VALLECULA_VERSION), this);
  title->setObjectName("title");
  auto* what = new QLabel(
      tr("A force-true trainer for neonatal endotracheal intubation. A training tool, not a medical device: it is not "
         "made for diagnosis or treatment, and practice here does not replace supervised practice.\n\n"
         "Free software under the GNU Affero General Public License, version 3, because TetGen is; without any warranty. "
         "The other parts keep their own licences."),
      this);
  what->setWordWrap(true);
  const auto parts = program_parts();
  auto* table = new QTableWidget(static_cast<int>(parts.size()), 3, this);
  table->setAccessibleName(tr("Parts of the program"));
  table->setHorizontalHeaderLabels({tr("Part"), tr("Version"), tr("Licence")});
  for (int row = 0; row < table->rowCount(); ++row) {
    const Part& part = parts[static_cast<std::size_t>(row)];
    int column = 0;
    for (const QString& text : {part.name, part.version, part.licence})
      table->setItem(row, column++, new QTableWidgetItem(text));
  }
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setTabKeyNavigation(false);
  auto* renderer = new QLabel(tr("Drawn by %1").arg(opengl_renderer()), this);
  renderer->setWordWrap(true);
  renderer->setProperty("role", "faint");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(22, 18, 22, 16);
  column->setSpacing(12);
  for (QWidget* widget : {static_cast<QWidget*>(title), static_cast<QWidget*>(what)}) column->addWidget(widget);
  column->addWidget(table, 1);
  column->addWidget(renderer);
  column->addWidget(buttons);
  resize(560, 560);
}

}  // namespace vallecula::gui
