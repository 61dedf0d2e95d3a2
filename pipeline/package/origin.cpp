#include "pipeline/package/origin.h"

#include <algorithm>

namespace vallecula::pipeline {

const char* name_of(Origin origin) {
  switch (origin) {
    case Origin::inferred:
      return "inferred";
    case Origin::given:
      return "given";
    case Origin::from_model:
      return "template";
    default:
      return "measured";
  }
}

bool origin_from(const std::string& text, Origin& origin) {
  for (const auto candidate : {Origin::measured, Origin::inferred, Origin::given, Origin::from_model}) {
    if (text != name_of(candidate)) continue;
    origin = candidate;
    return true;
  }
  return false;
}

std::string words_of(std::string name) {
  if (name.rfind("bone_", 0) == 0) name.erase(0, 5);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

bool PoseChange::moved() const {
  return scan_to_package != PoseChange().scan_to_package || extension_deg != 0.0 || mouth_opened_deg != 0.0;
}

}  // namespace vallecula::pipeline
