// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/settled_views.h"

#include "core/tracking/colour_tracker.h"
#include "core/trajectory/solid_choice.h"
#include "core/trajectory/view_disagreement.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace odo {

namespace {

std::vector<PointedOut> pointedOutIn(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                                     const std::vector<PointedOutRobot> &all)
{
    std::vector<PointedOut> here;
    for (const PointedOutRobot &one : all) {
        const auto robot = std::ranges::find(robots, one.robot, &RobotRecord::id);
        if (one.recording == view.recording.id && robot != robots.end())
            here.push_back({static_cast<std::size_t>(robot - robots.begin()), one.frame, one.pixel});
    }
    return here;
}

Error nothingThere(const RegisteredView &view, const PointedOut &given, const RobotRecord &robot)
{
    const auto frame = static_cast<std::size_t>(given.frame);
    const double timeS = frame < view.recording.frameTimes.size()
                             ? toSeconds(clockOf(view.recording).commonTime(view.recording.frameTimes[frame]))
                             : 0;
    return {ErrorCode::InvalidInput,
            ODO_TEXT("workflow.robot_in_view", "robot '%1' in view '%2'")(
                Named::robot(robot.name), Named::camera(view.recording.cameraName)),
            ODO_TEXT("workflow.nothing_stands_out", "no foreground object was found at pixel %1,%2 at %3")(
                quantity(given.pixel.x(), 0), quantity(given.pixel.y(), 0), quantity(timeS, 2, "s")),
            ODO_TEXT("workflow.point_out_whole_robot",
                     "point it out where the whole robot is visible and moving")};
}

} // namespace

NamedRobot namedRobot(const RobotRecord &robot)
{
    return {isFoundByColour({robot.name, robot.colour}) ? robot.colour : std::nullopt,
            shapeOf(robot).heightM};
}

Result<std::vector<NameAmbiguity>> settleNames(const std::vector<RegisteredView> &views,
                                               const std::vector<RobotRecord> &robots,
                                               std::vector<TrackedView> &tracked,
                                               const std::vector<PointedOutRobot> &pointedOut)
{
    std::vector<NamedRobot> named;
    for (const RobotRecord &robot : robots)
        named.push_back(namedRobot(robot));
    std::vector<NamedView> seen;
    for (std::size_t v = 0; v < views.size(); ++v) {
        NamedView &view = seen.emplace_back();
        view.floorView = views[v].floorView;
        view.startOffset = fromSeconds(views[v].recording.startOffsetS);
        view.clockRate = views[v].recording.clockRate;
        for (ObservationSeries &series : tracked[v].series)
            view.robots.push_back(std::move(series.observations));
        view.others = std::move(tracked[v].others);
        view.pointedOut = pointedOutIn(views[v], robots, pointedOut);
    }
    NameOutcome outcome = assignNames(seen, named);
    if (!outcome.nothingThere.empty()) {
        const auto &[view, number] = outcome.nothingThere.front();
        const PointedOut &given = seen[view].pointedOut[number];
        return tl::unexpected(nothingThere(views[view], given, robots[given.robot]));
    }
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t r = 0; r < robots.size(); ++r)
            tracked[v].series[r].observations = std::move(seen[v].robots[r]);
    }
    for (std::size_t r = 0; r < robots.size(); ++r) {
        std::vector<std::vector<Observation> *> its;
        for (TrackedView &view : tracked)
            its.push_back(&view.series[r].observations);
        uncertaintyUntrimmed(its);
    }
    return std::move(outcome.ambiguities);
}

std::vector<std::vector<AmbiguousName>> ambiguousNamesOf(const std::vector<NameAmbiguity> &ambiguities,
                                                         const std::vector<RobotRecord> &robots)
{
    std::vector<std::vector<AmbiguousName>> all(robots.size());
    for (const NameAmbiguity &ambiguity : ambiguities) {
        AmbiguousName &stored = all[ambiguity.robot].emplace_back();
        stored.from = fromSeconds(ambiguity.fromS);
        stored.to = fromSeconds(ambiguity.toS);
        for (const std::size_t other : ambiguity.others) {
            stored.others.push_back(robots[other].id);
            stored.otherNames.push_back(robots[other].name);
        }
    }
    return all;
}

double ambiguousSeconds(const std::vector<AmbiguousName> &ambiguities)
{
    double seconds = 0;
    for (const AmbiguousName &ambiguity : ambiguities)
        seconds += toSeconds(ambiguity.to - ambiguity.from);
    return seconds;
}

