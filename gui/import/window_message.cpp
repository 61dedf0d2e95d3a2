#include "gui/import/window_message.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "gui/views/capitalised.h"
#include "pipeline/package/label_map.h"

namespace vallecula::gui {

QString label_values_text() {
  QStringList values;
  for (const auto& label : pipeline::kLabelNames) values << QString("%1 %2").arg(label.value).arg(label.name);
  return values.join(", ");
}

QString window_message(const QString& message) {
  QString text = message;
  text.remove(QRegularExpression(": --seed [^)]*\\)"));  // here a person clicks it
  text.replace(QRegularExpression("say what its values mean: --label-value [^)]*\\)?"),
               "a file without names is read by this list of values: " + label_values_text() +
                   "; give it these, or save it with names (.seg.nrrd)");
  text.replace(
      "import the scan as it lies with --keep-position",
      "choose \"" +
          QCoreApplication::translate("vallecula::gui::BuildPage", "&Leave mouth and neck as scanned").remove('&') +
          "\" in the last step and build again");
  text.replace("give it with --labels", "load it in the check");
  text.replace("; coordinates are LPS mm (x to the left, y to the back, z to the head)", "; click a point inside it");
  text.replace("(x to the left, y to the back, z to the head, mm)?", "? Click a point inside it");
  text.replace("choose one with --series NUMBER (`vallecula series` lists them)", "choose one in the list");
  text.replace("`vallecula series` lists what does", "choose one in the list");
  text.replace("`vallecula series` lists them", "choose one in the list");
  text.replace("leave --series out", "choose that one in the list");
  text.replace("name a folder with", "choose a folder with");
  text.replace("another count (--tets)", "another count of tetrahedra");
  text.remove(", or --replace it");
  text.replace(QRegularExpression("choose another( place)? with --out"), "see to it that patients can be kept there");
  return text;
}

QString window_sentence(const QString& message) {
  QString text = window_message(message);
  if (text.startsWith("series: ")) text = text.mid(8);
  return capitalised(text);
}

}  // namespace vallecula::gui
