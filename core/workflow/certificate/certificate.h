// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/geometry/floor_view.h"
#include "core/project/records.h"

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Of what a certificate is made.
struct CertificateSettings
{
    std::string task =
        {}; ///< whose course the known run follows; empty: one over the floor that the cameras see
    std::string robot = {}; ///< empty: that of the newest trial, or else the first of the project
};

/// A registered camera, as the project knows it.
struct CertificateCamera
{
    std::string name;
    std::optional<IntrinsicsRecord> calibration; ///< that its registration was made with
    Intrinsics intrinsics;                       ///< of the registration
    RegistrationRecord registration;
    MarkerLayout layout;
    int widthPx = 0, heightPx = 0;   ///< of its recordings, or else as registered
    double framesPerSecond = 30;     ///< of its newest recording, if there is one
    bool isRateKnown = false;        ///< it has a recording
    bool isUncertaintyKnown = false; ///< its registration has a covariance
    FloorView view;                  ///< at that size
};

/// All that is simulated of a project.
struct CertificateSetUp
{
    std::string title; ///< of the project
    std::vector<CertificateCamera> cameras;
    RobotRecord robot;
    std::optional<double> measuredHeightM; ///< of a robot whose height is not set, by its newest trial
    bool isRobotInProject = true;          ///< false: a box is simulated in its stead
    std::optional<TaskRecord> task;
    std::vector<Message> remarks; ///< whole sentences: what is left out, and what was assumed
};

/// Reads a set-up: the cameras that are registered on one floor, that of the newest registration. NotFound
/// where no camera is registered, and for a task or robot that is not there; InvalidInput for a task without
/// a course. Project's thread; changes nothing.
Result<CertificateSetUp> readCertificateSetUp(Project &project, const CertificateSettings &settings);

/// What is measured of one quantity against its truth, over all simulated runs. SI units.
struct CertificateErrors
{
    double rms = 0, p95 = 0;       ///< of the errors: the root mean square, and what 95 % of them are below
    std::optional<double> sigma;   ///< as stated, root mean square; empty: none is stated
    std::optional<double> covered; ///< share of the truth inside the stated 95 % interval
};

/// One simulated run: what it was, and what was measured of it.
struct CertificateRun
{
    TruthSeries truth; ///< of the point that is measured
    Profile profile;
    std::optional<double> largestSyncErrorS; ///< of the views against the first one; empty: one view
};

struct CertificateOutcome
{
    CertificateErrors position, velocity, speed, acceleration, accelerationAmount;
    std::vector<CertificateRun> runs;                   ///< with errors of the registration of their own each
    std::int64_t frames = 0, compared = 0;              ///< of the first view, in all runs; with a result
    double durationS = 0, lengthM = 0, topSpeedMps = 0; ///< of one run
    double largestSyncErrorS = 0;
    Eigen::AlignedBox2d bounds;   ///< of the floor that matters
    std::string softwareVersion;  ///< that made it
    std::vector<Message> remarks; ///< as of the set-up, and what was noticed when it was simulated
};

/// Simulates the set-up with a known run, several times, measures the simulated videos as any others in a
/// temporary project, and compares with the truth. Where a registration has a covariance, each time the
/// cameras are drawn from it: they are not quite where the project has them. The same for the same set-up.
/// runs: how many; empty: two to five, fewer of large images. Any thread; slow. Errors: Undetermined where
/// the cameras see too little of the floor, or of the course; Cancelled; those of rendering and tracking.
Result<CertificateOutcome> makeCertificate(const CertificateSetUp &setUp, const JobControl &control,
                                           std::optional<int> runs = {});

/// What errors of a certificate are about.
Message certificateSubject();

} // namespace odo
