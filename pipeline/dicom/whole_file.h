// Is a DICOM file whole? Asked before the library reads it: the distribution's GDCM ends the process on some cut files
// and passes others.
#pragma once

#include <filesystem>
#include <string>

namespace vallecula::pipeline {

/// Walks all elements (sequences and encapsulated pixels too) against the file's length. Empty when the file is whole
/// or its contents are packed (deflated) and cannot be walked; else what is wrong, in words. Files without the DICM
/// marker are "no DICOM file".
std::string fault_of_dicom_file(const std::filesystem::path& file);

}  // namespace vallecula::pipeline
