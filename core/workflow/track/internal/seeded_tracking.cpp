// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/internal/seeded_tracking.h"

#include "core/video/video_reader.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr int mostMissedBack = 15;     // frames, after which a robot is lost
constexpr int mostMergedBack = 2;      // frames, after which it may leave what it merged with as another
constexpr int leastAgreed = 3;         // frames in a row in which both ways found the same
constexpr double leastSureScore = 0.2; // below it several robots may be one region

double seenRadiusPx(const Observation &seen)
{
    return std::sqrt(std::max(1.0, seen.areaPx) / std::numbers::pi);
}

bool isSameThing(const Observation &a, const Observation &b)
{
    return a.found && b.found &&
           (a.ellipse.centrePx - b.ellipse.centrePx).norm() <
               1 + 0.3 * std::min(seenRadiusPx(a), seenRadiusPx(b));
}

Observation notSeen(const Observation &any)
{
    Observation unseen;
    unseen.frame = any.frame;
    unseen.time = any.time;
    unseen.duplicateFrame = any.duplicateFrame;
    return unseen;
}

/// The frames of a video from one before an index to its first. Those that are damaged are left out.
class FramesBackwards
{
public:
    FramesBackwards(std::unique_ptr<VideoReader> reader, std::int64_t end)
        : m_reader(std::move(reader)), m_end(end)
    {
    }

    Result<std::optional<Frame>> previous()
    {
        while (m_chunk.empty() && m_end > 0)
            ODO_TRY(fill());
        if (m_chunk.empty())
            return std::nullopt;
        Frame frame = std::move(m_chunk.back());
        m_chunk.pop_back();
        return std::optional(std::move(frame));
    }

private:
    /// Decodes the frames before those that were given.
    Result<void> fill()
    {
        constexpr std::int64_t heldBytes = 256 << 20, fewest = 8, most = 120;
        const VideoInfo &info = m_reader->info();
        const std::int64_t bytes =
            std::max<std::int64_t>(1, 3LL * info.format.width * info.format.height / 2);
        const std::int64_t begin =
            std::max<std::int64_t>(0, m_end - std::clamp(heldBytes / bytes, fewest, most));
        ODO_TRY(m_reader->seek(begin));
        for (;;) {
            auto frame = m_reader->next();
            if (!frame && frame.error().code == ErrorCode::Cancelled)
                return tl::unexpected(frame.error());
            if (!frame)
                continue;
            if (!*frame || (*frame)->index >= m_end)
                break;
            if ((*frame)->index >= begin)
                m_chunk.push_back(std::move(**frame));
        }
        m_end = begin;
        return {};
    }

    std::unique_ptr<VideoReader> m_reader;
    std::int64_t m_end;
    std::vector<Frame> m_chunk; ///< in order
};

/// A mark of a robot and the part of its series before it, as indices: behind the mark before.
struct SeedPart
{
    std::size_t robot = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    std::size_t begin = 0, at = 0;
};

std::size_t indexOfFrame(const std::vector<Observation> &observations, std::int64_t frame)
{
    return std::size_t(std::ranges::lower_bound(observations, frame, {}, &Observation::frame) -
                       observations.begin());
}

std::vector<SeedPart> partsOf(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                              const TrackedView &tracked)
{
    std::vector<SeedPart> parts;
    for (std::size_t r = 0; r < robots.size(); ++r) {
        const std::vector<Observation> &observations = tracked.series[r].observations;
        std::vector<PointedOutRobot> own;
        std::ranges::copy_if(view.marks, std::back_inserter(own),
                             [&](const PointedOutRobot &mark) { return mark.robot == robots[r].id; });
        std::ranges::sort(own, {}, &PointedOutRobot::frame);
        std::size_t begin = 0;
        for (const PointedOutRobot &mark : own) {
            const std::size_t at = indexOfFrame(observations, mark.frame);
            if (at < observations.size() && observations[at].frame == mark.frame && observations[at].found)
                parts.push_back({r, mark.pixel, begin, at});
            begin = at + 1;
        }
    }
    return parts;
}

/// What was found backwards of a robot before a mark.
struct FoundBack
{
    std::vector<std::pair<std::size_t, Observation>> seen; ///< indices in the series, from the mark on
    std::size_t down = 0;                                  ///< the last index that was reached
    bool isJoined = false;                                 ///< with what was followed before
};

class BackTracker
{
public:
    BackTracker(const RegisteredView &view, const TrackedView &tracked, const CancelToken &cancel)
        : m_view(view), m_tracked(tracked), m_cancel(cancel)
    {
    }

