// Labels as surfaces to look at while they are being checked: quick and coarse, not the package's own.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <map>

#include "pipeline/volume.h"

namespace vallecula::gui {

/// By label value, mm in the labels' frame; kSkin is the outside of all labels together. A label without voxels has
/// none. Some seconds of work for a large scan: not for the window's thread. `go_on` is asked between structures; false
/// ends early with what there is.
std::map<std::uint8_t, vtkSmartPointer<vtkPolyData>> label_surfaces(const pipeline::Labels& labels,
                                                                    const std::function<bool()>& go_on = {});

}  // namespace vallecula::gui
