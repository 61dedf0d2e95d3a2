// `vallecula series`: what lies in a folder and what of it can be imported; or one volume as it was read.
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "gui/commands/commands.h"
#include "gui/commands/interruption.h"
#include "pipeline/dicom/read_series.h"
#include "pipeline/dicom/write_volume.h"

namespace vallecula::gui {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + '"';
}

void print_json(const std::vector<pipeline::SeriesEntry>& entries) {
  std::ostringstream out;
  out << std::setprecision(17) << "{\"series\": [";
  for (const auto& e : entries) {
    out << (&e == &entries.front() ? "\n" : ",\n") << "  {\"number\": " << e.number
        << ", \"modality\": " << quoted(e.modality) << ", \"columns\": " << e.size[0] << ", \"rows\": " << e.size[1]
        << ", \"slices\": " << e.size[2] << ", \"spacing_mm\": [" << e.spacing[0] << ", " << e.spacing[1] << ", "
        << e.spacing[2] << "], \"orientation\": " << quoted(e.orientation) << ", \"kernel\": " << quoted(e.kernel)
        << ", \"usable\": " << (e.usable ? "true" : "false") << ", \"reason\": " << quoted(e.reason) << "}";
  }
  std::cout << out.str() << "\n]}\n";
}

void print_table(const std::vector<pipeline::SeriesEntry>& entries) {
  for (const auto& e : entries) {
    std::cout << std::setw(3) << e.number << "  " << (e.usable ? "usable  " : "not     ") << described(e);
    if (!e.usable) std::cout << ": " << e.reason;
    std::cout << "\n";
  }
}

void write(const std::string& place, const std::string& choice, const std::string& out) {
  watch_for_interruption();
  const auto volume = pipeline::read_ct_volume(place, choice, [](double) { stop_when_interrupted("the reading"); });
  write_volume(volume, out);
  for (const auto& note : volume.notes) std::cout << "note: " << note << "\n";
  const auto& size = volume.geometry.size;
  std::cout << "volume: " << size[0] << " x " << size[1] << " x " << size[2] << " voxels, HU, " << out << "\n";
}

}  // namespace

void add_series_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("series", "List the series of a folder and what of it can be imported");
  struct Options {
    std::string place, choice, volume;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("PATH", options->place, "Folder, DICOM file, or NIfTI, NRRD or MetaImage file")->required();
  auto* choice = command->add_option("--series", options->choice, "With --volume: which, by its number or its UID");
  auto* volume = command->add_option("--volume", options->volume,
                                     "Write the volume as read, in its own directions and exact HU: NAME.nrrd");
  choice->needs(volume);
  command->add_flag("--json", options->json, "The list as JSON")->excludes(volume);
  volume->check([](const std::string& name) {
    const bool fits = name.size() > 5 && name.compare(name.size() - 5, 5, ".nrrd") == 0;
    return fits ? std::string() : "the name must end in .nrrd";
  });
  command->callback([options, &exit_code] {
    exit_code = 0;
    if (!options->volume.empty()) return write(options->place, options->choice, options->volume);
    const auto entries = pipeline::list_series(options->place);
    if (options->json)
      print_json(entries);
    else
      print_table(entries);
  });
}

}  // namespace vallecula::gui
