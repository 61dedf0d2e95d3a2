#include "pipeline/dicom/ct_helper.h"

#include <sys/mman.h>

#include "pipeline/dicom/ct_exchange.h"
#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {
namespace {

[[noreturn]] void fail(const std::string& file, const std::string& why) {
  throw SeriesError((file.empty() ? "series" : file) + ": " + why);
}

std::shared_ptr<const std::int16_t> view_of(const NamelessMemory& memory, std::size_t count) {
  const std::size_t bytes = count * sizeof(std::int16_t);
  if (memory.bytes() != bytes) throw ct_exchange::Damaged();
  void* data = ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, memory.descriptor(), 0);
  if (data == MAP_FAILED) throw std::bad_alloc();
  return {static_cast<const std::int16_t*>(data),
          [bytes](const std::int16_t* p) { ::munmap(const_cast<std::int16_t*>(p), bytes); }};
}

}  // namespace

HelperResult run_ct_helper(const ReadRequest& request, const std::function<void(double)>& progress,
                           const HelperLimits& limits) {
  std::string file;
  try {
    const NamelessMemory voxels;
    const auto handed = run_reading_helper(ct_exchange::packed(request), voxels, progress, limits);
    file = handed.file;
    HelperResult result;
    result.answer = ct_exchange::unpacked_answer(handed.letter);
    if (!request.list) result.voxels = view_of(voxels, result.answer.geometry.count());
    return result;
  } catch (const SeriesError&) {
    throw;
  } catch (const HelperError& e) {
    fail(e.file(), e.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const ct_exchange::Damaged&) {
    fail(file, kHelperFailed);
  }
}

}  // namespace vallecula::pipeline
