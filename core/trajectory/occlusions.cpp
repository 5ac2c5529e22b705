// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/occlusions.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace odo {

namespace {

constexpr Nanoseconds longestPause = std::chrono::milliseconds(200),
                      shortestOcclusion = std::chrono::milliseconds(100);
constexpr double touchingRadii = 1.2; // of the sum of two robots' radii: outlines nearer than that may be one

/// What one sample says. other: the robot's number where the cause names one.
struct OcclusionLabel
{
    OcclusionCause cause;
    std::optional<std::size_t> other;
};

bool isUnexplained(OcclusionCause cause)
{
    return cause == OcclusionCause::NotVisible || cause == OcclusionCause::PartlyVisible ||
           cause == OcclusionCause::OutlineTooLarge;
}

/// Samples with like labels, one after the other.
struct OcclusionRun
{
    TimeSpan span;
    std::array<int, 7> counts{}; ///< of each cause
    std::optional<std::size_t> other;
    bool isUnexplained = false, isCut = false;

    bool isOf(const OcclusionLabel &label) const
    {
        return other == label.other && isUnexplained == odo::isUnexplained(label.cause) &&
               isCut == (label.cause == OcclusionCause::CutByEdge);
    }
    /// The first of the causes that occurs says most; of outlines too small and too large, the one that
    /// occurs more often.
    OcclusionCause cause() const
    {
        const auto countOf = [this](OcclusionCause cause) { return counts[static_cast<std::size_t>(cause)]; };
        if (isUnexplained && countOf(OcclusionCause::NotVisible) == 0)
            return countOf(OcclusionCause::OutlineTooLarge) > countOf(OcclusionCause::PartlyVisible)
                       ? OcclusionCause::OutlineTooLarge
                       : OcclusionCause::PartlyVisible;
        return static_cast<OcclusionCause>(std::ranges::find_if(counts, [](int count) { return count > 0; }) -
                                           counts.begin());
    }
};

/// Whether it is known where it was at each sample.
bool isWatched(const OcclusionRobot &robot)
{
    return robot.profile && !robot.profile->samples.empty() &&
           robot.profile->samples.size() == robot.profile->points.size();
}

/// All robots as one view sees them.
class WatchedView
{
public:
    WatchedView(const OcclusionView &view, std::size_t number, std::span<const OcclusionRobot> robots)
        : m_view(view), m_number(number), m_robots(robots)
    {
        for (std::size_t r = 0; r < robots.size(); ++r)
            m_radiiM.push_back(usualRadiusM(r));
    }

    std::vector<OcclusionRun> runsOf(std::size_t robot) const
    {
        std::vector<OcclusionRun> runs;
        const Profile &profile = *m_robots[robot].profile;
        for (std::size_t i = 0; i < profile.samples.size(); ++i) {
            const auto label = labelOf(robot, i);
            if (!label)
                continue;
            const Nanoseconds time = profile.samples[i].time;
            if (runs.empty() || !runs.back().isOf(*label) || time - runs.back().span.end > longestPause)
                runs.push_back({{time, time},
                                {},
                                label->other,
                                isUnexplained(label->cause),
                                label->cause == OcclusionCause::CutByEdge});
            runs.back().span.end = time;
            ++runs.back().counts[static_cast<std::size_t>(label->cause)];
        }
        return runs;
    }

private:
    /// Where the middle of a robot is in the frame, and how large it usually is there.
    struct RobotPosition
    {
        Eigen::Vector2d pixel;
        double radiusPx = 0, distanceM = 0; ///< from the camera
    };

    double focalPx() const { return m_view.floorView->camera().intrinsics().fxPx; }

    std::optional<RobotPosition> positionOf(std::size_t robot, const ProfilePoint &point) const
    {
        const Eigen::Vector3d middle(point.position.x(), point.position.y(),
                                     silhouettePlaneM(m_robots[robot].profile->heightM));
        const auto pixel = point.valid ? m_view.floorView->pixelFromWorld(middle) : std::nullopt;
        if (!pixel)
            return std::nullopt;
        const double distanceM = (middle - m_view.floorView->cameraInWorld()).norm();
        return RobotPosition{*pixel, robot < m_radiiM.size() ? m_radiiM[robot] * focalPx() / distanceM : 0,
                             distanceM};
    }

