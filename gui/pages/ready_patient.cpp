#include "gui/pages/ready_patient.h"

#include <chrono>
#include <set>
#include <stdexcept>

#include "engine/scene_data.h"

namespace vallecula::gui {
namespace {

namespace fs = std::filesystem;

/// Every file with its size and its time: another where anything was changed. Empty: nothing that could be read.
std::string state_of(const fs::path& folder) {
  std::set<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    files.insert(entry.path().filename().string() + " " + std::to_string(entry.file_size(error)) + " " +
                 std::to_string(entry.last_write_time(error).time_since_epoch().count()));
  std::string state;
  for (const std::string& file : files) state += "\n" + file;
  return state.empty() ? state : folder.string() + state;
}

}  // namespace

std::unique_lock<std::timed_mutex> ReadyPatient::waited_for(
    const char* stage, const std::function<void(const std::string&, double)>& progress) {
  std::unique_lock lock(mutex_, std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(50)))
    if (progress) progress(stage, 0.0);
  return lock;
}

bool ReadyPatient::has(const fs::path& folder, const std::function<void(const std::string&, double)>& progress) {
  const auto lock = waited_for("Reading the patient", progress);
  return look_ && kept_ == state_of(folder);
}

std::shared_ptr<PatientLook> ReadyPatient::look(const fs::path& folder,
                                                const std::function<void(const std::string&, double)>& progress) {
  const auto lock = waited_for("Reading the patient", progress);
  const std::string state = state_of(folder);
  if (look_ && kept_ == state) return look_;
  const auto report = [&](const std::string& stage, double fraction) { go_on(progress, stage, fraction); };
  look_.reset();
  report("Reading the patient", 0.0);
  pipeline::PatientPackage package = pipeline::read_package(folder);
  report("Light and colour", 0.2);
  look_ = make_patient_look(
      std::move(package), [&](const std::string&, double done) { report("Light and colour", 0.2 + 0.8 * done); },
      Seen::from_the_eye, folder);
  kept_ = state;
  return look_;
}

std::shared_ptr<const engine::Scene> ReadyPatient::scene(
    const engine::SceneDescription& description, const std::function<void(const std::string&, double)>& progress) {
  const auto lock = waited_for("Building the scene", progress);
  constexpr double kParts = 3.0;
  double made = 0.0;
  scene_ =
      engine::build_scene(description, scene_.get(), [&] { go_on(progress, "Building the scene", made++ / kParts); });
  return scene_;
}

std::shared_ptr<const engine::Scene> ReadyPatient::kept_scene() {
  const auto lock = waited_for("", {});
  return scene_;
}

void ReadyPatient::go_on(const std::function<void(const std::string&, double)>& progress, const std::string& stage,
                         double fraction) const {
  if (stopped_) throw std::runtime_error("the window was closed");
  if (progress) progress(stage, fraction);
}

}  // namespace vallecula::gui
