// `vallecula demo`: the whole main job without a person, from CT to score, in a window of its own.
#include <unistd.h>

#include <QHBoxLayout>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "curricula/trial_log.h"
#include "gui/commands/commands.h"
#include "gui/commands/interruption.h"
#include "gui/commands/number_options.h"
#include "gui/commands/score_table.h"
#include "gui/pages/key_moments.h"
#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/window_application.h"
#include "gui/report/report.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/files.h"
#include "gui/session/user_paths.h"
#include "gui/session/virtual_display.h"
#include "gui/views/operator_view.h"
#include "gui/views/patient_look.h"
#include "gui/views/sagittal_view.h"
#include "pipeline/manikin/manikin.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

struct DemoOptions {
  std::string out;
  double weight_kg = 0.0;  ///< 0: the scenario's own
  long long seed = -1;     ///< -1: the scenario's own
  bool json = false;
};

/// The results appear under their name only when they are whole.
class WholeFolder {
 public:
  explicit WholeFolder(const fs::path& wanted) : final_(fs::absolute(wanted).lexically_normal()) {
    if (final_.filename().empty()) final_ = final_.parent_path();  // "results/"
    std::error_code error;
    if (fs::exists(final_) && !fs::is_directory(final_))
      throw std::runtime_error(final_.string() + ": is a file; name a folder for the results");
    if (fs::exists(final_) && !fs::is_empty(final_) && !fs::exists(final_ / "trial.vtrial"))
      throw std::runtime_error(final_.string() +
                               ": is not empty and holds no earlier demo; name another folder, or empty it");
    for (fs::path folder = final_.parent_path(); !folder.empty() && !fs::exists(folder); folder = folder.parent_path())
      created_.push_back(folder);
    aside_ = final_.string() + ".part-" + std::to_string(getpid());
    fs::create_directories(aside_, error);
    if (error) {
      forget();
      throw std::runtime_error(final_.string() + ": cannot be written (" + error.message() +
                               "); name a folder you may write to with --out");
    }
  }
  ~WholeFolder() {
    if (!published_) forget();
  }
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  const fs::path& path() const { return aside_; }
  const fs::path& final_path() const { return final_; }
  void publish() {
    const fs::path old = final_.string() + ".old-" + std::to_string(getpid());
    std::error_code ignored;
    const bool replaces = fs::exists(final_);
    if (replaces) fs::rename(final_, old);
    try {
      fs::rename(aside_, final_);
    } catch (...) {
      if (replaces) fs::rename(old, final_, ignored);
      throw;
    }
    published_ = true;
    fs::remove_all(old, ignored);
  }

 private:
  void forget() {
    std::error_code ignored;
    fs::remove_all(aside_, ignored);
    for (const fs::path& folder : created_) fs::remove(folder, ignored);  // only what was made here, and is empty
  }
  fs::path final_, aside_;
  std::vector<fs::path> created_;
  bool published_ = false;
};

/// Numbered stages on stderr: what is done, and how long it took.
void say(const std::string& line) { std::fprintf(stderr, "demo: %s\n", line.c_str()); }

const curricula::Scenario& scenario_for(const curricula::Curriculum& curriculum, double weight_kg) {
  if (curriculum.scenarios.empty()) throw std::runtime_error(curriculum.file.string() + ": holds no scenario");
  if (weight_kg <= 0.0) return curriculum.scenarios.front();
  // Blade and limits must suit the infant: the scenario of the nearest weight.
  return *std::min_element(
      curriculum.scenarios.begin(), curriculum.scenarios.end(), [weight_kg](const auto& a, const auto& b) {
        return std::abs(a.manikin.weight_kg - weight_kg) < std::abs(b.manikin.weight_kg - weight_kg);
      });
}

struct Pictures {
  std::map<std::string, QImage> by_name;  ///< file name -> picture
  void take(OperatorView& operator_view, SagittalView& sagittal_view, const std::string& moment,
            const engine::Snapshot& snapshot, double sight_percent) {
    sagittal_view.update_from(snapshot, sight_percent);
    by_name["operator-" + moment + ".png"] = operator_view.picture();
    by_name["sagittal-" + moment + ".png"] = sagittal_view.picture();
  }
  void write(const fs::path& folder) const {
    for (const auto& [name, picture] : by_name)
      if (!picture.save(QString::fromStdString((folder / name).string()), "PNG"))
        throw std::runtime_error((folder / name).string() + ": cannot be written; is the disk full?");
  }
};

struct Done {
  TrialOutcome outcome;
  curricula::Scenario scenario;
  double frames_per_second = 0.0;
};

