// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/synchronisation/frame_continuity.h"
#include "core/workflow/track/view_tracking.h"

#include <string>
#include <vector>

namespace odo {

/// Tests the frames of each registered view by the motion of its robots (findFrameSteps), and corrects the
/// times of the recordings and of all observations where frames are missing or doubled. Doubled frames are
/// marked as such. What was found is noted in the series (notedSteps), with what the import or an earlier
/// tracking had corrected: there the recording's times are other than the file's. Gives the recordings whose
/// times changed.
std::vector<RecordingRecord> correctFrameTimes(std::vector<RegisteredView> &views,
                                               const std::vector<RobotRecord> &robots,
                                               std::vector<TrackedView> &tracked);

/// What a stored series says of its view's frames; the steps without their times (ClockStep).
std::vector<FrameStep> notedSteps(const ObservationSeries &series);

/// The times of the frames before which a series notes a leap.
std::vector<Nanoseconds> leapTimes(const ObservationSeries &series,
                                   const std::vector<Nanoseconds> &frameTimes);

/// Whole sentences on the steps of one view. view: with the times as corrected.
std::vector<Message> stepSentences(const std::string &trialName, const RecordingRecord &view,
                                   const std::vector<FrameStep> &steps);

/// Those of all views.
std::vector<Message> frameStepWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                       const std::vector<TrackedView> &tracked);

} // namespace odo
