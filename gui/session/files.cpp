#include "gui/session/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <QCryptographicHash>
#include <QFile>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace vallecula::gui {

namespace fs = std::filesystem;

void write_file_whole(const fs::path& path, const std::string& bytes) {
  const fs::path part = path.string() + ".part";
  const auto fail = [&](const std::string& doing) {
    const std::string cause = std::strerror(errno);
    ::unlink(part.c_str());
    throw std::runtime_error(path.string() + ": could not be " + doing + " (" + cause +
                             "); choose a folder you may write to, on a disk with room");
  };
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail("written");
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int cause = errno;
      ::close(file);
      errno = cause;
      fail("written");
    }
    done += static_cast<std::size_t>(written);
  }
  // close() may report what a network disk held back, so both are asked before the old file is given up.
  const bool synced = ::fsync(file) == 0;
  const int cause = errno;
  const bool closed = ::close(file) == 0;
  if (!synced) errno = cause;
  if (!synced || !closed) fail("written");
  if (::rename(part.c_str(), path.c_str()) != 0) fail("put in place");
}

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream || fs::is_directory(path))
    throw std::runtime_error(path.string() + ": cannot be read; check the name and the permissions");
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) throw std::runtime_error(path.string() + ": reading failed half-way; check the disk");
  return bytes;
}

std::string sha256_of_bytes(const std::string& bytes) {
  QCryptographicHash hash(QCryptographicHash::Sha256);
  hash.addData(bytes.data(), static_cast<int>(bytes.size()));
  return hash.result().toHex().toStdString();
}

std::string sha256_of_file(const fs::path& path) {
  QFile file(QString::fromStdString(path.string()));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file)) {
    throw std::runtime_error(path.string() + ": cannot be read; check the name and the permissions");
  }
  return hash.result().toHex().toStdString();
}

std::string sha256_of_program() {
  static const std::string hash = sha256_of_file("/proc/self/exe");
  return hash;
}

}  // namespace vallecula::gui
