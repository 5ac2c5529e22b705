// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/tracking/view_change.h"
#include "core/workflow/trial_sources.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// How each view's first frame shows the scene against the image by which its camera was registered
/// (changeOfView); nullopt where no image was kept or too little of it is seen, where the registration was
/// converted from another size, and after a cancellation. Reads files; any thread.
std::vector<std::optional<ViewChange>> changesSinceRegistration(const std::vector<RegisteredView> &views,
                                                                const CancelToken &cancel);

/// Refuses views that show another scene than their cameras were registered by: zoomed, turned, mirrored, or
/// another part of it. changes: of each view.
Result<void> checkSameScene(const std::string &trialName, const std::vector<RegisteredView> &views,
                            const std::vector<std::optional<ViewChange>> &changes);

/// Counts the shift of a view whose camera was pushed since its registration as an error of the camera's
/// rotation: what is measured by it becomes as uncertain.
FloorView widenedByShift(const FloorView &view, double shiftPx);

/// Notes in a view's series that the scene is shifted against the registration in force.
void noteShift(const RegisteredView &view, double shiftPx, std::vector<ObservationSeries> &series);

/// The shift that a stored series notes against this registration, px; nullopt: none, or another one.
std::optional<double> notedShift(const ObservationSeries &series, RecordId registration);

Message shiftedSentence(const std::string &trialName, const RecordingRecord &view, double shiftPx);

/// Whole sentences on all views whose scene is not where it was, also on those that checkSameScene refuses.
std::vector<Message> sceneWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                   const std::vector<std::optional<ViewChange>> &changes);

} // namespace odo
