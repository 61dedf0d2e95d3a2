#include "gui/records_pages/rating_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>

#include "curricula/score/checklist.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

using curricula::Rating;

QString words_of(const Rating& rating) {
  if (rating.item != curricula::kGlobalRating)
    return (rating.value != 0.0 ? QCoreApplication::translate("RatingWords", "%1: yes")
                                : QCoreApplication::translate("RatingWords", "%1: no"))
        .arg(words_of_item(rating.item));
  const int step = std::clamp(static_cast<int>(std::lround(rating.value)), 1, 5);
  // The own rating was asked for in other words, so only its number is told.
  return rating.by == "self" ? QCoreApplication::translate("RatingWords", "%1 of 5").arg(step)
                             : QCoreApplication::translate("RatingWords", "%1 of 5, %2")
                                   .arg(step)
                                   .arg(in_words(curricula::kGlobalRatingWords[step - 1]));
}

}  // namespace

QString words_of_item(const std::string& item) {
  QString words = QString::fromStdString(item).replace('_', ' ');
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return in_words(words.toStdString());
}

QString words_of(const std::vector<Rating>& ratings, long long reader) {
  QStringList own;
  std::map<long long, QStringList> instructors;
  for (const Rating& rating : ratings) (rating.by == "self" ? own : instructors[rating.author_id]) << words_of(rating);
  QStringList lines;
  if (!own.isEmpty())
    lines << QCoreApplication::translate("RatingWords", "The trainee's own rating: %1").arg(own.join("; "));
  for (const auto& [author, words] : instructors)
    lines << (author == reader ? QCoreApplication::translate("RatingWords", "You as the instructor: %1")
                               : QCoreApplication::translate("RatingWords", "An instructor: %1"))
                 .arg(words.join("; "));
  return lines.join('\n');
}

}  // namespace vallecula::gui
