// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/look_rounds.h"

#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/tracking/internal/silhouette_tracker.h"
#include "core/video/video_reader.h"
#include "tests/acceptance/scenes/look_robots.h"
#include "tests/benchmark/cpu_clock.h"
#include "tests/benchmark/opencv_tracking.h"
#include "tests/support/said_error.h"

#include <numbers>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/background_segm.hpp>

namespace odo::test {

namespace {

struct LookClip
{
    std::filesystem::path file;
    std::size_t robots = 1;
};

struct LookRound
{
    double decodeS = 0, trackS = 0, subtractS = 0;
    std::int64_t frames = 0, found = 0;
};

Result<LookClip> provideClip(const std::filesystem::path &folder, std::size_t robots, double durationS)
{
    const LookClip clip{folder / ("looks-" + std::to_string(robots) + ".mkv"), robots};
    if (std::filesystem::exists(clip.file))
        return clip;
    SimulatedScene scene = demoTestbed(std::uint32_t(40 + robots));
    scene.durationS = durationS;
    for (std::size_t i = 0; i < robots; ++i) { // one behind the other, so that none hides another for long
        scene.robots.push_back(robotOfLook(
            Look::Rover, makeEllipseMotion({1.5, 1.1}, 1.15, 0.75, 9,
                                           2 * std::numbers::pi * double(i) / double(robots), 1)));
        scene.robots.back().name += std::to_string(i);
    }
    if (auto rendered = renderVideo(scene, 0, clip.file, {}, {}); !rendered)
        return tl::unexpected(rendered.error());
    return clip;
}

/// Reads a clip's frames, and gives each to a function; tells the time that reading takes.
template <class Take>
double readFrames(const LookClip &clip, const Take &take)
{
    double decodeS = 0;
    const auto reader = VideoReader::open(clip.file);
    while (reader) {
        const double begin = threadCpuS();
        const auto frame = (*reader)->next();
        if (!frame || !*frame)
            break;
        decodeS += workS(begin, threadCpuS());
        take(**frame);
    }
    return decodeS;
}

std::optional<Background> learnedFrom(const LookClip &clip)
{
    BackgroundLearner learner;
    readFrames(clip, [&](const Frame &frame) { learner.add(frame); });
    return learner.learned();
}

/// Tracks as the program does, and then subtracts: the other's model would drive all that the tracker knows
/// out of the processor's caches between two frames.
LookRound runRound(const LookClip &clip, const Background &background)
{
    LookRound round;
    SilhouetteTracker tracker(background, clip.robots);
    round.decodeS = readFrames(clip, [&](const Frame &frame) {
        const double begin = threadCpuS();
        for (const Observation &observation : tracker.track(frame))
            round.found += observation.found;
        round.trackS += workS(begin, threadCpuS());
        ++round.frames;
    });
    const auto subtractor = cv::createBackgroundSubtractorMOG2();
    cv::Mat bgr, mask;
    cv::setNumThreads(1);
    readFrames(clip, [&](const Frame &frame) {
        cv::cvtColor(stackedPlanes(frame), bgr, cv::COLOR_YUV2BGR_I420);
        const double begin = threadCpuS();
        subtractor->apply(bgr, mask);
        round.subtractS += workS(begin, threadCpuS());
    });
    return round;
}

void addMetrics(const LookClip &clip, const std::vector<LookRound> &rounds, std::vector<Measurement> &metrics)
{
    const auto medianOf = [&](const auto &of) {
        std::vector<double> values;
        for (const LookRound &round : rounds)
            values.push_back(of(round));
        return median(std::move(values));
    };
    const auto ms = [&](double LookRound::*part) {
        return QString::number(
            medianOf([&](const LookRound &r) { return 1000 * r.*part / double(r.frames); }), 'f', 3);
    };
    const QString robots = clip.robots == 1 ? QStringLiteral("1 robot of any look")
                                            : QStringLiteral("%1 robots of any look").arg(clip.robots);
    const double leastRatio = clip.robots == 1 ? 25 : 12;
    metrics.push_back({QStringLiteral("MOG2 / work after decoding, ") + robots,
                       medianOf([](const LookRound &r) { return r.subtractS / r.trackS; }),
                       leastRatio,
                       {},
                       {},
                       QStringLiteral("MOG2 %1 ms, track %2 ms; found %3 of %4")
                           .arg(ms(&LookRound::subtractS), ms(&LookRound::trackS))
                           .arg(rounds.front().found)
                           .arg(rounds.front().frames * std::int64_t(clip.robots))});
    metrics.push_back({QStringLiteral("H.264: decode / (decode + track), ") + robots,
                       medianOf([](const LookRound &r) { return r.decodeS / (r.decodeS + r.trackS); }),
                       clip.robots == 1 ? std::optional(0.95) : std::nullopt,
                       {},
                       {},
                       QStringLiteral("decode %1 ms").arg(ms(&LookRound::decodeS))});
}

} // namespace

Result<std::vector<Measurement>> measureLooks(const std::filesystem::path &folder, double durationS,
                                              int rounds)
{
    std::vector<Measurement> metrics;
    for (const std::size_t robots : {std::size_t(1), std::size_t(6)}) {
        const auto clip = provideClip(folder, robots, durationS);
        if (!clip)
            return tl::unexpected(clip.error());
        const auto background = learnedFrom(*clip);
        if (!background)
            return tl::unexpected(
                test::saidError(ErrorCode::Io, clip->file.string(), "cannot be read", "remove it"));
        std::vector<LookRound> all;
        for (int round = 0; round < rounds; ++round)
            all.push_back(runRound(*clip, *background));
        addMetrics(*clip, all, metrics);
    }
    return metrics;
}

} // namespace odo::test
