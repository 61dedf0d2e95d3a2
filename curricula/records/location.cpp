#include "curricula/records/location.h"

#include <fcntl.h>
#include <unistd.h>

#include <QUrl>
#include <QUrlQuery>
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "curricula/records/random_id.h"

namespace vallecula::curricula {
namespace {

namespace fs = std::filesystem;

constexpr const char* kForm = "; it is postgresql://USER:PASSWORD@HOST:PORT/DATABASE, or the path of a SQLite file";
constexpr std::size_t kIdDigits = 32;

bool is_id(const std::string& text) {
  return text.size() == kIdDigits &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

std::string first_word(const fs::path& file) {
  std::ifstream in(file);
  std::string word;
  in >> word;
  return word;
}

}  // namespace

RecordsLocation RecordsLocation::parse(const std::string& setting) {
  if (setting.empty()) throw RecordsError(std::string("records: the setting is empty") + kForm);
  const bool is_url = setting.rfind("postgresql:", 0) == 0 || setting.rfind("postgres:", 0) == 0;
  if (!is_url) {
    // A mistyped address must not become a file whose name has the password in it.
    if (setting.find("://") != std::string::npos)
      throw RecordsError(std::string("records: the setting is an address of an unknown kind") + kForm);
    return RecordsLocation(fs::path(setting));
  }
  const QUrl url(QString::fromStdString(setting), QUrl::StrictMode);
  if (!url.isValid()) throw RecordsError(std::string("records: the server's address cannot be read") + kForm);
  RecordsLocation location{fs::path()};
  location.host = url.host().toStdString();
  location.port = url.port(5432);
  location.user = url.userName(QUrl::FullyDecoded).toStdString();
  location.password = url.password(QUrl::FullyDecoded).toStdString();
  location.database = url.path(QUrl::FullyDecoded).mid(1).toStdString();
  if (location.database.empty())
    throw RecordsError(std::string("records: the server's address names no database") + kForm);
  for (const auto& [key, value] : QUrlQuery(url).queryItems(QUrl::FullyDecoded)) {
    static const std::string kKnown = " sslmode sslrootcert sslcert sslkey connect_timeout ";
    const std::string name = key.toStdString();
    if (name == "host") {
      location.host = value.toStdString();
    } else if (name == "port" && value.toUShort() > 0) {
      location.port = value.toUShort();
    } else if (kKnown.find(" " + name + " ") != std::string::npos && !value.contains(';')) {
      location.options[name] = value.toStdString();
    } else {
      throw RecordsError("records: the server's address has the option '" + name +
                         "', which is not known or has no such value; allowed: host port" + kKnown);
    }
  }
  return location;
}

std::string RecordsLocation::shown() const {
  if (!server()) return file.string();
  return "postgresql://" + host + ":" + std::to_string(port) + "/" + database;
}

std::string station_id(const fs::path& folder) {
  const fs::path file = folder / "station-id";
  std::error_code error;
  if (fs::exists(file, error)) {
    const std::string id = first_word(file);
    if (!is_id(id))
      throw RecordsError(file.string() +
                         ": holds no station's id (32 hexadecimal digits); remove it, a new one is made");
    return id;
  }
  fs::create_directories(folder, error);
  const std::string id = random_id();
  const fs::path aside = file.string() + "." + id;
  const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  const std::string line = id + "\n";
  const bool written = descriptor >= 0 &&
                       ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size()) &&
                       ::fsync(descriptor) == 0;
  const std::string cause = std::strerror(errno);
  if (descriptor >= 0) ::close(descriptor);
  // A link, unlike a rename, never replaces the id that another program has made meanwhile.
  const bool placed = written && (::link(aside.c_str(), file.c_str()) == 0 || errno == EEXIST);
  ::unlink(aside.c_str());
  if (!placed)
    throw RecordsError(file.string() + ": cannot be written (" + cause +
                       "); check the folder's permission and the disk");
  return first_word(file);
}

}  // namespace vallecula::curricula
