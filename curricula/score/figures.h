// Every figure of a score under one name, with unit, definition and source: what exports, charts and records go by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curricula/score/score.h"

namespace vallecula::curricula {

struct Figure {
  const char* name;        ///< unit in the name, as in score.json: "peak_tongue_force_n"
  const char* label;       ///< for a person: "Peak tongue force"
  const char* unit;        ///< "N"; empty: a count, or yes (1) and no (0)
  const char* definition;  ///< one sentence
  const char* source;      ///< of the definition; "own" where nobody else has it
  bool for_researchers;    ///< in exports only: no trainee is told it, nothing is judged by it
  int better;              ///< +1: more is better, -1: less, 0: neither
  std::optional<double> (*value)(const Score& score);  ///< nothing: the trial has none
};

/// In the order in which they are exported. The names never change their meaning.
const std::vector<Figure>& figures();

/// Null: there is none of that name.
const Figure* find_figure(const std::string& name);

}  // namespace vallecula::curricula
