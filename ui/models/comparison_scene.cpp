// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/comparison_scene.h"

#include "ui/models/profile_place.h"

#include <algorithm>

namespace odo {

namespace {

constexpr std::size_t mostFrames = 1000000; // two recordings that lie far apart

Nanoseconds alignedAt(const ComparisonScene &scene, std::size_t run)
{
    return fromSeconds(scene.compared.comparison.runs[run].aligned.timeS);
}

} // namespace

QStringList ComparisonScene::names() const
{
    QStringList names;
    for (std::size_t run = 0; run < runCount(); ++run)
        names << QString::fromStdString(name(run));
    return names;
}

Nanoseconds ComparisonScene::ownTime(std::size_t run, Nanoseconds common) const
{
    return common + alignedAt(*this, run);
}

Nanoseconds ComparisonScene::commonTime(std::size_t run, Nanoseconds own) const
{
    return own - alignedAt(*this, run);
}

std::vector<Nanoseconds> ComparisonScene::frameTimes() const
{
    Nanoseconds first = commonTime(0, profile(0).samples.front().time), last = first;
    for (std::size_t run = 0; run < runCount(); ++run) {
        first = std::min(first, commonTime(run, profile(run).samples.front().time));
        last = std::max(last, commonTime(run, profile(run).samples.back().time));
    }
    const std::vector<Sample> &samples = profile(0).samples;
    const auto intervals = static_cast<std::int64_t>(std::max<std::size_t>(1, samples.size() - 1));
    const Nanoseconds step =
        std::max({(samples.back().time - samples.front().time) / intervals, Nanoseconds(1000000),
                  (last - first) / static_cast<std::int64_t>(mostFrames)});
    std::vector<Nanoseconds> times;
    // The aligned moment is one of them.
    for (Nanoseconds time = -(-first / step) * step; time <= last; time += step)
        times.push_back(time);
    return times;
}

double ComparisonScene::distanceAt(std::size_t run, Nanoseconds common) const
{
    return compared.comparison.runs[run].wayAt(toSeconds(ownTime(run, common))) - compared.comparison.originM;
}

const ProfilePoint *ComparisonScene::pointAt(std::size_t run, Nanoseconds common) const
{
    const std::ptrdiff_t index = pointIndexAt(profile(run), ownTime(run, common));
    return index < 0 ? nullptr : &profile(run).points[static_cast<std::size_t>(index)];
}

Eigen::AlignedBox2d ComparisonScene::floorBounds() const
{
    Eigen::AlignedBox2d box;
    for (const TrialScenePtr &scene : scenes)
        box.extend(scene->floorBounds());
    return box;
}

Result<ComparisonScenePtr> loadComparisonScene(Project &project, const CompareSettings &settings)
{
    auto trials = readComparedTrials(project, settings);
    if (!trials)
        return tl::unexpected(trials.error());
    auto compared = compareTrials(*trials, settings);
    if (!compared)
        return tl::unexpected(compared.error());
    auto result = std::make_shared<ComparisonScene>();
    for (const ComparedTrial &run : trials->runs) {
        auto scene = loadTrialScene(project, run.trial.name);
        if (!scene)
            return tl::unexpected(scene.error());
        std::size_t robot = 0;
        while ((*scene)->robots[robot].robot.id != run.analysis.robot) // the analysis is one of the scene's
            ++robot;
        result->scenes.push_back(std::move(*scene));
        result->robots.push_back(robot);
    }
    result->settings = settings;
    result->trials = std::move(*trials);
    result->compared = std::move(*compared);
    return ComparisonScenePtr(std::move(result));
}

} // namespace odo
