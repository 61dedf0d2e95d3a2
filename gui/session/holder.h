// Who may hold a trial up.
#pragma once

#include <cstdint>

namespace vallecula::gui {

/// A trial stands while any of them holds it; each lets go for itself alone.
enum class Holder : std::uint32_t {
  expert = 1u << 0,      ///< the trainee looks at the expert's loop meanwhile
  instructor = 1u << 1,  ///< at the second window
  reader = 1u << 2,      ///< the trainee reads the list of keys meanwhile
  picture = 1u << 3      ///< nobody: the picture stands still, and a hand would steer blind
};

}  // namespace vallecula::gui
