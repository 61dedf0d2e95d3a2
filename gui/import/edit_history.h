// What a person has said about a segmentation so far, step by step, so that every step can be taken back.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "pipeline/segment/edits.h"

namespace vallecula::gui {

/// The same as pipeline::Edits, cheap to keep many of, and what was found good.
struct EditState {
  std::map<std::string, pipeline::Point> seeds;
  std::map<std::string, std::array<double, 2>> thresholds;
  std::shared_ptr<const pipeline::Labels> labels;
  std::set<std::uint8_t> replaced;
  std::map<std::string, pipeline::Point> landmarks;
  std::set<std::string> accepted;  ///< structures

  pipeline::Edits edits() const;
  /// Would a segmentation with one come out as with the other?
  bool same_segmentation(const EditState& other) const;
  bool same_landmarks(const EditState& other) const { return landmarks == other.landmarks; }
};

class EditHistory : public QObject {
  Q_OBJECT
 public:
  explicit EditHistory(QObject* parent = nullptr);
  const EditState& state() const { return state_; }
  QUndoStack& stack() { return stack_; }
  /// One step; `what` completes "Undo ...".
  void change(const QString& what, EditState next);
  void clear();

  void set_seed(const std::string& structure, const pipeline::Point& at);
  void set_threshold(const std::string& structure, const std::array<double, 2>& hu);
  void set_landmark(const std::string& name, const pipeline::Point& at);
  void set_accepted(const std::string& structure, bool accepted);
  /// Takes back all that was said of a structure.
  void forget(const std::string& structure);

 signals:
  void changed();

 private:
  friend class EditStep;
  void show(const EditState& state);
  EditState state_;
  QUndoStack stack_;
};

}  // namespace vallecula::gui
