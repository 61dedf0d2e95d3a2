// Landmarks as a 3D Slicer markups file (.mrk.json), in the scan's frame so that they lie on the CT.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Says which file, what is wrong with it and how to mend it.
class LandmarkFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One fiducial list in LPS mm, a point a landmark; "glottis_normal" is the point 10 mm from glottis_centre along it.
/// Each point's description says how it came about and where it was found, by which moved ones are told later. Points
/// of the package's frame are taken back to the scan's by the inverse of `pose.scan_to_package`; what was moved beyond
/// that (a mouth opened, a neck extended) is said in the descriptions. Throws LandmarkFileError.
void write_landmark_file(const PatientPackage& package, const std::filesystem::path& file);

struct GivenLandmarks {
  std::map<std::string, Point> moved;  ///< mm LPS in the file's frame; "glottis_normal" is a unit vector
  int unmoved = 0;                     ///< still where this program put them
  int left_out = 0;                    ///< points with none of our names
};

/// LPS or RAS. A point that was written by write_landmark_file and not moved since is no edit. Throws
/// LandmarkFileError, also when no point has a name of kLandmarks.
GivenLandmarks read_landmark_file(const std::filesystem::path& file);

}  // namespace vallecula::pipeline
