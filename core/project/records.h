// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/range/run_range.h"
#include "core/analysis/task.h"
#include "core/base/units.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/calibration/marker_layout.h"
#include "core/tracking/observation.h"
#include "core/trajectory/analyser.h"

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Identity of a row. 0: not stored yet.
using RecordId = std::int64_t;

/// Wall-clock instants are stored as milliseconds since 1970 UTC.
using Instant = std::chrono::sys_time<std::chrono::milliseconds>;

struct CameraRecord
{
    RecordId id = 0;
    std::string name;
    std::string deviceUri; ///< may be empty
};

/// An image of a calibration or of a registration, in the project's media folder.
struct StoredImage
{
    std::string path; ///< as a recording's; empty: it was not kept
    std::string sha256;
    std::int64_t bytes = 0;
};

/// A revision of a camera's intrinsics; the newest is in force unless another was chosen, old ones are kept.
struct IntrinsicsRecord
{
    RecordId id = 0;
    RecordId camera = 0;
    Instant made;
    Message origin; ///< "calibrated from 14 images", "imported from A.yaml"
    /// For an import: rmsPx 0 and no images. What follows from the rest is not stored: onFloor
    /// (expectedOnFloor gives it), halvesApart, modelTrials. With its images' corners it can be recomputed
    /// (recalibrate); those of projects before format 5 have none.
    IntrinsicCalibration calibration;
    BoardSpec board;                ///< as it was found out; 0 columns: not known
    std::string softwareVersion;    ///< that made it; empty: not known
    std::vector<StoredImage> files; ///< one for each of calibration.images, or none at all
};

/// A check of the camera position, by the camera's markers in a newer image.
struct RegistrationCheck
{
    Instant made;
    /// Undetermined: too few markers were found again.
    enum class Outcome { Still, CameraMoved, MarkersMoved, Undetermined } outcome = Outcome::Still;
    double shiftPx = 0, shiftM = 0; ///< as CameraPositionCheck
    Message words;
};

/// A revision of a camera's registration to the floor; in force as intrinsics are.
struct RegistrationRecord
{
    RecordId id = 0;
    RecordId camera = 0;
    RecordId layout = 0;
    RecordId intrinsics = 0; ///< 0: the lens was estimated along with it
    Instant made;
    Intrinsics assumedIntrinsics; ///< what was estimated when intrinsics is 0
    std::vector<MarkerPixel> pixels;
    FloorRegistration registration;
    std::string softwareVersion; ///< that made it; empty: not known
    StoredImage image;           ///< in which the markers were seen
    /// The pixels belong to upright frames. False: made by a version that took the frames of clips as stored.
    bool isUpright = true;
    std::optional<RegistrationCheck> lastCheck; ///< read only; added by addCheck
};

struct LayoutRecord
{
    RecordId id = 0;
    MarkerLayout layout;
};

/// In what colour of the charts' palette (Okabe and Ito 2008) a robot is drawn; by default by its position in
/// the trial.
enum class DrawingColour { Automatic, Blue, Vermilion, Green, Purple, Orange, SkyBlue };

struct RobotRecord
{
    RecordId id = 0;
    std::string name;
    std::optional<RgbColour> colour; ///< by which it is tracked; none: by background subtraction
    enum class Height { Given, Automatic, Free } heightMode = Height::Automatic;
    std::optional<double> heightM; ///< when the mode is Given
    std::optional<double> lengthM, widthM;
    DrawingColour drawingColour = DrawingColour::Automatic;
    /// forward and left from its footprint's centre: the point that is measured
    Eigen::Vector2d referenceM = Eigen::Vector2d::Zero();
};

struct TeamRecord
{
    RecordId id = 0;
    std::string name, className;
    /// by which it is shown where names are to stay among those who know them; may be empty
    std::string pseudonym = {};
    std::vector<std::string> members = {}; ///< names of the people, in the order of the list
    /// that belong to it, in the order of the list; a robot may belong to several teams
    std::vector<RecordId> robots = {};
};

