#include "tests/curricula/records/postgres_server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <grp.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

namespace vallecula::curricula::testing {
namespace {

namespace fs = std::filesystem;

/// The folder of initdb and postgres; the newest version's. Empty: not installed.
fs::path programs() {
  fs::path found;
  std::error_code error;
  for (const auto& version : fs::directory_iterator("/usr/lib/postgresql", error)) {
    const fs::path bin = version.path() / "bin";
    if (fs::exists(bin / "initdb") && fs::exists(bin / "postgres") && bin > found) found = bin;
  }
  std::stringstream path(std::getenv("PATH") != nullptr ? std::getenv("PATH") : "");
  for (std::string one; found.empty() && std::getline(path, one, ':');) {
    if (fs::exists(fs::path(one) / "initdb") && fs::exists(fs::path(one) / "postgres")) found = one;
  }
  return found;
}

/// The server refuses to be run by root; postgres is who Debian runs it as.
const passwd* its_user() {
  if (::geteuid() != 0) return nullptr;
  const passwd* user = ::getpwnam("postgres");
  return user != nullptr ? user : ::getpwnam("nobody");
}

/// Starts a program as the server's user, its words going to `words`; it is stopped when this process dies.
pid_t start_program(const std::vector<std::string>& command, const fs::path& words, const fs::path& folder) {
  const passwd* user = its_user();
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int out = ::open(words.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  ::dup2(out, 1);
  ::dup2(out, 2);
  ::setpgid(0, 0);
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  if (user != nullptr && (::setgroups(0, nullptr) != 0 || ::setgid(user->pw_gid) != 0 || ::setuid(user->pw_uid) != 0))
    ::_exit(126);
  ::prctl(PR_SET_PDEATHSIG, SIGQUIT);  // after the change of user, which clears it
  if (::getppid() != parent) ::_exit(126);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execv(arguments[0], arguments.data());
  ::_exit(127);
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void run_program(const std::vector<std::string>& command, const fs::path& words, const fs::path& folder) {
  int status = 0;
  ::waitpid(start_program(command, words, folder), &status, 0);
  if (status != 0) throw std::runtime_error(command[0] + " failed: " + text_of(words));
}

/// A port that is free now; another program may take it before the server does, which then does not start.
int free_port() {
  const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool bound = ::bind(probe, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
                     ::getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  ::close(probe);
  if (!bound) throw std::runtime_error("no port of the loopback is free");
  return ntohs(address.sin_port);
}

}  // namespace

std::string PostgresServer::why_not() {
  if (programs().empty()) return "PostgreSQL is not installed (packaging/setup installs it: postgresql)";
  if (::geteuid() == 0 && its_user() == nullptr)
    return "the server refuses root and there is no user postgres or nobody";
  return "";
}

PostgresServer& PostgresServer::instance() {
  static PostgresServer server;
  return server;
}

PostgresServer::PostgresServer() : owner_(::getpid()), port_(free_port()) {
  std::string name = "/tmp/vallecula-postgres-XXXXXX";  // a socket's whole path has room for 107 characters only
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the server in /tmp");
  folder_ = name;
  std::ofstream(folder_ / "password") << kPlainPassword << "\n";
  if (const passwd* user = its_user()) {
    for (const fs::path& path : {folder_, folder_ / "password"})
      if (::chown(path.c_str(), user->pw_uid, user->pw_gid) != 0)
        throw std::runtime_error("cannot give the folder away");
  }
  run_program({programs() / "initdb", "-D", folder_ / "data", "-U", "tester", "--pwfile", folder_ / "password", "-A",
               "trust", "--auth-host=scram-sha-256", "-E", "UTF8", "--locale=C", "--no-sync"},
              folder_ / "initdb.log", folder_);
  start();
}

void PostgresServer::start() {
  server_ = start_program({programs() / "postgres", "-D", folder_ / "data", "-k", folder_, "-p", std::to_string(port_),
                           "-c", "listen_addresses=127.0.0.1",
                           // A killed server's pages outlive it in the system's cache; syncing each of its files at
                           // every start would take half a minute on a busy disk.
                           "-c", "fsync=off"},
                          folder_ / "server.log", folder_);
  const std::string setting = "postgresql://tester@/postgres?host=" + folder_.string();
  for (int i = 0; i < 600; ++i) {
    if (ask(setting, "SELECT 1") == "1\n") return;
    if (::waitpid(server_, nullptr, WNOHANG) != 0) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw std::runtime_error("the PostgreSQL server did not start: " + text_of(folder_ / "server.log"));
}

void PostgresServer::stop() {
  if (server_ <= 0) return;
  ::kill(server_, SIGQUIT);  // immediate: as after a power cut
  ::waitpid(server_, nullptr, 0);
  server_ = -1;
}

void PostgresServer::crash_and_restart() {
  stop();
  start();
}

PostgresServer::~PostgresServer() {
  if (::getpid() != owner_) return;
  stop();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string PostgresServer::new_database(bool over_socket) {
  const std::string name = "test" + std::to_string(++databases_);
  ask("postgresql:///postgres", "CREATE DATABASE " + name);
  if (over_socket)
    return "postgresql://tester@/" + name + "?host=" + folder_.string() + "&port=" + std::to_string(port_);
  return "postgresql://tester:" + std::string(kPassword) + "@127.0.0.1:" + std::to_string(port_) + "/" + name;
}

std::string PostgresServer::ask(const std::string& setting, const std::string& sql) const {
  const std::string after = setting.substr(setting.rfind("://") + 3);
  const std::size_t slash = after.find('/', after.find('@') == std::string::npos ? 0 : after.find('@'));
  const std::string database = after.substr(slash + 1, after.find('?') - slash - 1);
  const fs::path words = folder_ / ("ask-" + std::to_string(::getpid()));
  std::error_code ignored;
  fs::remove(words, ignored);
  const pid_t child = start_program({programs() / "psql", "-X", "-q", "-A", "-t", "-v", "ON_ERROR_STOP=1", "-h",
                                     folder_, "-p", std::to_string(port_), "-U", "tester", "-d", database, "-c", sql},
                                    words, folder_);
  ::waitpid(child, nullptr, 0);
  return text_of(words);
}

}  // namespace vallecula::curricula::testing
