// What is kept of a person: handed out whole, and deleted whole.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "curricula/records/people.h"

namespace vallecula::curricula {

/// Everything kept of a person, in a new folder: records.json (the person without the PIN, every column of their
/// trials with their figures, notes and ratings on them or by them, the audit trail's lines about them) and trials/ID/ with the files of each trial
/// that are on this station and still that trial's; what is not there is said in records.json. By the person themself
/// or an instructor. Written aside and renamed; throws RecordsError (NotAllowed; the folder exists; the disk is full,
/// then nothing is left).
void export_person(Records& records, const SignedIn& who, long long person_id, const std::filesystem::path& folder);

struct Deletion {
  int trials = 0, notes = 0, files = 0;
  std::vector<std::string> left;  ///< what could not be deleted now and is tried again at every start, and why
};
/// Deletes a person with trials, notes, ratings and the trials' files, rows first, all or none. By the person themself or an
/// instructor; not the last instructor while there are other people. The audit trail keeps that the number was deleted,
/// and by which number. Files on other stations are deleted when those start (delete_pending_files). Throws
/// RecordsError.
Deletion delete_person(Records& records, const SignedIn& who, long long person_id);

/// Deletes what is still to be deleted on this station: files of people deleted at another, or by a program that was
/// cut off. A log that a later trial in the same folder has replaced is not touched. To be called when a program
/// starts.
Deletion delete_pending_files(Records& records);

}  // namespace vallecula::curricula
