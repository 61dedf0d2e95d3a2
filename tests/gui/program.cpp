#include "tests/gui/program.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace vallecula::gui::test {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> Outcome::messages() const {
  std::vector<std::string> lines;
  std::istringstream stream(err);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("vallecula: ", 0) == 0) lines.push_back(line);
  }
  return lines;
}

Sandbox::Sandbox() {
  ::unsetenv("VALLECULA_RECORDS");  // whoever runs the tests may have their own records there
  std::string name = (fs::temp_directory_path() / "vallecula-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
  folder_ = name;
  fs::create_directory(home());
}

Sandbox::~Sandbox() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

pid_t Sandbox::start(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                     unsigned long file_size_limit) const {
  const std::string program = std::string(VALLECULA_BINARY_DIR) + "/vallecula";
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const std::string out = (folder_ / "stdout").string(), err = (folder_ / "stderr").string();
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("no process can be started");
  if (process == 0) {
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    ::setenv("VALLECULA_HOME", home().c_str(), 1);
    for (const std::string& variable : environment) {
      const std::size_t equals = variable.find('=');
      ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
    }
    if (file_size_limit > 0) {
      ::signal(SIGXFSZ, SIG_IGN);  // then write() fails, as it does on a full disk
      const rlimit limit{file_size_limit, file_size_limit};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  return process;
}

Outcome Sandbox::wait(pid_t process) const {
  int status = 0;
  ::waitpid(process, &status, 0);
  Outcome outcome;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  outcome.out = text_of(folder_ / "stdout");
  outcome.err = text_of(folder_ / "stderr");
  fs::remove(folder_ / "stdout");
  fs::remove(folder_ / "stderr");
  return outcome;
}

Outcome Sandbox::run(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) const {
  return wait(start(arguments, environment));
}

Outcome Sandbox::run_on_full_disk(const std::vector<std::string>& arguments, unsigned long bytes) const {
  return wait(start(arguments, {}, bytes));
}

std::vector<std::string> Sandbox::names(const std::string& folder) const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_ / folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace vallecula::gui::test
