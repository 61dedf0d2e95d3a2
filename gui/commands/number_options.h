// What a number on the command line may be. CLI11's own ranges let NaN through and wrap what does not fit the type.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace vallecula::gui {

/// The largest seed of a manikin: curricula allow the same.
constexpr std::uint64_t kLargestSeed = 4294967295;

/// A finite decimal number from `low` to `high`, both included; nothing may follow it.
CLI::Validator number_within(double low, double high);
/// A whole number in plain digits from `low` to `high`, both included.
CLI::Validator whole_number_within(std::uint64_t low, std::uint64_t high);

}  // namespace vallecula::gui
