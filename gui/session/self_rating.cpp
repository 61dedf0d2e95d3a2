#include "gui/session/self_rating.h"

#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>

#include "gui/session/files.h"

namespace vallecula::gui {

void keep_self_rating(const std::filesystem::path& log, const SelfRating& rating) {
  QJsonObject json{{"global", rating.global}, {"at_utc", QDateTime::currentDateTimeUtc().toString(Qt::ISODate)}};
  if (rating.tube_in_trachea) json["tube_in_trachea"] = *rating.tube_in_trachea;
  if (rating.sure) json["sure"] = *rating.sure;
  write_file_whole(log.parent_path() / "self-rating.json", QJsonDocument(json).toJson().toStdString());
}

}  // namespace vallecula::gui
