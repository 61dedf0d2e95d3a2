// The three cuts of a scan as a radiologist hangs them: the patient's right is on the left of axial and coronal
// pictures; a sagittal one looks to the left.
#pragma once

namespace vallecula::gui {

enum class SlicePlane { axial, coronal, sagittal };

/// Which LPS axes (0 x to the left, 1 y to the back, 2 z to the head) a picture shows, and what stands at its edges.
struct SliceAxes {
  const char* name;
  int across, down, through;
  double down_sign;  ///< +1: the axis `down` rises downwards on the screen; -1: upwards
  const char *left, *right, *top, *bottom;
};

constexpr SliceAxes axes_of(SlicePlane plane) {
  switch (plane) {
    case SlicePlane::axial:
      return {"Axial", 0, 1, 2, 1.0, "R", "L", "A", "P"};
    case SlicePlane::coronal:
      return {"Coronal", 0, 2, 1, -1.0, "R", "L", "H", "F"};
    default:
      return {"Sagittal", 1, 2, 0, -1.0, "A", "P", "H", "F"};
  }
}

}  // namespace vallecula::gui
