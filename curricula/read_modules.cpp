#include "curricula/read_modules.h"

#include <algorithm>
#include <map>
#include <set>

#include "curricula/schema/read_value.h"

namespace vallecula::curricula {
namespace {

MasteryRule read_mastery(const YAML::Node& node, const Validator& rules, const std::string& path) {
  MasteryRule rule;
  const std::string word = node["rule"].Scalar();
  rule.by_cusum = word == "cusum";
  rule.passes = 3;
  rule.attempts = 2;
  read(node["passes"], rule.passes);
  read(node["attempts"], rule.attempts);
  read(node["source"], rule.source);
  rule.assessments_only = node["counts"] && node["counts"].Scalar() == "assessment";
  const auto percent = [&](const char* field, double& share) {
    if (!node[field]) return;
    if (!rule.by_cusum) rules.fail(node[field], path + field, "none with the rule " + word);
    share = 0.01 * checked_number(node[field]);
  };
  if (rule.by_cusum && node["passes"]) rules.fail(node["passes"], path + "passes", "none with the rule " + word);
  percent("acceptable_failure_percent", rule.cusum.acceptable_failure);
  percent("unacceptable_failure_percent", rule.cusum.unacceptable_failure);
  percent("alpha_percent", rule.cusum.alpha);
  percent("beta_percent", rule.cusum.beta);
  if (rule.cusum.acceptable_failure >= rule.cusum.unacceptable_failure) {
    const char* given =
        node["acceptable_failure_percent"] ? "acceptable_failure_percent" : "unacceptable_failure_percent";
    rules.fail(node[given], path + given, "an acceptable rate below the unacceptable one");
  }
  return rule;
}

/// The modules from `at` back to itself along what each waits for, in that order; empty when there is no such way.
std::vector<std::string> circle(const std::map<std::string, std::set<std::string>>& waits_for, const std::string& at,
                                std::vector<std::string> way, std::set<std::string>& seen) {
  way.push_back(at);
  for (const std::string& next : waits_for.at(at)) {
    if (next == way.front()) {
      way.push_back(next);
      return way;
    }
    if (!seen.insert(next).second) continue;
    std::vector<std::string> found = circle(waits_for, next, way, seen);
    if (!found.empty()) return found;
  }
  return {};
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace

std::vector<Module> read_modules(const YAML::Node& document, const std::vector<Scenario>& scenarios,
                                 const Validator& rules) {
  const YAML::Node nodes = document["modules"], scenario_nodes = document["scenarios"];
  MasteryRule for_all;
  if (const YAML::Node mastery = document["mastery"]) for_all = read_mastery(mastery, rules, "mastery.");

  std::vector<Module> modules;
  std::vector<std::string> names;
  std::map<std::string, std::string> module_of;  // by scenario
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const YAML::Node node = nodes[i];
    const std::string path = "modules[" + std::to_string(i) + "].";
    Module module;
    read(node["id"], module.id);
    read(node["title"], module.title);
    read(node["goal"], module.goal);
    read(node["scenarios"], module.scenarios);
    read(node["after"], module.after);
    if (const YAML::Node modes = node["modes"]) {
      module.modes.clear();
      for (std::size_t k = 0; k < modes.size(); ++k)
        module.modes.push_back(modes[k].Scalar() == "assessment" ? Mode::assessment : Mode::practice);
      if (module.modes.size() == 2 && module.modes[0] == module.modes[1])
        rules.fail(modes[1], path + "modes[1]", "each mode once");
    }
    module.mastery = node["mastery"] ? read_mastery(node["mastery"], rules, path + "mastery.") : for_all;
    if (module.mastery.assessments_only && std::count(module.modes.begin(), module.modes.end(), Mode::assessment) == 0)
      rules.fail(node["modes"], path + "modes", "assessment among them, since its mastery counts nothing else");
    if (std::count(names.begin(), names.end(), module.id) != 0)
      rules.fail(node["id"], path + "id", "an id no other module of the file has");
    for (std::size_t k = 0; k < module.scenarios.size(); ++k) {
      const std::string& id = module.scenarios[k];
      const std::string here = path + "scenarios[" + std::to_string(k) + "]";
      if (std::none_of(scenarios.begin(), scenarios.end(), [&](const Scenario& s) { return s.id == id; }))
        rules.fail(node["scenarios"][k], here, "the id of a scenario of this file");
      if (const auto [other, is_new] = module_of.emplace(id, module.id); !is_new)
        rules.fail(node["scenarios"][k], here, "a scenario in one module only; it is in " + other->second);
    }
    names.push_back(module.id);
    modules.push_back(std::move(module));
  }
  for (std::size_t i = 0; i < scenarios.size(); ++i)
    if (module_of.count(scenarios[i].id) == 0)
      rules.fail(scenario_nodes[i]["id"], "scenarios[" + std::to_string(i) + "].id",
                 "a scenario that one of the modules names");

  // A module waits for what it names, and for what its scenarios name: without these it is not mastered.
  std::map<std::string, std::set<std::string>> waits_for;
  for (const Module& module : modules) waits_for[module.id];
  const auto add = [&](const std::string& waiting, const YAML::Node& after, const std::string& path) {
    for (std::size_t k = 0; after && k < after.size(); ++k) {
      if (waits_for.count(after[k].Scalar()) == 0)
        rules.fail(after[k], path + "[" + std::to_string(k) + "]", "one of the modules " + joined(names, ", "));
      waits_for[waiting].insert(after[k].Scalar());
    }
  };
  for (std::size_t i = 0; i < modules.size(); ++i)
    add(modules[i].id, nodes[i]["after"], "modules[" + std::to_string(i) + "].after");
  for (std::size_t i = 0; i < scenarios.size(); ++i)
    add(module_of[scenarios[i].id], scenario_nodes[i]["after"], "scenarios[" + std::to_string(i) + "].after");
  for (std::size_t i = 0; i < modules.size(); ++i) {
    std::set<std::string> seen;
    const std::vector<std::string> way = circle(waits_for, modules[i].id, {}, seen);
    if (!way.empty())
      rules.fail(nodes[i]["id"], "modules[" + std::to_string(i) + "].id",
                 "modules that do not wait for each other, and these do: " + joined(way, " after "));
  }
  return modules;
}

}  // namespace vallecula::curricula
