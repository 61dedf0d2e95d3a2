// A DICOM segmentation, read by the helper program: what passes between it and this one. The sets lie in the voxels'
// memory, the rest in the letters (dicom/ct_exchange.h).
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/dicom/ct_exchange.h"
#include "pipeline/exchange/label_image.h"

namespace vallecula::pipeline::label_exchange {

std::string packed_request(const std::filesystem::path& file);
/// The rest of a request after its kind.
std::filesystem::path unpacked_request(ct_exchange::Reader& rest);

/// Without the sets.
std::string packed(const LabelImage& image);
/// Throws LabelMapError when the answer is one or its sizes are absurd, ct_exchange::Damaged when it makes no sense.
LabelImage unpacked_answer(const std::string& text, const std::filesystem::path& file);

}  // namespace vallecula::pipeline::label_exchange
