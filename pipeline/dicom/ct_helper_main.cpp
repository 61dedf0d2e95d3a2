// vallecula-ct: reads a CT or a DICOM segmentation in a process of its own, because damaged files can end the process
// they are read in.
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <new>

#include "pipeline/dicom/ct_exchange.h"
#include "pipeline/dicom/file_list.h"
#include "pipeline/dicom/series_error.h"
#include "pipeline/exchange/label_exchange.h"
#include "pipeline/exchange/label_readers.h"

namespace {

using namespace vallecula::pipeline;

class Host : public ReadHost {
 public:
  explicit Host(ct_exchange::Control& control) : control_(control) {}
  void at_file(const std::string& name) override {
    std::snprintf(control_.file, sizeof control_.file, "%s", name.c_str());
    ++control_.beat;
  }
  void alive(double fraction) override {
    const auto millionths = static_cast<std::uint32_t>(1e6 * fraction);
    if (control_.millionths.exchange(millionths) != millionths) ++control_.beat;
  }
  std::int16_t* voxels(std::size_t count) override {
    const std::size_t bytes = count * sizeof(std::int16_t);
    if (::ftruncate(ct_exchange::kVoxels, static_cast<off_t>(bytes)) != 0) throw std::bad_alloc();
    void* data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, ct_exchange::kVoxels, 0);
    if (data == MAP_FAILED) throw std::bad_alloc();
    return static_cast<std::int16_t*>(data);
  }

 private:
  ct_exchange::Control& control_;
};

std::string read_series(ct_exchange::Reader& request, Host& host) {
  try {
    return ct_exchange::packed(read_place(ct_exchange::unpacked_request(request), host));
  } catch (const SeriesError& e) {
    return ct_exchange::packed_error(e.what());
  } catch (const std::bad_alloc&) {
    return ct_exchange::packed_error("series: not enough memory for a series of this size; close other programs");
  } catch (const std::exception&) {
    // The words of a library may hold what it read.
    return ct_exchange::packed_error("series: it cannot be read (the DICOM library refused it); export it again");
  }
}

std::string read_labels(ct_exchange::Reader& request, Host& host) {
  const auto file = label_exchange::unpacked_request(request);
  const auto error = [&](const std::string& what) {
    return ct_exchange::packed_error("label map " + told_name(file) + ": " + what);
  };
  try {
    host.at_file(told_name(file));
    const auto image = parsed_dicom_segmentation(file);
    const auto bytes = image.sets.size() * sizeof(image.sets[0]);
    std::memcpy(host.voxels(image.sets.size()), image.sets.data(), bytes);
    return label_exchange::packed(image);
  } catch (const LabelMapError& e) {
    return ct_exchange::packed_error(e.what());
  } catch (const std::bad_alloc&) {
    return error("not enough memory for a segmentation of this size; crop it to the head");
  } catch (const std::exception&) {
    return error("the DICOM library refused it; export it again");
  }
}

std::string answer_to(const std::string& letter, Host& host) {
  ct_exchange::Reader request(letter);
  char kind = 0;
  request.take(kind);
  return kind == ct_exchange::kLabels ? read_labels(request, host) : read_series(request, host);
}

}  // namespace

int main() {
  struct stat facts {};
  void* control = MAP_FAILED;
  if (::fstat(ct_exchange::kControl, &facts) == 0 && facts.st_size >= static_cast<off_t>(sizeof(ct_exchange::Control)))
    control =
        ::mmap(nullptr, sizeof(ct_exchange::Control), PROT_READ | PROT_WRITE, MAP_SHARED, ct_exchange::kControl, 0);
  if (control == MAP_FAILED) {
    std::fputs("vallecula-ct is called by vallecula, which hands it what to read; use `vallecula import`\n", stderr);
    return 2;
  }
  Host host(*static_cast<ct_exchange::Control*>(control));
  try {
    const auto answer = answer_to(ct_exchange::read_all(ct_exchange::kLetters), host);
    return ct_exchange::write_all(ct_exchange::kLetters, answer) ? 0 : 1;
  } catch (const ct_exchange::Damaged&) {
    return 1;
  }
}
