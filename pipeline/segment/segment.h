// From Hounsfield units to labels and landmarks: the structures in the order in which they find each other.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/package/label_map.h"
#include "pipeline/package/patient_package.h"
#include "pipeline/segment/airway.h"
#include "pipeline/segment/bone.h"
#include "pipeline/segment/edits.h"
#include "pipeline/segment/epiglottis.h"

namespace vallecula::pipeline {

struct Segmentation {
  Thresholds thresholds;
  Frame frame;
  Box box;  ///< of the patient in the series' grid; what follows lies on the cropped grid
  Hounsfield hu;
  Labels labels;
  Head head;
  Airway airway;
  Bones bones;
  Epiglottis epiglottis;                   ///< its mask lies on the grid of `throat`
  Box throat;                              ///< of mouth, pharynx and larynx in the cropped grid
  std::map<std::string, Point> landmarks;  ///< all of kLandmarks, mm LPS
  std::map<std::string, Finding> findings;  ///< how each structure and landmark came about
  std::set<std::uint8_t> replaced;          ///< structures given as labels: these, not the grey values, have the borders
  std::map<std::uint8_t, double> bone_hu;   ///< borders of bones that are not at thresholds.bone
  PoseChange pose;                          ///< from the scan's frame to the one all of this lies in
};

/// `progress` gets the structure's name and 0..1. Throws std::runtime_error saying what could not be found or
/// (EditError) which edit cannot be followed.
Segmentation segment(const Hounsfield& hu, const Edits& edits,
                     const std::function<void(const std::string&, double)>& progress = {});

/// The box of mouth, pharynx and larynx in the cropped grid, from airway, jaw and glottis.
Box throat_of(const Segmentation& segmentation);

/// The labels put back onto the series' grid.
Labels on_series_grid(const Segmentation& segmentation, const Grid& series);

}  // namespace vallecula::pipeline
