// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/placement_advice.h"
#include "core/workflow/certificate/certificate.h"

namespace odo {

/// What placementAdvice is asked about a project. Plain values: may leave the project's thread.
struct SetUpQuestion
{
    std::vector<AdvisedCamera> cameras;
    MarkerLayout layout;
    PlacementQuestion question;
};

/// How far cameras may be moved, and what is driven; what is left out is taken from the project: the robot's
/// height, and the top speed and the σ of the time offset of the newest trial.
struct SetUpQuestionSettings
{
    std::string robot = {}; ///< as CertificateSettings
    std::optional<double> speedMps = {};
    double reachM = 1;
};

/// The cameras that are registered on the floor of the newest registration, and the markers of that floor.
/// Errors as readCertificateSetUp. Project's thread; changes nothing.
Result<SetUpQuestion> readSetUpQuestion(Project &project, const SetUpQuestionSettings &settings);

} // namespace odo
