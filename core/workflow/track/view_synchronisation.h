// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/synchronisation/clip_evidence.h"
#include "core/workflow/trial_sources.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// By what a view is synchronised with the first. Of Motion, Flash or Sound nothing else is looked at, and
/// where it does not give the time offset that is an Error.
enum class SyncBy {
    Automatic, ///< by whichever of the three is most precise
    None,      ///< the same start time is assumed
    Given,     ///< as entered
    Motion,
    Flash,
    Sound,
    Kept ///< it stays as it is stored
};

/// How a view is synchronised with the first.
struct ViewStep
{
    SyncBy how = SyncBy::Automatic;
    double offsetS = 0; ///< if given: how much later its first frame was taken
};

/// One for each view but the first: a single one without an offset holds for all, none is automatic.
/// InvalidInput for another number. what: the subject of that.
Result<std::vector<ViewStep>> stepsFor(const Message &what, std::size_t views, std::vector<ViewStep> given);

/// How a trial's views are to be synchronised.
struct SyncRequest
{
    /// What becomes of a view where an automatic step finds nothing.
    enum class Otherwise {
        Open, ///< tracking seeks it again (isSyncOpen); a sentence says why
        Fail  ///< an Error
    };
    std::string trial;
    std::vector<ViewStep> steps; ///< as stepsFor gives them
    Otherwise otherwise = Otherwise::Open;
    std::vector<RobotRecord> robots = {};                            ///< by whose motion
    std::vector<std::optional<MicrophonePosition>> microphones = {}; ///< of each view
    /// whether the files play at another rate than they were filmed at; empty: to be seen in them
    std::optional<bool> isSlowMotion = {};
    /// Interlaced frames may be counted by their fields: nothing is stored yet that counts them otherwise.
    bool mayTakeFields = true;
};

/// Whether anything has to be found in the files.
bool isAnythingSought(const SyncRequest &request);

/// Whether a file of this length was not filmed at the rate that it plays at.
bool isPlayedOtherwise(double playsS, double tookS);

/// Where the registered views hear from. Project's thread.
Result<std::vector<std::optional<MicrophonePosition>>>
microphonePositions(Project &project, const std::vector<RegisteredView> &views);

/// Sets how each view's recording is synchronised with the first, and of the trial what it says of its second
/// view. Where the motion shows that stamps are wrong, the recording's frame times become
/// those at which the frames were taken. Gives whole sentences on what a person should know. Touches no
/// project. Errors: an offset that is not found (SyncBy); a video that cannot be read; cancelled.
Result<std::vector<Message>> synchroniseViews(std::vector<RegisteredView> &views, const SyncRequest &request,
                                              TrialRecord &trial, const JobControl &control);

std::vector<RecordingRecord> recordingsOf(const std::vector<RegisteredView> &views);

/// The recordings whose frame times are no longer those that they were before.
std::vector<RecordingRecord> retimedRecordings(const std::vector<RegisteredView> &before,
                                               const std::vector<RegisteredView> &views);

/// Whole sentences on how the views' times fit together. Error: two of them have no time in common. what: its
/// subject.
Result<std::vector<Message>> commonTimeWarnings(const Message &what,
                                                const std::vector<RecordingRecord> &recordings);

} // namespace odo
