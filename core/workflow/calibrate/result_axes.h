// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/world_axes.h"
#include "core/project/records.h"

#include <optional>
#include <vector>

namespace odo {

class Project;

/// The way from the axes in which a registration was made to the present ones of its layout; identity where
/// the layout's axes were not changed since (changeLayoutAxes). It follows from the registrations that were
/// carried along, which keep their pixels: exact. nullopt where no camera was carried along. Project's
/// thread; quick.
Result<std::optional<AxesTransform>> presentAxesOf(Project &project, const RegistrationRecord &registration);

/// Puts a result into the present axes of its layout: positions, directions and their covariances; its task
/// becomes the trial's where that is the same course in those axes. Nothing changes where the axes were not
/// changed, or for imported tracks. false, and nothing changed, where the way is not known or the lengths
/// were multiplied: then only another analysis helps. Project's thread.
Result<bool> bringToPresentAxes(Project &project, const TrialRecord &trial, AnalysisRecord &analysis);

/// Whether positions of two results are in the same axes once both are in the present ones of their layouts:
/// they have a layout or a task in common, or one camera was registered via a camera of the other, or both
/// layouts have two markers at the same positions. Imported tracks count as such: nothing is known of them.
Result<bool> haveCommonAxes(Project &project, const AnalysisRecord &one, const AnalysisRecord &other);

/// Whether the registrations of two results are the same ones, but for a change of the axes.
Result<bool> haveSameRegistrations(Project &project, const AnalysisRecord &one, const AnalysisRecord &other);

/// The layout of a result's first registered view; 0: none.
Result<RecordId> layoutOf(Project &project, const AnalysisRecord &analysis);

Task transformed(const Task &task, const AxesTransform &newFromOld);
/// Only turned and moved: its scale must be 1.
Profile transformed(Profile profile, const AxesTransform &newFromOld);

} // namespace odo
