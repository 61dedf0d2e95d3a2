#include "pipeline/dicom/series_groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {
namespace {

bool is_stackable(const Picture& p) {
  return p.modality == "CT" && p.has_pixels && !p.localizer && !p.colour && p.fault.empty();
}

bool fits(const Picture& a, const Picture& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(a.row[i] - b.row[i]) > 1e-4 || std::abs(a.column[i] - b.column[i]) > 1e-4) return false;
  }
  for (int i = 0; i < 2; ++i) {
    if (std::abs(a.spacing[i] - b.spacing[i]) > 1e-5 * a.spacing[i]) return false;
  }
  return true;
}

std::string key_of(const Picture& p) {
  return p.series + '|' + p.modality + '|' + std::to_string(p.columns) + '|' + std::to_string(p.rows) + '|' +
         (p.localizer ? 'l' : '-') + (p.colour ? 'c' : '-') + (p.has_pixels ? 'p' : '-');
}

/// Does any place hold two different pictures (not two copies of one file)?
bool clashes(const std::vector<Picture>& pictures) {
  std::vector<std::pair<double, const Picture*>> sorted;
  for (const auto& p : pictures) sorted.emplace_back(place_of(p, pictures.front()), &p);
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const auto& [at, p] = sorted[i];
    const auto& [before, q] = sorted[i - 1];
    if (at - before <= kSamePlaceMm && (p->instance != q->instance || p->frame != q->frame || p->instance.empty()))
      return true;
  }
  return false;
}

/// Repeated scans of one place told apart by the first attribute that does so wholly; else the pictures as they are.
std::vector<std::vector<Picture>> taken_apart(std::vector<Picture> pictures) {
  std::vector<std::vector<Picture>> parts;
  if (!is_stackable(pictures.front()) || !clashes(pictures)) {
    parts.push_back(std::move(pictures));
    return parts;
  }
  for (std::size_t phase = 0; phase < pictures.front().phases.size(); ++phase) {
    std::map<std::string, std::vector<Picture>> by_value;
    for (const auto& p : pictures) by_value[p.phases[phase]].push_back(p);
    const bool good = by_value.size() > 1 && std::none_of(by_value.begin(), by_value.end(), [](const auto& part) {
                        return part.second.size() < 2 || clashes(part.second);
                      });
    if (!good) continue;
    for (auto& [value, part] : by_value) parts.push_back(std::move(part));
    return parts;
  }
  parts.push_back(std::move(pictures));
  return parts;
}

void refuse(SeriesGroup& group, const std::string& reason, const std::string& mend) {
  if (!group.entry.reason.empty()) return;
  group.entry.reason = reason;
  group.mend = mend;
}

/// "what; mend" of a fault split at its first semicolon.
void refuse(SeriesGroup& group, const std::string& fault) {
  const auto semicolon = fault.find("; ");
  if (semicolon == std::string::npos)
    refuse(group, fault, "export the series again");
  else
    refuse(group, fault.substr(0, semicolon), fault.substr(semicolon + 2));
}

