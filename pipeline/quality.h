// What a clinician should look at before a package is used, and the materials it starts with.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/package/patient_package.h"
#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// Tongue: E 6 kPa, nu 0.45, 1040 kg/m3 (CLINICAL: shear modulus 2.67 kPa in vivo gives 8 kPa, published values down to
/// 1). Epiglottis: 90 kPa, which makes a leaf of one layer of linear tetrahedra bend like cartilage of 1 MPa.
std::map<std::string, Material> default_materials();

/// What a segmentation can be judged by before there is a mesh: sizes, volumes, the mouth, the glottis.
std::vector<QualityItem> segmentation_quality(const Segmentation& s);

/// Volumes, mesh quality, watertightness, the size found, and finding_items() of the package.
std::vector<QualityItem> quality_report(const Segmentation& s, const PatientPackage& package,
                                        const std::vector<std::string>& notes);

/// Structures and landmarks that were not seen: one item for all that came about by the same rule.
std::vector<QualityItem> finding_items(const std::map<std::string, Finding>& findings);

struct QualityGroup {
  std::string title;
  std::vector<QualityItem> items;
};
/// In the order in which a person reads them: to be checked first, within limits, for information; no empty group.
std::vector<QualityGroup> in_groups(const std::vector<QualityItem>& items);
/// "2.24 ml" (three digits), "16490 triangles"; empty for an item without a figure.
std::string value_text(const QualityItem& item);

}  // namespace vallecula::pipeline
