#include "gui/import/import_work.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gui/import/given_labels.h"
#include "gui/import/window_message.h"
#include "gui/pages/background.h"
#include "gui/session/words_from_below.h"
#include "pipeline/exchange/label_image.h"
#include "pipeline/exchange/landmark_file.h"
#include "pipeline/mesh/generic_face.h"
#include "pipeline/package/origin.h"
#include "pipeline/quality.h"
#include "pipeline/segment/reslice.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::gui {
namespace {

/// Thrown through a progress report to leave work that nobody waits for any more.
struct Left : std::runtime_error {
  Left() : std::runtime_error("cancelled") {}
};

namespace begin = pipeline::stage_begin;
constexpr double kEnd = 1.0;

constexpr double kMargin = 5.0;  // mm about the patient in a fitted view

SegmentedScan result_of(const pipeline::Import& import, const EditState& edits) {
  const auto& s = import.segmentation();
  SegmentedScan scan;
  scan.labels = std::make_shared<const pipeline::Labels>(import.labels_on_scan());
  const auto box = pipeline::bounds_of(*scan.labels, kMargin);
  const auto& grid = scan.labels->grid;
  scan.bounds = {grid.position(box.low[0] - 0.5, box.low[1] - 0.5, box.low[2] - 0.5),
                 grid.position(box.high[0] + 0.5, box.high[1] + 0.5, box.high[2] + 0.5)};
  const auto to_scan = pipeline::inverse_of(s.pose.scan_to_package);
  for (const auto& [name, at] : s.landmarks)
    if (is_place(name)) scan.landmarks[name] = pipeline::moved(to_scan, at);
  scan.findings = s.findings;
  scan.found.landmarks = s.landmarks;
  scan.found.findings = s.findings;
  scan.found.pose = s.pose;
  scan.scale = s.frame.scale;
  scan.quality = pipeline::segmentation_quality(s);
  scan.from = edits;
  return scan;
}

}  // namespace

ImportWork::ImportWork(QObject* parent) : QObject(parent) {}

ImportWork::~ImportWork() {
  cancelled_ = true;
  if (worker_) worker_->wait();
}

std::shared_ptr<const pipeline::Hounsfield> ImportWork::scan() const {
  if (!import_) return {};
  return {import_, &import_->series().hu};
}

void ImportWork::close() {
  if (!busy()) import_.reset();
}

void ImportWork::cancel() {
  if (busy()) cancelled_ = true;
}

template <class Result>
bool ImportWork::run(double from, double to, std::function<Result()> work, std::function<void(Result)> done,
                     bool lasting, bool of_file) {
  if (busy()) return false;
  cancelled_ = false;
  from_ = from;
  to_ = to;
  clock_.start();
  worker_ = run_in_background<Result>(
      this, std::move(work),
      [this, lasting, done = std::move(done)](Result result) {
        worker_.clear();
        if (cancelled_ && !lasting)
          emit cancelled();
        else
          done(std::move(result));
      },
      [this, of_file](const QString& message) {
        worker_.clear();
        if (cancelled_)
          emit cancelled();
        else if (of_file)
          emit file_failed(window_message(message));
        else
          emit failed(window_message(message));
      });
  return true;
}

void ImportWork::report(const std::string& stage, double fraction) {
  if (cancelled_ && fraction < kEnd) throw Left();  // at the end the package is in its place
  const double from = from_, to = to_;
  const double share = std::clamp((fraction - from) / (to - from), 0.0, 1.0);
  const double left = seconds_left(share, 1e-3 * static_cast<double>(clock_.elapsed()));
  QMetaObject::invokeMethod(
      this,
      [this, text = stage_text(stage), share, left] {
        if (!cancelled_) emit progressed(text, share, left);
      },
      Qt::QueuedConnection);
}

bool ImportWork::list_series(const std::filesystem::path& source) {
  return run<std::vector<SeriesRow>>(
      0.0, 1.0, [this, source] { return series_at(source, [this](double f) { report("list", f); }); },
      [this](const std::vector<SeriesRow>& rows) { emit listed(rows); });
}

