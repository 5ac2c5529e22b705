// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/frame_continuity.h"

#include "core/base/percentile.h"
#include "core/synchronisation/internal/clean_track.h"
#include "core/synchronisation/internal/leap_fit.h"
#include "core/video/frame_times.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace odo {

namespace {

constexpr double leastSightScore = 0.5;    // of an observation
constexpr std::size_t besideInterval = 12; // positions that are fitted on each side, within
constexpr double besideS = 0.4;
constexpr std::int64_t mostUnseenOfLeap = 1; // frames: in more a board may have hidden the robot
constexpr std::int64_t mostUnseen = 6;       // frames without a position in the interval
constexpr double mostMissing = 15, longestMissingS = 0.55; // frames; over more no cubic follows a robot
// of a leap, in σ, and against how uneven the motion is anyway
constexpr double leastApart = 6, leastBeyond = 6, leastSharpness = 2;
constexpr double clearlyApart = 12, clearSharpness = 5, leastLeapM = 0.05,
                 leastSteps = 1.5; // where nothing explains it
constexpr double leastMotion = 4;  // σ in a usual interval, of a robot that shows time
constexpr double mostMisfit = 4, leastGain = 40, robotsApartSigmas = 4;
constexpr double wholeFrame = 0.15, sharpFrame = 0.25; // of an interval: off a whole number, and the σ
constexpr double mostOffWhole = 0.4;
constexpr double slowNoise = 1.5;   // factor on the σ of white noise, for errors that change slowly
constexpr double sharpShare = 0.1;  // likewise, of a long delay
constexpr double cubicShare = 0.02; // of a delay: σ of how far a cubic follows a robot that long
// of frozen frames: how far one lies from another, which coding adds to, at least and in steps of the robot;
// and the leap against the way at the speed before and after
constexpr double frozenPx = 0.3, mostFrozenPx = 1, frozenShare = 0.1, leastFrozenWay = 0.3,
                 mostFrozenWay = 1.3, mostWayAtOnce = 2.5;
constexpr double abruptShare = 0.5; // of the speed before, in the last step
constexpr std::int64_t fewestFrozen = 3;
constexpr double areaTolerance = 0.06, areaShare = 0.5;
// of a robot that might stop and start from one frame to the next: as its change of velocity is spread over
// an interval, which it would take only a third of
constexpr double hardestMps2 = 3, steadyShare = 0.25, mostSteadyShare = 0.4, steadyNoise = 6;

/// What one robot says of the interval before a frame.
struct RobotWord
{
    LeapTest test;
    std::optional<DelayFit> delay;
    std::int64_t repeats = 0, unseen = 0; ///< frames in it that repeat one, or show nothing
    bool isSameImage = false;             ///< all that repeat are the very same image
    std::int64_t frozen = 0;              ///< frames before it that repeat one, while the robot went on
    double metresPerPx = 0;
    double changeMps2 = 0;  ///< that stops it, or starts it, within an interval
    bool isSameArea = true; ///< as before, by as smooth a course

    bool leaps() const
    {
        const double beyond = test.excessPx.norm();
        return test.apart > leastApart && beyond > leastBeyond * test.noisePx &&
               beyond > leastSharpness * test.irregularPx;
    }
    bool leapsClearly() const { return unseen <= mostUnseenOfLeap && leapsFar(); }
    bool leapsFar() const
    {
        const double beyond = test.excessPx.norm();
        return test.apart > clearlyApart && beyond > clearSharpness * test.irregularPx &&
               beyond > clearlyApart * test.noisePx && beyond > leastSteps * test.fastestPx &&
               beyond * metresPerPx > leastLeapM;
    }
    /// Whether frames were doubled and not the robot stopped for as long.
    bool couldHardlyStop() const
    {
        return moves() && (isSameImage || (changeMps2 > hardestMps2 &&
                                           test.irregularPx < std::clamp(steadyNoise * test.noisePx,
                                                                         steadyShare * test.stepPx,
                                                                         mostSteadyShare * test.stepPx)));
    }
    bool moves() const { return test.stepPx > leastMotion * test.noisePx; }
};

class IntervalSearch
{
public:
    IntervalSearch(const std::vector<FrameTrack> &tracks, const std::vector<Nanoseconds> &frameTimes)
    {
        for (const FrameTrack &track : tracks)
            m_tracks.push_back(cleaned(track));
        m_usualS = toSeconds(spacingOf(frameTimes).usual);
    }

