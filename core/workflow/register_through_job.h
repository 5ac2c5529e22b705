// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/chained_registration.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

struct RegisterThroughSettings
{
    std::string camera;
    std::string through; ///< a camera that is registered
    std::vector<SharedPoint> points;
    StoredPicture picture = {}; ///< of the camera, in which the points were picked, where the project has it
};

/// Registers a camera by points of the floor that a registered camera sees as well. Stores it as the camera's
/// newest registration, with the places that were found as a layout of its own ("C through B", numbered where
/// that name is taken); the verdict names the registration it was made through. The camera needs intrinsics
/// or a recording, which tells the size of its pictures.
class RegisterThroughJob : public Job
{
public:
    explicit RegisterThroughJob(RegisterThroughSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const RegistrationRecord &record() const { return m_record; }   ///< after run; its layout after commit
    const std::string &layoutName() const { return m_layout.name; } ///< after commit

private:
    Result<void> findCamera(Project &project);

    RegisterThroughSettings m_settings;
    std::optional<FloorView> m_through;
    RecordId m_throughRegistration = 0;
    std::optional<CameraModel> m_camera;
    bool m_intrinsicsKnown = false;
    MarkerLayout m_layout;
    RegistrationRecord m_record;
};

/// Whether a layout is one of those that registrations through this camera keep.
bool isLayoutThrough(const std::string &layoutName, const std::string &through);

} // namespace odo
