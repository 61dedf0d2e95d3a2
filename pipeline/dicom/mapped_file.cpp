#include "pipeline/dicom/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stdexcept>

namespace vallecula::pipeline {

MappedFile::MappedFile(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat facts {};
  if (descriptor < 0 || ::fstat(descriptor, &facts) != 0 || !S_ISREG(facts.st_mode)) {
    if (descriptor >= 0) ::close(descriptor);
    throw std::runtime_error("cannot be opened; check its permissions");
  }
  size_ = static_cast<std::size_t>(facts.st_size);
  void* data = size_ == 0 ? nullptr : ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
  ::close(descriptor);
  if (data == MAP_FAILED) throw std::runtime_error("cannot be read into memory; it is too large");
  data_ = static_cast<const char*>(data);
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) ::munmap(const_cast<char*>(data_), size_);
}

ByteBuffer::ByteBuffer(std::string_view bytes) {
  char* begin = const_cast<char*>(bytes.data());  // a stream buffer's interface; nothing is written
  setg(begin, begin, begin + bytes.size());
}

ByteBuffer::pos_type ByteBuffer::seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode which) {
  const off_type base = from == std::ios_base::beg   ? 0
                        : from == std::ios_base::cur ? gptr() - eback()
                                                     : egptr() - eback();
  return seekpos(base + offset, which);
}

ByteBuffer::pos_type ByteBuffer::seekpos(pos_type position, std::ios_base::openmode) {
  const off_type at = position;
  if (at < 0 || at > egptr() - eback()) return pos_type(off_type(-1));
  setg(eback(), eback() + at, egptr());
  return position;
}

}  // namespace vallecula::pipeline
