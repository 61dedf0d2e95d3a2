// The table of trials for other programs: one row a trial, documented columns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curricula/records/people.h"

namespace vallecula::curricula {

/// A trial to be handed on.
struct ExportTrial {
  RecordRow row;
  std::string trainee_name;  ///< only where names were asked for
};

/// Whose and which trials. Empty fields: any.
struct ExportFilter {
  std::optional<long long> trainee_id;  ///< 0: those that belong to nobody
  std::string curriculum_id;
  std::string since_utc, until_utc;  ///< ISO 8601; finished at or after, and before
  bool names = false;                ///< instructors only
};

/// In the order in which they were recorded, interrupted ones too. An instructor gets everybody's, a trainee the own,
/// nobody signed in those that belong to nobody; whoever asks for more gets NotAllowed. A line in the audit trail says
/// that it was done. Throws RecordsError.
std::vector<ExportTrial> trials_to_export(Records& records, const Who& who, const ExportFilter& filter);

/// RFC 4180, UTF-8, a header line first; a figure that a trial does not have is empty.
std::string trials_csv(const std::vector<ExportTrial>& trials, bool names);
/// Its columns as a Markdown table.
std::string trial_column_table();

}  // namespace vallecula::curricula
