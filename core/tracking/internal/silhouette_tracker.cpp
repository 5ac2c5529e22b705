// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/silhouette_tracker.h"

#include "core/geometry/silhouette.h"
#include "core/tracking/internal/robot_expectation.h"
#include "core/tracking/internal/silhouette_finder.h"
#include "core/tracking/internal/silhouette_parts.h"
#include "core/tracking/internal/tracked_frame.h"
#include "core/tracking/observation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double mostCost = 2;     // of a silhouette that may be the robot followed
constexpr double areaSigma = 0.35; // of the area's logarithm, from frame to frame
constexpr int mostMisses = 15;     // frames
// of its usual area: what is larger and covers another robot's position shows both
constexpr double mostAlone = 1.15;
constexpr double mostLostRatio = 3; // of the areas of a robot before and after it was lost
constexpr double mostOfWhole = 0.5; // of a whole's hull: the share of a part that is a body by itself
constexpr double mostOfPart = 0.3;  // of a silhouette's area: what is larger is no part of it
constexpr double mostAlike = 3;     // ratio of the areas of parts that are alike
constexpr int mostBesideAlike = 10; // frames, after which they are parts of one robot
constexpr double scoreOfParts = 0.4;
constexpr int mostBesideOthers = 30;    // frames, after which it may be a part of what they are together
constexpr double leastFirstClear = 0.2; // share that cannot be a shadow
constexpr double shadowShift = 0.3;     // of the radius: by which a shadow may draw the centre
constexpr double leastSizeUncertainty = 0.15; // of the area: what is more moves the centre

struct Followed
{
    MotionPredictor predictor;
    AreaExpectation area;   ///< 0 before it was ever seen
    bool isOfParts = false; ///< found as several silhouettes together
    int besideAlike = 0;    ///< frames in a row in which others like its silhouette were beside it
    int besideOthers = 0;   ///< and in which anything did that may be a part of the same body
    int alone = 0;          ///< and in all, in which nothing did
    int missed = -1;        ///< frames since it was seen; below 0: it is lost or was never found
    int together = 0;       ///< frames for which it has been one silhouette with another robot

    bool isFollowing() const { return missed >= 0; }
    /// What comes beside it later is something else (a person).
    bool isKnownWhole() const { return alone >= mostBesideOthers; }
    double radiusPx() const { return std::sqrt(area.px() / std::numbers::pi); }
};

double costOf(const Followed &robot, const SeenSilhouette &silhouette, double timeS)
{
    if (silhouette.regions > 1 && !robot.isOfParts) // something is beside it
        return mostCost;
    const double sinceS = std::max(0.0, timeS - robot.predictor.lastTimeS());
    const double reach = 0.5 * robot.radiusPx() + 4 + 0.5 * sinceS * robot.predictor.velocity().norm() +
                         2.0 * (robot.missed + robot.together);
    const double away = (silhouette.moments.centrePx - robot.predictor.at(timeS)).norm() / reach;
    const double size =
        silhouette.touchesBorder ? 0 : robot.area.offInLn(silhouette.moments.areaPx2) / (2 * areaSigma);
    return std::hypot(away, std::min(size, 1.5));
}

/// What is a part of something is nothing besides it.
bool isPartOf(const SeenSilhouette &part, const SeenSilhouette &whole)
{
    if (!whole.box.contains(part.box))
        return false;
    if (whole.regions > part.regions)
        return true;
    return part.moments.areaPx2 < mostOfPart * whole.moments.areaPx2 &&
           isWithinSupport(whole.supportPx, whole.moments.centrePx, part.moments.centrePx);
}

bool lies(const PixelRect &box, const Eigen::Vector2d &at)
{
    return at.x() >= box.x0 && at.x() < box.x1 && at.y() >= box.y0 && at.y() < box.y1;
}

/// What a person means by a pixel: of several silhouettes that hold it the smallest.
std::vector<SeenSilhouette>::const_iterator silhouetteAt(const std::vector<SeenSilhouette> &seen,
                                                         const Eigen::Vector2d &pixel)
{
    constexpr double besidePx = 4;
    auto there = seen.end();
    for (auto one = seen.begin(); one != seen.end(); ++one) {
        if (isWithinSupport(one->supportPx, one->moments.centrePx, pixel, besidePx) &&
            (there == seen.end() || one->moments.areaPx2 < there->moments.areaPx2))
            there = one;
    }
    return there;
}

