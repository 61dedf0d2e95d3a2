#include "tests/gui/busy_course.h"

#include "tests/gui/block_patient.h"

namespace vallecula::gui::test {

std::filesystem::path write_busy_course(const std::filesystem::path& folder) {
  const std::string common = "\n" + usual_demands();
  std::string text = R"(schema: 2
id: busy-course
title: Busy course
goals: [Answer while the hands go on.]
rubric:
)";
  for (const char* mark : {"peak_tongue_force_n", "peak_gum_force_n", "glottis_visible_percent", "attempt_time_s",
                           "time_over_target_s", "time_over_device_limit_s"})
    text += std::string("  ") + mark + ": { source: assumed }\n";
  text += R"(modules:
  - id: first
    title: First things
    goal: To begin with.
    scenarios: [busy, helped]
    mastery: { rule: consecutive, passes: 1, attempts: 2, source: assumed }
  - id: second
    title: Later things
    goal: To go on with.
    scenarios: [later]
    after: [first]
    modes: [assessment]
    mastery: { rule: cusum, attempts: 2, source: assumed }
scenarios:
  - id: busy
    title: Busy
    briefing: Press on the block, and answer.
    debriefing: Which answer came late?
    assistance: { cut_view: false, force_bar: false })" +
          common + R"(    distractions:
      - at_s: 0.3
        kind: question
        text: How **long** has it been?
        answers: [6 minutes, 8 minutes, 12 minutes]
        right_answer: 2
        time_allowed_s: 20
      - { at_s: 0.5, kind: alarm, text: "Infusion pump: end of syringe", time_allowed_s: 20 }
      - { at_s: 0.6, kind: talk, text: "\"Bed four is free now.\"" }
  - id: helped
    title: Helped
    briefing: Press on the block.
    debriefing: It gave way.
    variation: { tongue_young_pa: [5000, 7000] }
    assistance: { ghost_path: true, glottis_highlight: true })" +
          common + R"(
  - id: later
    title: Later
    briefing: Press on the block.
    debriefing: It gave way.)" +
          common;
  write_text(folder / "busy.yaml", text);
  return folder / "busy.yaml";
}

}  // namespace vallecula::gui::test
