// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/workflow/measured_scene.h"

#include "core/analysis/quantity_curve.h"
#include "core/simulation/renderer.h"
#include "core/video/video_reader.h"
#include "core/workflow/track/settled_views.h"

#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo::test {

namespace {

void compareHeadings(const Profile &profile, const SimulatedScene &scene, SceneMetrics &metrics)
{
    constexpr double halfS = 1e-3;
    const auto headingAt = [&](double timeS) { return scene.robots.front().motion->at(timeS).headingRad; };
    const auto between = [](double a, double b) { return std::remainder(b - a, 2 * std::numbers::pi); };
    const auto headings = headingsOf(profile);
    double count = 0;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        if (!headings[i] || !headings[i]->isOfBody)
            continue;
        const double timeS = sceneTimeOfStamp(scene, 0, profile.samples[i].time),
                     away = between(headingAt(timeS), headings[i]->radians),
                     turnRate = between(headingAt(timeS - halfS), headingAt(timeS + halfS)) / (2 * halfS);
        const auto rate = turnRateOf(profile.points[i]);
        metrics.headingInside += std::abs(away) <= 2 * *headings[i]->sigmaRad;
        metrics.turnRateInside += std::abs(rate->value - turnRate) <= 2 * rate->sigma;
        metrics.headingRmsRad += away * away;
        metrics.turnRateRms += std::pow(rate->value - turnRate, 2);
        count += 1;
    }
    metrics.bodyShare = count / double(headings.size());
    if (count > 0) {
        metrics.headingInside /= count;
        metrics.turnRateInside /= count;
        metrics.headingRmsRad = std::sqrt(metrics.headingRmsRad / count);
        metrics.turnRateRms = std::sqrt(metrics.turnRateRms / count);
    }
    const auto turn = std::ranges::find(profile.metrics, "max_turn_rate", &Metric::name);
    if (turn != profile.metrics.end())
        metrics.fastestTurn = *turn;
}

SceneMetrics compared(const Profile &profile, const SimulatedScene &scene)
{
    SceneMetrics metrics;
    compareHeadings(profile, scene, metrics);
    double count = 0;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        metrics.foundShare += profile.samples[i].position.has_value() / double(profile.points.size());
        const ProfilePoint &point = profile.points[i];
        if (!point.valid)
            continue;
        const MotionState truth =
            scene.robots.front().motion->at(sceneTimeOfStamp(scene, 0, profile.samples[i].time));
        const Eigen::Vector2d off = point.position - truth.position;
        metrics.rmsM += off.squaredNorm();
        metrics.velocityRms += (point.velocity - truth.velocity).squaredNorm();
        metrics.accelerationRms += (point.acceleration - truth.acceleration).squaredNorm();
        metrics.insideShare +=
            (std::abs(off.x()) < 1.96 * point.sigmaXM) + (std::abs(off.y()) < 1.96 * point.sigmaYM);
        count += 1;
    }
    metrics.disagreeShare =
        double(std::ranges::count_if(
            profile.samples,
            [](const Sample &sample) { return hasFlag(sample.flags, SampleFlag::ViewsDisagree); })) /
        double(profile.samples.size());
    metrics.rmsM = std::sqrt(metrics.rmsM / count);
    metrics.velocityRms = std::sqrt(metrics.velocityRms / count);
    metrics.accelerationRms = std::sqrt(metrics.accelerationRms / count);
    metrics.insideShare /= 2 * count;
    metrics.spikes = int(profile.spikes.size());
    return metrics;
}

} // namespace

QString SceneMetrics::words() const
{
    return QStringLiteral("found %1, %2 mm, %3 inside, %4 mm/s, %5 mm/s2, %6 spikes, views disagree in %7, "
                          "heading of the body in %8: %9 mrad, %10 inside, turn rate %11 rad/s, %12 inside, "
                          "fastest %13 ± %14")
        .arg(foundShare, 0, 'f', 3)
        .arg(1e3 * rmsM, 0, 'f', 2)
        .arg(insideShare, 0, 'f', 2)
        .arg(1e3 * velocityRms, 0, 'f', 1)
        .arg(1e3 * accelerationRms, 0, 'f', 0)
        .arg(spikes)
        .arg(disagreeShare, 0, 'f', 2)
        .arg(bodyShare, 0, 'f', 2)
        .arg(1e3 * headingRmsRad, 0, 'f', 1)
        .arg(headingInside, 0, 'f', 2)
        .arg(turnRateRms, 0, 'f', 3)
        .arg(turnRateInside, 0, 'f', 2)
        .arg(fastestTurn ? fastestTurn->value : 0, 0, 'f', 3)
        .arg(fastestTurn ? fastestTurn->sigma.value_or(0) : 0, 0, 'f', 3);
}

Result<std::vector<RegisteredView>> renderedViews(const SimulatedScene &scene,
                                                  const std::filesystem::path &folder)
{
    std::vector<RegisteredView> views;
    for (std::size_t camera = 0; camera < scene.cameras.size(); ++camera) {
        RegisteredView view;
        view.file = folder / (std::to_string(camera) + ".mp4");
        if (auto rendered = renderVideo(scene, int(camera), view.file, {}, {}); !rendered)
            return tl::unexpected(rendered.error());
        const auto reader = VideoReader::open(view.file);
        if (!reader)
            return tl::unexpected(reader.error());
        view.recording.cameraName = scene.cameras[camera].name;
        view.recording.frameTimes = (*reader)->info().frameTimes;
        view.recording.startOffsetS = scene.cameras[camera].startOffsetS - scene.cameras[0].startOffsetS;
        view.floorView = scene.cameras[camera].view;
        views.push_back(std::move(view));
    }
    return views;
}

Result<SceneMetrics> measuredByViews(const SimulatedScene &scene, const std::vector<RegisteredView> &views,
                                     const RobotRecord &robot)
{
    auto tracked = trackAndSettle(views, {robot}, {});
    if (!tracked)
        return tl::unexpected(tracked.error());
    const auto profile = analyse(takeViewTracks(views, tracked->views, 0), shapeOf(robot), {});
    if (!profile)
        return tl::unexpected(profile.error());
    return compared(*profile, scene);
}

Result<SceneMetrics> measuredScene(const SimulatedScene &scene, const std::optional<RgbColour> &colour)
{
    const QTemporaryDir folder;
    const auto views = renderedViews(scene, folder.path().toStdString());
    if (!views)
        return tl::unexpected(views.error());
    RobotRecord robot;
    robot.name = scene.robots.front().name;
    robot.colour = colour;
    return measuredByViews(scene, *views, robot);
}

} // namespace odo::test
