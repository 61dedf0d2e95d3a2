// Ids that no two stations give twice (private to the library).
#pragma once

#include <string>

namespace vallecula::curricula {

/// 32 hexadecimal digits from the system's random numbers.
std::string random_id();

}  // namespace vallecula::curricula
