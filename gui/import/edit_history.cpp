#include "gui/import/edit_history.h"

#include <QUndoCommand>

#include "gui/session/words_from_below.h"
#include "pipeline/package/label_map.h"
#include "pipeline/package/origin.h"

namespace vallecula::gui {

class EditStep : public QUndoCommand {
 public:
  EditStep(EditHistory& history, const QString& what, EditState before, EditState after)
      : QUndoCommand(what), history_(history), before_(std::move(before)), after_(std::move(after)) {}
  void undo() override { history_.show(before_); }
  void redo() override { history_.show(after_); }

 private:
  EditHistory& history_;
  EditState before_, after_;
};

pipeline::Edits EditState::edits() const {
  pipeline::Edits edits;
  edits.seeds = seeds;
  edits.thresholds = thresholds;
  if (labels && !replaced.empty()) {
    edits.labels = *labels;
    edits.replaced = replaced;
  }
  edits.landmarks = landmarks;
  return edits;
}

bool EditState::same_segmentation(const EditState& other) const {
  return seeds == other.seeds && thresholds == other.thresholds && labels == other.labels && replaced == other.replaced;
}

EditHistory::EditHistory(QObject* parent) : QObject(parent) {}

void EditHistory::change(const QString& what, EditState next) {
  stack_.push(new EditStep(*this, what, state_, std::move(next)));  // push() calls redo()
}

void EditHistory::clear() {
  stack_.clear();
  show({});
}

void EditHistory::show(const EditState& state) {
  state_ = state;
  emit changed();
}

void EditHistory::set_seed(const std::string& structure, const pipeline::Point& at) {
  auto next = state_;
  next.seeds[structure] = at;
  next.accepted.erase(structure);
  change(tr("seed of %1").arg(in_words(pipeline::words_of(structure))), next);
}

void EditHistory::set_threshold(const std::string& structure, const std::array<double, 2>& hu) {
  auto next = state_;
  next.thresholds[structure] = hu;
  next.accepted.erase(structure);
  change(tr("threshold of %1").arg(in_words(pipeline::words_of(structure))), next);
}

void EditHistory::set_landmark(const std::string& name, const pipeline::Point& at) {
  auto next = state_;
  next.landmarks[name] = at;
  change(tr("move of %1").arg(in_words(pipeline::words_of(name))), next);
}

void EditHistory::set_accepted(const std::string& structure, bool accepted) {
  auto next = state_;
  accepted ? static_cast<void>(next.accepted.insert(structure)) : static_cast<void>(next.accepted.erase(structure));
  change(QString(accepted ? tr("accepting %1") : tr("doubting %1")).arg(in_words(pipeline::words_of(structure))), next);
}

void EditHistory::forget(const std::string& structure) {
  auto next = state_;
  next.seeds.erase(structure);
  next.thresholds.erase(structure);
  next.landmarks.erase(structure);
  for (const auto& label : pipeline::kLabelNames)
    if (label.name == structure) next.replaced.erase(label.value);
  if (next.same_segmentation(state_) && next.same_landmarks(state_)) return;
  change(tr("dropping the edits of %1").arg(in_words(pipeline::words_of(structure))), next);
}

}  // namespace vallecula::gui