void judge(SeriesGroup& group) {
  const Picture& first = group.pictures.front();
  auto& entry = group.entry;
  entry.modality = first.modality;
  entry.kernel = first.kernel;
  entry.size = {first.columns, first.rows, static_cast<int>(group.pictures.size())};
  if (first.modality != "CT") {
    refuse(group, (first.modality == "other" ? "not CT" : first.modality + ", not CT"),
           "name the folder of a CT series, for only its values are Hounsfield units");
    return;
  }
  if (!first.has_pixels) return refuse(group, "no pictures", "name the folder of the CT series itself");
  if (first.colour) return refuse(group, "colour pictures, not CT slices", "export the original CT series");
  if (first.localizer) return refuse(group, "a scout image, not a volume", "name the folder of the CT series itself");
  group.plan = plan_stack(group.pictures);
  const auto& g = group.plan.geometry;
  entry.orientation = orientation_words(g);
  entry.size = {g.size[0], g.size[1], group.slices()};
  entry.spacing = {norm(g.step[0]), norm(g.step[1]), norm(g.step[2])};
  if (group.slices() >= 2 && !group.plan.fault.empty()) return refuse(group, group.plan.fault);
  group.readable = group.plan.fault.empty();
  if (group.slices() < kFewestSlices) {
    return refuse(group, "only " + std::to_string(group.slices()) + (group.slices() == 1 ? " slice" : " slices"),
                  "at least " + std::to_string(kFewestSlices) +
                      " are needed, from the nose to the carina: name the folder of the whole series");
  }
  // The distance of the planes, not the way along a sheared stack.
  const auto normal = cross(g.step[0], g.step[1]);
  const double gap = std::abs(dot(normal, g.step[2])) / norm(normal);
  if (gap > kCoarsestSliceMm + kExactMm) {
    return refuse(group, "too coarse: slices " + millimetres_text(gap) + " apart",
                  "at most " + millimetres_text(kCoarsestSliceMm) + " are of use: export a thinner reconstruction");
  }
  const double in_plane = std::max(entry.spacing[0], entry.spacing[1]);
  if (in_plane > kCoarsestInPlaneMm + kExactMm) {
    return refuse(group, "too coarse: voxels of " + millimetres_text(in_plane) + " in the slices' plane",
                  "at most " + millimetres_text(kCoarsestInPlaneMm) + " are of use: export a finer reconstruction");
  }
}

/// Pictures that claim to be CT and cannot be used stand in the way of the series they belong to; one that does not say
/// where it belongs stands in the way of all, for it may be a slice of any.
void blame(std::vector<SeriesGroup>& groups, const std::vector<Picture>& faulty, const FileList& files) {
  for (const auto& p : faulty) {
    const auto fault = files.name(p.file) + ": " + p.fault;
    SeriesGroup* largest = nullptr;
    for (auto& group : groups) {
      if (group.plan.places.empty() || (!p.series.empty() && group.series != p.series)) continue;
      if (p.series.empty()) {
        group.readable = false;
        group.entry.reason.clear();
        refuse(group, fault);
      }
      if (largest == nullptr || group.slices() > largest->slices()) largest = &group;
    }
    if (largest == nullptr) {
      const bool told = std::any_of(groups.begin(), groups.end(), [&](const SeriesGroup& g) {
        return g.series == p.series && g.plan.places.empty() && g.pictures.front().fault == p.fault;
      });
      if (told) continue;
      SeriesGroup alone;
      alone.series = p.series;
      alone.pictures = {p};
      alone.entry.modality = p.modality;
      alone.entry.size = {p.columns, p.rows, 1};
      refuse(alone, fault);
      groups.push_back(std::move(alone));
    } else if (!p.series.empty() && largest->readable) {
      largest->readable = false;
      largest->entry.reason.clear();
      refuse(*largest, fault);
    }
  }
}

bool is_wanted(const SeriesGroup& group, Purpose purpose) {
  return purpose == Purpose::import ? group.entry.usable : group.readable;
}

SeriesError refusal_of(const SeriesGroup& group) {
  const bool of_file = group.entry.reason.rfind("file ", 0) == 0 || group.entry.reason.rfind("the file", 0) == 0;
  if (!group.readable && group.entry.modality != "CT")
    return SeriesError("series: its modality is " + group.entry.reason + "; " + group.mend);
  return SeriesError((of_file ? "" : "series: ") + group.entry.reason + "; " + group.mend);
}

SeriesError question(const std::vector<const SeriesGroup*>& candidates) {
  constexpr std::size_t kMostTold = 12;
  std::string text = "series: " + std::to_string(candidates.size()) + " CT series could be meant: ";
  for (std::size_t i = 0; i < std::min(candidates.size(), kMostTold); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(candidates[i]->entry.number) + " (" + described(candidates[i]->entry) +
            ")";
  }
  return SeriesError(text + (candidates.size() > kMostTold ? " ..." : "") +
                     "; choose one with --series NUMBER (`vallecula series` lists them)");
}