/// The scripted expert in real time, with the window drawn: in a scenario with a tube both of its hands.
Done play_expert(WindowApplication& application, MainWindow& window, const TrialSetup& setup) {
  Done done;
  Pictures pictures;
  std::unique_ptr<KeyMoments> moments;
  std::string failure;
  bool finished = false;
  QImage whole_window;
  TrialPage& page = window.trial_page();
  QObject::connect(&window, &MainWindow::trial_failed, [&](const QString& message) {
    failure = message.toStdString();
    application.qt().quit();
  });
  QObject::connect(&window, &MainWindow::trial_finished, [&](const TrialOutcome& outcome) {
    done.outcome = outcome;
    finished = true;
    application.qt().quit();
  });
  page.set_frame_hook([&](const engine::Snapshot& snapshot) {
    done.frames_per_second = page.frames_per_second();
    for (const std::string& moment : moments->at(snapshot)) {
      say("  at " + std::to_string(snapshot.time_s).substr(0, 4) + " s: " + moment.substr(2));
      pictures.take(page.operator_view(), page.sagittal_view(), moment, snapshot, done.scenario.sight_percent);
      if (moment == "5-best-sight" || moment == "7-between-cords") whole_window = window.grab().toImage();
    }
  });
  QObject::connect(&window, &MainWindow::prepared, [&] {
    done.scenario = page.scenario();
    moments = std::make_unique<KeyMoments>(page.patient(), done.scenario.sight_percent);
  });
  QTimer watch;
  QObject::connect(&watch, &QTimer::timeout, [&] {
    if (interrupted()) application.qt().quit();
  });
  watch.start(100);
  window.show();
  window.prepare(setup, true);
  application.qt().exec();
  page.set_frame_hook({});
  stop_when_interrupted("the demo");
  if (!failure.empty()) throw std::runtime_error(failure);
  if (!finished) throw std::runtime_error("the window was closed before the demo ended; nothing was written");
  pictures.write(setup.out);
  if (!whole_window.isNull()) whole_window.save(QString::fromStdString((setup.out / "window.png").string()));
  application.qt().processEvents();
  window.grab().save(QString::fromStdString((setup.out / "result.png").string()));
  // Once more, now that the pictures are there to be shown.
  write_report(setup.out, curricula::read_trial_log(done.outcome.log), done.scenario, done.outcome.score);
  return done;
}

