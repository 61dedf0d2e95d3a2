// The patient of the next trial, read and made ready for drawing, and its scene: before somebody asks for it, and kept
// for the trial after that one.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "engine/scene.h"
#include "gui/views/patient_look.h"

namespace vallecula::gui {

class ReadyPatient {
 public:
  /// From the folder NAME.patient as it lies on the disk now; read only where it is not the one that is kept. Any
  /// thread, one after the other. `progress(stage, 0..1)` may throw, to leave; so while another call is waited for.
  /// Throws what read_package() and make_patient_look() throw, and std::runtime_error after stop().
  /// The look is as the last trial left it, until it is updated with the next one's start.
  std::shared_ptr<PatientLook> look(const std::filesystem::path& folder,
                                    const std::function<void(const std::string&, double)>& progress = {});
  /// This folder is the one that is kept, as it lies on the disk now. Waits as look() does.
  bool has(const std::filesystem::path& folder, const std::function<void(const std::string&, double)>& progress = {});
  /// The scene of this description, the same to the bit as built alone; it is the one that is kept from here on, and
  /// what the one kept before made of the very same input is shared with it instead of made again. Any thread, as
  /// look(); `progress` is called before each long part that is made. Throws what engine::build_scene() throws, and
  /// std::runtime_error after stop().
  std::shared_ptr<const engine::Scene> scene(const engine::SceneDescription& description,
                                             const std::function<void(const std::string&, double)>& progress = {});
  std::shared_ptr<const engine::Scene> kept_scene();  ///< null: none yet; waits as look() does
  /// Nothing is begun from here on, and what is under way ends at its next stage.
  void stop() { stopped_ = true; }

 private:
  std::unique_lock<std::timed_mutex> waited_for(const char* stage, const std::function<void(const std::string&, double)>& progress);
  /// Tells of the progress, unless there is to be none any more.
  void go_on(const std::function<void(const std::string&, double)>& progress, const std::string& stage,
             double fraction) const;
  std::timed_mutex mutex_;
  std::string kept_;  ///< what lay in the folder when it was read
  std::shared_ptr<PatientLook> look_;
  std::shared_ptr<const engine::Scene> scene_;
  std::atomic<bool> stopped_{false};
};

}  // namespace vallecula::gui