namespace {

// each is tried where the one before it is better than what was known
constexpr float darkerShadows[] = {0.20F, 0.15F}, lighterShadows[] = {0.55F, 0.7F};
constexpr double leastAmbiguity = 0.1; // share of a robot's pixels, over the frames
constexpr double goodMisfit = 0.5;     // a quarter of a pixel
constexpr double less = 0.98;          // of the misfit
constexpr double clearlyLess = 0.9;    // where a shadow could as well be part of a robot that does not turn
constexpr double nearlyAsOften = 0.9;  // of the frames in which it was found
constexpr double firstPart = 0.7, nextPart = 0.1;

/// What was tracked of one robot.
struct Outlines
{
    std::size_t robot = 0;
    double found = 0;             ///< observations
    std::optional<double> misfit; ///< of the solid that explains their outlines best
};

/// The mean of one kind of ambiguity of a robot's outlines; 0 where it was measured by its colour.
class MeanAmbiguity
{
public:
    explicit MeanAmbiguity(float ShadowAmbiguity::*share) : m_share(share) {}
    void add(const std::vector<Observation> &observations)
    {
        for (const Observation &one : observations) {
            m_found += one.found;
            m_sum += one.found ? double(one.shadowAmbiguity.*m_share) : 0;
        }
    }
    double value() const { return m_sum / std::max(1.0, m_found); }

private:
    float ShadowAmbiguity::*m_share;
    double m_found = 0, m_sum = 0;
};

double meanAmbiguity(const std::vector<TrackedView> &tracked, std::size_t robot,
                     float ShadowAmbiguity::*share)
{
    MeanAmbiguity mean(share);
    for (const TrackedView &view : tracked)
        mean.add(view.series[robot].observations);
    return mean.value();
}

/// Whether what was followed in some view is in parts that a shadow connects: any of it may be the robot.
bool isInParts(const std::vector<TrackedView> &tracked)
{
    return std::ranges::any_of(tracked, [](const TrackedView &view) {
        MeanAmbiguity mean(&ShadowAmbiguity::apart);
        for (const ObservationSeries &series : view.series)
            mean.add(series.observations);
        for (const std::vector<Observation> &other : view.others)
            mean.add(other);
        return mean.value() > leastAmbiguity;
    });
}

Outlines outlinesOf(const std::vector<RegisteredView> &views, const std::vector<RobotRecord> &robots,
                    std::vector<TrackedView> &tracked, std::size_t robot)
{
    Outlines outlines{robot, 0, {}};
    for (const TrackedView &view : tracked)
        outlines.found += double(std::ranges::count_if(view.series[robot].observations, &Observation::found));
    std::vector<ViewTrack> tracks = takeViewTracks(views, tracked, robot);
    outlines.misfit = misfitOfOutlines(tracks, shapeOf(robots[robot]));
    returnObservations(std::move(tracks), tracked, robot);
    return outlines;
}

/// Robots of which much may be such a shadow, and whose outlines are not explained well already.
/// misfitOfNone: counts where no solid explains them at all.
std::vector<Outlines> uncertainOutlines(const std::vector<RegisteredView> &views,
                                        const std::vector<RobotRecord> &robots,
                                        std::vector<TrackedView> &tracked, float ShadowAmbiguity::*share,
                                        double misfitOfNone)
{
    std::vector<Outlines> uncertain;
    for (std::size_t r = 0; r < robots.size(); ++r) {
        if (meanAmbiguity(tracked, r, share) <= leastAmbiguity)
            continue;
        Outlines outlines = outlinesOf(views, robots, tracked, r);
        if (outlines.misfit.value_or(misfitOfNone) > goodMisfit)
            uncertain.push_back(outlines);
    }
    return uncertain;
}

/// Whether solids explain the outlines of these robots better than before, by less than this share of the
/// misfit, and nothing of them was lost. A few outlines are easily explained, so more of them may be
/// explained less well.
bool areBetter(const std::vector<Outlines> &now, const std::vector<Outlines> &before, double share)
{
    double gain = 0; // of the logarithms
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (!now[i].misfit || now[i].found < nearlyAsOften * before[i].found)
            return false;
        gain += std::log(now[i].found * before[i].misfit.value_or(worstShapeMisfit) /
                         (std::max(1.0, before[i].found) * *now[i].misfit)) /
                double(now.size());
    }
    return gain > -std::log(share);
}

/// What was found with other shadows than those that are kept, of one robot.
struct OtherShadows
{
    Outlines outlines;
    double evenShare = 1; ///< of the kept misfit, where both would be as likely
    std::vector<std::map<std::int64_t, Eigen::Vector2d>> centres; ///< of each view, by frame
};

OtherShadows otherShadows(const std::vector<TrackedView> &views, const Outlines &outlines, double evenShare)
{
    OtherShadows other{outlines, evenShare, {}};
    for (const TrackedView &view : views) {
        auto &centres = other.centres.emplace_back();
        for (const Observation &one : view.series[outlines.robot].observations)
            if (one.found)
                centres.emplace(one.frame, one.ellipse.centrePx);
    }
    return other;
}

