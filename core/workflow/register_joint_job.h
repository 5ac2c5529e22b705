// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/joint_registration.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <string>
#include <vector>

namespace odo {

struct RegisterJointSettings
{
    std::string layout;
    double tapeSigmaM = 0.002; ///< of the places of the layout's markers
};

/// Registers all cameras that stand on a layout together, from the pixels of their registrations in force, and stores
/// new revisions of all of them in one transaction. The layout stays as it was measured; the verdicts name the markers
/// that are to be measured again. Errors as registerJointly.
class RegisterJointJob : public Job
{
public:
    explicit RegisterJointJob(RegisterJointSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const std::vector<std::string> &cameras() const { return m_names; } ///< after prepare
    /// The registrations in force, in the order of cameras(); after prepare and until commit.
    const std::vector<RegistrationRecord> &before() const { return m_records; }
    const JointRegistration &joint() const { return m_joint; }          ///< after run, in the order of cameras()

private:
    RegisterJointSettings m_settings;
    MarkerLayout m_layout;
    std::vector<std::string> m_names;
    std::vector<RegistrationRecord> m_records;
    std::vector<JointCamera> m_cameras;
    JointRegistration m_joint;
};

} // namespace odo
