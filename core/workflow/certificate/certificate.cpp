// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/certificate/certificate.h"

#include "core/base/file_system.h"
#include "core/base/platform/user_folders.h"
#include "core/base/shortage.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/files/output_file.h"
#include "core/files/temporary.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/workflow/certificate/internal/certificate_errors.h"
#include "core/workflow/certificate/internal/known_run.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/known_truth.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/trial_sources.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace odo {

namespace {

using Eigen::Vector2d;
using Random = std::mt19937_64;

const std::string certificateTrial = "certificate";

/// Errors of zero mean with this covariance.
Eigen::VectorXd drawn(const Eigen::MatrixXd &covariance, Random &random)
{
    std::normal_distribution<double> normal;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    Eigen::VectorXd along(covariance.rows());
    for (Eigen::Index i = 0; i < along.size(); ++i)
        along[i] = std::sqrt(std::max(0.0, solver.eigenvalues()[i])) * normal(random);
    return solver.eigenvectors() * along;
}

/// Where the camera may be in truth, and what its lens may be, if the project has them to within their
/// covariance: lens and pose err together, as FloorView says.
FloorView drawnView(const CertificateCamera &camera, Random &random)
{
    const FloorRegistration &registered = camera.registration.registration;
    const auto model = CameraModel::create(camera.intrinsics);
    if (!camera.isUncertaintyKnown || !model)
        return camera.view;
    Eigen::VectorXd pose = drawn(registered.poseCovariance, random);
    Intrinsics intrinsics = camera.intrinsics;
    const PoseByIntrinsics byLens = poseByIntrinsics(
        *model, registered.worldFromCamera, markersOnFloorOf(registered, *model, camera.registration.pixels));
    if (intrinsics.covariance.rows() > 0 && byLens.cols() == intrinsics.covariance.rows()) {
        const Eigen::VectorXd lens = drawn(intrinsics.covariance, random);
        pose += byLens * lens;
        intrinsics.fxPx += lens[0];
        intrinsics.fyPx += lens[1];
        intrinsics.cxPx += lens[2];
        intrinsics.cyPx += lens[3];
        for (std::size_t i = 0; i < intrinsics.distortion.size(); ++i)
            intrinsics.distortion[i] += lens[Eigen::Index(4 + i)];
    }
    RegistrationRecord moved = camera.registration;
    RigidTransform &at = moved.registration.worldFromCamera;
    const Eigen::Vector3d turn = pose.head<3>();
    if (turn.norm() > 0)
        at.rotation = (Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * at.rotation)
                          .normalized();
    at.translation += pose.tail<3>();
    const auto view = floorViewAt(moved, intrinsics, camera.widthPx, camera.heightPx);
    return view && *view ? **view : camera.view;
}

/// A motion as a point of the robot makes it that is not its footprint's centre.
class ReferenceMotion : public Motion
{
public:
    ReferenceMotion(std::shared_ptr<const Motion> centre, Vector2d referenceM)
        : m_centre(std::move(centre)), m_referenceM(std::move(referenceM))
    {
    }
    MotionState at(double timeS) const override
    {
        constexpr double stepS = 1e-3; // central differences of a smooth motion: good to 1e-5 m/s²
        const Vector2d before = pointAt(timeS - stepS), after = pointAt(timeS + stepS);
        MotionState state = m_centre->at(timeS);
        state.position = pointAt(timeS);
        state.velocity = (after - before) / (2 * stepS);
        state.acceleration = (after - 2 * state.position + before) / (stepS * stepS);
        return state;
    }

private:
    Vector2d pointAt(double timeS) const
    {
        const MotionState centre = m_centre->at(timeS);
        return centre.position + Eigen::Rotation2Dd(centre.headingRad) * m_referenceM;
    }
    const std::shared_ptr<const Motion> m_centre;
    const Vector2d m_referenceM;
};

SimulatedRobot simulatedRobot(const CertificateSetUp &setUp)
{
    const RobotRecord &robot = setUp.robot;
    SimulatedRobot simulated = demoRobot(
        robot.name,
        {robot.colour, robot.lengthM, robot.widthM, robot.heightM ? robot.heightM : setUp.measuredHeightM},
        nullptr);
    return simulated;
}

/// The floor with its markers, as far as the run and the markers reach.
SimulatedFloor floorUnder(const CertificateSetUp &setUp, const Eigen::AlignedBox2d &bounds)
{
    constexpr double beyondM = 0.35, usualSideM = 0.16, mostOfSpacing = 0.35;
    constexpr std::size_t mostTags = 500;
    SimulatedFloor floor;
    floor.lower = bounds.min() - Vector2d::Constant(beyondM);
    floor.upper = bounds.max() + Vector2d::Constant(beyondM);
    floor.markers = setUp.cameras.front().layout;
    const auto &markers = floor.markers.markers;
    floor.markerSideM = markers.size() > mostTags ? 0 : usualSideM;
    for (std::size_t i = 0; floor.markerSideM > 0 && i < markers.size(); ++i)
        for (std::size_t k = i + 1; k < markers.size(); ++k)
            floor.markerSideM =
                std::min(floor.markerSideM,
                         mostOfSpacing * (markers[i].pointInWorld - markers[k].pointInWorld).norm());
    return floor;
}

SimulatedScene sceneOf(const CertificateSetUp &setUp, const SimulatedRobot &robot, double durationS,
                       const Eigen::AlignedBox2d &bounds, std::uint32_t number)
{
    constexpr double laterS = 0.011, mostOfPeriod = 0.5;
    SimulatedScene scene;
    scene.seed = 100 + number;
    scene.floor = floorUnder(setUp, bounds);
    scene.robots = {robot};
    scene.durationS = durationS;
    Random random(number);
    for (const CertificateCamera &known : setUp.cameras) {
        SimulatedCamera camera{known.name, drawnView(known, random), known.framesPerSecond, 0, 0, {}, 0};
        camera.startOffsetS = laterS * double(scene.cameras.size());
        camera.sensor.exposureS = std::min(camera.sensor.exposureS, mostOfPeriod / known.framesPerSecond);
        scene.cameras.push_back(std::move(camera));
    }
    return scene;
}

/// The progress of one run, whatever its steps say.
JobControl controlOfRun(const JobControl &whole, int number, int count)
{
    JobControl control = partOf(whole, double(number) / count, double(number + 1) / count);
    if (control.progress)
        control.progress =
            [report = control.progress,
             words = ODO_TEXT("workflow.simulating_run", "simulating run %1 of %2")(number + 1, count)](
                double fraction, const Message &) { report(fraction, words); };
    return control;
}

/// That a step of the simulation failed, and why.
tl::unexpected<Error> simulationFailed(const Error &error)
{
    return error.code == ErrorCode::Cancelled
               ? cancelled(certificateSubject())
               : fail(error.code, certificateSubject(), joined({error.what, error.why}, Join::Colon),
                      error.advice);
}

/// A project of its own in a folder, with the set-up as the real one knows it and one simulated trial.
class SimulatedProject
{
public:
    SimulatedProject(const CertificateSetUp &setUp, const SimulatedScene &scene,
                     const std::filesystem::path &folder)
        : m_setUp(setUp), m_scene(scene), m_folder(folder)
    {
    }

