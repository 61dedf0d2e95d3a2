// Changes of a whole course: what belongs together changes together. Like those of yaml_edit.h, each gives a new text
// or throws std::runtime_error.
#pragma once

#include <string>
#include <vector>

#include "curricula/authoring/yaml_text.h"

namespace vallecula::curricula {

/// A new course with one module and one scenario, valid as it stands, commented.
std::string empty_course(const std::string& id, const std::string& title);

/// "lift-2" where "lift" is taken.
std::string free_id(const std::vector<std::string>& taken, const std::string& wanted);
std::vector<std::string> ids_in(const YamlText& course, const std::string& list);  ///< "modules" or "scenarios"
/// "scenarios[3]" of this id; empty: none.
std::string path_of(const YamlText& course, const std::string& list, const std::string& id);

/// A new scenario at the end of the module (its place in modules; ignored by a course of schema 1); its id in `id`.
std::string with_new_scenario(const YamlText& course, std::size_t module, std::string& id);
/// A copy of a scenario of `from` (which may be the course itself); `position` in the module's order.
std::string with_scenario_copied(const YamlText& course, const YamlText& from, const std::string& scenario,
                                 std::size_t module, std::size_t position, std::string& id);
/// A module with one new scenario; or a copy of one with copies of its scenarios.
std::string with_new_module(const YamlText& course, std::string& id);
std::string with_module_copied(const YamlText& course, const YamlText& from, const std::string& module,
                               std::string& id);
/// With its id in its module; a module's last scenario stays, for a module has one.
std::string without_scenario(const YamlText& course, const std::string& scenario);
/// With its scenarios, and where others wait for it.
std::string without_module(const YamlText& course, const std::string& module);
/// To this place of that module's order.
std::string with_scenario_moved(const YamlText& course, const std::string& scenario, std::size_t module,
                                std::size_t position);
/// A course of schema 1 becomes one of schema 2: all its scenarios in one module, as the program reads it anyway.
std::string with_modules(const YamlText& course);
/// An id changes where it is given and wherever it is named.
std::string with_id(const YamlText& course, const std::string& list, const std::string& id, const std::string& new_id);

}  // namespace vallecula::curricula
