#include "gui/import/quality_list.h"

#include <QCoreApplication>
#include <map>

#include "gui/import/window_message.h"
#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"
#include "pipeline/quality.h"

namespace vallecula::gui {
namespace {

QString coloured(const QString& text, const QColor& colour) {
  return QString("<span style=\"color:%1\">%2</span>").arg(colour.name(), text);
}

/// What stands in the column of figures, as HTML.
QString figure_of(const pipeline::QualityItem& item) {
  return QString::fromStdString(pipeline::value_text(item)).toHtmlEscaped().replace("mm2", "mm²");
}

}  // namespace

QualityList::QualityList(Remarks remarks, QWidget* parent) : QTextBrowser(parent), remarks_(remarks) {
  setAccessibleName(tr("Quality report"));
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void QualityList::show_items(const std::vector<pipeline::QualityItem>& items,
                             const std::vector<pipeline::QualityItem>& before) {
  std::map<std::string, QString> earlier;
  for (const auto& item : before)
    if (item.value) earlier[item.name] = figure_of(item);
  to_check_ = 0;
  QString html;
  for (const auto& group : pipeline::in_groups(items)) {
    html += QString(
                "<p style=\"font-size:12pt; font-weight:bold; margin:10px 4px 2px 4px\">%1 (%2)</p>"
                "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"3\">")
                .arg(in_words(group.title))
                .arg(group.items.size());
    for (const auto& item : group.items) {
      const bool check = item.judged && !item.ok;
      to_check_ += check ? 1 : 0;
      QString name = in_words(item.name).toHtmlEscaped(), figure = figure_of(item);
      const auto was = earlier.find(item.name);
      if (was != earlier.end() && was->second != figure)
        figure += coloured(tr(" (was %1)").arg(was->second), theme::faint());
      if (check) name = coloured(name, theme::over());
      const QString note = window_message(QString::fromStdString(item.note)).toHtmlEscaped();
      if (remarks_ == Remarks::beside) {
        html += QString("<tr><td width=\"27%\">%1</td><td width=\"21%\">%2</td><td width=\"52%\">%3</td></tr>")
                    .arg(name, figure, note);
        continue;
      }
      html += QString("<tr><td width=\"60%\">%1</td><td width=\"40%\">%2</td></tr>").arg(name, figure);
      if (!note.isEmpty())
        html += QString("<tr><td colspan=\"2\" style=\"padding-left:14px\">%1</td></tr>")
                    .arg(coloured(note, theme::faint()));
    }
    html += "</table>";
  }
  setHtml(html);
}

}  // namespace vallecula::gui