    std::vector<FrameStep> search()
    {
        std::vector<FrameStep> found;
        if (!(m_usualS > 0))
            return found;
        std::set<std::int64_t> open = suspects();
        // what is found is corrected, because it spoils what lies beside it
        while (!open.empty()) {
            std::optional<FrameStep> clearest;
            double most = 0;
            for (const std::int64_t frame : open) {
                double clearness = 0;
                if (auto step = stepBefore(frame, clearness); step && clearness > most) {
                    most = clearness;
                    clearest = std::move(step);
                }
            }
            if (!clearest)
                break;
            open.erase(clearest->frame);
            correct(*clearest);
            found.push_back(std::move(*clearest));
        }
        std::ranges::sort(found, {}, &FrameStep::frame);
        return found;
    }

private:
    /// Frames before which some robot may leap, or stood.
    std::set<std::int64_t> suspects() const
    {
        std::set<std::int64_t> frames;
        for (const CleanTrack &track : m_tracks) {
            const FrameTrack &all = track.positions;
            for (std::size_t i = fewestBeside; i + fewestBeside <= all.size(); ++i) {
                const auto around = aroundInterval(track, i);
                if (!around)
                    continue;
                const Eigen::Vector2d in = (all[i - 1].px - all[i - 2].px) /
                                           double(all[i - 1].frame - all[i - 2].frame),
                                      out = (all[i + 1].px - all[i].px) /
                                            double(all[i + 1].frame - all[i].frame);
                const double frameCount = double(all[i].frame - all[i - 1].frame);
                const Eigen::Vector2d beyond = all[i].px - all[i - 1].px - frameCount * (in + out) / 2;
                const double ofBlow = frameCount * (in - out).norm() / 2;
                if (frameCount > 1 || track.repeatsBefore(i) > 0 ||
                    beyond.norm() > ofBlow + leastBeyond * track.noisePx / 2)
                    frames.insert(all[i].frame);
            }
        }
        return frames;
    }

    /// Nothing where there are too few positions near by.
    static std::optional<AroundInterval> aroundInterval(const CleanTrack &track, std::size_t index)
    {
        const FrameTrack &all = track.positions;
        if (all[index].frame - all[index - 1].frame - track.repeatsBefore(index) > 1 + mostUnseen)
            return std::nullopt;
        AroundInterval around;
        around.noisePx = track.noisePx;
        const auto isNear = [&](std::size_t i, std::size_t of) {
            return std::abs(all[i].frame - all[of].frame) <= std::int64_t(fewestBeside) ||
                   std::abs(all[i].timeS - all[of].timeS) < besideS;
        };
        for (std::size_t i = index; i-- > 0 && around.before.size() < besideInterval && isNear(i, index - 1);)
            around.before.insert(around.before.begin(), {all[i].timeS, all[i].px});
        for (std::size_t i = index;
             i < all.size() && around.behind.size() < besideInterval && isNear(i, index); ++i)
            around.behind.push_back({all[i].timeS, all[i].px});
        if (around.before.size() < fewestBeside || around.behind.size() < fewestBeside)
            return std::nullopt;
        return around;
    }

    std::optional<RobotWord> wordOf(const CleanTrack &track, std::int64_t frame) const
    {
        const FrameTrack &all = track.positions;
        const auto at = std::ranges::lower_bound(all, frame, {}, &FramePosition::frame);
        const auto index = std::size_t(at - all.begin());
        if (at == all.end() || index < fewestBeside || all[index - 1].frame >= frame)
            return std::nullopt;
        const auto around = aroundInterval(track, index);
        if (!around)
            return std::nullopt;
        RobotWord word;
        word.test = leapTest(*around, m_usualS);
        word.repeats = track.repeatsBefore(index);
        word.unseen = all[index].frame - all[index - 1].frame - 1 - word.repeats;
        word.isSameImage = track.isSameImageBefore(index);
        word.metresPerPx = all[index].metresPerPx;
        word.changeMps2 = word.test.stepPx * word.metresPerPx / (m_usualS * m_usualS);
        const double intervalS = all[index].timeS - all[index - 1].timeS;
        if (word.moves())
            word.delay = fitDelay(*around, word.test.noisePx, 0.1 * m_usualS - intervalS,
                                  std::min((mostMissing + 1) * m_usualS, longestMissingS), m_usualS / 3);
        if (word.leapsFar())
            word.frozen = frozenBefore(all, index, word.unseen);
        word.isSameArea = isSameArea(all, index, word.delay ? word.delay->delayS : 0);
        return word;
    }

