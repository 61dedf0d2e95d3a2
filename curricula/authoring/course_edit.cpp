#include "curricula/authoring/course_edit.h"

#include <algorithm>
#include <stdexcept>

#include "curricula/authoring/yaml_edit.h"

namespace vallecula::curricula {
namespace {

std::string place(const std::string& list, std::size_t index) { return list + "[" + std::to_string(index) + "]"; }

const YamlNode& entry(const YamlText& course, const std::string& list, std::size_t index) {
  const YamlNode* node = course.find(place(list, index));
  if (node == nullptr) throw std::runtime_error(place(list, index) + " is not there; look at the text");
  return *node;
}

std::string id_of(const YamlNode& node) {
  const YamlNode* id = node.child("id");
  return id == nullptr ? "" : id->value;
}

std::size_t index_of(const YamlText& course, const std::string& list, const std::string& id) {
  const std::vector<std::string> ids = ids_in(course, list);
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) throw std::runtime_error(list + " has none with the id '" + id + "'; look at the text");
  return static_cast<std::size_t>(found - ids.begin());
}

std::vector<std::string> values_of(const YamlNode* list) {
  std::vector<std::string> values;
  if (list != nullptr)
    for (const YamlNode& item : list->children) values.push_back(item.value);
  return values;
}

/// The module that names a scenario, and where in it; false: none does.
bool find_in_modules(const YamlText& course, const std::string& scenario, std::size_t& module, std::size_t& position) {
  const YamlNode* modules = course.find("modules");
  for (module = 0; modules != nullptr && module < modules->children.size(); ++module) {
    const std::vector<std::string> ids = values_of(modules->children[module].child("scenarios"));
    position = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), scenario) - ids.begin());
    if (position < ids.size()) return true;
  }
  return false;
}

std::string named_in_module(const std::string& text, const std::string& scenario, std::size_t module,
                            std::size_t position) {
  const YamlText course(text);
  if (course.find("modules") == nullptr) return text;  // schema 1 has none
  return with_item(course, place("modules", module) + ".scenarios", position, yaml_text(scenario));
}

YamlNode numbers(std::vector<std::pair<std::string, const char*>> fields) {
  std::vector<std::pair<std::string, YamlNode>> group;
  for (auto& [name, value] : fields) group.emplace_back(std::move(name), yaml_plain(value));
  return yaml_group(std::move(group));
}

YamlNode new_scenario(const std::string& id) {
  return yaml_group({{"id", yaml_text(id)},
                     {"title", yaml_text("New scenario")},
                     {"briefing", yaml_text("What the trainee is asked to do.\n")},
                     {"debriefing", yaml_text("What the trainee should take home.\n")},
                     {"manikin", numbers({{"weight_kg", "3.2"}, {"seed", "1"}})},
                     {"blade", yaml_text("miller-1")},
                     {"sight_percent", yaml_plain("25")},
                     {"max_attempt_s", yaml_plain("60")},
                     {"targets", numbers({{"tongue_force_n", "5"}, {"gum_force_n", "2"}})},
                     {"pass", numbers({{"peak_tongue_force_n", "6.8"},
                                       {"peak_gum_force_n", "3"},
                                       {"glottis_visible_percent", "50"},
                                       {"attempt_time_s", "30"},
                                       {"time_over_target_s", "3"},
                                       {"time_over_device_limit_s", "0.2"}})}});
}

/// What a copied scenario was judged by in its own course: weights and sources that neither it nor its new course has.
std::string with_rubric_of(std::string text, std::size_t scenario, const YamlText& from) {
  const YamlNode* rubric = from.find("rubric");
  if (rubric == nullptr) return text;
  for (const YamlNode& mark : rubric->children) {
    const YamlText course(text);
    const std::string own = place("scenarios", scenario) + ".rubric." + mark.key;
    if (course.find("rubric." + mark.key) != nullptr || course.find(own) != nullptr) continue;
    std::vector<std::pair<std::string, YamlNode>> fields;
    for (const YamlNode& field : mark.children)
      fields.emplace_back(field.key, field.is_text ? yaml_text(field.value) : yaml_plain(field.value));
    text = with_value(course, own, yaml_group(std::move(fields)));
  }
  return text;
}

