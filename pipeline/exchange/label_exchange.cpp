#include "pipeline/exchange/label_exchange.h"

#include <unistd.h>

#include "pipeline/dicom/reading_helper.h"
#include "pipeline/exchange/label_readers.h"

namespace vallecula::pipeline {
namespace label_exchange {

std::string packed_request(const std::filesystem::path& file) {
  ct_exchange::Writer w;
  w.put(ct_exchange::kLabels);
  w.put(file.string());
  return w.text();
}

std::filesystem::path unpacked_request(ct_exchange::Reader& rest) {
  std::string file;
  rest.take(file);
  return file;
}

std::string packed(const LabelImage& image) {
  ct_exchange::Writer w;
  w.put('a');
  w.put(image.place);
  w.put(image.left_out);
  return w.text();
}

LabelImage unpacked_answer(const std::string& text, const std::filesystem::path& file) {
  ct_exchange::Reader r(text);
  char kind = 0;
  r.take(kind);
  if (kind == 'e') {
    std::string message;
    r.take(message);
    throw LabelMapError(message);
  }
  if (kind != 'a') throw ct_exchange::Damaged();
  LabelImage image;
  r.take(image.place);
  r.take(image.left_out);
  check_placement(image.place, 1, file);
  return image;
}

}  // namespace label_exchange

namespace {

void take_sets(const NamelessMemory& memory, LabelImage& image) {
  image.sets.resize(image.place.count());
  const std::size_t bytes = image.sets.size() * sizeof(image.sets[0]);
  if (memory.bytes() != bytes) throw ct_exchange::Damaged();
  auto* to = reinterpret_cast<char*>(image.sets.data());
  for (std::size_t done = 0; done < bytes;) {
    const auto n = ::pread(memory.descriptor(), to + done, bytes - done, static_cast<off_t>(done));
    if (n <= 0) throw ct_exchange::Damaged();
    done += static_cast<std::size_t>(n);
  }
}

}  // namespace

LabelImage read_dicom_segmentation(const std::filesystem::path& file) {
  try {
    const NamelessMemory sets;
    const auto handed = run_reading_helper(label_exchange::packed_request(file), sets, {}, HelperLimits());
    auto image = label_exchange::unpacked_answer(handed.letter, file);
    take_sets(sets, image);
    return image;
  } catch (const HelperError& e) {
    fail_label_file(file, e.what());
  } catch (const ct_exchange::Damaged&) {
    fail_label_file(file, kHelperFailed);
  }
}

}  // namespace vallecula::pipeline
