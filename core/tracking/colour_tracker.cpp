// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/colour_tracker.h"

#include "core/tracking/duplicate_detector.h"
#include "core/tracking/robot_follower.h"

#include <utility>

namespace odo {

namespace {

constexpr double leastSaturation =
    8.0;                      ///< code values of 128; paler than that a robot cannot be told from its floor
constexpr double alike = 0.6; ///< overlap of two robots' colours above which colour does not tell them apart

bool sameLayout(const FrameFormat &a, const FrameFormat &b)
{
    return a.width == b.width && a.height == b.height && a.chromaShiftX == b.chromaShiftX &&
           a.chromaShiftY == b.chromaShiftY && a.matrix == b.matrix && a.fullRange == b.fullRange;
}

} // namespace

struct ColourTracker::Impl
{
    std::vector<TrackTarget> targets;
    std::vector<RobotFollower> followers;
    std::vector<Observation> last;
    DuplicateDetector duplicates;
    FrameFormat format{.width = -1};

    ChromaDensity backgroundOf(std::size_t robot, TrackedFrame &frame, const ChromaRect &rect) const;
    bool isTaken(const Candidate &candidate, std::size_t robot) const;
    void followAll(const TrackedFrame &frame);
    void findMissing(TrackedFrame &frame);
    void rebuildTables(TrackedFrame &frame);
};

/// What there is in the picture but the robot, which takes up the rectangle; and the other robots' colours.
ChromaDensity ColourTracker::Impl::backgroundOf(std::size_t robot, TrackedFrame &frame,
                                                const ChromaRect &rect) const
{
    ChromaDensity background = frame.backgroundWithout(rect);
    if (followers.size() == 1)
        return background;
    const ChromaDensity own = followers[robot].model().density();
    for (std::size_t other = 0; other < followers.size(); ++other) {
        if (other == robot)
            continue;
        const ChromaDensity theirs = followers[other].model().density();
        if (own.overlap(theirs) > alike)
            continue;
        for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin)
            background[bin] += theirs[bin];
    }
    return background;
}

/// Whether another robot was already seen where this candidate is.
bool ColourTracker::Impl::isTaken(const Candidate &candidate, std::size_t robot) const
{
    for (std::size_t other = 0; other < last.size(); ++other) {
        const Ellipse &ellipse = last[other].ellipse;
        if (other != robot && last[other].found &&
            (candidate.centrePx - ellipse.centrePx).norm() < ellipse.semiMinorPx)
            return true;
    }
    return false;
}

/// Gives the candidates to the robots, the surest first; no region is given to two.
void ColourTracker::Impl::followAll(const TrackedFrame &frame)
{
    for (RobotFollower &follower : followers) {
        if (follower.isFollowing())
            follower.propose(frame);
    }
    while (true) {
        std::size_t bestRobot = followers.size();
        const Candidate *best = nullptr;
        for (std::size_t robot = 0; robot < followers.size(); ++robot) {
            if (!followers[robot].isFollowing() || last[robot].found)
                continue;
            for (const Candidate &candidate : followers[robot].candidates()) {
                if ((!best || candidate.score > best->score) && !isTaken(candidate, robot)) {
                    best = &candidate;
                    bestRobot = robot;
                }
            }
        }
        if (!best)
            break;
        followers[bestRobot].accept(frame, *best, last[bestRobot]);
    }
}

void ColourTracker::Impl::findMissing(TrackedFrame &frame)
{
    for (std::size_t robot = 0; robot < followers.size(); ++robot) {
        RobotFollower &follower = followers[robot];
        if (last[robot].found)
            continue;
        follower.miss();
        if (follower.isFollowing())
            continue;
        follower.search(frame, backgroundOf(robot, frame, {}));
        for (const Candidate &candidate : follower.candidates()) {
            const ChromaDensity background = backgroundOf(robot, frame, candidate.blob.box.grownBy(3));
            if (!isTaken(candidate, robot) && follower.acceptFound(frame, candidate, background, last[robot]))
                break;
        }
    }
}

void ColourTracker::Impl::rebuildTables(TrackedFrame &frame)
{
    for (std::size_t robot = 0; robot < followers.size(); ++robot) {
        if (followers[robot].wantsTable())
            followers[robot].buildTable(backgroundOf(robot, frame, followers[robot].occupied()));
    }
}

Result<std::unique_ptr<ColourTracker>> ColourTracker::create(std::vector<TrackTarget> targets)
{
    if (targets.empty())
        return fail(ErrorCode::InvalidInput, "Cannot track", "no robot is given",
                    "add a robot with its colour first");
    for (const TrackTarget &target : targets) {
        if (chromaOf(target.colour, FrameFormat{}).norm() < leastSaturation)
            return fail(ErrorCode::InvalidInput, "Cannot track robot " + target.name,
                        "its colour " + target.colour.toString() +
                            " is grey, and only hue tells a robot from the floor",
                        "put a coloured plate on it and tell that colour");
    }
    auto impl = std::make_unique<Impl>();
    for (const TrackTarget &target : targets)
        impl->followers.emplace_back(target.colour);
    impl->targets = std::move(targets);
    return std::unique_ptr<ColourTracker>(new ColourTracker(std::move(impl)));
}

ColourTracker::ColourTracker(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

ColourTracker::~ColourTracker() = default;

std::vector<Observation> ColourTracker::track(const Frame &frame)
{
    Impl &d = *m_impl;
    const bool anew = !sameLayout(d.format, frame.format);
    const bool repeats = d.duplicates.repeatsTheLast(frame) && !anew;
    if (anew) {
        d.format = frame.format;
        for (RobotFollower &follower : d.followers)
            follower.reset(frame.format);
    }
    if (!repeats) {
        TrackedFrame tracked(frame);
        d.last.assign(d.followers.size(), Observation());
        d.followAll(tracked);
        d.findMissing(tracked);
        d.rebuildTables(tracked);
    }
    for (Observation &observation : d.last) {
        observation.frame = frame.index;
        observation.time = frame.time;
        observation.duplicateFrame = repeats;
    }
    return d.last;
}

} // namespace odo
