#include "pipeline/dicom/ct_exchange.h"

#include <sys/stat.h>
#include <unistd.h>

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline::ct_exchange {
namespace {

void put(Writer& w, const SeriesEntry& e) {
  w.put(e.number);
  w.put(e.modality);
  w.put(e.size);
  w.put(e.spacing);
  w.put(e.orientation);
  w.put(e.kernel);
  w.put(e.usable);
  w.put(e.reason);
  w.put(e.thumbnail.width);
  w.put(e.thumbnail.height);
  w.put(std::string(e.thumbnail.grey.begin(), e.thumbnail.grey.end()));
}

SeriesEntry take_entry(Reader& r) {
  SeriesEntry e;
  std::string grey;
  r.take(e.number);
  r.take(e.modality);
  r.take(e.size);
  r.take(e.spacing);
  r.take(e.orientation);
  r.take(e.kernel);
  r.take(e.usable);
  r.take(e.reason);
  r.take(e.thumbnail.width);
  r.take(e.thumbnail.height);
  r.take(grey);
  e.thumbnail.grey.assign(grey.begin(), grey.end());
  const bool fits = e.thumbnail.width >= 0 && e.thumbnail.height >= 0 && e.thumbnail.width < 4096 &&
                    e.thumbnail.height < 4096 &&
                    grey.size() == static_cast<std::size_t>(e.thumbnail.width) * e.thumbnail.height;
  if (!fits) throw Damaged();
  return e;
}

}  // namespace

std::string packed(const ReadRequest& request) {
  Writer w;
  w.put(kSeries);
  w.put(request.place);
  w.put(request.choice);
  w.put(request.list);
  w.put(request.thumbnails);
  w.put(request.purpose);
  w.put(request.padding);
  return w.text();
}

ReadRequest unpacked_request(Reader& r) {
  ReadRequest request;
  r.take(request.place);
  r.take(request.choice);
  r.take(request.list);
  r.take(request.thumbnails);
  r.take(request.purpose);
  r.take(request.padding);
  return request;
}

std::string packed(const ReadAnswer& answer) {
  Writer w;
  w.put('a');
  w.put(answer.geometry);
  w.put(answer.slices);
  w.put(static_cast<std::uint64_t>(answer.notes.size()));
  for (const auto& note : answer.notes) w.put(note);
  w.put(static_cast<std::uint64_t>(answer.entries.size()));
  for (const auto& entry : answer.entries) put(w, entry);
  return w.text();
}

std::string packed_error(const std::string& message) {
  Writer w;
  w.put('e');
  w.put(message);
  return w.text();
}

ReadAnswer unpacked_answer(const std::string& text) {
  Reader r(text);
  char kind = 0;
  r.take(kind);
  if (kind == 'e') {
    std::string message;
    r.take(message);
    throw SeriesError(message);
  }
  if (kind != 'a') throw Damaged();
  ReadAnswer answer;
  r.take(answer.geometry);
  r.take(answer.slices);
  answer.notes.resize(r.count(text.size()));
  for (auto& note : answer.notes) r.take(note);
  const auto entries = r.count(text.size());
  for (std::size_t i = 0; i < entries; ++i) answer.entries.push_back(take_entry(r));
  std::int64_t count = 1;
  for (const int n : answer.geometry.size) {
    if (n < 0 || n > kMostVoxels) throw Damaged();
    count *= n;
    if (count > kMostVoxels) throw Damaged();
  }
  return answer;
}

std::string read_all(int descriptor) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) != 0) return {};
  std::string text(static_cast<std::size_t>(facts.st_size), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const auto n = ::pread(descriptor, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (n <= 0) return {};
    done += static_cast<std::size_t>(n);
  }
  return text;
}

bool write_all(int descriptor, const std::string& text) {
  if (::ftruncate(descriptor, 0) != 0) return false;
  std::size_t done = 0;
  while (done < text.size()) {
    const auto n = ::pwrite(descriptor, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace vallecula::pipeline::ct_exchange
