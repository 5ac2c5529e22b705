// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/demo.h"

#include "core/analysis/scoring.h"
#include "core/base/file_system.h"
#include "core/base/shortage.h"
#include "core/exchange/labelled_points.h"
#include "core/files/output_file.h"
#include "core/files/temporary.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/calibrate_job.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/known_truth.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/track_job.h"

#include <vector>

namespace odo {

namespace {

const Eigen::Vector2d middle(1.5, 1.1); // of the floor

Task straightLine()
{
    const Eigen::Vector2d from(0.35, 0.55), to(2.65, 1.6), way = (to - from).normalized();
    Task task;
    task.kind = TaskTemplate::StraightLine;
    task.gates = {gateAcross("Start", GateRole::Start, from + 0.4 * way, way, 0.5),
                  gateAcross("Half-way", GateRole::Split, (from + to) / 2, way, 0.5),
                  gateAcross("Finish", GateRole::Finish, to - 0.4 * way, way, 0.5)};
    task.path.points = {from, to};
    return task;
}

Task circle()
{
    constexpr double radiusM = 0.75;
    Task task;
    task.kind = TaskTemplate::Circle;
    const Eigen::Vector2d up(0, radiusM);
    task.gates = {gateAcross("Lap", GateRole::StartFinish, middle + up, {-1, 0}, 0.4),
                  gateAcross("Half lap", GateRole::Split, middle - up, {1, 0}, 0.4)};
    task.path = circlePath(middle, radiusM);
    return task;
}

Task figureEight()
{
    constexpr double halfWidthM = 1.05, halfHeightM = 0.6;
    Task task;
    task.kind = TaskTemplate::FigureEight;
    const Eigen::Vector2d end(halfWidthM, 0);
    task.gates = {gateAcross("Right", GateRole::StartFinish, middle + end, {0, -1}, 0.5),
                  gateAcross("Left", GateRole::Split, middle - end, {0, -1}, 0.5)};
    task.path = figureEightPath(middle, halfWidthM, halfHeightM);
    task.limits = {3.0, 15.0};
    return task;
}

Task stopAndGo()
{
    Task task;
    task.path.points = {{0.45, 0.5}, {2.5, 0.55}, {2.4, 1.7}, {0.6, 1.65}};
    const Eigen::Vector2d first = task.path.points[0], second = task.path.points[1];
    task.gates = {gateAcross("Start", GateRole::Start, first + 0.2 * (second - first), second - first, 0.4),
                  gateAcross("Finish", GateRole::Finish, {1.0, 1.6611}, {-1, 0}, 0.4)};
    return task;
}

} // namespace

/// The tasks of the demo's trials (demoTrials, by name), placed where its robots drive: a straight line with
/// start and finish, laps of a circle, a figure eight, and a square with stops.
std::vector<TaskRecord> demoTasks()
{
    return {{0, "Straight line", straightLine()},
            {0, "Circle", circle()},
            {0, "Figure eight", figureEight()},
            {0, "Stop and go", stopAndGo()}};
}

/// How one of them is scored: by its time, by how well its path is kept, and a point off for each spike.
std::vector<Criterion> demoScoring(const Task &task)
{
    const bool hasLaps = task.kind == TaskTemplate::Circle || task.kind == TaskTemplate::FigureEight;
    return {{hasLaps ? "best_lap" : "gate_time", 1, 10, 60},
            {"cross_track_rms", 0, 40, 40},
            {"spikes", 10, 0, -10}};
}

namespace {

namespace fs = std::filesystem;

constexpr const char *className = "Year 9 robotics";
constexpr int boardImages = 14;
constexpr double boardNoise = 1.5; // of 255

Message demoAdvice()
{
    return ODO_TEXT("workflow.choose_folder_for_demo", "choose a folder you can write to, with 300 MB free");
}

tl::unexpected<Error> demoCancelled()
{
    return cancelled(ODO_TEXT("workflow.demo", "demo"));
}

Result<void> makeFolder(const fs::path &folder)
{
    std::error_code problem;
    files::makeFolders(folder, problem);
    return problem ? fail(ErrorCode::Io, folderCalled(folder), foreignWords(problem.message()), demoAdvice())
                   : Result<void>();
}

/// What the project is given of a robot: colour and size of a box, nothing of a robot of parts, which is one
/// of any look.
RobotRecord recordOf(const SimulatedRobot &simulated)
{
    RobotRecord robot;
    robot.name = simulated.name;
    if (!simulated.parts.empty())
        return robot;
    robot.colour = simulated.colour;
    robot.heightMode = RobotRecord::Height::Given;
    robot.heightM = simulated.heightM;
    robot.lengthM = simulated.lengthM;
    robot.widthM = simulated.widthM;
    return robot;
}

class DemoMaker
{
public:
    DemoMaker(const fs::path &folder, Project &project, const JobControl &control)
        : m_folder(folder), m_project(project), m_control(control), m_trials(demoTrials())
    {
    }

