// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/trajectory/occlusions.h"
#include "core/workflow/track/view_tracking.h"

#include <vector>

namespace odo {

class Project;

/// When which views of a trial did not measure the whole of a robot (findOcclusions): a list for each
/// analysis, with the registrations that it was made with. They follow from what is stored. None for imported
/// tracks. Project's thread.
Result<std::vector<std::vector<Occlusion>>> trialOcclusions(Project &project, RecordId trial,
                                                            const std::vector<AnalysisRecord> &analyses);

/// A robot of a trial as it is stored. observations: one list a view.
struct StoredRobot
{
    AnalysisRecord analysis;
    std::vector<std::vector<Observation>> observations;
};
/// Those of a trial that were analysed, but for some. Project's thread.
Result<std::vector<StoredRobot>> otherRobots(Project &project, RecordId trial,
                                             const std::vector<RegisteredView> &views,
                                             const std::vector<RobotRecord> &but);

/// The same of robots that were tracked and analysed, and not stored yet, among others that are. robots:
/// their analyses, in the order of the views' series. Pure.
std::vector<std::vector<Occlusion>> trackedOcclusions(const std::vector<RegisteredView> &views,
                                                      const std::vector<TrackedView> &tracked,
                                                      const std::vector<const AnalysisRecord *> &robots,
                                                      const std::vector<StoredRobot> &others = {});

/// Removes spikes that only the tracker's low score made while another robot hid this one or touched it in
/// the frame: passing robots widen σ and are no spikes. The samples stay flagged. Pure.
void removeSpikesOfPassing(const std::vector<Occlusion> &occlusions, std::vector<Spike> &spikes);

} // namespace odo