/// A task's course is not changed once it is stored: trials were measured by it.
struct TaskRecord
{
    RecordId id = 0;
    std::string name;
    Task task;
    std::optional<Instant> archived = {}; ///< since when it is out of the way; what was measured by it stays
};

struct TrialRecord
{
    RecordId id = 0;
    std::string name;
    RecordId team = 0;               ///< 0: none
    std::string teamName, className; ///< read only, joined
    std::string teamPseudonym;       ///< read only, joined; may be empty
    std::string task;                ///< its name; empty: none
    Instant date;
    std::string notes;
    /// of the second view: "none", "told", "auto" (from the motion), "flash" (of light), "audio", "clock"
    /// (recorded here, by the cameras' time stamps), or "open": sought and not found, tracking seeks it again
    std::string syncMethod;
    double syncOffsetS = 0; ///< how much later the second view's first frame was taken than the first's
    double syncOffsetSigmaS = 0;
    double syncRate = 0;      ///< by how much the second view's clock runs faster than the first's
    double syncRateSigma = 0; ///< 0: not estimated
    double syncScore = 0;
    std::vector<RecordId> robots;        ///< that are expected in it
    std::vector<std::string> robotNames; ///< read only, joined
    double durationS = 0;
    std::optional<TimeSpan> range; ///< of its time, that its results are of; empty: all of it
    int viewCount = 0;             ///< read only
    bool starred = false;
    std::vector<std::string> tags; ///< in alphabetical order
    /// a person's own, by name: "surface", "battery"; text, or a number as text
    std::map<std::string, std::string> variables;
    std::optional<Instant> archived; ///< since when it is out of the way; it counts as before
    /// since when it is in the bin: it counts nowhere, and can be restored
    std::optional<Instant> binned;
    /// read only: it is being recorded, or was when that was cut off; its recordings have raw times only
    bool unfinished = false;
};

/// The range of a trial; of one without, all of its time.
TimeSpan rangeOf(const TrialRecord &trial);
/// "Range: 1.000 s to 7.300 s of 12.033 s; all results are of this part."; empty without a range.
Message rangeSentence(const TrialRecord &trial);

/// What a list to choose from needs of a trial.
struct TrialName
{
    RecordId id = 0;
    std::string name, teamName;
    bool unfinished = false, binned = false;
};

/// A video of one view of a trial. Frame times are kept here, whatever becomes of the file.
struct RecordingRecord
{
    RecordId id = 0;
    RecordId trial = 0;
    RecordId camera = 0;
    std::string cameraName; ///< read only, joined
    int position = 0;       ///< 0: the first view
    std::string path;       ///< relative to the project's folder when beside it, else absolute
    std::string sha256;     ///< empty: not made yet
    std::int64_t bytes = 0;
    int widthPx = 0, heightPx = 0; ///< of the frames as they are measured
    /// How stored frames are turned to be measured, numbered as in EXIF (core/video/frame_turn.h). 0: not at
    /// all, by a version of the program that did not ask whether the file demands it.
    int orientation = 1;
    double framesPerSecond = 0;
    std::string syncMethod;       ///< how startOffsetS is known, as in TrialRecord; empty: the first view
    double startOffsetS = 0;      ///< against the first view
    double startOffsetSigmaS = 0; ///< 0: not known
    double clockRate = 0;         ///< by how much its clock runs faster than the first view's
    std::vector<Nanoseconds> frameTimes;
};

/// Whether a view was synchronised by a measurement, with a σ: not by hand, nor left
/// unsynchronised.
inline bool isStepMeasured(const RecordingRecord &view)
{
    return view.syncMethod == "auto" || view.syncMethod == "flash" || view.syncMethod == "audio" ||
           view.syncMethod == "clock";
}

/// Whether tracking is to seek a view's time offset, which nothing has given yet.
inline bool isSyncOpen(const RecordingRecord &view)
{
    return view.syncMethod == "open";
}