    /// How many frames before a leap show the robot where the one before them does, if it moved up to there
    /// and leaps about as far as it would have got meanwhile, and farther than it gets in the frames behind
    /// them in which it was not seen, as where a tracker searches for it.
    std::int64_t frozenBefore(const FrameTrack &all, std::size_t index, std::int64_t unseen) const
    {
        if (index + fewestBeside > all.size())
            return 0;
        const auto speedOf = [&](std::size_t from) {
            const std::size_t to = from + fewestBeside - 1;
            return (all[to].px - all[from].px).norm() / (all[to].timeS - all[from].timeS);
        };
        const double behind = speedOf(index),
                     apartPx = std::clamp(frozenShare * behind * m_usualS, frozenPx, mostFrozenPx);
        std::size_t first = index - 1; // that is shown again
        while (first > 0 && (all[first - 1].px - all[index - 1].px).norm() < apartPx)
            --first;
        const std::int64_t frames = all[index].frame - all[first].frame - 1;
        if (first < fewestBeside || frames < fewestFrozen + unseen)
            return 0;
        const double before = speedOf(first + 1 - fewestBeside), fastest = std::max(before, behind),
                     leapPx = (all[index].px - all[first].px).norm(),
                     lengthS = all[index].timeS - all[first].timeS;
        const double stepPx = (all[first].px - all[first - 1].px).norm();
        if (before * m_usualS < frozenPx || stepPx < abruptShare * before * m_usualS)
            return 0;
        if (unseen <= mostUnseenOfLeap)
            return leapPx < mostWayAtOnce * fastest * lengthS ? frames : 0;
        return behind * m_usualS > frozenPx && leapPx < mostFrozenWay * fastest * lengthS &&
                       leapPx > leastFrozenWay * std::min(before, behind) * lengthS &&
                       leapPx > mostFrozenWay * fastest * double(unseen + 1) * m_usualS
                   ? frames
                   : 0;
    }

    bool isSameArea(const FrameTrack &all, std::size_t index, double delayS) const
    {
        const auto logOf = [&](std::size_t i) { // as if seen from one distance
            return std::log(std::max(1e-9, all[i].areaPx * all[i].metresPerPx * all[i].metresPerPx));
        };
        const auto usual = [&](std::size_t from) {
            std::vector<double> areas;
            for (std::size_t i = from; i < from + fewestBeside; ++i)
                areas.push_back(logOf(i));
            return median(std::move(areas));
        };
        const std::size_t first = index - fewestBeside;
        const double change = usual(index) - usual(first);
        const double aroundS = all[index + fewestBeside - 1].timeS - all[first].timeS;
        const double slope = (std::abs(logOf(index - 1) - logOf(first)) +
                              std::abs(logOf(index + fewestBeside - 1) - logOf(index))) /
                             std::max(1e-6, aroundS - (all[index].timeS - all[index - 1].timeS));
        const double ofScale = 2 * std::abs(std::log(all[index].metresPerPx / all[index - 1].metresPerPx));
        return std::abs(change) <
               areaTolerance + areaShare * ofScale + (1 + areaShare) * slope * (aroundS + delayS);
    }

    std::optional<FrameStep> stepBefore(std::int64_t frame, double &clearness) const
    {
        std::vector<RobotWord> words;
        for (const CleanTrack &track : m_tracks)
            if (auto word = wordOf(track, frame))
                words.push_back(std::move(*word));
        const bool isLeap = std::ranges::any_of(words, &RobotWord::leaps);
        // a robot that stood is evidence of its own
        if (!isLeap && std::ranges::none_of(words, [](const RobotWord &word) { return word.repeats > 0; }))
            return std::nullopt;
        for (const RobotWord &word : words)
            clearness = std::max(clearness, word.test.apart);
        if (auto step = delayOf(words, frame); step && (isLeap || step->kind != FrameStep::Kind::Lost))
            return step;
        return isLeap ? leapOf(words, frame) : std::nullopt;
    }

