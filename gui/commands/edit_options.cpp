#include "gui/commands/edit_options.h"

#include <charconv>

#include "pipeline/exchange/label_names.h"

namespace vallecula::gui {
namespace {

/// NAME=a,b,...: exactly `count` finite numbers.
std::pair<std::string, std::vector<double>> parsed(const char* option, const std::string& text, std::size_t count,
                                                   const char* expected) {
  const std::size_t equals = text.find('=');
  std::vector<double> numbers;
  bool good = equals != std::string::npos && equals > 0;
  const char* at = text.data() + (good ? equals + 1 : text.size());
  const char* end = text.data() + text.size();
  while (good && numbers.size() < count) {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(at, end, value);
    const bool last = numbers.size() + 1 == count;
    good = error == std::errc() && (last ? stop == end : stop != end && *stop == ',');
    numbers.push_back(value);
    at = good && !last ? stop + 1 : stop;
  }
  if (!good) throw CLI::ValidationError(option, "'" + text + "' is not " + expected);
  return {text.substr(0, equals), numbers};
}

}  // namespace

EditOptions::EditOptions(CLI::App& command) : texts_(std::make_shared<Texts>()) {
  command.add_option("--seed", texts_->seeds,
                     "A point inside a structure that is not found by itself: NAME=x,y,z (mm, LPS); tongue, airway, "
                     "bone_skull, bone_mandible, spine, epiglottis, soft_palate, larynx (at the cords), hyoid");
  command.add_option("--threshold", texts_->thresholds, "Lowest and highest HU of a structure: NAME=lo,hi (skin=lo)");
  command.add_option("--labels", texts_->labels,
                     "A label map made elsewhere (NRRD or .seg.nrrd with 3D Slicer's names, NIfTI, DICOM SEG): its "
                     "structures replace what is found");
  command.add_option("--label-value", texts_->label_values,
                     "What a value means in a --labels file that has no names (NIfTI): NAME=value");
  command.add_option("--landmarks", texts_->landmarks,
                     "Landmarks moved in 3D Slicer (.mrk.json): they replace what is found");
}

void EditOptions::put_into(pipeline::ImportOptions& import) const {
  for (const std::string& text : texts_->seeds) {
    const auto [name, p] = parsed("--seed", text, 3, "NAME=x,y,z (mm, LPS), for instance tongue=0,-40.5,12");
    if (!import.edits.seeds.insert({name, {p[0], p[1], p[2]}}).second)
      throw CLI::ValidationError("--seed", "'" + name + "' is given twice");
  }
  for (const std::string& text : texts_->thresholds) {
    const bool skin = text.rfind("skin=", 0) == 0;
    const auto [name, hu] = skin ? parsed("--threshold", text, 1, "skin=lo (HU; skin has no highest value)")
                                 : parsed("--threshold", text, 2, "NAME=lo,hi (HU), for instance airway=-1024,-400");
    if (!import.edits.thresholds.insert({name, {hu[0], skin ? pipeline::kNoHighest : hu[1]}}).second)
      throw CLI::ValidationError("--threshold", "'" + name + "' is given twice");
  }
  for (const std::string& text : texts_->label_values) {
    const auto [name, value] = parsed("--label-value", text, 1, "NAME=value, for instance tongue=4");
    const auto label = pipeline::label_of_name(name);
    if (!label) {
      throw CLI::ValidationError("--label-value",
                                 "'" + name + "' is no structure; known are " + pipeline::known_label_names());
    }
    const int whole = value[0] >= 1.0 && value[0] <= 65535.0 ? static_cast<int>(value[0]) : 0;
    if (static_cast<double>(whole) != value[0])
      throw CLI::ValidationError("--label-value", "'" + text + "': a value is a whole number from 1 to 65535");
    if (!import.edit_files.label_values.insert({whole, *label}).second)
      throw CLI::ValidationError("--label-value", "the value " + std::to_string(whole) + " is given twice");
  }
  if (!texts_->label_values.empty() && texts_->labels.empty())
    throw CLI::ValidationError("--label-value", "says what values of a --labels FILE mean; there is none");
  import.edit_files.labels = texts_->labels;
  import.edit_files.landmarks = texts_->landmarks;
  try {
    pipeline::check_edits(import.edits);
  } catch (const pipeline::EditError& error) {
    throw CLI::ValidationError(error.what());
  }
}

}  // namespace vallecula::gui
