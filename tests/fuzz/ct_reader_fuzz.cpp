// Any bytes as a file beside a good slice, through the whole reader with its helper program (VALLECULA_HELPERS): what
// is guaranteed is that the process which asks goes on, with a volume, a list or a SeriesError, within the limits.
#include <stdlib.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/read_series.h"
#include "tests/pipeline/dicom_file.h"

using namespace vallecula::pipeline;

namespace {

/// Told at the end: how often a volume came out, an error, and an error because the helper died.
struct Tally {
  int volumes = 0;
  int errors = 0;
  int deaths = 0;
  ~Tally() {
    std::fprintf(stderr, "reader: %d volumes, %d errors, of these %d from a helper that died\n", volumes, errors,
                 deaths);
  }
};

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "vallecula-fuzz-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
    test::DicomSlice good;
    good.columns = 12;
    good.rows = 10;
    good.instance = "77";
    good.stored.assign(120, 1024);
    test::write_dicom(good, path_ / "IM0");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void survive(const std::function<void()>& read) {
  static Tally tally;
  const auto start = std::chrono::steady_clock::now();
  try {
    read();
    ++tally.volumes;
  } catch (const SeriesError& e) {
    const std::string message = e.what();
    if (message.find("not beside vallecula") != std::string::npos) std::abort();  // nothing was tested
    ++tally.errors;
    tally.deaths += message.find("does not survive") != std::string::npos ? 1 : 0;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (took.count() > kHelperStallSeconds + 10) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const auto file = folder.path() / "IM1";
  test::write_bytes(std::string(reinterpret_cast<const char*>(data), size), file);
  survive([&] { read_ct_volume(folder.path()); });
  survive([&] { read_ct_series(file); });
  return 0;
}
