// A file's bytes in memory, and a stream over them for libraries that want one.
#pragma once

#include <filesystem>
#include <istream>
#include <streambuf>
#include <string_view>

namespace vallecula::pipeline {

class MappedFile {
 public:
  /// Throws std::runtime_error (without the file's name) when it cannot be opened.
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  std::string_view bytes() const { return {data_, size_}; }

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

class ByteBuffer : public std::streambuf {
 public:
  explicit ByteBuffer(std::string_view bytes);

 private:
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode which) override;
  pos_type seekpos(pos_type position, std::ios_base::openmode which) override;
};

class ByteStream : private ByteBuffer, public std::istream {
 public:
  explicit ByteStream(std::string_view bytes)
      : ByteBuffer(bytes), std::istream(static_cast<std::streambuf*>(static_cast<ByteBuffer*>(this))) {}
};

}  // namespace vallecula::pipeline
