// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/truth_files.h"

#include "core/base/file_system.h"
#include "core/exchange/file_name.h"
#include "core/exchange/text_file.h"
#include "core/files/output_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

Result<void> writeTruthCsv(const std::filesystem::path &file, const TruthSeries &truth)
{
    std::string text = "t_s,x_mm,y_mm,vx_mm_s,vy_mm_s,ax_mm_s2,ay_mm_s2\n";
    for (std::size_t i = 0; i < truth.times.size(); ++i) {
        text += numberText(toSeconds(truth.times[i]));
        for (const Eigen::Vector2d &pair : {truth.positions[i], truth.velocities[i], truth.accelerations[i]})
            text += ',' + numberText(toMillimetres(pair.x())) + "," + numberText(toMillimetres(pair.y()));
        text += "\n";
    }
    return writeOutput(file, text);
}

} // namespace

TruthSeries truthOf(const SimulatedScene &scene, std::size_t robot)
{
    TruthSeries truth;
    for (std::int64_t frame = 0; frame < frameCount(scene, 0); ++frame) {
        const MotionState state = scene.robots[robot].motion->at(frameSceneTime(scene, 0, frame));
        truth.times.push_back(frameStamp(scene, 0, frame));
        truth.positions.push_back(state.position);
        truth.velocities.push_back(state.velocity);
        truth.accelerations.push_back(state.acceleration);
    }
    return truth;
}

Result<void> keepTruth(Project &project, const TrialRecord &trial, const SimulatedScene &scene,
                       const std::filesystem::path &folder)
{
    std::error_code problem;
    files::makeFolders(folder, problem);
    if (problem)
        return fail(ErrorCode::Io, "folder '" + folder.string() + "'", problem.message(), "choose a folder that you may write to");
    for (std::size_t r = 0; r < scene.robots.size(); ++r) {
        const std::string &name = scene.robots[r].name;
        const auto robot = project.robots().find(name);
        if (!robot)
            return tl::unexpected(robot.error());
        TruthSeries truth = truthOf(scene, r);
        truth.trial = trial.id;
        truth.robot = robot->id;
        if (auto stored = project.trials().setTruth(truth); !stored)
            return stored;
        if (auto written = writeTruthCsv(folder / (fileNameOf(trial.name + "_" + name) + ".csv"), truth); !written)
            return written;
    }
    return {};
}

} // namespace odo
