#include "gui/session/builtin_patient.h"

#include <gtest/gtest.h>

#include <set>

namespace vallecula::gui {
namespace {

TEST(BuiltinPatient, EveryNumberOfAManikinMakesAnotherName) {
  std::set<std::string> names;
  curricula::ManikinSpec plain;
  plain.weight_kg = 3.2;
  plain.seed = 1;
  names.insert(builtin_patient_name(plain));
  EXPECT_EQ(names.begin()->rfind("manikin-3.20kg-1-", 0), 0u) << *names.begin();
  EXPECT_EQ(*names.begin(), builtin_patient_name(plain));
  const auto with = [&](auto&& change) {
    curricula::ManikinSpec other = plain;
    change(other);
    names.insert(builtin_patient_name(other));
  };
  with([](auto& m) { m.weight_kg = 3.201; });  // the same to two places
  with([](auto& m) { m.seed = 2; });
  with([](auto& m) { m.gestation_weeks = 1.0; });  // the same number in each field
  with([](auto& m) { m.mouth_opening = 1.0; });
  with([](auto& m) { m.tongue_size = 1.0; });
  with([](auto& m) { m.larynx_height_mm = 1.0; });
  with([](auto& m) { m.epiglottis_length = 1.0; });
  with([](auto& m) { m.larynx_height_mm = 0.0; });  // asked for, not left to the seed
  EXPECT_EQ(names.size(), 9u);
}

}  // namespace
}  // namespace vallecula::gui
