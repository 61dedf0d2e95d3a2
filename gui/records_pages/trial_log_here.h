// The log of a trial that the records name, where it is on this computer.
#pragma once

#include "curricula/records/records.h"
#include "curricula/trial_log.h"

namespace vallecula::gui {

/// Throws std::runtime_error with one message when it is on another station, was moved, or when a later trial took its
/// place; read_trial_log's errors too. Not for the window's thread.
curricula::TrialLog read_log_here(const curricula::RecordRow& row);

}  // namespace vallecula::gui