    Result<FoundBack> follow(const std::vector<TrackTarget> &targets, const SeedPart &part) const
    {
        const auto tracker =
            ODO_TRY(RobotTracker::create(targets, m_tracked.background, m_view.floorView, 0, m_view.area));
        const std::vector<Observation> &forward = m_tracked.series[part.robot].observations;
        auto reader = ODO_TRY(VideoReader::open(m_view.file, m_cancel, knownRecording(m_view.recording)));
        FramesBackwards frames(std::move(reader), forward[part.at].frame + 1);
        FoundBack found;
        found.down = part.at;
        int missed = 0, merged = 0, agreed = 0;
        std::vector<RobotSeed> seeds = seedsAt(part);
        for (;;) {
            if (m_cancel.isCancelled())
                return cancelled(trackingSubject());
            auto frame = ODO_TRY(frames.previous());
            if (!frame)
                return found;
            const std::size_t index = indexOfFrame(forward, frame->index);
            if (index < part.begin)
                return found;
            const Nanoseconds time = timeOfFrame(*frame);
            frame->time = -time; // backwards it rises
            Observation seen = tracker->track(*frame, seeds)[part.robot];
            seeds.clear();
            if (index == part.at || index >= forward.size() || forward[index].frame != frame->index)
                continue;
            const bool isSure = seen.found && seen.score >= leastSureScore;
            missed = seen.found ? 0 : missed + 1;
            merged = seen.found && !isSure ? merged + 1 : 0;
            if (missed > mostMissedBack || merged > mostMergedBack)
                return found;
            if (!isSure)
                continue;
            agreed = isSameThing(seen, forward[index]) ? agreed + 1 : 0;
            found.down = index;
            found.isJoined = agreed >= leastAgreed;
            if (found.isJoined)
                return found;
            seen.time = time;
            found.seen.emplace_back(index, std::move(seen));
        }
    }

private:
    /// The robot by the mark, the others where they were followed: they are taken then.
    std::vector<RobotSeed> seedsAt(const SeedPart &part) const
    {
        std::vector<RobotSeed> seeds{{part.robot, part.pixel}};
        for (std::size_t r = 0; r < m_tracked.series.size(); ++r) {
            const Observation &seen = m_tracked.series[r].observations[part.at];
            if (r != part.robot && seen.found)
                seeds.push_back({r, seen.ellipse.centrePx});
        }
        return seeds;
    }

    Nanoseconds timeOfFrame(const Frame &frame) const
    {
        const auto index = static_cast<std::size_t>(frame.index);
        const std::vector<Nanoseconds> &times = m_view.recording.frameTimes;
        return index < times.size() ? times[index] : frame.time;
    }

    const RegisteredView &m_view;
    const TrackedView &m_tracked;
    const CancelToken &m_cancel;
};

/// From which index on what was followed before the mark was another thing: down to where both ways join, or
/// to where it was last lost or merged with something.
std::size_t firstOfWrong(const std::vector<Observation> &forward, const SeedPart &part, const FoundBack &back)
{
    if (back.isJoined)
        return back.down + leastAgreed;
    std::size_t first = back.down;
    while (first > part.begin && forward[first - 1].found && forward[first - 1].score >= leastSureScore)
        --first;
    return first;
}

void putInstead(const SeedPart &part, const FoundBack &back, bool mayBeOther, TrackedView &tracked)
{
    std::vector<Observation> &own = tracked.series[part.robot].observations;
    const std::size_t from = firstOfWrong(own, part, back);
    if (from >= part.at) // it was followed there all along
        return;
    std::vector<Observation> wrong;
    for (const Observation &one : own)
        wrong.push_back(notSeen(one));
    for (std::size_t i = from; i < part.at; ++i)
        wrong[i] = std::exchange(own[i], notSeen(own[i]));
    for (const auto &[index, seen] : back.seen)
        if (index >= from)
            own[index] = seen;
    if (mayBeOther)
        tracked.others.push_back(std::move(wrong));
    const auto giveUp = [&](std::vector<Observation> &observations) {
        for (const auto &[index, seen] : back.seen)
            if (index >= from && isSameThing(seen, observations[index]))
                observations[index] = notSeen(observations[index]);
    };
    for (std::size_t r = 0; r < tracked.series.size(); ++r)
        if (r != part.robot)
            giveUp(tracked.series[r].observations);
    for (std::vector<Observation> &other : tracked.others)
        giveUp(other);
}

} // namespace

std::vector<RobotSeed> seedsIn(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                               std::int64_t frame)
{
    std::vector<RobotSeed> seeds;
    for (const PointedOutRobot &mark : view.marks) {
        const auto robot = std::ranges::find(robots, mark.robot, &RobotRecord::id);
        if (mark.frame == frame && robot != robots.end())
            seeds.push_back({std::size_t(robot - robots.begin()), mark.pixel});
    }
    return seeds;
}

Result<void> followBackwards(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                             const std::vector<TrackTarget> &targets, TrackedView &tracked,
                             const CancelToken &cancel)
{
    for (const SeedPart &part : partsOf(view, robots, tracked)) {
        const FoundBack back = ODO_TRY(BackTracker(view, tracked, cancel).follow(targets, part));
        putInstead(part, back, !isFoundByColour(targets[part.robot]), tracked);
    }
    return {};
}

} // namespace odo