/// Whether a mean colour is mostly one: parts without a colour only draw it toward grey.
bool isMostly(const Chroma &mean, const Chroma &colour)
{
    constexpr double leastChroma = 6, leastCosine = 0.8;
    return mean.norm() > leastChroma && mean.dot(colour) > leastCosine * mean.norm() * colour.norm();
}

} // namespace

struct SilhouetteTracker::Impl
{
    SilhouetteFinder finder;
    SearchedArea area;
    std::vector<Followed> robots; ///< and what else is followed
    std::size_t given = 0;        ///< how many of them robots are
    std::vector<Observation> last;
    DuplicateDetector duplicates;
    std::optional<FloorView> floor;
    std::vector<SeenSilhouette> wholes, besides; ///< of the frame: of parts that are alike, and of others

    std::vector<bool> leaveTogether(std::vector<SeenSilhouette> &seen, double timeS);
    void takeWholeInstead(Followed &robot, SeenSilhouette &taken) const;
    void uncertainPart(Followed &robot, SeenSilhouette &taken) const;
    void assign(const Frame &frame, std::vector<SeenSilhouette> seen, std::span<const SilhouetteCue> cues,
                std::span<const RobotSeed> seeds);
    void addWholes(std::vector<SeenSilhouette> &seen);
    void accept(Followed &robot, const SeenSilhouette &silhouette, double timeS, Observation &observation);
};

void SilhouetteTracker::Impl::accept(Followed &robot, const SeenSilhouette &silhouette, double timeS,
                                     Observation &observation)
{
    const double areaPx = silhouette.moments.areaPx2;
    const bool isNew = !robot.isFollowing();
    if (isNew) {
        robot.predictor.start(silhouette.moments.centrePx, timeS);
        robot.area.start(areaPx);
        robot.isOfParts = silhouette.regions > 1;
    } else {
        robot.predictor.update(silhouette.moments.centrePx, timeS);
    }
    robot.missed = robot.together = 0;
    observation.found = true;
    observation.touchesBorder = silhouette.touchesBorder;
    observation.ellipse = ellipseOf(silhouette.moments.centrePx, silhouette.moments.covariancePx2);
    observation.centreCovariancePx2 = silhouette.centreCovariancePx2;
    observation.areaPx = areaPx;
    observation.supportPx = silhouette.supportPx;
    observation.meanChroma = silhouette.meanChroma;
    observation.isTrimmed = silhouette.isTrimmed;
    observation.shadowAmbiguity = silhouette.shadowAmbiguity;
    if (silhouette.clearShare < leastFirstClear) { // the robot and its shadow look alike
        const double shift = shadowShift * robot.radiusPx();
        observation.centreCovariancePx2 += Eigen::Matrix2d::Identity() * shift * shift;
    }
    const double off = robot.area.offInLn(areaPx);
    if (off > leastSizeUncertainty) { // something hides a part of it, or has grown together with it
        const double shift = std::min(off, 1.0) * robot.radiusPx();
        observation.centreCovariancePx2 += Eigen::Matrix2d::Identity() * shift * shift;
    }
    observation.score = std::exp(-0.5 * off * off / (areaSigma * areaSigma));
    if (robot.isOfParts) // what lies between and beyond them is not seen: its outline shows no solid
        observation.score *= scoreOfParts;
    robot.area.follow(areaPx, silhouette.touchesBorder);
}

/// Adds what parts may be together: before them, where they are alike (wheels) and none of them is most of
/// it, for then it is the likelier robot.
void SilhouetteTracker::Impl::addWholes(std::vector<SeenSilhouette> &seen)
{
    wholes.clear();
    besides.clear();
    if (given > 1) // whose parts are beside those of others
        return;
    for (const std::vector<std::size_t> &parts : groupsOfParts(seen)) {
        SeenSilhouette whole = joined(seen, parts);
        if (floor && isTooLargeForRobot(*floor, whole.box))
            continue;
        double largest = 0, smallest = whole.moments.areaPx2;
        for (const std::size_t part : parts) {
            largest = std::max(largest, seen[part].moments.areaPx2);
            smallest = std::min(smallest, seen[part].moments.areaPx2);
        }
        const bool isLikely = largest < mostOfWhole * whole.moments.areaPx2 && largest < mostAlike * smallest;
        (isLikely ? wholes : besides).push_back(std::move(whole));
    }
    seen.insert(seen.begin(), wholes.begin(), wholes.end());
    seen.insert(seen.end(), besides.begin(), besides.end());
}