    Result<void> make()
    {
        for (const auto step : {&DemoMaker::calibrateCameras, &DemoMaker::addLayout, &DemoMaker::renderVideos,
                                &DemoMaker::registerCameras, &DemoMaker::addTasks, &DemoMaker::addTrials,
                                &DemoMaker::trackTrials}) {
            ODO_TRY((this->*step)());
            if (m_control.isCancelled())
                return demoCancelled();
        }
        return {};
    }

private:
    const SimulatedScene &testbed() const { return m_trials.front().scene; }

    Result<void> calibrateCameras()
    {
        const fs::path images = m_folder / "calibration";
        ODO_TRY(makeFolder(images));
        for (const SimulatedCamera &camera : testbed().cameras) {
            m_control.report(0.02, ODO_TEXT("workflow.calibrating_camera",
                                            "calibrating camera %1")(Named::camera(camera.name)));
            CalibrateSettings settings;
            settings.camera = camera.name;
            SimulatedBoard board;
            settings.board.squareM = board.squareM;
            int number = 0;
            for (const RigidTransform &pose : heldBoardPoses(camera.view.camera(), board, boardImages, 7)) {
                if (m_control.isCancelled())
                    return demoCancelled();
                board.cameraFromBoard = pose;
                const std::string suffix = (number < 9 ? "_0" : "_") + std::to_string(number + 1) + ".png";
                const fs::path file = images / (camera.name + suffix);
                ODO_TRY(writeImage(
                    renderBoard(camera.view.camera(), board, boardNoise, std::uint32_t(100 + number)), file));
                settings.files.push_back(file);
                ++number;
            }
            CalibrateJob job(std::move(settings));
            if (auto done = runToEnd(job, m_project, {m_control.cancel, {}}); !done)
                return done;
            const auto record = ODO_TRY(m_project.cameras().find(camera.name));
            ODO_TRY(m_project.cameras().setDevice(record.id, "sim:" + camera.name));
        }
        return {};
    }

    Result<void> addLayout()
    {
        const MarkerLayout &layout = testbed().floor.markers;
        m_layout = layout.name;
        const auto added = ODO_TRY(m_project.layouts().add(layout));
        return writeLayoutCsv(m_folder / "calibration" / "layout.csv", layout);
    }

    fs::path videoFile(std::size_t trial, const SimulatedCamera &camera) const
    {
        return m_project.mediaFolder() / (m_trials[trial].trial + "_" + camera.name + ".mkv");
    }

    Result<void> renderVideos()
    {
        ODO_TRY(makeFolder(m_project.mediaFolder()));
        for (std::size_t t = 0; t < m_trials.size(); ++t) {
            const double share = 0.75 / double(m_trials.size()), from = 0.05 + share * double(t);
            ODO_TRY(renderTrial(t, partOf(m_control, from, from + share)));
        }
        return {};
    }

    Result<void> renderTrial(std::size_t t, const JobControl &control)
    {
        const SimulatedScene &scene = m_trials[t].scene;
        std::vector<Result<void>> results(scene.cameras.size());
        sideBySide(scene.cameras.size(), [&](std::size_t c) {
            JobControl mine = control;
            if (c > 0)
                mine.progress = nullptr; // the views go on side by side: the first speaks for all
            OutputTarget target = videoFile(t, scene.cameras[c]);
            target.isOwnMedia = true;
            results[c] = renderVideo(scene, int(c), target, {}, mine);
        });
        for (const auto &result : results) {
            if (!result)
                return result;
        }
        return {};
    }

    Result<void> registerCameras()
    {
        for (const SimulatedCamera &camera : testbed().cameras) {
            RegisterSettings settings;
            settings.camera = camera.name;
            settings.layout = m_layout;
            settings.imageFile = videoFile(0, camera);
            RegisterJob job(std::move(settings));
            if (auto done = runToEnd(job, m_project, {m_control.cancel, {}}); !done)
                return done;
        }
        return {};
    }