/// How a trial's views were synchronised, as others read it.
inline std::string publishedSyncMethod(const std::string &method)
{
    return method == "open" ? "none" : method;
}

/// What the tracker saw of one robot in one recording.
struct ObservationSeries
{
    RecordId recording = 0;
    RecordId robot = 0;
    std::string algorithm; ///< name and version of the tracker
    std::vector<Observation> observations;
};

/// Where a robot was, as another program measured it: the raw measurement of a trial without recordings.
struct ImportedTrack
{
    RecordId trial = 0, robot = 0;
    Instant imported;
    std::string file; ///< its name, without folders
    std::string sha256;
    std::int64_t bytes = 0;
    std::string format; ///< what it was read as, one word: "tum", "csv", "tracker"
    Message reading;    ///< for people: units, axes and errors it was read with
    /// In order of time, with their covariances; flagged Lost where it has no position. Views and
    /// disagreement are not known.
    std::vector<Sample> samples;
    double noiseM = 0; ///< read only: the root mean square σ of a coordinate
};

/// An interval in which it is ambiguous which of several robots of the same appearance a robot is:
/// it may be another one from then on.
struct AmbiguousName
{
    Nanoseconds from{0}, to{0};          ///< of the trial, from not after to
    std::vector<RecordId> others;        ///< that it may be; empty where that is not known
    std::vector<std::string> otherNames; ///< read only, joined
};

/// Where a person marked a robot of any appearance in one frame of a trial. The tracker follows what is
/// there.
struct PointedOutRobot
{
    RecordId robot = 0, recording = 0;
    std::int64_t frame = 0;                          ///< of the recording
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< luma pixels
    bool operator==(const PointedOutRobot &) const = default;
};

/// One computed result for one robot of a trial, with all that went into it.
struct AnalysisRecord
{
    RecordId id = 0;
    RecordId trial = 0;
    RecordId robot = 0;
    std::string robotName; ///< read only, joined
    Instant made;
    std::string softwareVersion;
    RecordId task = 0;                   ///< by which gates, path and limits it was measured; 0: by none
    AnalysisOptions options;             ///< read back without the task
    std::vector<RecordId> registrations; ///< one a view, in the views' order; 0 where unregistered
    std::vector<std::string> views;      ///< names of the views, bit i of Sample::views
    /// of the trial's time, that profile and ambiguous names are of; empty: all of it
    std::optional<TimeSpan> range;
    Profile profile;
    OutsideRange outside; ///< what of the run is not in the range
    /// in order; found as the observations were made, so a reanalysis keeps them
    std::vector<AmbiguousName> ambiguousNames;
    std::vector<AmbiguousName> allAmbiguousNames; ///< with a range: as they were found
    /// Read only: whether positions and metrics are as they were when it was made. NotKept: it is older than
    /// digests.
    enum class Proof { NotKept, Holds, Broken } proof = Proof::NotKept;
};

/// Gives an analysis another range, or none, and measures that. task: by which it was measured; nullptr: by
/// none.
void changeRange(AnalysisRecord &analysis, const std::optional<TimeSpan> &range, const Task *task);

/// One metric of a trial's newest analysis.
struct TrialMetric
{
    RecordId trial = 0, robot = 0;
    Metric metric;
};

/// That a person changed something, or undid the change.
struct ChangeEntry
{
    enum class Kind { Made, Undone, Redone };
    Instant made;
    Kind kind = Kind::Made;
    Message words; ///< what was changed
};

/// Values from elsewhere that belong to a trial: the demo's truth.
struct TruthSeries
{
    RecordId trial = 0;
    RecordId robot = 0;
    std::vector<Nanoseconds> times; ///< since the first view's first frame
    std::vector<Eigen::Vector2d> positions, velocities, accelerations;
};

/// The wall clock, as moments are stored. Any thread.
inline Instant instantNow()
{
    return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

} // namespace odo