    /// The delay that all robots share, of a whole number of frames.
    std::optional<FrameStep> delayOf(const std::vector<RobotWord> &words, std::int64_t frame) const
    {
        double sum = 0, weights = 0, gain = 0;
        for (const RobotWord &word : words) {
            if (!word.delay || word.delay->misfit > mostMisfit || !word.isSameArea)
                continue;
            const double weight = 1 / (word.delay->sigmaS * word.delay->sigmaS);
            sum += weight * word.delay->delayS;
            weights += weight;
            gain += word.delay->gain;
        }
        if (!(weights > 0) || gain < leastGain)
            return std::nullopt;
        const double delayS = sum / weights,
                     sigmaS = std::hypot(slowNoise / std::sqrt(weights), cubicShare * delayS);
        const auto frames = std::int64_t(std::lround(delayS / m_usualS));
        if (frames == 0 || sigmaS > std::max(sharpFrame * m_usualS, sharpShare * delayS) ||
            std::abs(delayS - double(frames) * m_usualS) >
                std::clamp(3 * sigmaS, wholeFrame * m_usualS, mostOffWhole * m_usualS))
            return std::nullopt;
        for (const RobotWord &word : words) {
            if (word.moves() && !agrees(word, double(frames) * m_usualS))
                return std::nullopt;
            if (word.moves() && frames < 0 && word.repeats != -frames)
                return std::nullopt;
        }
        FrameStep step;
        step.frame = frame;
        step.frames = std::abs(frames);
        fillLeap(words, step);
        step.kind = FrameStep::Kind::Lost;
        if (frames < 0)
            step.kind = std::ranges::any_of(words, &RobotWord::couldHardlyStop) ? FrameStep::Kind::Doubled
                                                                                : FrameStep::Kind::Stood;
        if (step.kind == FrameStep::Kind::Stood)
            return step;
        step.step.lengthS = double(frames) * m_usualS;
        step.step.sigmaS = sigmaS;
        if (frames < 0)
            step.step.squeezedS = -step.step.lengthS;
        return step;
    }

    bool agrees(const RobotWord &word, double delayS) const
    {
        return word.delay && word.delay->misfit <= mostMisfit &&
               std::abs(word.delay->delayS - delayS) <
                   robotsApartSigmas *
                       std::hypot(word.delay->sigmaS, wholeFrame * m_usualS / 2, cubicShare * delayS);
    }

    /// A leap that nothing explains, of all robots that move or of one that is alone.
    std::optional<FrameStep> leapOf(const std::vector<RobotWord> &words, std::int64_t frame) const
    {
        if (!std::ranges::all_of(words, [](const RobotWord &word) {
                return (word.leapsClearly() && word.isSameArea) || word.frozen > 0 || !word.moves();
            }))
            return std::nullopt;
        if (std::ranges::none_of(
                words, [](const RobotWord &word) { return word.leapsClearly() || word.frozen > 0; }))
            return std::nullopt;
        FrameStep step;
        step.frame = frame;
        fillLeap(words, step);
        for (const RobotWord &word : words)
            if (word.frozen > step.frames) {
                step.kind = FrameStep::Kind::Frozen;
                step.frames = word.frozen;
            }
        return step;
    }

    void fillLeap(const std::vector<RobotWord> &words, FrameStep &step) const
    {
        for (const RobotWord &word : words)
            step.leapM = std::max(step.leapM, word.test.excessPx.norm() * word.metresPerPx);
    }

    void correct(const FrameStep &step)
    {
        for (CleanTrack &track : m_tracks)
            for (FramePosition &position : track.positions)
                if (position.frame >= step.frame)
                    position.timeS += step.step.lengthS;
    }

    std::vector<CleanTrack> m_tracks;
    double m_usualS = 0;
};

} // namespace

FrameTrack frameTrack(const FloorView &view, double heightM, const std::vector<Observation> &observations)
{
    FrameTrack track;
    for (const Observation &seen : observations) {
        if (!seen.found || seen.isDamaged || seen.touchesBorder || seen.score < leastSightScore ||
            !seen.ellipse.centrePx.allFinite())
            continue;
        const auto here = view.floorFromPixel(seen.ellipse.centrePx, heightM / 2),
                   beside = view.floorFromPixel(seen.ellipse.centrePx + Eigen::Vector2d(1, 0), heightM / 2);
        if (here && beside)
            track.push_back({seen.frame, toSeconds(seen.time), seen.ellipse.centrePx, seen.areaPx,
                             (*beside - *here).norm(), seen.duplicateFrame});
    }
    return track;
}

std::vector<FrameStep> findFrameSteps(const std::vector<FrameTrack> &tracks,
                                      const std::vector<Nanoseconds> &frameTimes)
{
    std::vector<FrameStep> steps = IntervalSearch(tracks, frameTimes).search();
    for (FrameStep &step : steps) {
        const auto before = std::size_t(std::max<std::int64_t>(1, step.frame)) - 1;
        if (before < frameTimes.size())
            step.step.afterS = toSeconds(frameTimes[before]);
    }
    return steps;
}

ClockRepair repairOf(const std::vector<FrameStep> &steps)
{
    ClockRepair repair;
    for (const FrameStep &step : steps)
        if (step.step.lengthS != 0)
            repair.steps.push_back(step.step);
    return repair;
}

} // namespace odo