    /// Where it was searched; one entry a frame, found or not.
    std::span<const Observation> observationsOf(std::size_t robot) const
    {
        return m_number < m_robots[robot].observations.size() ? m_robots[robot].observations[m_number]
                                                              : std::span<const Observation>();
    }

    /// A view that started later or ended earlier hid nothing then.
    bool isRecordedAt(std::size_t robot, Nanoseconds time) const
    {
        const std::span<const Observation> all = observationsOf(robot);
        const Nanoseconds own = m_view.clock.ownTime(time);
        return !all.empty() && own >= all.front().time && own <= all.back().time;
    }

    /// nullptr where it was not found in the frame nearest to a time.
    const Observation *observationAt(std::size_t robot, Nanoseconds time) const
    {
        const std::span<const Observation> all = observationsOf(robot);
        const Nanoseconds own = m_view.clock.ownTime(time);
        auto at = std::ranges::lower_bound(all, own, {}, &Observation::time);
        if (at == all.end() || (at != all.begin() && own - (at - 1)->time < at->time - own))
            at = at == all.begin() ? at : at - 1;
        return at != all.end() && at->found && std::chrono::abs(at->time - own) < shortestOcclusion ? &*at
                                                                                                    : nullptr;
    }

    static double radiusOf(const Observation &observation)
    {
        return std::sqrt(observation.areaPx / std::numbers::pi);
    }

    double usualRadiusM(std::size_t robot) const
    {
        std::vector<double> radiiM;
        const Profile *profile = m_robots[robot].profile;
        for (std::size_t i = 0; profile && i < profile->samples.size(); ++i) {
            const auto position = positionOf(robot, profile->points[i]);
            const Observation *seen = position ? observationAt(robot, profile->samples[i].time) : nullptr;
            if (seen && !seen->touchesBorder)
                radiiM.push_back(radiusOf(*seen) * position->distanceM / focalPx());
        }
        return radiiM.empty() ? 0 : upperMedian(std::move(radiiM));
    }

    /// How far inside the frame a pixel lies; negative outside.
    double insidePx(const Eigen::Vector2d &pixel) const
    {
        const Intrinsics &frame = m_view.floorView->camera().intrinsics();
        return std::min(
            {pixel.x(), pixel.y(), frame.widthPx - 1 - pixel.x(), frame.heightPx - 1 - pixel.y()});
    }

    /// nullopt: the view measured all of it, or has nothing to do with it.
    std::optional<OcclusionLabel> labelOf(std::size_t robot, std::size_t i) const
    {
        const Profile &profile = *m_robots[robot].profile;
        const Sample &sample = profile.samples[i];
        const Observation *seen = observationAt(robot, sample.time);
        const bool isMeasured =
            (sample.views >> m_number & 1) != 0 && !hasFlag(sample.flags, SampleFlag::LowScore);
        // its reason says so
        const bool isElsewhere = seen && hasFlag(sample.flags, SampleFlag::ViewsDisagree);
        if (isMeasured || isElsewhere || !isRecordedAt(robot, sample.time) ||
            hasFlag(sample.flags, SampleFlag::DuplicateFrame))
            return std::nullopt;
        const auto position = positionOf(robot, profile.points[i]);
        if (!position || insidePx(position->pixel) < 0)
            return std::nullopt;
        if (seen ? seen->touchesBorder : insidePx(position->pixel) < position->radiusPx)
            return OcclusionLabel{OcclusionCause::CutByEdge, {}};
        if (const auto label = labelByOther(robot, sample.time, *position, seen))
            return label;
        if (!seen)
            return OcclusionLabel{OcclusionCause::NotVisible, {}};
        return OcclusionLabel{radiusOf(*seen) < position->radiusPx ? OcclusionCause::PartlyVisible
                                                                   : OcclusionCause::OutlineTooLarge,
                              {}};
    }