    Result<CertificateRun> measure(const JobControl &control)
    {
        m_project = ODO_TRY(Project::create(m_folder / "certificate.odo", certificateTrial));
        ODO_TRY(addCameras());
        RobotRecord robot = m_setUp.robot;
        robot.id = 0;
        ODO_TRY(m_project->robots().add(robot));
        ODO_TRY(render(partOf(control, 0, 0.5)));
        ODO_TRY(import(partOf(control, 0.5, 0.75)));
        TrackJob tracking(certificateTrial, {});
        ODO_TRY(runToEnd(tracking, *m_project, partOf(control, 0.75, 1)));
        const auto trial = ODO_TRY(m_project->trials().find(certificateTrial));
        auto analyses = ODO_TRY(m_project->analyses().current(trial.id));
        if (analyses.empty())
            return fail(ErrorCode::Undetermined, certificateSubject(),
                        ODO_TEXT("workflow.simulated_robot_not_found",
                                 "the simulated robot was not found in the simulated views"),
                        ODO_TEXT("workflow.check_robot_and_registration",
                                 "check the robot's colour and size, and the registrations"));
        CertificateRun run;
        run.profile = std::move(analyses.front().profile);
        run.largestSyncErrorS = m_syncErrorS;
        SimulatedScene asMeasured = m_scene;
        asMeasured.robots.front().motion =
            std::make_shared<ReferenceMotion>(m_scene.robots.front().motion, robot.referenceM);
        run.truth = truthOf(robot.referenceM.isZero() ? m_scene : asMeasured, 0);
        return run;
    }

private:
    Result<void> addCameras()
    {
        std::set<std::string> layouts;
        for (const CertificateCamera &known : m_setUp.cameras) {
            const auto camera = ODO_TRY(m_project->cameras().add({0, known.name, {}}));
            RegistrationRecord registration = known.registration;
            registration.id = 0;
            registration.camera = camera.id;
            registration.image = {};
            registration.lastCheck = {};
            if (layouts.insert(known.layout.name).second)
                ODO_TRY(m_project->layouts().add(known.layout));
            registration.layout = ODO_TRY(m_project->layouts().find(known.layout.name)).id;
            if (known.calibration) {
                IntrinsicsRecord calibration = *known.calibration;
                calibration.id = 0;
                calibration.camera = camera.id;
                calibration.files.clear();
                registration.intrinsics = ODO_TRY(m_project->cameras().addIntrinsics(calibration)).id;
            }
            ODO_TRY(m_project->cameras().addRegistration(registration));
        }
        return {};
    }