SeriesGroup* chosen_by_hand(std::vector<SeriesGroup>& groups, const std::string& choice, Purpose purpose) {
  if (choice.find_first_not_of("0123456789") == std::string::npos && choice.size() < 7) {
    const int number = std::stoi(choice);
    if (number < 1 || number > static_cast<int>(groups.size())) {
      throw SeriesError("series: there is no number " + choice + " in this place, it holds " +
                        std::to_string(groups.size()) + "; `vallecula series` lists them");
    }
    return &groups[static_cast<std::size_t>(number - 1)];
  }
  std::vector<SeriesGroup*> same;
  std::vector<const SeriesGroup*> wanted;
  for (auto& group : groups) {
    if (group.series != choice) continue;
    same.push_back(&group);
    if (is_wanted(group, purpose)) wanted.push_back(&group);
  }
  if (same.empty())
    throw SeriesError("series: none of this UID lies in this place; `vallecula series` lists what does");
  if (wanted.size() > 1) throw question(wanted);
  return wanted.empty() ? same.front() : const_cast<SeriesGroup*>(wanted.front());
}

SeriesGroup* only_one_meant(std::vector<SeriesGroup>& groups, Purpose purpose) {
  SeriesGroup* largest = nullptr;
  for (auto& group : groups) {
    if (is_wanted(group, purpose) && (largest == nullptr || group.slices() > largest->slices())) largest = &group;
  }
  if (largest == nullptr) {
    const auto ct = std::find_if(groups.begin(), groups.end(), [](const auto& g) { return g.entry.modality == "CT"; });
    throw refusal_of(ct == groups.end() ? groups.front() : *ct);
  }
  std::vector<const SeriesGroup*> candidates;
  for (const auto& group : groups) {
    if (is_wanted(group, purpose) && group.slices() * 4 > largest->slices()) candidates.push_back(&group);
  }
  if (candidates.size() > 1) throw question(candidates);
  return largest;
}

}  // namespace

std::vector<SeriesGroup> group_pictures(std::vector<Picture> pictures, const FileList& files) {
  std::map<std::string, std::vector<std::vector<Picture>>> by_key;
  std::vector<Picture> faulty;
  for (auto& p : pictures) {
    if (p.modality == "CT" && !p.fault.empty()) {
      faulty.push_back(std::move(p));
      continue;
    }
    auto& stacks = by_key[key_of(p)];
    auto stack = std::find_if(stacks.begin(), stacks.end(),
                              [&](const auto& s) { return !is_stackable(p) || fits(s.front(), p); });
    if (stack == stacks.end()) stack = stacks.emplace(stacks.end());
    stack->push_back(std::move(p));
  }
  std::vector<SeriesGroup> groups;
  for (auto& [key, stacks] : by_key) {
    for (auto& stack : stacks) {
      for (auto& part : taken_apart(std::move(stack))) {
        SeriesGroup group;
        group.series = part.front().series;
        group.pictures = std::move(part);
        judge(group);
        groups.push_back(std::move(group));
      }
    }
  }
  blame(groups, faulty, files);
  for (auto& group : groups) group.entry.usable = group.readable && group.entry.reason.empty();
  std::stable_sort(groups.begin(), groups.end(), [](const SeriesGroup& a, const SeriesGroup& b) {
    if (a.entry.usable != b.entry.usable) return a.entry.usable;
    if (a.readable != b.readable) return a.readable;
    if (a.entry.size[2] != b.entry.size[2]) return a.entry.size[2] > b.entry.size[2];
    return a.pictures.front().file < b.pictures.front().file;
  });
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i].entry.number = static_cast<int>(i + 1);
  return groups;
}

SeriesGroup& choose(std::vector<SeriesGroup>& groups, const std::string& choice, Purpose purpose) {
  auto* group = choice.empty() ? only_one_meant(groups, purpose) : chosen_by_hand(groups, choice, purpose);
  if (!is_wanted(*group, purpose)) throw refusal_of(*group);
  for (const auto& other : groups) {
    if (&other == group || other.entry.modality != "CT") continue;
    const auto count = std::to_string(other.pictures.size());
    const std::string files = other.pictures.size() == 1 ? " picture" : " pictures";
    group->plan.notes.push_back(count +
                                (other.pictures.front().localizer ? files + " of a scout"
                                 : other.series == group->series
                                     ? files + " of another size, direction or phase in the same series"
                                     : files + " of another CT series in the folder") +
                                (other.pictures.size() == 1 ? " was left out" : " were left out"));
  }
  return *group;
}

}  // namespace vallecula::pipeline
