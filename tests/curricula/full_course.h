// A curriculum of schema 2 that has every field, for tests of all of them.
#pragma once

namespace vallecula::curricula::testing {

constexpr const char* kFullCourse = R"(schema: 2
id: full
title: Every field
goals: [One goal, { en: Another, de: Noch eins }]
mastery:
  rule: cusum
  attempts: 2
  acceptable_failure_percent: 25
  unacceptable_failure_percent: 50
  alpha_percent: 5
  beta_percent: 20
  counts: assessment
  source: assumed
rubric:
  peak_tongue_force_n: { weight: 3, source: assumed }
  attempts: { source: NEAR4NEOS }
blades_by_weight: [{ below_kg: 5, blade: miller-1 }]
tubes_by_weight: [{ below_kg: 5, tube: "3.5" }]
modules:
  - id: a
    title: Module a
    goal: { en: Begin, de: Anfangen }
    scenarios: [one]
    modes: [practice]
    mastery: { rule: consecutive, passes: 4, source: assumed }
  - id: b
    title: Module b
    goal: Go on
    after: [a]
    scenarios: [two]
scenarios:
  - id: one
    title: Scenario one
    briefing: Do it.
    debriefing: Done.
    manikin: { weight_kg: 3.2, seed: 1 }
    blade: miller-0
    tongue_young_pa: 7000
    sight_percent: 25
    max_attempt_s: 60
    targets: { tongue_force_n: 5, gum_force_n: 2 }
    pass:
      peak_tongue_force_n: 6.5
      peak_gum_force_n: 3
      glottis_visible_percent: 50
      attempt_time_s: 30
      time_over_target_s: 3
      time_over_device_limit_s: 0.2
  - id: two
    title: Scenario two
    briefing: { en: "**Do** it.", de: "**Tu** es.", pt-BR: Faz. }
    debriefing: Done.
    after: [a]
    manikin:
      weight_kg: 3.4
      seed: 7
      gestation_weeks: 39
      mouth_opening: 0.9
      tongue_size: 1.05
      larynx_height_mm: 0.5
      epiglottis_length: 1.1
    variation:
      infants: 3
      mouth_opening: [0.9, 1]
      tongue_size: [0.95, 1.05]
      larynx_height_mm: [-1, 1]
      epiglottis_length: [0.9, 1.15]
      tongue_young_pa: [5000, 8000]
      secretions_ml: [0.5, 2]
      infant_seed: true
      distraction_delay_s: [1, 9]
    sight_percent: 25
    max_attempt_s: 180
    targets: { tongue_force_n: 5, gum_force_n: 2 }
    pass:
      peak_tongue_force_n: 6.5
      peak_gum_force_n: 3
      glottis_visible_percent: 50
      attempt_time_s: 30
      time_over_target_s: 3
      time_over_device_limit_s: 0.2
    rubric:
      peak_tongue_force_n: { weight: 2, source: assumed }
      peak_gum_force_n: { weight: 2, source: assumed }
      glottis_visible_percent: { weight: 2, source: assumed }
      attempt_time_s: { weight: 2, source: assumed }
      time_over_target_s: { weight: 2, source: assumed }
      time_over_device_limit_s: { weight: 2, source: assumed }
      outcomes: { weight: 2, source: assumed }
      lowest_spo2_percent: { weight: 2, source: assumed }
      lowest_heart_per_min: { weight: 2, source: assumed }
      tube_force_n: { weight: 2, source: assumed }
      time_to_pass_s: { weight: 2, source: assumed }
      co2_confirmed: { weight: 2, source: assumed }
      depth_neutral: { weight: 2, source: assumed }
      oesophagus_in_time: { weight: 2, source: assumed }
      no_severe_desaturation: { weight: 2, source: assumed }
      right_blade: { weight: 2, source: assumed }
      right_tube: { weight: 2, source: assumed }
    offered_blades: [miller-0, miller-1]
    intubation:
      tube: "3.0"
      offered_tubes: ["3.0", "3.5"]
      stylet: true
      stylet_mm: 1.5
      catheter_f: 6
      course: term
      gestation_weeks: 39
      infant_seed: 17
      added_oxygen_percent: 20
      premedicated: false
      breathes: false
      laryngospasm_s: 25
      laryngospasm_from_start: true
      cord_closure_s: 2
      secretions_ml: 1.5
      laryngeal_pressure_n: 4
      breaths_to_confirm: 5
      pass:
        outcomes: [good-depth]
        lowest_spo2_percent: 60
        lowest_heart_per_min: 80
        tube_force_n: 2
        time_to_pass_s: 20
        attempts: 2
        co2_confirmed: true
        depth_neutral: true
        oesophagus_in_time: true
        no_severe_desaturation: true
    assistance:
      ghost_path: true
      glottis_highlight: true
      cut_view: false
      force_bar: false
      video_view: false
      expert_loop: false
    distractions:
      - at_s: 10
        kind: question
        text: { en: "How many?", de: "Wie viele?" }
        answers: [Two, { en: Three, de: Drei }]
        right_answer: 2
        time_allowed_s: 8
      - { at_s: 20, kind: alarm, text: Pump, time_allowed_s: 5 }
      - { at_s: 30, kind: talk, text: "Who is free?" }
)";

}  // namespace vallecula::curricula::testing
