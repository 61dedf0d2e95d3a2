#include "gui/records_pages/curve_charts.h"

#include <QCoreApplication>

#include "gui/records_pages/tables.h"
#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

using curricula::Figure;
using curricula::RecordRow;

QString with_unit(const Figure& figure) {
  return in_words(figure.label) + (*figure.unit == '\0' ? QString() : QString(" (%1)").arg(figure.unit));
}

std::optional<double> value_of(const RecordRow& row, const Figure& figure) {
  const auto found = row.figures.find(figure.name);
  return found == row.figures.end() ? std::nullopt : std::optional(found->second);
}

QString result_of(const RecordRow& row) {
  return !row.score.complete   ? QCoreApplication::translate("CurveCharts", "interrupted")
         : !row.score.counts() ? QCoreApplication::translate("CurveCharts", "not counted")
         : row.score.passed    ? QCoreApplication::translate("CurveCharts", "passed")
                               : QCoreApplication::translate("CurveCharts", "not passed");
}

TrialChart::Content learning_chart(const std::vector<RecordRow>& rows, const Figure& figure,
                                   const curricula::Scenario* scenario) {
  TrialChart::Content content{with_unit(figure), {}, {}, QCoreApplication::translate("CurveCharts", "No trial yet.")};
  int number = 0;
  for (const RecordRow& row : rows) {
    TrialChart::Point point;
    point.value = value_of(row, figure);
    point.mark = !row.score.counts() ? TrialChart::Mark::interrupted
                 : row.score.passed  ? TrialChart::Mark::good
                                     : TrialChart::Mark::bad;
    point.apart = !row.score.counts();  // set aside or a part of a trial: comparable with nothing
    point.tip =
        QCoreApplication::translate("CurveCharts", "trial %1, %2: %3%4")
            .arg(++number)
            .arg(for_people(row.finished_utc), result_of(row),
                 point.value ? QString(", %1 %2").arg(short_decimal(*point.value, 4)).arg(figure.unit) : QString());
    content.points.push_back(point);
  }
  if (scenario != nullptr) {
    const bool more = figure.better > 0;
    if (const auto target = training_target(*scenario, figure.name))
      content.levels.push_back(
          {*target, theme::target().darker(130), QCoreApplication::translate("CurveCharts", "target"), true});
    if (const auto limit = pass_limit(*scenario, figure.name))
      content.levels.push_back({*limit, theme::over(),
                                more ? QCoreApplication::translate("CurveCharts", "passed from here up")
                                     : QCoreApplication::translate("CurveCharts", "passed up to here"),
                                more});
  }
  return content;
}

TrialChart::Content cusum_chart(const CurveReading& reading) {
  const curricula::CusumLines lines = curricula::cusum_lines(reading.rule);
  TrialChart::Content sum{QCoreApplication::translate("CurveCharts", "Cumulative sum (CUSUM) over whole trials"),
                          {},
                          {},
                          QCoreApplication::translate("CurveCharts", "No whole trial yet.")};
  for (std::size_t i = 0; i < reading.cusum.size(); ++i) {
    const curricula::CusumPoint& point = reading.cusum[i];
    const bool begins = i == 0 || reading.cusum[i - 1].verdict != curricula::CusumVerdict::undecided;
    const auto mark = point.verdict == curricula::CusumVerdict::competent   ? TrialChart::Mark::good
                      : point.verdict == curricula::CusumVerdict::deficient ? TrialChart::Mark::bad
                                                                            : TrialChart::Mark::neutral;
    sum.points.push_back({point.sum, mark, begins, false,
                          QCoreApplication::translate("CurveCharts", "trial %1: %2, sum %3, %4")
                              .arg(i + 1)
                              .arg(reading.successes[i] ? QCoreApplication::translate("CurveCharts", "success")
                                                        : QCoreApplication::translate("CurveCharts", "failure"))
                              .arg(decimal(point.sum, 2))
                              .arg(in_words(name_of(point.verdict)))});
  }
  if (!sum.points.empty())
    sum.levels = {
        {lines.lower, theme::within(), QCoreApplication::translate("CurveCharts", "competent below"), true},
        {lines.upper, theme::over(), QCoreApplication::translate("CurveCharts", "not competent above"), false}};
  return sum;
}

}  // namespace vallecula::gui