/// Everywhere that `name` stands in the lists `field` of modules and scenarios.
template <class Change>
std::string in_every_list(std::string text, const char* field, const std::string& name, const Change& change) {
  for (const char* list : {"modules", "scenarios"}) {
    const YamlText course(text);
    const YamlNode* all = course.find(list);
    for (std::size_t i = 0; all != nullptr && i < all->children.size(); ++i) {
      const std::vector<std::string> names = values_of(all->children[i].child(field));
      const auto found = std::find(names.begin(), names.end(), name);
      if (found != names.end())
        text = change(YamlText(text), place(list, i) + "." + field, static_cast<std::size_t>(found - names.begin()));
    }
  }
  return text;
}

}  // namespace

std::string empty_course(const std::string& id, const std::string& title) {
  YamlText course(
      "# A course of your own. Forces are training targets, never injury limits; say where each number comes from,\n"
      "# or that it is assumed.\n"
      "schema: 2\n"
      "id: x\n"
      "title: x\n"
      "mastery: { rule: consecutive, passes: 3, attempts: 2, source: assumed }\n"
      "modules:\n"
      "  - id: first-module\n"
      "    title: First module\n"
      "    goal: What whoever has mastered this module can do.\n"
      "    scenarios: [first-scenario]\n");
  course = YamlText(with_value(course, "id", yaml_text(id)));
  course = YamlText(with_value(course, "title", yaml_text(title)));
  return with_value(course, "scenarios", yaml_list({new_scenario("first-scenario")}));
}

std::string free_id(const std::vector<std::string>& taken, const std::string& wanted) {
  std::string id = wanted;
  for (int n = 2; std::find(taken.begin(), taken.end(), id) != taken.end(); ++n)
    id = wanted.substr(0, 55) + "-" + std::to_string(n);  // 60 characters are allowed
  return id;
}

std::vector<std::string> ids_in(const YamlText& course, const std::string& list) {
  std::vector<std::string> ids;
  if (const YamlNode* all = course.find(list))
    for (const YamlNode& one : all->children) ids.push_back(id_of(one));
  return ids;
}

std::string path_of(const YamlText& course, const std::string& list, const std::string& id) {
  const std::vector<std::string> ids = ids_in(course, list);
  const auto found = std::find(ids.begin(), ids.end(), id);
  return found == ids.end() ? "" : place(list, static_cast<std::size_t>(found - ids.begin()));
}

std::string with_new_scenario(const YamlText& course, std::size_t module, std::string& id) {
  const std::vector<std::string> ids = ids_in(course, "scenarios");
  id = free_id(ids, "new-scenario");
  const std::string text = with_item(course, "scenarios", ids.size(), new_scenario(id));
  return named_in_module(text, id, module, SIZE_MAX);
}

std::string with_scenario_copied(const YamlText& course, const YamlText& from, const std::string& scenario,
                                 std::size_t module, std::size_t position, std::string& id) {
  const std::vector<std::string> ids = ids_in(course, "scenarios");
  id = free_id(ids, scenario);
  const bool own = &course == &from;
  const std::size_t source = index_of(from, "scenarios", scenario), to = own ? source + 1 : ids.size();
  std::string text = with_item_copied(course, "scenarios", to, from, "scenarios", source);
  text = with_value(YamlText(text), place("scenarios", to) + ".id", yaml_text(id));
  // What it waited for, and sizes by weight, are the other course's.
  if (!own) text = with_rubric_of(without_value(YamlText(text), place("scenarios", to) + ".after"), to, from);
  return named_in_module(text, id, module, position);
}

std::string with_new_module(const YamlText& course, std::string& id) {
  const std::vector<std::string> ids = ids_in(course, "modules"), scenarios = ids_in(course, "scenarios");
  id = free_id(ids, "new-module");
  const std::string scenario = free_id(scenarios, "new-scenario");
  const std::string text = with_item(course, "modules", ids.size(),
                                     yaml_group({{"id", yaml_text(id)},
                                                 {"title", yaml_text("New module")},
                                                 {"goal", yaml_text("What whoever has mastered it can do.")},
                                                 {"scenarios", yaml_list({yaml_text(scenario)})}}));
  return with_item(YamlText(text), "scenarios", scenarios.size(), new_scenario(scenario));
}

