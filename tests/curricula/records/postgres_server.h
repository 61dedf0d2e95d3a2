// A real PostgreSQL server for the tests: in a folder of its own, on the loopback, gone with the test program.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace vallecula::curricula::testing {

class PostgresServer {
 public:
  /// The one server of this test program, started at first use; throws std::runtime_error when it does not start.
  static PostgresServer& instance();
  /// Why there can be none here; empty: there can. PostgreSQL is looked for in /usr/lib/postgresql/*/bin and the PATH.
  static std::string why_not();

  /// A new empty database; the setting that names it, over TCP with user and password, or over the socket.
  std::string new_database(bool over_socket = false);
  /// Runs SQL in a database as its administrator, beside the code under test; what it answers.
  std::string ask(const std::string& setting, const std::string& sql) const;
  /// Pulls the plug: the server dies at once without a checkpoint, as in a power cut, and is started again.
  void crash_and_restart();
  void stop();
  void start();

  static constexpr const char* kPassword = "p%40ss%2Fw%5C%27or%25d";  ///< as an address has it
  static constexpr const char* kPlainPassword = "p@ss/w\\'or%d";

  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;
  ~PostgresServer();

 private:
  PostgresServer();
  std::filesystem::path folder_;
  pid_t server_ = -1;
  pid_t owner_ = -1;  ///< a forked child must not stop it
  int port_ = 0;
  int databases_ = 0;
};

}  // namespace vallecula::curricula::testing