    Result<void> addTasks()
    {
        for (const TaskRecord &task : demoTasks()) {
            const auto added = ODO_TRY(m_project.tasks().add(task));
            ODO_TRY(m_project.tasks().setScoring(added.id, demoScoring(task.task)));
        }
        return {};
    }

    Result<void> addRobotAndTeam(const DemoTrial &trial)
    {
        for (const SimulatedRobot &simulated : trial.scene.robots) {
            if (m_project.robots().find(simulated.name))
                continue;
            ODO_TRY(m_project.robots().add(recordOf(simulated)));
        }
        if (!m_project.teams().find(trial.team))
            ODO_TRY(m_project.teams().add({0, trial.team, className}));
        return {};
    }

    Result<void> addTrials()
    {
        for (std::size_t t = 0; t < m_trials.size(); ++t) {
            const DemoTrial &trial = m_trials[t];
            ODO_TRY(addRobotAndTeam(trial));
            ImportSettings settings;
            settings.trial = trial.trial;
            settings.team = trial.team;
            settings.task = trial.task;
            for (const SimulatedRobot &robot : trial.scene.robots)
                settings.robots.push_back(robot.name);
            for (const SimulatedCamera &camera : trial.scene.cameras)
                settings.videos.emplace_back(camera.name, videoFile(t, camera));
            settings.steps = {
                {SyncBy::Given, frameSceneTime(trial.scene, 1, 0) - frameSceneTime(trial.scene, 0, 0)}};
            ImportTrialJob job(std::move(settings));
            if (auto done = runToEnd(job, m_project, {m_control.cancel, {}}); !done)
                return done;
            ODO_TRY(keepTruth(m_project, job.trial(), trial.scene, m_folder / "truth"));
        }
        return {};
    }

    Result<void> trackTrials()
    {
        for (std::size_t t = 0; t < m_trials.size(); ++t) {
            const double share = 0.18 / double(m_trials.size()), from = 0.82 + share * double(t);
            TrackJob job(m_trials[t].trial, {});
            ODO_TRY(runToEnd(job, m_project, partOf(m_control, from, from + share)));
        }
        return {};
    }

    const fs::path m_folder;
    Project &m_project;
    const JobControl &m_control;
    const std::vector<DemoTrial> m_trials;
    std::string m_layout;
};

Result<void> buildIn(const fs::path &folder, const JobControl &control)
{
    auto project = ODO_TRY(Project::create(folder / "demo.odo", "Demo lesson: Year 9 robotics"));
    return DemoMaker(folder, *project, control).make();
}

constexpr std::array<const char *, 4> parts = {"demo.media", "calibration", "truth", "demo.odo"};

/// All of it, or nothing. The first is a folder, created exclusively: of two demos made at once one fails
/// there.
std::error_code moveParts(const fs::path &from, const fs::path &to)
{
    std::error_code problem, ignored;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        files::rename(from / parts[i], to / parts[i], problem);
        for (std::size_t moved = i; problem && moved > 0; --moved)
            files::rename(to / parts[moved - 1], from / parts[moved - 1], ignored);
        if (problem)
            break;
    }
    return problem;
}

Result<void> makeIn(const fs::path &folder, const Message &what, const JobControl &control)
{
    const auto staging = ODO_TRY(TemporaryFolder::make(folder, what));
    ODO_TRY(buildIn(staging->path(), control));
    const std::error_code problem = moveParts(staging->path(), folder);
    return problem ? fail(ErrorCode::Io, what, foreignWords(problem.message()), demoAdvice())
                   : Result<void>();
}

} // namespace

Result<fs::path> makeDemo(const fs::path &folder, const JobControl &control)
{
    const Message what = ODO_TEXT("workflow.demo_in", "demo in '%1'")(Named::file(folder));
    for (const char *name : parts) {
        if (files::exists(folder / name))
            return fail(ErrorCode::AlreadyExists, what,
                        ODO_TEXT("workflow.demo_is_there", "%1 already exists")(Named::file(name)),
                        ODO_TEXT("workflow.open_it_or_elsewhere", "open it, or choose another folder"));
    }
    ODO_TRY(checkNewProject(folder / "demo.odo", what));
    std::error_code problem;
    const bool folderIsNew = files::makeFolders(folder, problem);
    if (problem)
        return fail(ErrorCode::Io, what, foreignWords(problem.message()), demoAdvice());
    if (auto made = makeIn(folder, what, control); !made) {
        if (folderIsNew)
            files::remove(folder); // only when empty
        return tl::unexpected(made.error());
    }
    return folder / "demo.odo";
}

} // namespace odo