bool ImportWork::open(const ImportChoice& choice) {
  if (busy()) return false;
  import_.reset();
  last_ = {};
  positioned_ = {};
  stale_ = false;
  auto import = std::make_shared<pipeline::Import>(options_of(choice),
                                                   [this](const std::string& stage, double f) { report(stage, f); });
  return run<SegmentedScan>(
      begin::kRead, begin::kPosition,
      [this, import] {
        import->read();
        // The scan is shown even when no structure is found: a person then says where the tongue is.
        QMetaObject::invokeMethod(
            this,
            [this, import] {
              if (cancelled_) return;
              import_ = import;
              emit scan_read();
            },
            Qt::QueuedConnection);
        import->segment();
        return result_of(*import, {});
      },
      [this](SegmentedScan scan) {
        last_ = std::move(scan);
        emit segmented(last_);
      });
}

bool ImportWork::segment(const EditState& edits) {
  if (busy() || !import_) return false;
  import_->options().edits = edits.edits();
  stale_ = true;
  return run<SegmentedScan>(
      begin::kSegment, begin::kPosition,
      [import = import_, edits] {
        import->segment();
        return result_of(*import, edits);
      },
      [this](SegmentedScan scan) {
        last_ = std::move(scan);
        stale_ = false;
        emit segmented(last_);
      });
}

bool ImportWork::build(const EditState& edits, const BuildChoice& choice) {
  if (busy() || !import_) return false;
  const bool anew = stale_ || !last_.labels || !choice.same_position(positioned_) ||
                    !edits.same_segmentation(last_.from) || !edits.same_landmarks(last_.from);
  stale_ = true;  // a positioning that failed or was cancelled half way is not to be gone on with
  positioned_ = choice;
  auto& options = import_->options();
  options.edits = edits.edits();
  options.keep_position = choice.keep_position;
  options.to_newborn_size = choice.to_newborn_size;
  options.tetrahedra = choice.tetrahedra;
  return run<SegmentedScan>(
      anew ? begin::kSegment : begin::kPosition, begin::kWrite,
      [import = import_, edits, anew, last = last_]() mutable {
        if (anew) {
          import->segment();
          last = result_of(*import, edits);
        }
        import->mesh();
        import->check();
        return last;
      },
      [this, anew](SegmentedScan scan) {
        last_ = std::move(scan);
        stale_ = import_->options().generic_face;  // put on once: the next build begins with the patient's own face
        if (anew) emit segmented(last_);
        emit built();
      });
}

bool ImportWork::write(const QString& name) {
  if (busy() || !import_) return false;
  import_->options().out = package_of(name);
  return run<QString>(
      begin::kWrite, kEnd, [import = import_] { return QString::fromStdString(import->write().package.string()); },
      [this](const QString& package) { emit written(package); }, true);
}

bool ImportWork::load(const std::filesystem::path& file, const std::string& structure, const EditState& before) {
  if (busy() || !import_) return false;
  const bool landmarks = file.extension() == ".json";
  const QString what = landmarks           ? tr("loading landmarks")
                       : structure.empty() ? tr("loading labels")
                                           : tr("loading %1").arg(in_words(pipeline::words_of(structure)));
  return run<EditState>(
      0.0, 1.0,
      [import = import_, file, structure, before, landmarks] {
        if (landmarks) {
          EditState next = before;
          for (const auto& [name, at] : pipeline::read_landmark_file(file).moved) next.landmarks[name] = at;
          return next;
        }
        std::set<std::uint8_t> wanted;
        for (const auto& label : pipeline::kLabelNames)
          if (label.name == structure) wanted.insert(label.value);
        const auto image = pipeline::read_label_image(file);
        return with_given_labels(before, pipeline::on_grid(image, import->series().hu.grid, file), wanted);
      },
      [this, what](const EditState& next) { emit loaded(what, next); }, false, true);
}

