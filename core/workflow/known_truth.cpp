// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/known_truth.h"

#include "core/base/file_system.h"
#include "core/exchange/file_name.h"
#include "core/exchange/text_file.h"
#include "core/files/file_words.h"
#include "core/files/output_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <cmath>

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
        return fail(ErrorCode::Io, folderCalled(folder), foreignWords(problem.message()),
                    chooseWritableFolder());
    for (std::size_t r = 0; r < scene.robots.size(); ++r) {
        const std::string &name = scene.robots[r].name;
        const auto robot = ODO_TRY(project.robots().find(name));
        TruthSeries truth = truthOf(scene, r);
        truth.trial = trial.id;
        truth.robot = robot.id;
        ODO_TRY(project.trials().setTruth(truth));
        ODO_TRY(writeTruthCsv(folder / (fileNameOf(trial.name + "_" + name) + ".csv"), truth));
    }
    return {};
}

namespace {

constexpr Nanoseconds sameTime = std::chrono::microseconds(100);
constexpr double sigmas95 = 1.96;

} // namespace

std::optional<std::size_t> truthAt(const TruthSeries &truth, Nanoseconds time)
{
    const auto after = std::lower_bound(truth.times.begin(), truth.times.end(), time - sameTime);
    if (after == truth.times.end() || *after > time + sameTime)
        return std::nullopt;
    return std::size_t(after - truth.times.begin());
}

TruthAccuracy compareWithTruth(const Profile &profile, const TruthSeries &truth)
{
    TruthAccuracy sum;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        const std::optional<std::size_t> found = truthAt(truth, profile.samples[i].time);
        if (!point.valid || !found)
            continue;
        const std::size_t k = *found;
        const Eigen::Vector2d error = point.position - truth.positions[k];
        ++sum.compared;
        sum.positionRmsM += error.squaredNorm();
        sum.velocityRmsMps += (point.velocity - truth.velocities[k]).squaredNorm();
        sum.accelerationRmsMps2 += (point.acceleration - truth.accelerations[k]).squaredNorm();
        sum.insideX95 += std::abs(error.x()) <= sigmas95 * point.sigmaXM;
        sum.insideY95 += std::abs(error.y()) <= sigmas95 * point.sigmaYM;
        sum.insideSpeed95 +=
            std::abs(point.speedMps - truth.velocities[k].norm()) <= sigmas95 * point.sigmaSpeedMps;
    }
    if (sum.compared == 0)
        return sum;
    const double n = double(sum.compared);
    return {sum.compared,
            std::sqrt(sum.positionRmsM / n),
            std::sqrt(sum.velocityRmsMps / n),
            std::sqrt(sum.accelerationRmsMps2 / n),
            sum.insideX95 / n,
            sum.insideY95 / n,
            sum.insideSpeed95 / n};
}

} // namespace odo
