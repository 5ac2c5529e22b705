// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/colour_tracker.h"

#include "core/tracking/internal/searched_mask.h"
#include "core/tracking/internal/similar_robots.h"
#include "core/tracking/internal/tracked_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

constexpr double leastSaturation =
    8.0;                      ///< code values of 128; a paler robot cannot be distinguished from the floor
constexpr double alike = 0.6; ///< overlap of two robots' colours above which colour does not tell them apart

} // namespace

bool isFoundByColour(const TrackTarget &target)
{
    return target.colour && chromaOf(*target.colour, FrameFormat{}).norm() >= leastSaturation;
}

struct ColourTracker::Impl
{
    std::vector<TrackTarget> targets;
    SearchedArea area;
    std::vector<RobotFollower> followers;
    SimilarRobots similar;
    std::vector<Observation> last;
    DuplicateDetector duplicates;
    FrameFormat format{.width = -1};
    std::vector<double> sharesAlike; ///< of the first frame
    std::vector<std::uint8_t>
        alikes; ///< robots × robots: whether colour cannot distinguish samples of the two

    bool areAlike(std::size_t a, std::size_t b) const { return alikes[a * followers.size() + b] != 0; }
    std::shared_ptr<const BitMask> searchedIn(const Frame &frame) const;
    void compareColours(std::size_t robot);
    void measureShares(TrackedFrame &frame);
    ChromaDensity backgroundOf(std::size_t robot, TrackedFrame &frame, const ChromaRect &rect) const;
    bool isTaken(const Candidate &candidate, std::size_t robot) const;
    bool isHidden(std::size_t robot, const TrackedFrame &frame) const;
    std::vector<std::vector<std::size_t>> groupsOf(const TrackedFrame &frame) const;
    void noteTouching();
    void followAll(const TrackedFrame &frame);
    void followByItself(const TrackedFrame &frame, std::size_t robot);
    void findMissing(TrackedFrame &frame);
    void startAt(TrackedFrame &frame, const RobotSeed &seed);
    void noteFound(std::size_t robot);
    void rebuildTables(TrackedFrame &frame);
    std::optional<PixelRect> neededRegion(double timeS) const;
    bool holdsNeeded(const Frame &frame) const;
};

/// The chroma samples that are searched; null: all.
std::shared_ptr<const BitMask> ColourTracker::Impl::searchedIn(const Frame &frame) const
{
    if (area.isWholeFrame())
        return nullptr;
    const ChromaGrid grid(frame);
    return std::make_shared<const BitMask>(
        searchedSamples(area, {grid.u.width, grid.u.height, grid.offset, grid.scale}));
}

void ColourTracker::Impl::compareColours(std::size_t robot)
{
    alikes.resize(followers.size() * followers.size());
    if (followers.size() == 1)
        return;
    const ColourModel &own = followers[robot].model();
    const ChromaDensity ownNow = own.density();
    for (std::size_t other = 0; other < followers.size(); ++other) {
        if (other == robot)
            continue;
        const ColourModel &theirs = followers[other].model();
        // A learned colour cannot be compared with one that was only given.
        const bool learned = own.isLearned() && theirs.isLearned();
        const double overlap =
            learned ? ownNow.overlap(theirs.density()) : own.givenDensity().overlap(theirs.givenDensity());
        alikes[robot * followers.size() + other] = alikes[other * followers.size() + robot] = overlap > alike;
    }
}

void ColourTracker::Impl::measureShares(TrackedFrame &frame)
{
    const ChromaDensity image = frame.backgroundWithout({});
    for (const RobotFollower &follower : followers)
        sharesAlike.push_back(follower.model().shareAlike(image));
}

