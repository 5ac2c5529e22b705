// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/synchronisation/clock_repair.h"
#include "core/workflow/track/view_tracking.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// Whole sentences on an analysis whose results were changed since, that gave some, but not of all of the
/// task (never of an imported track), whose views see different things, or whose robot may be confused with
/// another of its look. From stored data, available at any time.
std::vector<Message> analysisWarnings(const AnalysisRecord &analysis, const std::string &trialName);

/// That what is stored is not what the analysis gave. Without subject.
Message changedResults();

/// "in 40 of 200 frames the views contradict each other: …", or show it far apart, with what to do. Empty
/// where they agree, but for some moments. Where it is known why they contradict each other, that is said.
/// views: names of the views that were measured with.
Message viewsApartSentence(const Profile &profile, const std::vector<std::string> &views);

/// What was wrong with a view's time stamps, and was repaired: a predicate.
Message clockStepSentence(const ClockStep &step);

/// That a view's clock runs so fast that its file states a wrong frame rate, or faster than clocks differ; by
/// the first view's clock, which may be the wrong one as well. Empty where the rate is usual. A predicate.
Message clockRateSentence(const RecordingRecord &view, const RecordingRecord &first, double clockRate);

/// "from 3.20 s to 3.90 s this may be Blue 1 or Blue 2": a robot and those that it may be as well. Of several
/// stretches the first one, how many there are, and all those robots. Empty for none.
Message ambiguousNamesText(std::span<const AmbiguousName> ambiguities, const std::string &robotName);

/// The numbers of the views that an analysis measured with, of so many; none of an imported track.
std::vector<std::size_t> usedViews(const AnalysisRecord &analysis, std::size_t views);

/// What stepWarnings says of one view beside others; empty where there is nothing to say, and of the first.
Message stepWarning(const std::string &trialName, const RecordingRecord &view);

/// Whole sentences on views that are fused although their time offset is unknown or uncertain: not
/// synchronised, or with a σ of more than 5 ms, which is 5 mm at 1 m/s. `used`: the views that are measured
/// with (a camera that is not registered is none of them), in their order; for fewer than two there is
/// nothing to say. From stored data, available at any time.
std::vector<Message> stepWarnings(const std::string &trialName,
                                  const std::vector<const RecordingRecord *> &used);

/// The same for a trial as it would be tracked now. Project's thread.
std::vector<Message> stepWarnings(const std::string &trialName, const std::vector<RegisteredView> &views);

/// A whole sentence on a view whose camera was moved while it was recorded: by how much, when, and what to
/// do.
Message movedSentence(const std::string &trialName, const RecordingRecord &view, const CameraMove &move);
/// Those of the views that were moved.
std::vector<Message> moveWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                  const std::vector<TrackedView> &tracked);

/// A whole sentence for each view of which some frames are damaged: how many, when, and what to do.
std::vector<Message> damageWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                    const std::vector<TrackedView> &tracked);

/// The given colour of one robot is also the floor's: it covers more of a frame than a robot can. An error to
/// fail with if the robot was hardly ever found, else a warning. nullopt: it is not, or the views are stored
/// ones, whose frames are not known.
struct FloorColour
{
    Error error;
    bool hardlyEverFound = false;
};
std::optional<FloorColour> floorColourOf(const RobotRecord &robot, const std::string &trialName,
                                         const std::vector<RegisteredView> &views,
                                         const std::vector<TrackedView> &tracked, std::size_t robotIndex);

} // namespace odo
