// The folders beside a package in which it is made, and what killed processes left of them.
#pragma once

#include <filesystem>

namespace vallecula::pipeline {

/// The folder meant by what a person wrote: absolute, without a slash at the end.
std::filesystem::path package_folder(const std::filesystem::path& written);

struct Asides {
  std::filesystem::path part;  ///< being written
  std::filesystem::path old;   ///< was there before, for the moment in which both change places
};
/// This process's own, beside `target`.
Asides asides_of(const std::filesystem::path& target);

/// Removes those that processes left that live no more; an old package whose successor never came into its place is put
/// back. Errors are passed over: nothing depends on it.
void clean_asides(const std::filesystem::path& target);

}  // namespace vallecula::pipeline
