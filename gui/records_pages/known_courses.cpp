#include "gui/records_pages/known_courses.h"

#include <algorithm>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

const curricula::Curriculum* KnownCourses::find(const std::string& curriculum_id) const {
  const auto found = std::find_if(curricula_.begin(), curricula_.end(),
                                  [&](const curricula::Curriculum& one) { return one.id == curriculum_id; });
  return found == curricula_.end() ? nullptr : &*found;
}

const curricula::Scenario* KnownCourses::find(const std::string& curriculum_id, const std::string& scenario_id) const {
  const curricula::Curriculum* curriculum = find(curriculum_id);
  return curriculum == nullptr ? nullptr : curriculum->find(scenario_id);
}

QString KnownCourses::title(const std::string& curriculum_id) const {
  const curricula::Curriculum* curriculum = find(curriculum_id);
  return curriculum == nullptr ? QString::fromStdString(curriculum_id) : course_words(curriculum->title);
}

QString KnownCourses::title(const std::string& curriculum_id, const std::string& scenario_id) const {
  const curricula::Scenario* scenario = find(curriculum_id, scenario_id);
  return scenario == nullptr ? QString::fromStdString(scenario_id) : course_words(scenario->title);
}

}  // namespace vallecula::gui
