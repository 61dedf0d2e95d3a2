#include "curricula/export/tick_table.h"

#include <functional>
#include <vector>

#include "curricula/export/csv.h"
#include "curricula/score/intubation_score.h"

namespace vallecula::curricula {
namespace {

using Cell = std::function<std::string(const LogTick&)>;
struct Column {
  ColumnText text;
  Cell cell;
};

std::string number(double value) { return csv_number(value); }
std::string yes_or_no(bool value) { return value ? "1" : "0"; }

/// `unit` as it stands in the column's name: "n".
std::string shown(const std::string& unit) { return unit == "n" ? "N" : unit == "nm" ? "N m" : unit; }

template <class Get>
void add_vector(std::vector<Column>& columns, const std::string& name, const std::string& unit,
                const std::string& definition, Get get) {
  for (int axis = 0; axis < 3; ++axis)
    columns.push_back({{name + "_" + "xyz"[axis] + (unit.empty() ? "" : "_" + unit), shown(unit),
                        axis == 0 ? definition : "likewise", ""},
                       [get, axis](const LogTick& t) { return number(get(t)[static_cast<std::size_t>(axis)]); }});
}

template <class Get>
void add_pose(std::vector<Column>& columns, const std::string& name, const std::string& definition, Get get) {
  add_vector(columns, name, "m", definition + ": the blade's or tube's tip",
             [get](const LogTick& t) { return get(t).position_m; });
  for (int i = 0; i < 4; ++i)
    columns.push_back(
        {{name + "_q" + "wxyz"[i], "", i == 0 ? "its rotation, tool to world, as a quaternion" : "likewise", ""},
         [get, i](const LogTick& t) { return number(get(t).rotation_wxyz[static_cast<std::size_t>(i)]); }});
}

const char* word(LoggedState state) {
  constexpr const char* kWords[] = {"tracking", "limited", "lost", "recovering"};
  return kWords[static_cast<int>(state)];
}
const char* word(LoggedInHand held) {
  constexpr const char* kWords[] = {"tube-with-stylet", "tube", "catheter"};
  return kWords[static_cast<int>(held)];
}
const char* word(LoggedPlace place) {
  constexpr const char* kWords[] = {"outside", "mouth", "larynx", "trachea", "main-bronchus", "oesophagus"};
  return kWords[static_cast<int>(place)];
}

std::vector<Column> blade_columns() {
  std::vector<Column> c{
      {{"tick", "", "number of the servo tick, from 0", ""}, [](const LogTick& t) { return std::to_string(t.tick); }},
      {{"time_s", "s", "trial time", ""}, [](const LogTick& t) { return number(t.time_s); }},
      {{"paused", "", "1: the device could not be used; nothing that happens is the hand's doing", ""},
       [](const LogTick& t) { return yes_or_no(paused(t)); }},
      {{"device_valid", "", "0: the device of the blade's hand could not be used", ""},
       [](const LogTick& t) { return yes_or_no(t.device_valid); }},
      {{"step_fed", "", "number of the simulation step that was given this tick's pose; -1: none", ""},
       [](const LogTick& t) { return std::to_string(t.step_fed); }},
      {{"step_used", "", "number of the step whose tissue this tick's force is of; -1: none yet", ""},
       [](const LogTick& t) { return std::to_string(t.step_used); }},
      {{"state", "", "tracking, limited, lost or recovering, of the device's force limit", ""},
       [](const LogTick& t) { return std::string(word(t.state)); }},
      {{"buttons", "",
        "a bit each: 0 to 15 of the device, above them what was asked for by keys, by an instructor, and the helps",
        ""},
       [](const LogTick& t) { return std::to_string(t.buttons); }},
      {{"faults", "", "of the loop, a bit each", ""}, [](const LogTick& t) { return std::to_string(t.faults); }},
      {{"glottis_visible", "", "share of the glottis in sight, 0 to 1; sampled every 20 ticks", "POGO, Levitan 1998"},
       [](const LogTick& t) { return t.has_sight ? number(t.glottis_visible) : std::string(); }},
  };
  add_pose(c, "device", "where the hand really is, world axes (LPS)", [](const LogTick& t) { return t.device_pose; });
  add_pose(c, "proxy", "where the scene holds the blade", [](const LogTick& t) { return t.proxy_pose; });
  add_vector(c, "model_force", "n", "of the tissue on the blade, world axes",
             [](const LogTick& t) { return t.model_force_n; });
  add_vector(c, "model_torque", "nm", "about the blade's tip", [](const LogTick& t) { return t.model_torque_nm; });
  add_vector(c, "displayed_force", "n",
             "what the device was told; where the blade was led to the vallecula it was told none",
             [](const LogTick& t) { return t.displayed_force_n; });
  constexpr const char* kNames[kStructures] = {"tongue", "epiglottis", "gum", "palate", "teeth", "larynx"};
  for (std::size_t i = 0; i < kStructures; ++i) {
    const std::string name = kNames[i];
    add_vector(c, name + "_force", "n", "model force of the " + name,
               [i](const LogTick& t) { return t.loads[i].force_n; });
    add_vector(c, name + "_centre", "m", "centre of its contacts",
               [i](const LogTick& t) { return t.loads[i].centre_m; });
    c.push_back({{name + "_contacts", "", "their count", ""},
                 [i](const LogTick& t) { return std::to_string(t.loads[i].contacts); }});
    c.push_back({{name + "_area_m2", "m2", "of its surface at rest that they stand for; empty: not known", ""},
                 [i](const LogTick& t) { return t.has_areas ? number(t.loads[i].area_m2) : std::string(); }});
  }
  return c;
}

std::vector<Column> tube_columns() {
  std::vector<Column> c;
  const auto add = [&c](const char* name, const char* unit, const char* definition, auto cell) {
    c.push_back({{name, unit, definition, ""}, [cell](const LogTick& t) { return cell(t.intubation); }});
  };
  using I = const LogIntubation&;
  add("in_hand", "", "tube-with-stylet, tube or catheter", [](I i) { return std::string(word(i.in_hand)); });
  add("tip_in", "", "outside, mouth, larynx, trachea, main-bronchus or oesophagus",
      [](I i) { return std::string(word(i.place)); });
  add("bronchus_side", "", "0 right, 1 left; empty: in none",
      [](I i) { return i.side < 0 ? std::string() : std::to_string(i.side); });
  add("past_cords_m", "m", "of the tip along the airway, at most 0 above them",
      [](I i) { return number(i.past_cords_m); });
  add("at_mouth_m", "m",
      "the tube's mark at the upper lip (a package that tells no lips: at the gums); 0: the tip is before the gums",
      [](I i) { return number(i.at_mouth_m); });
  add("buckled_m", "m", "how far the tube is bent aside", [](I i) { return number(i.buckled_m); });
  add_pose(c, "second_hand", "where the hand that has the tube is",
           [](const LogTick& t) { return t.intubation.hand_pose; });
  add_vector(c, "tip", "m", "the tip's place, world axes", [](const LogTick& t) { return t.intubation.tip_m; });
  add_vector(c, "tip_direction", "", "where it points", [](const LogTick& t) { return t.intubation.tip_direction; });
  add_vector(c, "second_model_force", "n", "on the hand that has the tube",
             [](const LogTick& t) { return t.intubation.model_force_n; });
  add_vector(c, "second_displayed_force", "n", "what its device was told",
             [](const LogTick& t) { return t.intubation.displayed_force_n; });
  for (std::size_t k = 0; k < kTubeLoads; ++k)
    c.push_back({{std::string("tube_on_") + name_of(static_cast<LoggedTubeLoad>(k)) + "_n", "N",
                  k == 0 ? "sum of the magnitudes of the tube's forces there" : "likewise", ""},
                 [k](const LogTick& t) { return number(t.intubation.loads_n[k]); }});
  add("tip_load_n", "N", "along the tube, of what stands before its tip", [](I i) { return number(i.tip_load_n); });
  add("tip_against", "", "what that is, mostly", [](I i) {
    return i.tip_against == kNothingAgainstTip ? std::string()
                                               : std::string(name_of(static_cast<LoggedTubeLoad>(i.tip_against)));
  });
  add("glottis_opening", "", "0 closed to 1", [](I i) { return number(i.glottis_opening); });
  add("spasm", "", "1: the cords are in spasm", [](I i) { return yes_or_no(i.spasm); });
  add("secretions_ml", "ml", "", [](I i) { return number(i.secretions_ml); });
  add("sao2", "", "true saturation, 0 to 1", [](I i) { return number(i.sao2); });
  add("spo2", "", "displayed saturation, 0 to 1", [](I i) { return number(i.spo2); });
  add("heart_per_min", "1/min", "heart rate", [](I i) { return number(i.heart_per_min); });
  add("detector_yellow", "", "1: the CO2 detector is yellow", [](I i) { return yes_or_no(i.detector_yellow); });
  add("breaths_given", "", "since the trial began", [](I i) { return std::to_string(i.breaths_given); });
  add("given_per_min", "1/min", "breaths", [](I i) { return number(i.given_per_min); });
  return c;
}

}  // namespace

std::string ticks_csv(const TrialLog& log) {
  std::vector<Column> columns = blade_columns();
  if (log.header.has_intubation)
    for (Column& column : tube_columns()) columns.push_back(std::move(column));
  std::vector<std::string> cells;
  for (const Column& column : columns) cells.push_back(column.text.name);
  std::string csv = csv_line(cells);
  for (const LogTick& tick : log.ticks) {
    for (std::size_t i = 0; i < columns.size(); ++i) cells[i] = columns[i].cell(tick);
    csv += csv_line(cells);
  }
  return csv;
}

std::string tick_column_table() {
  std::vector<ColumnText> all;
  for (const auto& columns : {blade_columns(), tube_columns()})
    for (const Column& column : columns) all.push_back(column.text);
  return column_table(all);
}

}  // namespace vallecula::curricula