/// What has long gone along beside something else may be a part of what both are: then the whole's middle is
/// the robot's.
void SilhouetteTracker::Impl::uncertainPart(Followed &robot, SeenSilhouette &taken) const
{
    const auto contains = [&taken](const SeenSilhouette &one) {
        return one.box.contains(taken.box) && one.regions > taken.regions;
    };
    const SeenSilhouette *whole = nullptr;
    for (const auto *all : {&wholes, &besides})
        if (const auto found = std::ranges::find_if(*all, contains); !whole && found != all->end())
            whole = &*found;
    robot.besideOthers = whole ? robot.besideOthers + 1 : 0;
    robot.alone += whole ? 0 : 1;
    if (robot.besideOthers < mostBesideOthers || robot.isKnownWhole())
        return;
    const Eigen::Vector2d away = whole->moments.centrePx - taken.moments.centrePx;
    taken.centreCovariancePx2 += away * away.transpose();
}

/// What goes along beside others like it is one part of a robot (a wheel), though it was found alone.
void SilhouetteTracker::Impl::takeWholeInstead(Followed &robot, SeenSilhouette &taken) const
{
    const auto whole = std::ranges::find_if(
        wholes, [&taken](const SeenSilhouette &one) { return one.box.contains(taken.box); });
    const bool isPart = taken.regions == 1 && whole != wholes.end();
    robot.besideAlike = isPart ? robot.besideAlike + 1 : 0;
    if (robot.besideAlike < mostBesideAlike || robot.isKnownWhole())
        return;
    taken = *whole;
    robot = Followed(); // what was known of it was of a part
}

/// A silhouette that shows several robots as one is none of them: it is removed, and they are expected in it
/// until they part. Returns for each robot whether it is in one.
std::vector<bool> SilhouetteTracker::Impl::leaveTogether(std::vector<SeenSilhouette> &seen, double timeS)
{
    std::vector<bool> isTogether(robots.size());
    std::erase_if(seen, [&](const SeenSilhouette &one) {
        std::vector<std::size_t> within;
        double largestPx = 0;
        for (std::size_t r = 0; r < robots.size(); ++r) {
            if (!robots[r].isFollowing() || last[r].found || !lies(one.box, robots[r].predictor.at(timeS)))
                continue;
            within.push_back(r);
            largestPx = std::max(largestPx, robots[r].area.px());
        }
        // it was a part of another
        std::erase_if(within, [&](std::size_t r) { return robots[r].area.px() < mostOfPart * largestPx; });
        if (within.size() < 2 || one.moments.areaPx2 < mostAlone * largestPx)
            return false;
        for (const std::size_t robot : within) {
            ++robots[robot].together;
            isTogether[robot] = true;
        }
        return true;
    });
    return isTogether;
}

void SilhouetteTracker::Impl::assign(const Frame &frame, std::vector<SeenSilhouette> seen,
                                     std::span<const SilhouetteCue> cues, std::span<const RobotSeed> seeds)
{
    const double timeS = toSeconds(frame.time);
    const auto take = [&](std::size_t robot, std::size_t silhouette) {
        SeenSilhouette taken = std::move(seen[silhouette]);
        seen.erase(seen.begin() + std::ptrdiff_t(silhouette));
        takeWholeInstead(robots[robot], taken);
        uncertainPart(robots[robot], taken);
        std::erase_if(seen, [&taken](const SeenSilhouette &one) {
            return isPartOf(one, taken) || isPartOf(taken, one);
        });
        accept(robots[robot], taken, timeS, last[robot]);
    };
    for (const RobotSeed &seed : seeds) {
        const auto there = silhouetteAt(seen, seed.pixel);
        if (there == seen.end())
            continue;
        Followed &robot = robots[seed.target];
        if (!robot.isFollowing() || costOf(robot, *there, timeS) >= mostCost)
            robot = Followed();
        take(seed.target, std::size_t(there - seen.begin()));
    }
    const auto cueOf = [cues](std::size_t robot) {
        return robot < cues.size() ? cues[robot] : SilhouetteCue();
    };
    for (std::size_t r = 0; r < robots.size(); ++r) {
        const Observation *coloured = cueOf(r).coloured;
        if (!coloured || !coloured->found || last[r].found)
            continue;
        const auto own = std::ranges::find_if(seen, [coloured](const SeenSilhouette &one) {
            return lies(one.box, coloured->ellipse.centrePx);
        });
        if (own != seen.end())
            take(r, std::size_t(own - seen.begin()));
    }
    const std::vector<bool> isTogether = leaveTogether(seen, timeS);
    while (true) { // the likeliest pair first
        double least = mostCost;
        std::size_t robot = 0, silhouette = 0;
        for (std::size_t r = 0; r < robots.size(); ++r) {
            for (std::size_t s = 0;
                 robots[r].isFollowing() && !last[r].found && !isTogether[r] && s < seen.size(); ++s) {
                if (const double cost = costOf(robots[r], seen[s], timeS); cost < least) {
                    least = cost;
                    robot = r;
                    silhouette = s;
                }
            }
        }
        if (least >= mostCost)
            break;
        take(robot, silhouette);
    }
    for (std::size_t r = 0; r < robots.size(); ++r) {
        if (last[r].found || isTogether[r])
            continue;
        if (robots[r].isFollowing() && ++robots[r].missed <= mostMisses)
            continue;
        robots[r].missed = -1;
        if (r >= given) // any other may be next
            robots[r] = Followed();
        const auto fits = [&](const SeenSilhouette &one) {
            const double ratio = robots[r].area.px() > 0 ? one.moments.areaPx2 / robots[r].area.px() : 1;
            if (cueOf(r).coloured && !isMostly(one.meanChroma, cueOf(r).colour))
                return false;
            return !one.touchesBorder && ratio < mostLostRatio && ratio > 1 / mostLostRatio;
        };
        if (const auto first = std::ranges::find_if(seen, fits); first != seen.end())
            take(r, std::size_t(first - seen.begin()));
    }
}

