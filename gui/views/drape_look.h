// A cloth from the neck down: what a scan or a manikin has of the body ends there, and an end of flesh is no patient.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "gui/views/patient_look.h"

namespace vallecula::gui {

/// Lies about the neck halfway from the cords to the carina and over all that the face's surface has below, as it lies
/// at rest. Null where the package has no carina or no skin there. Drawn only: nothing touches it.
vtkSmartPointer<vtkActor> drape(const PatientLook& look);

}  // namespace vallecula::gui
