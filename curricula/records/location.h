// Where the records are: a SQLite file, or a PostgreSQL server that several stations share.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

namespace vallecula::curricula {

class RecordsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RecordsLocation {
  RecordsLocation(const std::filesystem::path& sqlite_file) : file(sqlite_file) {}  // NOLINT: a file is a location
  /// "postgresql://[USER[:PASSWORD]@][HOST][:PORT]/DATABASE[?OPTION=VALUE&...]" (postgres:// too; %-encoded where
  /// needed; options: host for a socket's folder and its port, sslmode, sslrootcert, sslcert, sslkey, connect_timeout),
  /// else the path of a SQLite file. Throws RecordsError; no message has the password.
  static RecordsLocation parse(const std::string& setting);

  bool server() const { return file.empty(); }
  /// For messages: the file, or the server's address and database; never a user's name or password.
  std::string shown() const;

  std::filesystem::path file;  ///< empty: a server
  std::string host, database, user, password;
  int port = 5432;
  std::map<std::string, std::string> options;
  std::string station;  ///< which computer this is (station_id); logs and their files lie on the station that made them
  /// ms since 1970; empty: the system's clock, of a server the server's. For tests.
  std::function<long long()> clock_ms;
  double patience_s = 10.0;  ///< how long other writers, or a server that went away, are waited for
};

/// The station's id: 32 random hexadecimal digits, kept in `folder`/station-id, made there at first use. It tells
/// stations that share a server apart and says nothing of the computer. Throws RecordsError.
std::string station_id(const std::filesystem::path& folder);

}  // namespace vallecula::curricula