bool ImportWork::save(const std::filesystem::path& file, const EditState& edits) {
  if (busy() || !import_ || !last_.labels) return false;
  return run<QString>(
      0.0, 1.0,
      [scan = last_, generic = import_->options().generic_face, file, edits] {
        // The positioning of a build moves the import's own landmarks; labels and landmarks written here lie as
        // scanned.
        pipeline::write_label_map(generic ? pipeline::without_face(*scan.labels, scan.scale) : *scan.labels, file);
        auto beside = file;
        beside.replace_extension(".mrk.json");
        auto marks = scan.found;
        for (const auto& [name, at] : edits.landmarks)
          if (is_place(name)) marks.landmarks[name] = pipeline::moved(marks.pose.scan_to_package, at);
        pipeline::write_landmark_file(marks, beside);
        return (generic ? tr("%1 and %2; of the skin what lies near other structures, for the face is to be the "
                             "generic one")
                        : tr("%1 and %2"))
            .arg(QString::fromStdString(file.filename().string()), QString::fromStdString(beside.filename().string()));
      },
      [this](const QString& files) { emit saved(files); }, true, true);
}

QString stage_text(const std::string& stage) {
  const std::map<std::string, QString> texts = {
      {"list", QCoreApplication::translate("ImportWork", "Looking at what is there")},
      {"read", QCoreApplication::translate("ImportWork", "Reading the series")},
      {"segment", QCoreApplication::translate("ImportWork", "Finding the structures")},
      {"segment: head", QCoreApplication::translate("ImportWork", "Finding the head")},
      {"segment: airway", QCoreApplication::translate("ImportWork", "Finding the airway")},
      {"segment: bones", QCoreApplication::translate("ImportWork", "Finding skull, jaw, spine and hyoid")},
      {"segment: epiglottis", QCoreApplication::translate("ImportWork", "Finding the epiglottis")},
      {"segment: tongue", QCoreApplication::translate("ImportWork", "Finding the tongue")},
      {"segment: soft palate and larynx",
       QCoreApplication::translate("ImportWork", "Finding soft palate, larynx and oesophagus")},
      {"segment: landmarks", QCoreApplication::translate("ImportWork", "Finding the landmarks")},
      {"position", QCoreApplication::translate("ImportWork", "Bringing the patient into position")},
      {"surfaces", QCoreApplication::translate("ImportWork", "Making the surfaces")},
      {"surfaces: face", QCoreApplication::translate("ImportWork", "Making the surface of face and throat")},
      {"surfaces: airway", QCoreApplication::translate("ImportWork", "Making the surface of the airway")},
      {"surfaces: jaw and palate", QCoreApplication::translate("ImportWork", "Making the surfaces of jaw and palate")},
      {"tetrahedra", QCoreApplication::translate("ImportWork", "Filling tongue and epiglottis with tetrahedra")},
      {"check by playing", QCoreApplication::translate("ImportWork", "Trying an intubation with the scripted expert")},
      {"write", QCoreApplication::translate("ImportWork", "Writing the patient")}};
  const auto found = texts.find(stage);
  return found != texts.end() ? found->second : QString::fromStdString(stage);
}

double seconds_left(double share, double elapsed_s) {
  if (share < 0.03 || elapsed_s < 0.5) return -1.0;
  return elapsed_s * (1.0 - share) / share;
}

QString time_left_text(double seconds, double since_s) {
  if (seconds < 0.0) return {};
  const double left = seconds - since_s;
  if (left < -2.0) return QCoreApplication::translate("ImportWork", "takes longer than expected");
  if (left < 20.0)
    return QCoreApplication::translate("ImportWork", "about %1 s left").arg(std::max(1.0, std::ceil(left)), 0, 'f', 0);
  if (left < 90.0)
    return QCoreApplication::translate("ImportWork", "about %1 s left").arg(5.0 * std::ceil(left / 5.0), 0, 'f', 0);
  return QCoreApplication::translate("ImportWork", "about %1 min left").arg(std::ceil(left / 60.0), 0, 'f', 0);
}

bool is_place(const std::string& landmark) { return landmark != "glottis_normal" && landmark != "operator_eye"; }

}  // namespace vallecula::gui
