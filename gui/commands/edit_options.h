// What a person says about a segmentation on the command line: --seed, --threshold, --labels, --landmarks.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/import.h"

namespace vallecula::gui {

class EditOptions {
 public:
  explicit EditOptions(CLI::App& command);
  /// Into an import's options. Throws CLI::ValidationError (wrong usage) naming the option and what is wrong.
  void put_into(pipeline::ImportOptions& import) const;

 private:
  struct Texts {
    std::vector<std::string> seeds, thresholds, label_values;
    std::string labels, landmarks;
  };
  std::shared_ptr<Texts> texts_;  // CLI11 keeps references to it
};

}  // namespace vallecula::gui
