// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/sync_passport.h"

#include "core/base/units.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double blockS = 0.5; ///< for so long the views' errors go together
constexpr double milli = 1e-3;

void addPairing(const RecordingRecord &first, const RecordingRecord &view, ViewPassport &passport)
{
    const std::vector<Nanoseconds> &times = first.frameTimes;
    double sum = 0, count = 0;
    for (const Nanoseconds frame : view.frameTimes) {
        const Nanoseconds time = clockOf(view).commonTime(frame);
        const auto after = std::ranges::lower_bound(times, time);
        if (after == times.end() || (after == times.begin() && *after != time))
            continue;
        double apart = toSeconds(*after - time);
        if (after != times.begin())
            apart = std::min(apart, toSeconds(time - *(after - 1)));
        sum += apart;
        count += 1;
        passport.mostApartS = std::max(passport.mostApartS, apart);
    }
    passport.meanApartS = count > 0 ? sum / count : 0;
}

std::optional<CurveValue> topSpeed(const std::vector<const Profile *> &profiles)
{
    std::optional<CurveValue> top;
    for (const Profile *profile : profiles)
        for (const Metric &metric : profile->metrics)
            if (metric.name == "max_speed" && (!top || metric.value > top->value))
                top = CurveValue{metric.value, metric.sigma.value_or(0)};
    return top;
}

/// Means over half a second.
struct Block
{
    double speedSquared = 0, apartSquared = 0;
};

std::vector<Block> blocksOf(const std::vector<const Profile *> &profiles)
{
    constexpr int fewestSamples = 3;
    std::vector<Block> blocks;
    for (const Profile *profile : profiles) {
        Block sum;
        int count = 0;
        double begin = 0;
        const auto close = [&] {
            if (count >= fewestSamples)
                blocks.push_back({sum.speedSquared / count, sum.apartSquared / count});
            sum = {};
            count = 0;
        };
        for (std::size_t i = 0; i < std::min(profile->samples.size(), profile->points.size()); ++i) {
            const Sample &sample = profile->samples[i];
            if (!sample.viewDisagreementM || !isUsed(sample) || !profile->points[i].valid)
                continue;
            const double time = toSeconds(sample.time);
            if (count > 0 && time - begin >= blockS)
                close();
            if (count == 0)
                begin = time;
            sum.speedSquared += std::pow(profile->points[i].speedMps, 2);
            sum.apartSquared += std::pow(*sample.viewDisagreementM, 2);
            ++count;
        }
        close();
    }
    return blocks;
}

/// τ² by least squares, and its σ by the scatter of the blocks.
std::optional<CurveValue> squaredTimeError(const std::vector<Block> &blocks)
{
    constexpr std::size_t fewestBlocks = 8;
    constexpr double leastSpread = 0.01; ///< of v², (m/s)⁴: 0.1 m/s beside rest
    if (blocks.size() < fewestBlocks)
        return std::nullopt;
    const auto count = double(blocks.size());
    double meanSpeed = 0, meanApart = 0;
    for (const Block &block : blocks) {
        meanSpeed += block.speedSquared / count;
        meanApart += block.apartSquared / count;
    }
    double spread = 0, product = 0;
    for (const Block &block : blocks) {
        spread += std::pow(block.speedSquared - meanSpeed, 2);
        product += (block.speedSquared - meanSpeed) * (block.apartSquared - meanApart);
    }
    if (spread / count < leastSpread * leastSpread)
        return std::nullopt;
    const double slope = product / spread;
    double scatter = 0;
    for (const Block &block : blocks)
        scatter += std::pow(block.apartSquared - meanApart - slope * (block.speedSquared - meanSpeed), 2);
    return CurveValue{slope, std::sqrt(scatter / (count - 2) / spread)};
}

void addResidual(const std::vector<const Profile *> &profiles, SyncPassport &passport)
{
    const auto squared = squaredTimeError(blocksOf(profiles));
    if (!squared)
        return;
    passport.isResidualSignificant = squared->value > 2 * squared->sigma;
    const double time = std::sqrt(std::max(0.0, squared->value));
    passport.residualS =
        CurveValue{time, passport.isResidualSignificant
                             ? squared->sigma / (2 * time)
                             : std::sqrt(std::max(0.0, squared->value) + squared->sigma) - time};
}

} // namespace

