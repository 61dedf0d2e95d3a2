#include "gui/commands/sign_in.h"

#include <termios.h>
#include <unistd.h>

#include <iostream>
#include <stdexcept>

namespace vallecula::gui {
namespace {

std::string read_pin() {
  std::string pin;
  termios before{};
  const bool terminal = ::isatty(STDIN_FILENO) != 0 && ::tcgetattr(STDIN_FILENO, &before) == 0;
  if (terminal) {
    termios unseen = before;
    unseen.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    std::cerr << "PIN: " << std::flush;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &unseen);
  }
  std::getline(std::cin, pin);
  if (terminal) {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
    std::cerr << "\n";
  }
  if (!pin.empty() && pin.back() == '\r') pin.pop_back();
  return pin;
}

}  // namespace

curricula::SignedIn sign_in(curricula::People& people, const std::string& name) {
  for (const curricula::Person& person : people.list())
    if (person.name == name) return people.sign_in(person.id, read_pin());
  throw std::runtime_error("--sign-in: nobody is known by this name; see the list in the window");
}

}  // namespace vallecula::gui
