// The curricula this window knows, for the records that name them.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "curricula/scenario.h"

namespace vallecula::gui {

/// Records hold ids; a curriculum that is not here any more, or another version of it, is told by those.
class KnownCourses {
 public:
  void set(std::vector<curricula::Curriculum> curricula) { curricula_ = std::move(curricula); }
  const curricula::Curriculum* find(const std::string& curriculum_id) const;  ///< null: not known here
  const curricula::Scenario* find(const std::string& curriculum_id, const std::string& scenario_id) const;
  QString title(const std::string& curriculum_id) const;
  QString title(const std::string& curriculum_id, const std::string& scenario_id) const;

 private:
  std::vector<curricula::Curriculum> curricula_;
};

}  // namespace vallecula::gui