SilhouetteTracker::SilhouetteTracker(Background background, std::size_t robots,
                                     std::optional<FloorView> floor, std::size_t others, SearchedArea area)
    : m_impl(new Impl{SilhouetteFinder(std::move(background), area),
                      std::move(area),
                      std::vector<Followed>(robots + others),
                      robots,
                      {},
                      {},
                      std::move(floor),
                      {},
                      {}})
{
}

SilhouetteTracker::~SilhouetteTracker() = default;

void SilhouetteTracker::setBackground(Background background)
{
    m_impl->finder = SilhouetteFinder(std::move(background), m_impl->area);
    // what was followed may have been where a robot was: if it is gone, it is searched at once
    for (Followed &robot : m_impl->robots)
        robot.missed = robot.isFollowing() ? mostMisses : robot.missed;
}

std::vector<Observation> SilhouetteTracker::track(const Frame &frame, std::span<const Observation> elsewhere,
                                                  std::span<const SilhouetteCue> cues,
                                                  std::span<const RobotSeed> seeds)
{
    Impl &d = *m_impl;
    const bool repeats = d.duplicates.repeatsTheLast(frame);
    if (!repeats || !seeds.empty()) {
        d.last.assign(d.robots.size(), Observation());
        if (const auto whole = wholeFrame(frame)) {
            std::vector<SeenSilhouette> seen = d.finder.find(*whole);
            std::erase_if(seen, [&](const SeenSilhouette &one) {
                if (d.floor && isTooLargeForRobot(*d.floor, one.box))
                    return true;
                return std::ranges::any_of(elsewhere, [&](const Observation &other) {
                    return other.found && lies(one.box, other.ellipse.centrePx);
                });
            });
            d.addWholes(seen);
            d.assign(frame, std::move(seen), cues, seeds);
        }
    }
    stamp(d.last, frame, repeats);
    return d.last;
}

namespace {

constexpr double largestM = 1.2; // of what counts as a robot

} // namespace

std::optional<SizeOnFloor> sizeOnFloor(const FloorView &view, const PixelRect &box)
{
    const double middleX = (box.x0 + box.x1 - 1) / 2.0, bottomY = box.y1 - 1;
    const auto foot = view.floorFromPixel({middleX, bottomY}, 0),
               left = view.floorFromPixel({double(box.x0), bottomY}, 0);
    const auto right = view.floorFromPixel({double(box.x1 - 1), bottomY}, 0);
    if (!foot || !left || !right)
        return std::nullopt;
    const Eigen::Vector3d camera = view.cameraInWorld();
    const auto farEnd = view.floorFromPixel({middleX, double(box.y0)}, 0);
    // The ray of its upper edge above its foot; one that never meets the floor passes above the camera's
    // height.
    const double footAway = (*foot - camera.head<2>()).norm();
    const double heightM =
        farEnd ? camera.z() * (1 - footAway / std::max(footAway, (*farEnd - camera.head<2>()).norm()))
               : camera.z();
    const double depthM = farEnd ? (*farEnd - *foot).norm() : HUGE_VAL;
    return SizeOnFloor{(*right - *left).norm(), std::min(depthM, heightM)};
}

bool isTooLargeForRobot(const FloorView &view, const PixelRect &box)
{
    const auto size = sizeOnFloor(view, box);
    return size && std::max(size->widthM, size->reachM) > largestM;
}

} // namespace odo
