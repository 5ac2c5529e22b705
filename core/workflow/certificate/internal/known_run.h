// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/course_motion.h"
#include "core/workflow/certificate/certificate.h"

namespace odo {

/// Box that holds the markers of all cameras and the course of the task.
Eigen::AlignedBox2d floorOf(const CertificateSetUp &setUp);

/// The run that a set-up is simulated with: along the task's course, or else a straight line, a curve and
/// stop-and-go over the floor that two cameras (or the only one) see whole, with the robot's size. remarks:
/// what the cameras do not see of it. Undetermined where that is too little.
Result<CourseRun> planKnownRun(const CertificateSetUp &setUp, const SimulatedRobot &robot,
                               std::vector<Message> &remarks);

} // namespace odo
