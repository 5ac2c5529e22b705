// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/certificate/certificate.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>

namespace odo {

Message certificateSubject()
{
    return ODO_TEXT("workflow.certificate", "certificate");
}

namespace {

constexpr RgbColour standInBlue{0x1f, 0x6f, 0xd0};

/// A camera and the floor that it is on.
struct FoundCamera
{
    CertificateCamera camera;
    std::string floor; ///< name of the layout, or of that of the camera it was registered via
};

Result<CertificateCamera> readCamera(Project &project, const CameraRecord &record,
                                     const RegistrationRecord &registration)
{
    auto view = ODO_TRY(floorViewOf(project, registration));
    std::optional<IntrinsicsRecord> calibration;
    if (registration.intrinsics != 0) {
        calibration = ODO_TRY(project.cameras().intrinsics(registration.intrinsics));
    }
    const Intrinsics intrinsics = view.camera().intrinsics();
    CertificateCamera camera{record.name,
                             std::move(calibration),
                             intrinsics,
                             registration,
                             ODO_TRY(project.layouts().get(registration.layout)).layout,
                             intrinsics.widthPx,
                             intrinsics.heightPx,
                             30,
                             false,
                             registration.registration.poseCovariance.diagonal().maxCoeff() > 0,
                             std::move(view)};
    const auto recording = ODO_TRY(project.trials().newestRecording(record.id));
    if (!recording)
        return camera;
    if (recording->framesPerSecond > 0) {
        camera.framesPerSecond = recording->framesPerSecond;
        camera.isRateKnown = true;
    }
    if (auto atSize = ODO_TRY(floorViewAt(project, registration, *recording))) {
        camera.widthPx = recording->widthPx;
        camera.heightPx = recording->heightPx;
        camera.view = std::move(*atSize);
    }
    return camera;
}

/// The layout that a camera's floor belongs to: through another camera it is that one's.
std::string floorOf(const CertificateCamera &camera, const std::vector<FoundCamera> &others)
{
    for (const FoundCamera &other : others)
        if (other.camera.name != camera.name && isLayoutOfReference(camera.layout.name, other.camera.name))
            return other.camera.layout.name;
    return camera.layout.name;
}

Result<void> readCameras(Project &project, CertificateSetUp &setUp)
{
    std::vector<FoundCamera> found;
    const auto records = ODO_TRY(project.cameras().all());
    for (const CameraRecord &record : records) {
        const auto registration = ODO_TRY(project.cameras().currentRegistration(record.id));
        if (registration)
            found.push_back({ODO_TRY(readCamera(project, record, *registration)), {}});
    }
    if (found.empty())
        return fail(ErrorCode::NotFound, certificateSubject(),
                    ODO_TEXT("workflow.no_camera_registered", "no camera is registered to the floor"),
                    ODO_TEXT("workflow.register_a_camera", "register the cameras first"));
    for (FoundCamera &each : found)
        each.floor = floorOf(each.camera, found);
    const auto newest = std::ranges::max_element(
        found, {}, [](const FoundCamera &each) { return each.camera.registration.made; });
    const std::string floor = newest->floor;
    for (FoundCamera &each : found) {
        if (each.floor == floor) {
            setUp.cameras.push_back(std::move(each.camera));
            continue;
        }
        setUp.remarks.push_back(wholeMessage(
            ODO_TEXT("workflow.camera", "camera '%1'")(Named::camera(each.camera.name)),
            ODO_TEXT("workflow.registered_on_other_floor",
                     "it is registered on another floor, '%1', and left out")(Named::layout(each.floor))));
    }
    return {};
}

/// Sentences on what nobody knows of the cameras.
void remarkOnCameras(CertificateSetUp &setUp)
{
    std::vector<std::string> withoutRate, exact;
    for (const CertificateCamera &camera : setUp.cameras) {
        if (!camera.isRateKnown)
            withoutRate.push_back(camera.name);
        if (!camera.isUncertaintyKnown)
            exact.push_back(camera.name);
    }
    if (!withoutRate.empty())
        setUp.remarks.push_back(wholeMessage(
            ODO_TEXT("workflow.frame_rate_of",
                     "frame rate of %1")(listed(withoutRate, MessageArgument::Kind::Camera)),
            ODO_TEXT("workflow.rate_is_assumed", "no recording shows it, so 30 frames/s are simulated")));
    if (!exact.empty())
        setUp.remarks.push_back(
            wholeMessage(ODO_TEXT("workflow.registration_of",
                                  "registration of %1")(listed(exact, MessageArgument::Kind::Camera)),
                         ODO_TEXT("workflow.registration_counts_as_exact",
                                  "its uncertainty is not known, so it counts as exact")));
}

/// The newest trial with robots, of that task if one is given.
Result<std::optional<TrialRecord>> tellingTrial(Project &project, const std::string &task, RecordId robot)
{
    const auto trials = ODO_TRY(project.trials().all());
    for (const TrialRecord &trial : trials) {
        const bool hasRobot =
            robot == 0 ? !trial.robots.empty() : std::ranges::count(trial.robots, robot) > 0;
        if (!trial.binned && hasRobot && (task.empty() || trial.task == task))
            return trial;
    }
    return std::nullopt;
}

Result<RobotRecord> chosenRobot(Project &project, const CertificateSettings &settings)
{
    if (!settings.robot.empty())
        return project.robots().find(settings.robot);
    for (const std::string &task : {settings.task, std::string()}) {
        const auto trial = ODO_TRY(tellingTrial(project, task, 0));
        if (trial)
            return project.robots().get(trial->robots.front());
    }
    const auto robots = ODO_TRY(project.robots().all());
    if (!robots.empty())
        return robots.front();
    RobotRecord box;
    box.name = "Robot";
    box.colour = standInBlue;
    return box;
}

Result<void> readRobot(Project &project, const CertificateSettings &settings, CertificateSetUp &setUp)
{
    setUp.robot = ODO_TRY(chosenRobot(project, settings));
    setUp.isRobotInProject = setUp.robot.id != 0;
    if (!setUp.isRobotInProject) {
        setUp.remarks.push_back(wholeMessage(
            ODO_TEXT("workflow.robot", "robot"),
            ODO_TEXT("workflow.box_stands_in",
                     "the project has none, so a blue box of 260 mm × 190 mm × 60 mm is simulated")));
        return {};
    }
    if (setUp.robot.heightM)
        return {};
    const auto trial = ODO_TRY(tellingTrial(project, {}, setUp.robot.id));
    if (!trial)
        return {};
    const auto analyses = ODO_TRY(project.analyses().currentMetrics(trial->id));
    for (const AnalysisRecord &analysis : analyses)
        if (analysis.robot == setUp.robot.id && analysis.profile.heightM > 0)
            setUp.measuredHeightM = analysis.profile.heightM;
    return {};
}

Result<void> readTask(Project &project, const std::string &name, CertificateSetUp &setUp)
{
    if (name.empty())
        return {};
    setUp.task = ODO_TRY(project.tasks().find(name));
    const Task &task = setUp.task->task;
    if (task.path.points.size() < 2 && task.gates.empty())
        return fail(
            ErrorCode::InvalidInput, certificateSubject(),
            ODO_TEXT("workflow.task_without_course",
                     "task '%1' has neither a path nor gates to drive along")(Named::task(name)),
            ODO_TEXT("workflow.choose_task_with_course", "choose a task that has, or leave the task out"));
    return {};
}

} // namespace

Result<CertificateSetUp> readCertificateSetUp(Project &project, const CertificateSettings &settings)
{
    CertificateSetUp setUp;
    setUp.title = ODO_TRY(project.title());
    ODO_TRY(readTask(project, settings.task, setUp));
    ODO_TRY(readCameras(project, setUp));
    remarkOnCameras(setUp);
    ODO_TRY(readRobot(project, settings, setUp));
    return setUp;
}

} // namespace odo
