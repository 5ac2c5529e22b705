// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace odo {

class Project;

/// A calibration or a registration of a camera, as a list shows it.
struct Revision
{
    enum class Kind { Calibration, Registration } kind = Kind::Calibration;
    RecordId id = 0;
    Instant made;
    std::string softwareVersion; ///< empty: not known
    Message origin;              ///< "calibrated from 20 pictures", "layout 'Gym', lens of calibration 3"
    int evidence = 0;            ///< pictures of a calibration, markers of a registration
    double rmsPx = 0;            ///< 0: not known
    Message verdict;
    bool isCurrent = false; ///< in force
    /// that it was made from, of a calibration the first; empty: none was kept
    std::filesystem::path picture;
    std::vector<MarkerPixel> markers; ///< in it
    std::vector<std::string> trials;  ///< whose newest analysis was made with it
};

/// Calibrations first, then registrations, each the newest first. NotFound for a camera that is not there.
/// Project's thread.
Result<std::vector<Revision>> revisionsOf(Project &project, const std::string &camera);

/// Puts a revision of a camera in force until the next one is made. NotFound where it is none of this
/// camera's.
Result<void> chooseRevision(Project &project, const std::string &camera, Revision::Kind kind, RecordId id);

/// Trials whose newest analysis was made with another registration of a camera than the one in force.
/// In the order of their names.
Result<std::vector<std::string>> outdatedTrials(Project &project);

/// Whole sentences on what may be wrong with a camera's calibration in force, each with what to do; empty:
/// nothing. Old: intrinsics or registration made longer than oldAfter before now. Overtaken: registered with
/// older intrinsics than the newest. Another size: the newest recording is of other pictures than the
/// intrinsics. Never calibrated. A camera that is not registered has no warning of a registration. Project's
/// thread.
Result<std::vector<Message>> calibrationWarnings(Project &project, const CameraRecord &camera, Instant now,
                                                 std::chrono::days oldAfter = std::chrono::days(90));

} // namespace odo