    /// By the nearest robot whose outline can meet this one's.
    std::optional<OcclusionLabel> labelByOther(std::size_t robot, Nanoseconds time,
                                               const RobotPosition &position, const Observation *seen) const
    {
        std::optional<OcclusionLabel> label;
        double nearest = touchingRadii;
        for (std::size_t other = 0; other < m_robots.size(); ++other) {
            const auto its = other == robot ? std::nullopt : positionAt(other, time);
            const double radii =
                its ? (its->pixel - position.pixel).norm() / (its->radiusPx + position.radiusPx) : nearest;
            if (!(radii < nearest))
                continue;
            nearest = radii;
            const bool isBehind =
                its->distanceM < position.distanceM &&
                (its->pixel - position.pixel).norm() < std::max(its->radiusPx, position.radiusPx);
            label = OcclusionLabel{!isBehind ? OcclusionCause::OneOutline
                                   : seen    ? OcclusionCause::PartlyHiddenBehind
                                             : OcclusionCause::HiddenBehind,
                                   other};
        }
        return label;
    }

    std::optional<RobotPosition> positionAt(std::size_t robot, Nanoseconds time) const
    {
        if (!isWatched(m_robots[robot]))
            return std::nullopt;
        const Profile &profile = *m_robots[robot].profile;
        const auto at = std::ranges::lower_bound(profile.samples, time, {}, &Sample::time);
        return at == profile.samples.end()
                   ? std::nullopt
                   : positionOf(robot,
                                profile.points[static_cast<std::size_t>(at - profile.samples.begin())]);
    }

    const OcclusionView &m_view;
    std::size_t m_number;
    std::span<const OcclusionRobot> m_robots;
    std::vector<double> m_radiiM; ///< of a disc with the usual outline's area
};

/// Where an outline grows or shrinks just before or after it is hidden behind a robot or cut, it is the same
/// event.
std::vector<OcclusionRun> joinedEvents(const std::vector<OcclusionRun> &runs)
{
    std::vector<OcclusionRun> events;
    for (const OcclusionRun &run : runs) {
        const bool follows = !events.empty() && run.span.begin - events.back().span.end <= longestPause;
        if (!follows || (!run.isUnexplained && !events.back().isUnexplained &&
                         (run.other != events.back().other || run.isCut != events.back().isCut))) {
            events.push_back(run);
            continue;
        }
        OcclusionRun &event = events.back();
        const OcclusionRun &named = event.isUnexplained ? run : event;
        OcclusionRun both{
            {event.span.begin, run.span.end}, named.counts, named.other, named.isUnexplained, named.isCut};
        if (event.isUnexplained == run.isUnexplained)
            std::ranges::transform(event.counts, run.counts, both.counts.begin(), std::plus());
        event = both;
    }
    return events;
}

} // namespace

std::string_view occlusionCauseName(OcclusionCause cause)
{
    static constexpr std::array<std::string_view, 7> names{
        "hidden_behind", "partly_hidden_behind", "one_outline",      "cut_by_edge",
        "not_visible",   "partly_visible",       "outline_too_large"};
    return names[static_cast<std::size_t>(cause)];
}

Message occlusionWords(const Occlusion &occlusion)
{
    const MessageArgument other = Named::robot(occlusion.other), view = Named::camera(occlusion.view);
    switch (occlusion.cause) {
    case OcclusionCause::HiddenBehind:
        return ODO_TEXT("trajectory.hidden_behind", "hidden behind %1 in view %2")(other, view);
    case OcclusionCause::PartlyHiddenBehind:
        return ODO_TEXT("trajectory.partly_hidden_behind", "partly hidden behind %1 in view %2")(other, view);
    case OcclusionCause::OneOutline:
        return ODO_TEXT("trajectory.one_outline", "outline merged with %1 in view %2")(other, view);
    case OcclusionCause::CutByEdge:
        return ODO_TEXT("trajectory.cut_by_frames_edge", "cut by the frame's edge in view %1")(view);
    case OcclusionCause::PartlyVisible:
        return ODO_TEXT("trajectory.outline_smaller", "outline smaller than usual in view %1")(view);
    case OcclusionCause::OutlineTooLarge:
        return ODO_TEXT("trajectory.outline_larger", "outline larger than usual in view %1")(view);
    case OcclusionCause::NotVisible:
        break;
    }
    return ODO_TEXT("trajectory.not_visible", "not visible in view %1")(view);
}

Message occlusionSentence(const Occlusion &occlusion)
{
    return ODO_TEXT("trajectory.occlusion_span", "%1 (%2 to %3)")(
        occlusionWords(occlusion), quantity(toSeconds(occlusion.span.begin), 2, "s"),
        quantity(toSeconds(occlusion.span.end), 2, "s"));
}

