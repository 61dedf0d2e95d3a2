// What a person is told when a CT cannot be read.
#pragma once

#include <stdexcept>

namespace vallecula::pipeline {

/// What is wrong, in which file, and how to mend it. Files are named by their place (see file_list.h); neither their
/// folders nor anything that identifies a patient appears.
class SeriesError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace vallecula::pipeline