    std::filesystem::path videoFile(std::size_t camera) const
    {
        return m_project->mediaFolder() / ("view_" + std::to_string(camera + 1) + ".mkv");
    }

    Result<void> render(const JobControl &control)
    {
        std::error_code problem;
        files::makeFolders(m_project->mediaFolder(), problem);
        std::vector<Result<void>> results(m_scene.cameras.size());
        sideBySide(m_scene.cameras.size(), [&](std::size_t c) {
            JobControl mine = control;
            if (c > 0)
                mine.progress = nullptr; // the first view speaks for all
            OutputTarget target = videoFile(c);
            target.isOwnMedia = true;
            results[c] = renderVideo(m_scene, int(c), target, videoOptions(c), mine);
        });
        for (const auto &result : results)
            ODO_TRY(result);
        return {};
    }

    /// As many bits a pixel as the usual video of 1280×720 at 30 frames/s has.
    VideoWriterOptions videoOptions(std::size_t camera) const
    {
        constexpr double usualPixelsPerS = 1280.0 * 720 * 30, mostBits = 80e6;
        const CertificateCamera &known = m_setUp.cameras[camera];
        VideoWriterOptions options;
        options.nominalFramesPerSecond = known.framesPerSecond;
        const double pixelsPerS = known.framesPerSecond * known.widthPx * known.heightPx;
        options.bitRate =
            int(std::min(mostBits, options.bitRate * std::max(1.0, pixelsPerS / usualPixelsPerS)));
        return options;
    }

    Result<void> import(const JobControl &control)
    {
        ImportSettings settings;
        settings.trial = certificateTrial;
        settings.robots = {m_setUp.robot.name};
        for (std::size_t c = 0; c < m_scene.cameras.size(); ++c)
            settings.videos.emplace_back(m_scene.cameras[c].name, videoFile(c));
        ImportTrialJob job(std::move(settings));
        ODO_TRY(runToEnd(job, *m_project, control));
        for (std::size_t c = 1; c < m_scene.cameras.size(); ++c) {
            const double offsetS = frameSceneTime(m_scene, int(c), 0) - frameSceneTime(m_scene, 0, 0);
            m_syncErrorS =
                std::max(m_syncErrorS.value_or(0), std::abs(job.recordings()[c].startOffsetS - offsetS));
        }
        return {};
    }

    const CertificateSetUp &m_setUp;
    const SimulatedScene &m_scene;
    const std::filesystem::path m_folder;
    std::unique_ptr<Project> m_project;
    std::optional<double> m_syncErrorS;
};

/// As many runs as take about as long as three with the demo's cameras; two at least.
int countOfRuns(const CertificateSetUp &setUp, double durationS)
{
    constexpr double wantedPixels = 3 * 2 * 1280.0 * 720 * 30 * 14;
    constexpr int fewest = 2, most = 5;
    double pixels = 0;
    for (const CertificateCamera &camera : setUp.cameras)
        pixels += camera.framesPerSecond * camera.widthPx * camera.heightPx * durationS;
    return std::clamp(int(std::lround(wantedPixels / pixels)), fewest, most);
}

} // namespace

Result<CertificateOutcome> makeCertificate(const CertificateSetUp &setUp, const JobControl &control,
                                           std::optional<int> runs)
{
    CertificateOutcome outcome;
    outcome.softwareVersion = ODOGRAPH_VERSION;
    outcome.remarks = setUp.remarks;
    SimulatedRobot robot = simulatedRobot(setUp);
    const CourseRun course = ODO_TRY(planKnownRun(setUp, robot, outcome.remarks));
    robot.motion = course.motion;
    outcome.durationS = course.durationS;
    outcome.lengthM = course.lengthM;
    outcome.topSpeedMps = course.topSpeedMps;
    outcome.bounds = floorOf(setUp);
    constexpr double stepS = 0.1;
    for (double timeS = 0; timeS < course.durationS; timeS += stepS)
        outcome.bounds.extend(course.motion->at(timeS).position);
    const int count = runs.value_or(countOfRuns(setUp, course.durationS));
    for (int number = 0; number < count; ++number) {
        const auto folder = ODO_TRY(TemporaryFolder::make(temporaryFolder(), certificateSubject()));
        const SimulatedScene scene =
            sceneOf(setUp, robot, course.durationS, outcome.bounds, std::uint32_t(number + 1));
        auto run =
            SimulatedProject(setUp, scene, folder->path()).measure(controlOfRun(control, number, count));
        if (!run)
            return simulationFailed(run.error());
        if (control.isCancelled())
            return cancelled(certificateSubject());
        outcome.runs.push_back(std::move(*run));
    }
    addErrors(outcome);
    return outcome;
}

} // namespace odo