SyncPassport syncPassport(const TrialRecord &trial, const std::vector<const RecordingRecord *> &recordings,
                          const std::vector<const Profile *> &profiles)
{
    SyncPassport passport;
    passport.topSpeedMps = topSpeed(profiles);
    for (std::size_t i = 1; i < recordings.size(); ++i) {
        const RecordingRecord &recording = *recordings[i];
        ViewPassport view;
        view.camera = recording.cameraName;
        view.method = recording.syncMethod;
        view.offsetS = recording.startOffsetS;
        view.clockRate = recording.clockRate;
        addPairing(*recordings.front(), recording, view);
        if (isStepMeasured(recording)) {
            view.sigmaOffsetS = recording.startOffsetSigmaS;
            if (i == 1 && trial.syncRateSigma > 0)
                view.sigmaClockRate = trial.syncRateSigma;
            const double length = recording.frameTimes.empty() ? 0 : toSeconds(recording.frameTimes.back());
            view.sigmaTimeS =
                std::hypot(recording.startOffsetSigmaS, view.sigmaClockRate.value_or(0) * length);
            if (passport.topSpeedMps)
                view.costM = CurveValue{*view.sigmaTimeS * passport.topSpeedMps->value,
                                        *view.sigmaTimeS * passport.topSpeedMps->sigma};
        }
        passport.views.push_back(std::move(view));
    }
    if (!passport.views.empty())
        addResidual(profiles, passport);
    return passport;
}

namespace {

MessageArgument milliseconds(double seconds)
{
    return quantity(seconds / milli, 1, "ms");
}

MessageArgument millimetres(double metres)
{
    return quantity(metres / milli, 1, "mm");
}

MessageArgument speed(const CurveValue &value)
{
    return quantity(value.value, 2, "m/s");
}

Message costSentence(const ViewPassport &view, const SyncPassport &passport)
{
    constexpr double example = 0.01;
    const MessageArgument camera = Named::camera(view.camera);
    if (!passport.topSpeedMps)
        return view.sigmaTimeS
                   ? ODO_TEXT("sync.known_to",
                              "View %1: its times are known to ±%2")(camera, milliseconds(*view.sigmaTimeS))
                   : ODO_TEXT("sync.not_measured", "View %1: nothing has measured its time offset")(camera);
    const MessageArgument top = speed(*passport.topSpeedMps);
    if (!view.costM)
        return ODO_TEXT("sync.cost_of_error",
                        "View %1: nothing has measured its time offset; an error of %2 would shift the robot "
                        "by %3 at the top speed of %4")(
            camera, milliseconds(example), millimetres(example * passport.topSpeedMps->value), top);
    return ODO_TEXT("sync.cost", "View %1: its times are known to ±%2, which is ±%3 at the top speed of %4")(
        camera, milliseconds(*view.sigmaTimeS), millimetres(view.costM->value), top);
}

} // namespace

std::vector<Message> passportSentences(const SyncPassport &passport)
{
    std::vector<Message> sentences;
    for (const ViewPassport &view : passport.views) {
        sentences.push_back(costSentence(view, passport));
        if (view.sigmaClockRate)
            sentences.push_back(ODO_TEXT("sync.drift", "Its clock runs %1 ±%2 faster than the first view's")(
                quantity(view.clockRate * 1e6, 0, "ppm"), quantity(*view.sigmaClockRate * 1e6, 0, "ppm")));
        if (view.mostApartS > 0)
            sentences.push_back(
                ODO_TEXT("sync.pairing",
                         "Its frames are %1 on average and at most %2 from the first view's; positions are "
                         "interpolated to the same times")(milliseconds(view.meanApartS),
                                                           milliseconds(view.mostApartS)));
    }
    if (const auto &residual = passport.residualS; residual && passport.topSpeedMps) {
        const double top = passport.topSpeedMps->value;
        sentences.push_back(
            passport.isResidualSignificant
                ? ODO_TEXT("sync.residual",
                           "The views disagree the more the faster the robot is, as a time error of %1 ±%2 "
                           "would make them: %3 at the top speed")(milliseconds(residual->value),
                                                                   milliseconds(residual->sigma),
                                                                   millimetres(residual->value * top))
                : ODO_TEXT("sync.no_residual",
                           "The views' disagreement does not grow with the speed: a remaining time error is "
                           "at most %1, or %2 at the top speed")(
                      milliseconds(residual->value + 2 * residual->sigma),
                      millimetres((residual->value + 2 * residual->sigma) * top)));
    }
    return sentences;
}

} // namespace odo