Message reasonAmong(const std::vector<Occlusion> &occlusions, const Spike &spike)
{
    std::vector<Message> reasons{spike.reason};
    for (const Occlusion &one : occlusions) {
        if (one.span.contains(spike.time))
            reasons.push_back(occlusionWords(one));
    }
    return joined(std::move(reasons), Join::Semicolon);
}

std::vector<std::vector<Occlusion>> findOcclusions(std::span<const OcclusionView> views,
                                                   std::span<const OcclusionRobot> robots)
{
    std::vector<std::vector<Occlusion>> all(robots.size());
    for (std::size_t v = 0; v < views.size(); ++v) {
        if (!views[v].floorView)
            continue;
        const WatchedView watched(views[v], v, robots);
        for (std::size_t r = 0; r < robots.size(); ++r) {
            for (const OcclusionRun &run :
                 isWatched(robots[r]) ? joinedEvents(watched.runsOf(r)) : std::vector<OcclusionRun>()) {
                if (run.span.end - run.span.begin >= shortestOcclusion)
                    all[r].push_back({run.span, run.cause(), views[v].name,
                                      run.other ? robots[*run.other].name : std::string()});
            }
        }
    }
    for (auto &its : all)
        std::ranges::stable_sort(its, {}, [](const Occlusion &one) { return one.span.begin; });
    return all;
}

namespace {

constexpr Nanoseconds longestAtEnd = std::chrono::milliseconds(500);

/// Rejected spikes in between do not show where it is; but mostly spikes is another matter than not seen.
bool mostlyHidden(const std::vector<Sample> &samples, std::size_t begin, std::size_t end)
{
    std::size_t unseen = 0;
    for (std::size_t i = begin; i < end; ++i)
        unseen += !samples[i].position;
    return 2 * unseen > end - begin;
}

Message ofMeasuredPart()
{
    return ODO_TEXT("trajectory.figures_of_seen", "the metrics cover only the measured part");
}

Message gapText(const Sample &left, const Sample *back)
{
    const MessageArgument since = quantity(toSeconds(left.time), 1, "s"),
                          x = quantity(left.position->x(), 2, "m"), y = quantity(left.position->y(), 2, "m");
    return joined(
        {back ? ODO_TEXT("trajectory.unseen_between", "no view sees it from %1 to %2 (it was at X %3, Y %4)")(
                    since, quantity(toSeconds(back->time), 1, "s"), x, y)
              : ODO_TEXT("trajectory.unseen_after", "no view sees it after %1 (it was at X %2, Y %3)")(since,
                                                                                                       x, y),
         ODO_TEXT("trajectory.move_camera", "move or add a camera to cover the whole task"),
         ofMeasuredPart()},
        Join::Semicolon);
}

} // namespace

Message unmeasuredSentence(const TimeSpan &gap)
{
    return joined({ODO_TEXT("trajectory.unmeasured_between", "nothing was measured from %1 to %2")(
                       quantity(toSeconds(gap.begin), 1, "s"), quantity(toSeconds(gap.end), 1, "s")),
                   ofMeasuredPart()},
                  Join::Semicolon);
}

std::vector<Message> describeGaps(const Profile &profile, Nanoseconds longestBridgedGap)
{
    const std::vector<Sample> &samples = profile.samples;
    std::vector<Message> sentences;
    const Sample *last = nullptr;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!isUsed(samples[i]))
            continue;
        const Sample &next = samples[i];
        const auto since = last ? static_cast<std::size_t>(last - samples.data()) + 1 : i;
        if (last && next.time - last->time > longestBridgedGap) {
            if (since == i) // not even a frame
                sentences.push_back(unmeasuredSentence({last->time, next.time}));
            else if (mostlyHidden(samples, since, i))
                sentences.push_back(gapText(*last, &next));
        }
        last = &next;
    }
    if (!last)
        return sentences;
    const auto since = static_cast<std::size_t>(last - samples.data()) + 1;
    if (samples.back().time - last->time > longestAtEnd && mostlyHidden(samples, since, samples.size()))
        sentences.push_back(gapText(*last, nullptr));
    return sentences;
}

} // namespace odo