/// What the frame shows besides the robot, which fills the rectangle; and the other robots' colours.
ChromaDensity ColourTracker::Impl::backgroundOf(std::size_t robot, TrackedFrame &frame,
                                                const ChromaRect &rect) const
{
    ChromaDensity background = frame.backgroundWithout(rect);
    for (std::size_t other = 0; other < followers.size(); ++other) {
        if (other == robot || areAlike(robot, other))
            continue;
        const ChromaDensity theirs = followers[other].model().densityUnderOtherLight();
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

/// Whether another robot is seen where this one should be.
bool ColourTracker::Impl::isHidden(std::size_t robot, const TrackedFrame &frame) const
{
    const Eigen::Vector2d position = frame.grid().fromLuma(followers[robot].predictedPx(frame));
    for (std::size_t other = 0; other < followers.size(); ++other) {
        if (other != robot && last[other].found &&
            followers[other].occupied().contains(static_cast<int>(position.x()),
                                                 static_cast<int>(position.y())))
            return true;
    }
    return false;
}

void ColourTracker::Impl::noteTouching()
{
    for (std::size_t a = 0; a < followers.size(); ++a) {
        bool touched = false;
        for (std::size_t b = 0; b < followers.size(); ++b)
            touched |= a != b && !followers[a].occupied().clippedTo(followers[b].occupied()).isEmpty();
        followers[a].setTouched(touched);
    }
}

/// The robots that are followed, those together that are near one another and of a like colour.
std::vector<std::vector<std::size_t>> ColourTracker::Impl::groupsOf(const TrackedFrame &frame) const
{
    std::vector<std::vector<std::size_t>> groups;
    std::vector<ChromaRect> windows(followers.size());
    for (std::size_t robot = 0; robot < followers.size(); ++robot) {
        if (!followers[robot].isFollowing() || last[robot].found) // as a person says
            continue;
        windows[robot] = followers.size() > 1 ? followers[robot].windowOf(frame) : ChromaRect();
        std::vector<std::size_t> group{robot};
        const auto isNear = [&](std::size_t other) {
            return areAlike(robot, other) && !windows[robot].clippedTo(windows[other]).isEmpty();
        };
        std::erase_if(groups, [&](const std::vector<std::size_t> &earlier) {
            if (std::none_of(earlier.begin(), earlier.end(), isNear))
                return false;
            group.insert(group.end(), earlier.begin(), earlier.end());
            return true;
        });
        groups.push_back(std::move(group));
    }
    return groups;
}

void ColourTracker::Impl::followByItself(const TrackedFrame &frame, std::size_t robot)
{
    followers[robot].propose(frame);
    for (const Candidate &candidate : followers[robot].candidates()) {
        if (!isTaken(candidate, robot)) {
            followers[robot].accept(frame, candidate, last[robot]);
            return;
        }
    }
}

void ColourTracker::Impl::followAll(const TrackedFrame &frame)
{
    noteTouching();
    for (const std::vector<std::size_t> &group : groupsOf(frame)) {
        if (group.size() == 1) {
            followByItself(frame, group.front());
            continue;
        }
        std::vector<RobotFollower *> robots;
        std::vector<Observation *> observations;
        for (const std::size_t robot : group) {
            robots.push_back(&followers[robot]);
            observations.push_back(&last[robot]);
        }
        similar.follow(frame, robots, observations);
    }
}

void ColourTracker::Impl::findMissing(TrackedFrame &frame)
{
    for (std::size_t robot = 0; robot < followers.size(); ++robot) {
        RobotFollower &follower = followers[robot];
        if (last[robot].found)
            continue;
        follower.miss(isHidden(robot, frame));
        if (follower.isFollowing() || !frame.complete())
            continue;
        follower.search(frame, backgroundOf(robot, frame, {}));
        for (const Candidate &candidate : follower.candidates()) {
            const ChromaDensity background = backgroundOf(robot, frame, candidate.blob.box.grownBy(3));
            if (isTaken(candidate, robot) || !follower.acceptFound(frame, candidate, background, last[robot]))
                continue;
            noteFound(robot);
            break;
        }
    }
}

/// Its colour has become known.
void ColourTracker::Impl::noteFound(std::size_t robot)
{
    compareColours(robot);
    for (std::size_t other = 0; other < followers.size(); ++other)
        if (other != robot)
            followers[other].askForTable();
}

void ColourTracker::Impl::startAt(TrackedFrame &frame, const RobotSeed &seed)
{
    RobotFollower &follower = followers[seed.target];
    const Eigen::Vector2d sample = frame.grid().fromLuma(seed.pixel);
    if (follower.occupied().contains(int(std::lround(sample.x())), int(std::lround(sample.y()))) ||
        !frame.complete()) // it is followed there
        return;
    if (follower.startAt(frame, seed.pixel, backgroundOf(seed.target, frame, {}), last[seed.target]))
        noteFound(seed.target);
}

void ColourTracker::Impl::rebuildTables(TrackedFrame &frame)
{
    for (std::size_t robot = 0; robot < followers.size(); ++robot) {
        if (!followers[robot].wantsTable() || !frame.complete())
            continue;
        compareColours(robot);
        followers[robot].buildTable(backgroundOf(robot, frame, followers[robot].occupied()));
    }
}

std::optional<PixelRect> ColourTracker::Impl::neededRegion(double timeS) const
{
    if (format.width < 0)
        return std::nullopt;
    PixelRect needed;
    for (const RobotFollower &follower : followers) {
        const auto own = follower.neededRegion(format, timeS);
        if (!own)
            return std::nullopt;
        needed = needed.united(*own);
    }
    return needed;
}

/// Whether following can start on the decoded part of the frame.
bool ColourTracker::Impl::holdsNeeded(const Frame &frame) const
{
    if (!frame.validRegion)
        return true;
    const auto needed = neededRegion(toSeconds(frame.time));
    return needed &&
           frame.validRegion->contains(needed->clipped({0, 0, frame.format.width, frame.format.height}));
}

Result<std::unique_ptr<ColourTracker>> ColourTracker::create(std::vector<TrackTarget> targets,
                                                             SearchedArea area)
{
    if (targets.empty())
        return fail(ErrorCode::InvalidInput, ODO_TEXT("tracking.cannot_track", "Cannot track"),
                    ODO_TEXT("tracking.no_robot_given", "no robot is given"),
                    ODO_TEXT("tracking.add_robot", "add a robot with its colour first"));
    for (const TrackTarget &target : targets) {
        if (!isFoundByColour(target))
            return fail(
                ErrorCode::InvalidInput,
                ODO_TEXT("tracking.cannot_track_robot", "Cannot track robot %1")(Named::robot(target.name)),
                ODO_TEXT(
                    "tracking.colour_is_grey",
                    "its colour %1 is grey, and tracking by colour needs a hue that differs from the floor")(
                    target.colour ? target.colour->toString() : std::string()),
                ODO_TEXT("tracking.tell_no_colour", "set no colour; background subtraction then finds it"));
    }
    auto impl = std::make_unique<Impl>();
    for (const TrackTarget &target : targets)
        impl->followers.emplace_back(*target.colour);
    impl->targets = std::move(targets);
    impl->area = std::move(area);
    return std::unique_ptr<ColourTracker>(new ColourTracker(std::move(impl)));
}

ColourTracker::ColourTracker(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

ColourTracker::~ColourTracker() = default;

std::optional<PixelRect> ColourTracker::neededRegion(Nanoseconds time) const
{
    return m_impl->neededRegion(toSeconds(time));
}

const std::vector<double> &ColourTracker::sharesAlike() const
{
    return m_impl->sharesAlike;
}

std::vector<Observation> ColourTracker::track(const Frame &frame, std::span<const RobotSeed> seeds)
{
    Impl &d = *m_impl;
    const bool anew = !sameLayout(d.format, frame.format);
    const bool repeats = d.duplicates.repeatsTheLast(frame) && !anew;
    if (anew) {
        d.format = frame.format;
        const auto searched = d.searchedIn(frame);
        for (RobotFollower &follower : d.followers)
            follower.reset(frame.format, searched);
        for (std::size_t robot = 0; robot < d.followers.size(); ++robot)
            d.compareColours(robot);
    }
    if (!repeats || !seeds.empty()) {
        TrackedFrame tracked(frame);
        d.last.assign(d.followers.size(), Observation());
        if (d.holdsNeeded(frame) || tracked.complete()) {
            if (d.sharesAlike.empty()) // no robot is followed yet, so the frame is whole
                d.measureShares(tracked);
            for (const RobotSeed &seed : seeds)
                d.startAt(tracked, seed);
            d.followAll(tracked);
            d.findMissing(tracked);
            d.rebuildTables(tracked);
        }
    }
    stamp(d.last, frame, repeats);
    return d.last;
}

} // namespace odo
