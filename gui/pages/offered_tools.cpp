#include "gui/pages/offered_tools.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "gui/views/capitalised.h"

namespace vallecula::gui {

OfferedTools::OfferedTools(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  blade_label_ = new QLabel(tr("Blade"), this);
  blade_ = new QComboBox(this);
  blade_->setObjectName("blade");
  tube_label_ = new QLabel(tr("Tube"), this);
  tube_ = new QComboBox(this);
  tube_->setObjectName("tube");
  blade_->setAccessibleName(blade_label_->text());
  tube_->setAccessibleName(tube_label_->text());
  form->addRow(blade_label_, blade_);
  form->addRow(tube_label_, tube_);
  for (QComboBox* box : {blade_, tube_})
    connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &OfferedTools::changed);
  hide();
}

void OfferedTools::offer(const curricula::Scenario& scenario) {
  const auto fill = [](QComboBox* box, QLabel* label, const std::vector<std::string>& offered, const QString& form) {
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItem(tr("Choose for this infant ..."), QString());
    for (const std::string& one : offered) {
      const QString name = QString::fromStdString(one);
      box->addItem(form.arg(capitalised(QString(name).replace('-', ' '))), name);
    }
    box->setVisible(!offered.empty());
    label->setVisible(!offered.empty());
  };
  const auto tubes = scenario.intubation ? scenario.intubation->offered_tubes : std::vector<std::string>();
  fill(blade_, blade_label_, scenario.offered_blades, "%1");
  fill(tube_, tube_label_, tubes, tr("%1 mm inner diameter"));
  setVisible(!scenario.offered_blades.empty() || !tubes.empty());
}

curricula::ToolChoice OfferedTools::taken() const {
  return {blade_->currentData().toString().toStdString(), tube_->currentData().toString().toStdString()};
}

bool OfferedTools::open() const {
  for (const QComboBox* box : {blade_, tube_})
    if (box->count() > 1 && box->currentData().toString().isEmpty()) return true;
  return false;
}

}  // namespace vallecula::gui
