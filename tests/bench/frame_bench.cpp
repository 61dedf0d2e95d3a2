// vallecula_frame_bench NAME.patient [SECONDS]: what the trial's views cost. First the share of late ticks of a trial
// in real time with and without drawing, in turns of three seconds, so that both meet the same trial and the same
// machine; then what comes to the screen of the whole trial page beside such a trial, second by second, with two views
// and with all panels side by side; then every view and all together, by step of the quality governor, over snapshots
// of the scripted expert.
#include <time.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QGridLayout>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "gui/pages/main_window.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/pages/window_application.h"
#include "gui/session/trial_session.h"
#include "gui/session/user_paths.h"
#include "gui/session/virtual_display.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/video_view.h"

namespace {

using namespace vallecula;
using namespace vallecula::gui;

constexpr int kSnapshots = 25, kTurnMs = 3000;
constexpr double kSettlesS = 8.0;  // the governor begins with everything and gives up a step a second

/// Of one frame: until it is on the screen, and what this process computed for it, the driver's thread included. The
/// second is the machine's own, whoever else it works for.
struct Cost {
  double wall_ms = 0.0, cpu_ms = 0.0;
};

double cpu_ms() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

void print(const char* what, const std::vector<Cost>& costs) {
  std::vector<double> wall, cpu;
  for (const Cost& c : costs) {
    wall.push_back(c.wall_ms);
    cpu.push_back(c.cpu_ms);
  }
  std::sort(wall.begin(), wall.end());
  std::sort(cpu.begin(), cpu.end());
  const auto at = [](const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  std::printf("  %-24s p50 %6.1f  p95 %6.1f  p99 %6.1f ms; computing p50 %6.1f  p95 %6.1f ms\n", what, at(wall, 0.5),
              at(wall, 0.95), at(wall, 0.99), at(cpu, 0.5), at(cpu, 0.95));
}

/// The trial page's views in its window of 1280 x 800, with the video picture below the cut.
struct Window {
  QWidget widget;
  OperatorView* eye = new OperatorView(&widget);
  SagittalView* cut = new SagittalView(&widget);
  VideoView* video = new VideoView(&widget);
  int swaps = 0;

  Window(const TrialSession& session, const std::string& patient) {
    auto* grid = new QGridLayout(&widget);
    grid->addWidget(eye, 0, 0, 2, 1);
    grid->addWidget(cut, 0, 1);
    grid->addWidget(video, 1, 1);
    grid->setColumnStretch(0, 17);
    grid->setColumnStretch(1, 10);
    widget.resize(1280, 800);
    const std::shared_ptr<PatientLook> look = make_patient_look(session.package(), {}, Seen::from_the_eye, patient);
    const auto& scene = session.scene();
    const auto* intubation = scene.intubation ? &*scene.intubation : nullptr;
    eye->show_patient(look, scene.tool.surface, intubation);
    cut->show_patient(look, scene.tool.surface, intubation);
    video->show_patient(look, scene.tool.surface, intubation);
    widget.show();
    for (auto* view : {static_cast<GlView*>(eye), static_cast<GlView*>(cut), static_cast<GlView*>(video)})
      QObject::connect(view, &GlView::painted, &widget, [this] { ++swaps; });
    QApplication::processEvents();
  }
  void draw_eye(const engine::Snapshot& s) { eye->update_from(s), eye->draw(); }
  void draw_cut(const engine::Snapshot& s) { cut->update_from(s, 25.0), cut->draw(); }
  void draw_video(const engine::Snapshot& s) { video->update_from(s), video->draw(); }
  Cost frame(const std::function<void()>& draw) {
    QElapsedTimer timer;
    timer.start();
    const int before = swaps;
    const double computed = cpu_ms();
    draw();
    while (swaps == before && timer.elapsed() < 2000) QApplication::processEvents(QEventLoop::AllEvents, 5);
    return {1e-6 * static_cast<double>(timer.nsecsElapsed()), cpu_ms() - computed};
  }
};

TrialSetup setup_of(const std::string& patient, const std::filesystem::path& out, bool realtime) {
  TrialSetup setup;
  setup.patient = patient;
  setup.curriculum = curricula_folder() / "first-intubation.yaml";
  setup.scenario = curricula::load_curriculum(setup.curriculum).scenarios.front().id;
  setup.device = "scripted:expert";
  setup.realtime = realtime;
  setup.out = out;
  return setup;
}

std::vector<engine::Snapshot> snapshots_of(TrialSession& session) {
  std::vector<engine::Snapshot> all;
  double next_s = 0.0;
  session.start();
  while (!session.finished()) {
    const engine::Snapshot& now = session.latest();
    if (now.step >= 0 && now.time_s >= next_s) {
      all.push_back(now);
      next_s = now.time_s + 0.25;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (all.size() > kSnapshots) {  // evenly over the trial
    std::vector<engine::Snapshot> some;
    for (int i = 0; i < kSnapshots; ++i) some.push_back(all[all.size() * static_cast<std::size_t>(i) / kSnapshots]);
    return some;
  }
  return all;
}

void frame_times(Window& window, const std::vector<engine::Snapshot>& snapshots) {
  auto& governor = GlView::governor();
  for (int step = 0; step < static_cast<int>(kQualities.size()); ++step) {
    governor.hold(step);
    std::printf("step %d: %s\n", step,
                governor.reduced().isEmpty() ? "everything" : governor.reduced().toUtf8().constData());
    std::vector<Cost> eye, cut, video, two, all;
    for (const auto& s : snapshots) {
      eye.push_back(window.frame([&] { window.draw_eye(s); }));
      cut.push_back(window.frame([&] { window.draw_cut(s); }));
      video.push_back(window.frame([&] { window.draw_video(s); }));
      two.push_back(window.frame([&] { window.draw_eye(s), window.draw_cut(s); }));
      all.push_back(window.frame([&] { window.draw_eye(s), window.draw_cut(s), window.draw_video(s); }));
    }
    print("operator's view", eye);
    print("mid-sagittal cut", cut);
    print("video laryngoscope", video);
    print("operator's view and cut", two);
    print("all three", all);
  }
}

struct Lateness {
  const char* what;
  int every_ms;  ///< 0: nothing is drawn
  std::int64_t ticks = 0, misses = 0, overruns = 0;
  int frames = 0;
  double seconds = 0.0;
};

void lateness(Window& window, const std::string& patient, const QTemporaryDir& home, double seconds) {
  GlView::governor().set_mode(QualityGovernor::Mode::automatic);
  std::vector<Lateness> kinds{{"nothing drawn", 0}, {"all views every 33 ms", 33}, {"all views every 45 ms", 45}};
  std::size_t turn = 0;
  int number = 0;
  while (kinds.back().seconds < seconds) {
    TrialSession session(setup_of(patient, home.filePath(QString("live%1").arg(++number)).toStdString(), true));
    session.start();
    while (!session.finished() && session.latest().ticks < 200)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    while (!session.finished() && kinds.back().seconds < seconds) {
      Lateness& kind = kinds[turn++ % kinds.size()];
      const engine::Snapshot before = session.latest();
      QElapsedTimer turn_timer;
      turn_timer.start();
      while (turn_timer.elapsed() < kTurnMs && !session.finished()) {
        QElapsedTimer frame;
        frame.start();
        const engine::Snapshot& now = session.latest();
        if (kind.every_ms > 0) {
          window.frame([&] { window.draw_eye(now), window.draw_cut(now), window.draw_video(now); });
          ++kind.frames;
        }
        const qint64 left = (kind.every_ms > 0 ? kind.every_ms : 33) - frame.elapsed();
        if (left > 0) std::this_thread::sleep_for(std::chrono::milliseconds(left));
      }
      const engine::Snapshot& after = session.latest();
      kind.ticks += after.ticks - before.ticks;
      kind.misses += after.deadline_misses - before.deadline_misses;
      kind.overruns += after.overruns - before.overruns;
      kind.seconds += 1e-3 * static_cast<double>(turn_timer.elapsed());
    }
  }
  std::printf("a trial in real time (%s)\n", GlView::governor().reduced().isEmpty()
                                                 ? "nothing reduced at its end"
                                                 : GlView::governor().reduced().toUtf8().constData());
  for (const Lateness& kind : kinds)
    std::printf("  %-24s %8lld ticks  %.3f %% late by 1 ms  %.2f %% steps late  %.1f frames/s\n", kind.what,
                static_cast<long long>(kind.ticks),
                100.0 * static_cast<double>(kind.misses) / static_cast<double>(std::max<std::int64_t>(1, kind.ticks)),
                100.0 * static_cast<double>(kind.overruns) / static_cast<double>(std::max<std::int64_t>(1, kind.ticks)),
                kind.frames / std::max(1e-9, kind.seconds));
}

/// The trial page as a trainee has it, in a window of 1280 x 800: pictures a second, of each whole second.
void page_rates(const std::string& patient, const QTemporaryDir& home, double seconds, bool all_panels) {
  GlView::governor().hold(0);
  GlView::governor().set_mode(QualityGovernor::Mode::automatic);
  TrialSetup setup = setup_of(patient, home.filePath(all_panels ? "page-all" : "page").toStdString(), true);
  setup.scenario = "term-tube";
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  bool ready = false;
  QObject::connect(&window, &MainWindow::prepared, [&] { ready = true; });
  std::string failure;
  QObject::connect(&window, &MainWindow::trial_failed, [&](const QString& why) { failure = why.toStdString(); });
  window.prepare(setup, true);
  while (!ready && failure.empty()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  if (!failure.empty()) throw std::runtime_error(failure);
  TrialPage& page = window.trial_page();
  TrialPanels& panels = page.panels();
  if (all_panels) {
    for (const auto panel : {TrialPanels::video, TrialPanels::team}) panels.dock(panel)->toggleViewAction()->trigger();
    panels.splitDockWidget(panels.dock(TrialPanels::cut), panels.dock(TrialPanels::video), Qt::Horizontal);
  }
  int pictures = 0, views = 0;
  const auto heard = QObject::connect(&page.operator_view(), &GlView::painted, [&] { ++pictures; });
  std::vector<double> rates;
  QElapsedTimer second;
  double settled_s = 0.0;
  while (page.running() && static_cast<double>(rates.size()) < seconds) {
    pictures = 0;
    second.start();
    while (second.elapsed() < 1000) QApplication::processEvents(QEventLoop::AllEvents, 5);
    const double length_s = 1e-9 * static_cast<double>(second.nsecsElapsed());
    settled_s += length_s;
    if (settled_s > kSettlesS) rates.push_back(pictures / length_s);
  }
  for (const GlView* view : page.findChildren<GlView*>()) views += view->visibleRegion().isEmpty() ? 0 : 1;
  QObject::disconnect(heard);
  std::sort(rates.begin(), rates.end());
  if (rates.empty())
    std::printf("the trial page: the trial was over before anything was counted\n");
  else
    std::printf(
        "the trial page, %s (%d views): frames/s least %.1f  p5 %.1f  p50 %.1f over %zu s; step %d at its end\n",
        all_panels ? "all panels side by side" : "as at first", views, rates.front(), rates[rates.size() / 20],
        rates[rates.size() / 2], rates.size(), GlView::governor().step());
  page.close_trial();
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const double seconds = argc > 2 ? std::atof(argv[2]) : 30.0;
  if (argc < 2 || !(seconds >= 3.0 && seconds <= 3600.0)) {
    std::fprintf(stderr,
                 "vallecula_frame_bench NAME.patient [SECONDS]: a patient package, and 3 to 3600 seconds of each "
                 "kind of drawing\n");
    return 2;
  }
  try {
    QTemporaryDir home;  // the bench is nobody's trial
    qputenv("VALLECULA_HOME", home.path().toUtf8());
    VirtualDisplay display(1400, 900);
    WindowApplication application;
    TrialSession session(setup_of(argv[1], home.filePath("still").toStdString(), false));
    Window window(session, argv[1]);
    lateness(window, argv[1], home, seconds);
    for (const bool all_panels : {false, true}) page_rates(argv[1], home, seconds, all_panels);
    frame_times(window, snapshots_of(session));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "vallecula_frame_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
