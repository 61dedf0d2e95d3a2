#include "gui/session/virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "gui/session/user_paths.h"

namespace vallecula::gui {
namespace {

constexpr int kStartTimeoutMs = 15000;
constexpr auto kEndTimeout = std::chrono::seconds(3);

bool answers(const std::string& socket_path, bool abstract) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::size_t lead = abstract ? 1 : 0;  // an abstract name begins with a zero byte
  if (socket_path.size() + lead >= sizeof address.sun_path) return false;
  std::memcpy(address.sun_path + lead, socket_path.data(), socket_path.size());
  const int handle = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (handle < 0) return false;
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + lead + socket_path.size());
  const bool connected = connect(handle, reinterpret_cast<const sockaddr*>(&address), length) == 0;
  close(handle);
  return connected;
}

/// What the server writes to its -displayfd: the number it took, and a newline. Empty when it said nothing in time.
std::string read_line(int handle, int timeout_ms) {
  std::string line;
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
  while (line.empty() || line.back() != '\n') {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
    pollfd waiting{handle, POLLIN, 0};
    if (left.count() <= 0 || poll(&waiting, 1, static_cast<int>(left.count())) <= 0) return "";
    std::array<char, 64> bytes{};
    const ssize_t count = read(handle, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return "";  // the server ended
    line.append(bytes.data(), static_cast<std::size_t>(count));
  }
  line.pop_back();
  return line;
}

}  // namespace

std::string display_problem() {
  if (set_variable("WAYLAND_DISPLAY") != nullptr) return "";
  const char* display = set_variable("DISPLAY");
  if (display == nullptr) return "there is no display (DISPLAY is not set)";
  if (display[0] != ':') return "";  // another machine's: Qt will see
  const std::string number = std::string(display + 1).substr(0, std::string(display + 1).find('.'));
  const std::string path = "/tmp/.X11-unix/X" + number;
  if (answers(path, true) || answers(path, false)) return "";
  return std::string("no X server answers on display ") + display;
}

VirtualDisplay::VirtualDisplay(int width, int height) {
  int tells[2], fails[2];  // the display's number; why exec failed (closes without a word when it did not)
  if (pipe(tells) != 0) throw std::runtime_error("no virtual display: " + std::string(std::strerror(errno)));
  if (pipe2(fails, O_CLOEXEC) != 0) {
    const int reason = errno;
    close(tells[0]);
    close(tells[1]);
    throw std::runtime_error("no virtual display: " + std::string(std::strerror(reason)));
  }
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  const std::string handle = std::to_string(tells[1]);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(127);  // it died before the line above
    close(tells[0]);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    setpgid(0, 0);  // Ctrl-C is for the program, which then ends the server in order
    execlp("Xvfb", "Xvfb", "-displayfd", handle.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp", "-noreset",
           static_cast<char*>(nullptr));
    const int reason = errno;
    [[maybe_unused]] const ssize_t written = write(fails[1], &reason, sizeof reason);
    _exit(127);
  }
  const int fork_error = errno;
  close(tells[1]);
  close(fails[1]);
  int reason = 0;
  const bool not_run = process_ > 0 && read(fails[0], &reason, sizeof reason) == static_cast<ssize_t>(sizeof reason);
  close(fails[0]);
  const std::string number = process_ > 0 && !not_run ? read_line(tells[0], kStartTimeoutMs) : "";
  close(tells[0]);
  if (process_ < 0) throw std::runtime_error("no virtual display: " + std::string(std::strerror(fork_error)));
  if (number.empty()) {
    end_server();
    if (not_run && reason == ENOENT)
      throw std::runtime_error(
          "there is no display, and no Xvfb to make one with: install xvfb (apt-get install xvfb)");
    throw std::runtime_error("the virtual display (Xvfb) did not start" +
                             (not_run ? ": " + std::string(std::strerror(reason)) : "") +
                             "; try `Xvfb -displayfd 1` to see why");
  }
  name_ = ":" + number;
  if (const char* display = set_variable("DISPLAY")) {
    had_display_ = true;
    display_before_ = display;
  }
  if (const char* wayland = set_variable("WAYLAND_DISPLAY")) {
    had_wayland_ = true;
    wayland_before_ = wayland;
  }
  setenv("DISPLAY", name_.c_str(), 1);
  unsetenv("WAYLAND_DISPLAY");
}

VirtualDisplay::~VirtualDisplay() {
  end_server();
  if (had_display_)
    setenv("DISPLAY", display_before_.c_str(), 1);
  else
    unsetenv("DISPLAY");
  if (had_wayland_) setenv("WAYLAND_DISPLAY", wayland_before_.c_str(), 1);
}

void VirtualDisplay::end_server() {
  if (process_ <= 0) return;
  kill(process_, SIGTERM);
  const auto until = std::chrono::steady_clock::now() + kEndTimeout;
  while (waitpid(process_, nullptr, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > until) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  process_ = -1;
}

}  // namespace vallecula::gui
