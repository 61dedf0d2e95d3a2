// Lines of the rubric in the making (private to the library).
#pragma once

#include <string>

#include "curricula/score/score.h"

namespace vallecula::curricula {

std::string fixed(double value, int decimals);
std::string millimetres(double m);       ///< "2.5 mm", of metres
std::string second(double time_s);       ///< "6.50 s"
std::string limit_text(double value);    ///< as it was written in the scenario
/// Its value beside its limit: never equal in print where it is not. Of percents and beats a minute whole ones, unless
/// those would hide that the limit was missed.
std::string figure(const Criterion& c);

/// A figure that must not exceed its limit. `what` is the sentence's subject, `when` says at which second.
Criterion at_most(const char* name, const char* unit, double value, double limit, double at_s, const std::string& what,
                  const std::string& when);
/// A figure that must reach its limit.
Criterion at_least(const char* name, const char* unit, double value, double limit, double at_s, const std::string& what,
                   const std::string& when);
Criterion fact(const char* name, bool met, double at_s, const std::string& sentence);

}  // namespace vallecula::curricula
