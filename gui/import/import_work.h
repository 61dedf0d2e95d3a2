// The import's stages on a thread of their own, one job at a time, with how long it still takes.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QThread>
#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gui/import/edit_history.h"
#include "gui/import/import_choice.h"
#include "gui/import/series_rows.h"
#include "pipeline/import.h"

namespace vallecula::gui {

/// What a segmentation came to, in the scan's frame.
struct SegmentedScan {
  std::shared_ptr<const pipeline::Labels> labels;
  std::array<pipeline::Point, 2> bounds{};  ///< of everything labelled, with a margin: two corners, mm
  std::map<std::string, pipeline::Point> landmarks;
  pipeline::PatientPackage found;  ///< its landmarks, findings and pose alone, before a virtual opening: in its own frame
  double scale = 1.0;              ///< of the head, as pipeline::without_face takes it
  std::map<std::string, pipeline::Finding> findings;
  std::vector<pipeline::QualityItem> quality;  ///< of the segmentation alone
  EditState from;                              ///< the edits it was made with
};

class ImportWork : public QObject {
  Q_OBJECT
 public:
  explicit ImportWork(QObject* parent = nullptr);
  /// Cancels and waits.
  ~ImportWork() override;

  bool busy() const { return worker_ != nullptr; }
  /// Jobs; each ends with one of the signals of its line, or failed(), or cancelled(). Refused (false) while busy.
  bool list_series(const std::filesystem::path& source);  ///< listed()
  bool open(const ImportChoice& choice);                  ///< scan_read(), then segmented()
  bool segment(const EditState& edits);                   ///< segmented()
  /// built(); segments again when the edits are new, or the patient is to be positioned otherwise.
  bool build(const EditState& edits, const BuildChoice& choice);
  bool write(const QString& name);  ///< written(); `name` as problem_with_name takes it
  /// Takes from a label map one structure by name, or (empty) all that are in it; from a .mrk.json the landmarks that
  /// were moved: loaded() with `before` and that.
  bool load(const std::filesystem::path& file, const std::string& structure, const EditState& before);
  /// Labels as FILE.nrrd and landmarks (those moved in `edits` too) as FILE.mrk.json beside it, in the scan's frame:
  /// saved().
  bool save(const std::filesystem::path& file, const EditState& edits);
  /// Leaves the job at its next report of progress. Nothing is on the disk before write(), and that is whole or not.
  void cancel();

  /// Null before scan_read(). Not to be touched while busy() but for series().
  const pipeline::Import* import() const { return import_.get(); }
  /// Lives as long as anybody holds it.
  std::shared_ptr<const pipeline::Hounsfield> scan() const;
  /// Lets go of the import (as cancelled and left).
  void close();

 signals:
  /// `seconds_left` below 0: not known yet.
  void progressed(const QString& stage, double share, double seconds_left);
  void listed(const std::vector<vallecula::gui::SeriesRow>& rows);
  void scan_read();
  void segmented(const vallecula::gui::SegmentedScan& scan);
  void built();
  void written(const QString& package);
  void failed(const QString& message);
  void file_failed(const QString& message);  ///< load() and save()
  void cancelled();
  void loaded(const QString& what, const vallecula::gui::EditState& edits);
  void saved(const QString& files);

 private:
  /// `lasting`: what is done is done, even if it was cancelled after its last report of progress.
  template <class Result>
  bool run(double from, double to, std::function<Result()> work, std::function<void(Result)> done, bool lasting = false,
           bool of_file = false);
  void report(const std::string& stage, double fraction);
  std::shared_ptr<pipeline::Import> import_;
  SegmentedScan last_;
  BuildChoice positioned_;  ///< how the last build did it
  bool stale_ = false;  ///< the import's segmentation may not be last_: begun anew, half positioned, another face in it
  QPointer<QThread> worker_;
  std::atomic<bool> cancelled_{false};
  std::atomic<double> from_{0.0}, to_{1.0};  ///< the job's part of the whole import
  QElapsedTimer clock_;
};

/// For a person: "Finding the airway" for "segment: airway".
QString stage_text(const std::string& stage);
/// "about 12 s left", "about 2 min left"; empty below 0. `since_s`: the seconds since that was reckoned; when they are
/// over and it is not done, it says so.
QString time_left_text(double seconds, double since_s = 0.0);
/// What is left of a job, from the share done and the time it took; below 0 while too little is done to tell.
double seconds_left(double share, double elapsed_s);

/// Landmarks that are places a person can look at (glottis_normal is a direction, the operator's eye stands outside).
bool is_place(const std::string& landmark);

}  // namespace vallecula::gui