/// The scripted novice at laryngoscopy, as fast as it goes, nothing drawn but a picture where it went wrong.
TrialOutcome run_novice(WindowApplication& application, const TrialSetup& setup) {
  TrialSession session(setup);
  const curricula::Scenario scenario = session.scenario();
  QWidget darkroom;
  QHBoxLayout row(&darkroom);
  OperatorView operator_view(&darkroom);
  SagittalView sagittal_view(&darkroom);
  row.addWidget(&operator_view, 17);
  row.addWidget(&sagittal_view, 10);
  darkroom.resize(1280, 640);
  const std::shared_ptr<PatientLook> look = make_patient_look(session.package());
  operator_view.show_patient(look, session.scene().tool.surface);
  sagittal_view.show_patient(look, session.scene().tool.surface);
  operator_view.set_zoom(OperatorView::Zoom::mouth);
  darkroom.show();
  Pictures pictures;
  double gum_n = scenario.pass.peak_gum_force_n;
  bool limited = false;
  session.start();
  while (!session.finished() && !interrupted()) {
    application.qt().processEvents(QEventLoop::AllEvents, 20);
    const engine::Snapshot& now = session.latest();
    const double on_gum_n = now.loads[static_cast<std::size_t>(engine::Structure::gum)].force_n.norm();
    operator_view.update_from(now);
    if (!limited && now.state == engine::HapticState::limited) {
      limited = true;
      pictures.take(operator_view, sagittal_view, "1-device-limit", now, scenario.sight_percent);
    } else if (on_gum_n > 1.3 * gum_n) {
      gum_n = on_gum_n;
      pictures.take(operator_view, sagittal_view, "2-levering-on-the-gum", now, scenario.sight_percent);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  stop_when_interrupted("the demo");
  TrialOutcome outcome = session.finish("finished");
  pictures.write(setup.out);
  write_report(setup.out, curricula::read_trial_log(outcome.log), scenario, outcome.score);
  return outcome;
}

std::string score_line(const curricula::Score& score) {
  char line[240];
  std::snprintf(line, sizeof line, "%s: tongue %.2f N, gum %.2f N, glottis %.0f %%, attempt %.1f s",
                score.passed ? "passed" : "not passed", score.peak_tongue_force_n, score.peak_gum_force_n,
                score.glottis_visible_max_percent, score.attempt_time_s);
  return score.intubation ? curricula::outcome_in_words(*score.intubation) + "; " + line : std::string(line);
}

int run_demo(const DemoOptions& options) {
  watch_for_interruption();
  WholeFolder folder(options.out.empty() ? user_data_folder() / "demo" : fs::path(options.out));
  say("results will be in " + folder.final_path().string());
  const fs::path intubations = curricula_folder() / "first-intubation.yaml", laryngoscopies = default_curriculum();
  const curricula::Curriculum curriculum = curricula::load_curriculum(intubations),
                              first_steps = curricula::load_curriculum(laryngoscopies);
  const curricula::Scenario& scenario = scenario_for(curriculum, options.weight_kg);
  curricula::ManikinSpec manikin = scenario.manikin;
  if (options.weight_kg > 0.0) manikin.weight_kg = options.weight_kg;
  if (options.seed >= 0) manikin.seed = static_cast<unsigned>(options.seed);

  std::unique_ptr<VirtualDisplay> display;  // before anything takes long: what is missing is said at once
  if (const std::string problem = display_problem(); !problem.empty()) {
    display = std::make_unique<VirtualDisplay>();
    say(problem + "; drawing on a virtual one (" + display->name() + ")");
  }
  WindowApplication application;

  char infant[80];
  std::snprintf(infant, sizeof infant, "manikin of %.2f kg, seed %u", manikin.weight_kg, manikin.seed);
  say(std::string("1 of 4  ") + infant + ": CT series and import");
  std::string stage;
  const fs::path patient =
      make_manikin_patient(manikin, folder.path(), [&stage](const std::string& now, double fraction) {
        stop_when_interrupted("the demo");
        if (now == stage) return;
        stage = now;
        std::fprintf(stderr, "demo:   %3.0f %%  %s\n", 100.0 * fraction, now.c_str());
      });

  TrialSetup setup;
  setup.patient = patient;
  setup.curriculum = intubations;
  setup.scenario = scenario.id;
  setup.device = "scripted:expert";
  setup.out = folder.path();
  setup.final_out = folder.final_path();
  say("2 of 4  scripted expert with blade and tube, \"" + scenario.title + "\", in real time at 1 kHz");
  Done expert;
  {
    MainWindow window;
    expert = play_expert(application, window, setup);
  }
  say("  " + score_line(expert.outcome.score));
  char pace[160];
  std::snprintf(pace, sizeof pace, "  loop %.1f Hz, %lld of %lld ticks late, %lld steps dropped, %.0f frames/s",
                expert.outcome.score.loop_rate_hz, expert.outcome.score.deadline_misses, expert.outcome.score.ticks,
                expert.outcome.score.overruns, expert.frames_per_second);
  say(pace);
  say("  " + expert.outcome.score.real_time_setup);

  say("3 of 4  scripted novice at laryngoscopy, without a window");
  const curricula::Scenario& novice_scenario = scenario_for(first_steps, manikin.weight_kg);
  setup.curriculum = laryngoscopies;
  setup.scenario = novice_scenario.id;
  setup.device = "scripted:novice";
  setup.out = folder.path() / "novice";
  setup.final_out = folder.final_path() / "novice";
  setup.realtime = false;
  const TrialOutcome novice = run_novice(application, setup);
  say("  " + score_line(novice.score));

  say("4 of 4  putting the results in place");
  const std::string expert_json = read_file(expert.outcome.score_json), novice_json = read_file(novice.score_json);
  folder.publish();
  if (options.json) {
    std::cout << "{\"results\": \"" << folder.final_path().string() << "\",\n\"expert\": " << expert_json
              << ",\n\"novice\": " << novice_json << "}\n";
    return 0;
  }
  std::cout << "scripted expert\n";
  print_score(std::cout, expert.outcome.score, expert.scenario);
  std::cout << "\nscripted novice\n";
  print_score(std::cout, novice.score, novice_scenario);
  std::cout << "\nresults: " << folder.final_path().string()
            << "\n  report.html, score.json, force.png, operator-*.png, sagittal-*.png, trial.vtrial; "
            << "novice/ with its own; manikin.patient\n";
  return 0;
}

}  // namespace

void add_demo_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "demo",
      "The whole main job without a person: manikin, CT, import, an intubation by a scripted expert, a scripted "
      "novice, scores");
  auto options = std::make_shared<DemoOptions>();
  command->add_option("--out", options->out, "Folder for the results (the user's data folder if left out)");
  command->add_option("--weight", options->weight_kg, "Weight of the infant, kg (the scenario's if left out)")
      ->check(number_within(pipeline::kLightest, pipeline::kHeaviest));
  command->add_option("--seed", options->seed, "Which infant of that weight (the scenario's if left out)")
      ->check(whole_number_within(0, kLargestSeed));
  command->add_flag("--json", options->json, "Print both scores as JSON");
  command->callback([options, &exit_code] { exit_code = run_demo(*options); });
}

}  // namespace vallecula::gui
