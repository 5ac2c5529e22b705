// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/world_axes.h"
#include "core/files/output_file.h"
#include "core/project/records.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// The camera of this name, made when the project has none of that name: whoever adds its images, intrinsics
/// or videos need not announce it first.
Result<CameraRecord> findOrAddCamera(Project &project, const std::string &name);

/// Reads a calibration file (readCalibrationFile) and stores it as the camera's newest intrinsics. entry:
/// which of several cameras in it; where none is chosen, the one of the camera's name.
Result<IntrinsicsRecord> importIntrinsics(Project &project, const std::string &camera,
                                          const std::filesystem::path &file, const std::string &entry = {});

/// Writes the camera's intrinsics in force; the format follows the file's name (.yml OpenCV, otherwise ROS).
Result<void> exportIntrinsics(Project &project, const std::string &camera, const OutputTarget &target);

/// Stores a registration as the newest one of a camera, which is made when the project has none of that name,
/// and stamps it with the time of now and the version of the program. For a job's commit, inside its
/// transaction; gives back what is stored.
Result<RegistrationRecord> storeRegistration(Project &project, const std::string &camera,
                                             RegistrationRecord record);

/// As storeRegistration, for one recomputed from older markers, which say nothing of the camera's present
/// position: the last check of the one before still holds.
Result<RegistrationRecord> storeFromOldMarkers(Project &project, const std::string &camera,
                                               RegistrationRecord record,
                                               const std::optional<RegistrationCheck> &lastCheck);

/// A camera with its registration in force.
struct RegisteredCamera
{
    CameraRecord camera;
    RegistrationRecord registration;
};

/// The cameras whose registration in force was made with this layout. Project's thread.
Result<std::vector<RegisteredCamera>> camerasOnLayout(Project &project, RecordId layout);

/// The registration in force of a camera by name. NotFound where it has none, with what to do.
Result<RegisteredCamera> registeredCamera(Project &project, const std::string &camera);

/// A calibration or a registration of a camera, as a list shows it.
struct Revision
{
    enum class Kind { Calibration, Registration } kind = Kind::Calibration;
    RecordId id = 0;
    Instant made;
    std::string softwareVersion; ///< empty: not known
    Message origin;              ///< "calibrated from 20 images", "layout 'Gym', lens calibration 3"
    int evidence = 0;            ///< images of a calibration, markers of a registration
    double rmsPx = 0;            ///< 0: not known
    Message verdict;
    bool isCurrent = false; ///< in force
    /// that it was made from, of a calibration the first; empty: none was kept
    std::filesystem::path image;
    std::vector<MarkerPixel> markers; ///< in it
    std::vector<std::string> trials;  ///< whose newest analysis was made with it
};

/// Calibrations first, then registrations, each the newest first. NotFound for a camera that is not there.
/// Project's thread.
Result<std::vector<Revision>> revisionsOf(Project &project, const std::string &camera);

/// Puts a revision of a camera in force until the next one is made. A registration in older axes of its
/// layout is stored again in the present ones. NotFound where it is none of this camera's; InvalidInput for a
/// registration whose axes are not known.
Result<void> chooseRevision(Project &project, const std::string &camera, Revision::Kind kind, RecordId id);

/// Trials whose newest analysis was made with another registration of a camera than the one in force.
/// In the order of their names.
Result<std::vector<std::string>> outdatedTrials(Project &project);

/// Whole sentences on what may be wrong with a camera's calibration in force, each with what to do; empty:
/// nothing. Old: intrinsics or registration made longer than oldAfter before now. Overtaken: registered with
/// older intrinsics than the newest. Another size: the newest recording has another frame size than the
/// intrinsics. Never calibrated. A camera that is not registered has no warning of a registration. Project's
/// thread.
Result<std::vector<Message>> calibrationWarnings(Project &project, const CameraRecord &camera, Instant now,
                                                 std::chrono::days oldAfter = std::chrono::days(90));

struct LayoutAxesOutcome
{
    LayoutRecord layout; ///< in the new axes
    AxesTransform newFromOld;
    std::vector<std::string> cameras;    ///< whose registrations were carried along
    std::vector<std::string> movedTasks; ///< whose gates, paths and zones were carried along
    /// with gates or a path, which stay where they are in the axes that were: other floors use them, too
    std::vector<std::string> tasks;
};

/// Changes the world axes of a layout in one transaction: the layout's positions, and a new revision of the
/// registration of each of its cameras, also of those registered via such a camera ("C through B") with their
/// own layouts; and the tasks that were driven on this floor only, or of a project with a single floor. Older
/// revisions, and the analyses made with them, stay in the old axes (result_axes.h). Project's thread; quick.
Result<LayoutAxesOutcome> changeLayoutAxes(Project &project, const std::string &layout,
                                           const AxesChange &change);

} // namespace odo
