#include "curricula/schema/migrate.h"

namespace vallecula::curricula {

void migrate_1_to_2(YAML::Node& document) {
  YAML::Node module;
  module["id"] = document["id"].Scalar();
  module["title"] = document["title"].Scalar();
  module["goal"] = document["title"].Scalar();
  for (const auto& scenario : document["scenarios"]) module["scenarios"].push_back(scenario["id"].Scalar());
  document["modules"].push_back(module);
  document["schema"] = YAML::Load("2");  // an assigned number would count as a quoted one
}

}  // namespace vallecula::curricula
