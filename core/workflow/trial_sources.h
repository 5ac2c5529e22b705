// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/geometry/floor_view.h"
#include "core/project/records.h"
#include "core/tracking/searched_area.h"
#include "core/trajectory/analyser.h"
#include "core/video/video_reader.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace odo {

class Project;

/// A view of a trial with the calibration that is in force for its camera.
struct RegisteredView
{
    RecordingRecord recording;
    std::filesystem::path file;
    std::optional<RegistrationRecord> registration;
    std::optional<FloorView> floorView; ///< empty: not registered, or registered at another frame shape
    /// at which the camera was registered, where that is not the recording's and floorView was converted
    std::optional<std::pair<int, int>> convertedFromPx = {};
    std::filesystem::path registrationImage = {}; ///< in which its markers were seen; empty: none is kept
    SearchedArea area = {};                       ///< where robots are searched
    std::vector<PointedOutRobot> marks = {};      ///< where a person marked robots in its frames
};

/// Clock of a trial's recording against the first view's.
ViewClock clockOf(const RecordingRecord &recording);

/// With what a recording is to be opened, so that its frames are those that were measured.
KnownRecording knownRecording(const RecordingRecord &recording);

/// The file of an image of the project; empty where none was kept. Looks at the disk.
std::filesystem::path imageFileOf(const Project &project, const StoredImage &image);

/// The camera registered to the floor, from the stored registration and the intrinsics that it was made with,
/// whose uncertainty it carries to the floor.
Result<FloorView> floorViewOf(Project &project, const RegistrationRecord &registration);

/// The same for frames of a size, which the lens that it was made with is converted to where that is
/// determined (determinedFormat); nullopt where it is not: the camera has to be registered in such a frame.
/// Any thread.
Result<std::optional<FloorView>> floorViewAt(const RegistrationRecord &registration,
                                             const Intrinsics &intrinsics, int widthPx, int heightPx);
/// For the frames of a recording.
Result<std::optional<FloorView>> floorViewAt(Project &project, const RegistrationRecord &registration,
                                             const RecordingRecord &recording);

/// What is said where floorViewAt gives none.
Error registeredAtOtherSize(const std::string &trialName, const RecordingRecord &recording,
                            const Intrinsics &intrinsics);

/// Whole sentences on views whose frames have another size than their camera was registered at, and how that
/// was dealt with. Any thread.
std::vector<Message> convertedViewWarnings(const std::string &trialName,
                                           const std::vector<RegisteredView> &views);

/// The advice to do so.
Message registerInItsVideo();

/// The camera as it is registered now; nullopt where it is not. Project's thread.
Result<std::optional<FloorView>> floorViewInForce(Project &project, RecordId camera);

/// The views of a trial in their order. A recording of another frame size than its camera was registered at
/// is an Error where the lens cannot be converted to it for sure (floorViewAt): the results would be silently
/// wrong. Project's thread.
Result<std::vector<RegisteredView>> registeredViews(Project &project, const TrialRecord &trial);

/// Whether the recordings are what they were when they were imported or made, by their sizes and by their
/// content where its SHA-256 is known: nothing is measured from others. Error InvalidInput names the view.
/// A file that is missing is left to its reader. Any thread.
Result<void> checkRecordings(const std::vector<RegisteredView> &views, const JobControl &control);

/// The robots named; or else those of the trial; or else all of the project. NotFound for a name that is not
/// there, and when there is no robot at all.
Result<std::vector<RobotRecord>> robotsToTrack(Project &project, const TrialRecord &trial,
                                               const std::vector<std::string> &names);

/// Where the tracks came from that another program measured of a trial's robots, without their samples, in
/// the robots' order; none of a trial that has recordings. On the project's thread.
Result<std::vector<ImportedTrack>> importedTracksOf(Project &project, const TrialRecord &trial);

} // namespace odo
