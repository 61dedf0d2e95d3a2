// Edits that come as files from other programs, put onto the scan.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/segment/edits.h"

namespace vallecula::pipeline {

struct EditFiles {
  std::filesystem::path labels;              ///< a label map (label_image.h); empty: none
  std::map<int, std::uint8_t> label_values;  ///< what its values mean when it has no names; empty: kLabelNames' own
  std::filesystem::path landmarks;           ///< a .mrk.json; empty: none
};

/// Adds what the files hold to `edits`: every structure of the label map replaces what is found, every landmark that
/// was moved too. What `edits` has already stands. Returns remarks for a person, without identity. Throws LabelMapError
/// or LandmarkFileError.
std::vector<std::string> add_edit_files(const EditFiles& files, const Grid& scan, Edits& edits);

}  // namespace vallecula::pipeline
