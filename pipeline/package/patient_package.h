// The patient package: what import hands to the trainer. Plain numbers, millimetres, DICOM LPS.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "pipeline/package/origin.h"
#include "pipeline/volume.h"

namespace vallecula::pipeline {

using Point = std::array<double, 3>;

/// What a face.vtp triangle is: decides its colour, its friction with the blade and whose load a contact is.
enum class Tissue : std::uint8_t { skin = 0, lip = 1, gum = 2, palate = 3, mucosa = 4, larynx = 5 };

struct Surface {
  std::vector<Point> points;                  ///< mm, LPS
  std::vector<std::array<int, 3>> triangles;  ///< outward orientation
  std::vector<std::uint8_t> tissue;           ///< per triangle (Tissue), for "face"; empty elsewhere
};

/// To what a node of the tongue mesh is fastened.
enum class Anchor : std::uint8_t { free = 0, mandible = 1, hyoid = 2, larynx = 3 };

/// Where a node of the tongue mesh lies: what a blade can touch is `free`.
enum class Contact : std::uint8_t { inside = 0, free = 1, tissue = 2 };

struct TetMesh {
  std::vector<Point> points;             ///< mm, LPS, rest
  std::vector<std::array<int, 4>> tets;  ///< positively oriented: (b-a)x(c-a).(d-a) > 0
  std::vector<std::uint8_t> tissue;      ///< per tet: 0 tongue, 1 epiglottis
  std::vector<std::uint8_t> anchor;      ///< per node (Anchor)
  std::vector<std::uint8_t> contact;     ///< per node (Contact); empty in packages of before it was written
};

struct Material {
  double young_pa = 0.0;
  double poisson = 0.0;
  double density_kg_m3 = 0.0;
};

struct QualityItem {
  std::string name;  ///< "tongue volume"
  std::optional<double> value;  ///< none: what it says is in the note
  std::string unit;
  bool ok = true;  ///< false: to be looked at
  std::string note;
  bool judged = true;  ///< false: a figure without a limit to hold it against; `ok` says nothing
};

/// The head's extension on the neck that every import is brought into and the built-in patient has, degrees (a neck up
/// to 8 short of it is left as it is).
constexpr double kHeadExtendedDeg = 25.0;

/// How the scripted expert goes about this patient, from its plan: mm (term) along the line of sight and along the
/// lift. Found by playing (the last check of an import).
struct Approach {
  double along_mm = 0.0;  ///< of the tip in the vallecula; positive towards the eye
  double lift_mm = 0.0;   ///< of the tip before and during the lift
};

struct PatientPackage {
  int schema = 1;
  std::string name;                               ///< of the folder; never from the source's identity
  std::map<std::string, std::string> provenance;  ///< modality, voxel size, software version; no identity
  std::map<std::string, Point> landmarks;         ///< mm, LPS; see kLandmarks. "glottis_normal" is a unit vector
  std::map<std::string, Finding> findings;        ///< of every structure (kLabelNames) and landmark
  PoseChange pose;                                ///< labels.nrrd lies in the scan's frame, all else in the package's
  std::map<std::string, Material> materials;      ///< "tongue", "epiglottis"
  Approach approach;
  std::map<std::string, Surface> surfaces;  ///< "face", "airway", "mandible", "palate", "glottis" ...
  TetMesh tongue;
  std::vector<QualityItem> quality;
};

/// Landmarks a package must carry.
constexpr std::array<const char*, 10> kLandmarks = {"upper_gum_midline", "lower_gum_midline",
                                                    "vallecula",         "glottis_centre",
                                                    "glottis_normal",    "carina",
                                                    "operator_eye",      "hyoid",
                                                    "epiglottis_tip",    "condyle_axis"};

/// Surfaces a package must carry.
constexpr std::array<const char*, 5> kSurfaces = {"face", "airway", "mandible", "palate", "glottis"};

/// Names the file and what is wrong with it, and how to mend it.
class PackageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes DIR aside and puts it in its place when whole, in one step: a process killed at any moment leaves the package
/// that was there, the new one or none, and what it left aside goes with the next write. The thumbnail is drawn from
/// the labels, which lie on the scan's grid. A package already at DIR is replaced; anything else there is left alone.
/// Throws PackageError.
void write_package(const PatientPackage& package, const Labels& labels, const std::filesystem::path& dir);
/// Reads and checks (schema, landmarks, materials, sha256 of every file and of patient.yaml itself, meshes). Throws
/// PackageError.
PatientPackage read_package(const std::filesystem::path& dir);

}  // namespace vallecula::pipeline