/// How likely it is that these are the right ones: where a solid explains the outlines nearly as well as
/// those that are kept, and those not well.
double shareOf(const OtherShadows &other, const Outlines &kept)
{
    constexpr double unlikely = 1.15; // times the misfit where both are as likely
    if (!other.outlines.misfit || kept.misfit.value_or(0) <= goodMisfit ||
        other.outlines.found < nearlyAsOften * kept.found)
        return 0;
    const double worse =
                     std::log(*other.outlines.misfit / (other.evenShare * *kept.misfit)) / std::log(unlikely),
                 likelihood = std::clamp(1 - worse, 0.0, 1.0);
    return likelihood / (1 + likelihood);
}

/// Adds how far the centres would be elsewhere.
void addUncertainty(const OtherShadows &other, double share, std::vector<TrackedView> &kept)
{
    for (std::size_t v = 0; v < kept.size(); ++v) {
        for (Observation &its : kept[v].series[other.outlines.robot].observations) {
            const auto there = other.centres[v].find(its.frame);
            if (!its.found || there == other.centres[v].end())
                continue;
            const Eigen::Vector2d away = there->second - its.ellipse.centrePx;
            its.lastingCovariancePx2 += share * away * away.transpose();
        }
    }
}

} // namespace

Result<SettledViews> trackAndSettle(const std::vector<RegisteredView> &views,
                                    const std::vector<RobotRecord> &robots, const JobControl &control,
                                    const std::vector<PointedOutRobot> &pointedOut)
{
    double done = 0; // of the job
    const auto tracked = [&](double part, const auto &track) -> Result<SettledViews> {
        auto seen = ODO_TRY(track(partOf(control, done, done + part)));
        done += part;
        control.report(done, ODO_TEXT("workflow.settling_names", "assigning names to the robots"));
        auto ambiguities = ODO_TRY(settleNames(views, robots, seen, pointedOut));
        return SettledViews{std::move(seen), std::move(ambiguities)};
    };
    bool inParts = false;
    auto best = tracked(firstPart, [&](const JobControl &part) {
        auto seen = trackViews(views, robots, part);
        inParts = seen && isInParts(*seen); // before the names are settled, which takes the others away
        return seen;
    });
    if (!best)
        return best;
    Background::Shadow shadow;
    std::vector<OtherShadows> others;
    // Takes them for what they are where solids then explain the outlines of these robots better.
    const auto tryShadows = [&](const Background::Shadow &tried, std::vector<Outlines> &known,
                                double share = less) {
        if (known.empty() || control.isCancelled())
            return false;
        auto again = tracked(nextPart, [&](const JobControl &part) {
            return trackAgain(views, robots, best->views, tried, part);
        });
        if (!again) // what was found before stays
            return false;
        std::vector<Outlines> now;
        for (const Outlines &before : known)
            now.push_back(outlinesOf(views, robots, again->views, before.robot));
        const bool better = areBetter(now, known, share);
        if (better) {
            std::swap(best, again);
            std::swap(known, now);
            shadow = tried;
        }
        for (const Outlines &outlines : now)
            others.push_back(otherShadows(again->views, outlines, better ? 1 / share : share));
        return better;
    };
    const auto uncertain = [&](float ShadowAmbiguity::*share, double misfitOfNone = 0) {
        return uncertainOutlines(views, robots, best->views, share, misfitOfNone);
    };
    const auto with = [&shadow](auto Background::Shadow::*what, auto value) {
        Background::Shadow tried = shadow;
        tried.*what = value;
        return tried;
    };
    std::vector<Outlines> ofParts;
    for (std::size_t r = 0; inParts && r < robots.size(); ++r)
        if (!namedRobot(robots[r]).colour)
            ofParts.push_back(outlinesOf(views, robots, best->views, r));
    tryShadows(with(&Background::Shadow::connects, true), ofParts);
    std::vector<Outlines> tinted = uncertain(&ShadowAmbiguity::tinted);
    tryShadows(with(&Background::Shadow::tint, Background::strongTint), tinted, clearlyLess);
    std::vector<Outlines> deep = uncertain(&ShadowAmbiguity::deep);
    for (const float darkest : darkerShadows)
        if (!tryShadows(with(&Background::Shadow::darkest, darkest), deep))
            break;
    if (shadow.darkest == Background::Shadow().darkest) {
        std::vector<Outlines> light = uncertain(&ShadowAmbiguity::light, worstShapeMisfit);
        for (const float darkest : lighterShadows)
            if (!tryShadows(with(&Background::Shadow::darkest, darkest), light, clearlyLess))
                break;
    }
    if (control.isCancelled())
        return cancelled(trackingSubject());
    std::map<std::size_t, Outlines> kept; // by robot
    for (const OtherShadows &other : others)
        if (const std::size_t robot = other.outlines.robot; !kept.contains(robot))
            kept.emplace(robot, outlinesOf(views, robots, best->views, robot));
    for (const OtherShadows &other : others)
        if (const double share = shareOf(other, kept.at(other.outlines.robot)); share > 0)
            addUncertainty(other, share, best->views);
    return best;
}

} // namespace odo