std::string with_module_copied(const YamlText& course, const YamlText& from, const std::string& module,
                               std::string& id) {
  const std::vector<std::string> ids = ids_in(course, "modules");
  id = free_id(ids, module);
  const std::size_t source = index_of(from, "modules", module), to = ids.size();
  std::string text = with_item_copied(course, "modules", to, from, "modules", source);
  text = with_value(YamlText(text), place("modules", to) + ".id", yaml_text(id));
  if (&course != &from) text = without_value(YamlText(text), place("modules", to) + ".after");
  std::vector<YamlNode> names;
  for (const std::string& scenario : values_of(entry(from, "modules", source).child("scenarios"))) {
    const YamlText now(text);
    const std::vector<std::string> taken = ids_in(now, "scenarios");
    const std::string copy = free_id(taken, scenario);
    text = with_item_copied(now, "scenarios", taken.size(), from, "scenarios", index_of(from, "scenarios", scenario));
    text = with_value(YamlText(text), place("scenarios", taken.size()) + ".id", yaml_text(copy));
    if (&course != &from)
      text = with_rubric_of(without_value(YamlText(text), place("scenarios", taken.size()) + ".after"), taken.size(), from);
    names.push_back(yaml_text(copy));
  }
  return with_value(YamlText(text), place("modules", to) + ".scenarios", yaml_list(std::move(names)));
}

std::string without_scenario(const YamlText& course, const std::string& scenario) {
  std::size_t module = 0, position = 0;
  std::string text = course.text();
  if (find_in_modules(course, scenario, module, position)) {
    if (entry(course, "modules", module).child("scenarios")->children.size() == 1)
      throw std::runtime_error("it is the only scenario of its module; delete the module, or add another one first");
    text = without_item(course, place("modules", module) + ".scenarios", position);
  } else if (ids_in(course, "scenarios").size() == 1) {
    throw std::runtime_error("it is the only scenario of the course; add another one first");
  }
  const YamlText now(text);
  return without_item(now, "scenarios", index_of(now, "scenarios", scenario));
}

std::string without_module(const YamlText& course, const std::string& module) {
  const std::size_t index = index_of(course, "modules", module);
  if (ids_in(course, "modules").size() == 1)
    throw std::runtime_error("it is the only module of the course; add another one first");
  const std::vector<std::string> scenarios = values_of(entry(course, "modules", index).child("scenarios"));
  std::string text = without_item(course, "modules", index);
  for (const std::string& scenario : scenarios) {
    const YamlText now(text);
    if (!path_of(now, "scenarios", scenario).empty())
      text = without_item(now, "scenarios", index_of(now, "scenarios", scenario));
  }
  return in_every_list(text, "after", module, without_item);
}

std::string with_scenario_moved(const YamlText& course, const std::string& scenario, std::size_t module,
                                std::size_t position) {
  std::size_t from = 0, at = 0;
  if (!find_in_modules(course, scenario, from, at)) {
    const std::size_t last = ids_in(course, "scenarios").size() - 1;
    return with_item_moved(course, "scenarios", index_of(course, "scenarios", scenario), std::min(position, last));
  }
  const std::string list = place("modules", from) + ".scenarios";
  const std::size_t count = course.find(list)->children.size();
  if (from == module) return with_item_moved(course, list, at, std::min(position, count - 1));
  if (count == 1) throw std::runtime_error("it is the only scenario of its module, and a module has at least one");
  return named_in_module(without_item(course, list, at), scenario, module, position);
}

std::string with_modules(const YamlText& course) {
  std::vector<YamlNode> names;
  for (const std::string& id : ids_in(course, "scenarios")) names.push_back(yaml_text(id));
  const YamlNode *id = course.find("id"), *title = course.find("title");
  if (names.empty() || id == nullptr || title == nullptr)
    throw std::runtime_error("the course has no id, title or scenarios yet; give them first");
  const std::string text = with_value(course, "schema", yaml_plain("2"));
  return with_value(YamlText(text), "modules",
                    yaml_list({yaml_group({{"id", yaml_text(id->value)},
                                           {"title", yaml_text(title->value)},
                                           {"goal", yaml_text(title->value)},
                                           {"scenarios", yaml_list(std::move(names))},
                                           {"mastery", yaml_group({{"rule", yaml_text("consecutive")},
                                                                   {"passes", yaml_plain("1")},
                                                                   {"attempts", yaml_plain("20")},
                                                                   {"source", yaml_text("assumed: the curriculum "
                                                                                        "named no rule")}})}})}));
}

std::string with_id(const YamlText& course, const std::string& list, const std::string& id, const std::string& new_id) {
  const std::string text = with_value(course, place(list, index_of(course, list, id)) + ".id", yaml_text(new_id));
  const char* named = list == "modules" ? "after" : "scenarios";
  return in_every_list(text, named, id, [&](const YamlText& now, const std::string& path, std::size_t index) {
    return with_value(now, place(path, index), yaml_text(new_id));
  });
}

}  // namespace vallecula::curricula
