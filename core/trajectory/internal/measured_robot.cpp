// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/measured_robot.h"

#include "core/base/percentile.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/pair_correction.h"
#include "core/trajectory/internal/positioned_robot.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/internal/view_alignment.h"
#include "core/trajectory/solid_choice.h"
#include "core/trajectory/view_contradiction.h"
#include "core/trajectory/view_disagreement.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

tl::unexpected<Error> viewsExchanged(const ViewTrack &a, const ViewTrack &b)
{
    return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                ODO_TEXT("trajectory.views_exchanged",
                         "the videos of %1 and %2 seem to be exchanged: exchanged, they agree")(
                    Named::camera(a.view), Named::camera(b.view)),
                ODO_TEXT("trajectory.import_exchanged", "import them again, each for its own camera"));
}

/// Onto the plane that a robot of these proportions has by the given height.
void moveToGivenHeight(PositionedRobot &placed, double givenM)
{
    const double planeM =
        placed.heightM > 0 ? placed.planeM * givenM / placed.heightM : silhouettePlaneM(givenM);
    for (auto &view : placed.views)
        for (Sighting &one : view)
            one.position.pointInWorld += (planeM - placed.planeM) * one.position.displacementPerMetreHeight;
    placed.planeM = planeM;
    placed.heightM = givenM;
    placed.estimated = false;
}

/// The plane on which a robot's views are compared.
ComparedPlane planeOf(const PositionedRobot &placed, const RobotShape &shape)
{
    return {placed.planeM, placed.planeSigmaM, shape.heightM.has_value(), placed.isPlainAndRight};
}

/// Whether a correction does not let any form explain the outlines clearly better: then the plain form is
/// wrong, and no view.
bool isRefuted(const PairCorrection &correction, const std::vector<ViewTrack> &views, const RobotShape &shape)
{
    constexpr double clearlyBetter = 0.95, hardly = 1e-6;
    PairCorrection none; // which divides the views alike
    none.turnA = hardly * correction.turnA;
    none.turnB = hardly * correction.turnB;
    none.since = correction.since;
    RobotShape corrected = shape;
    if (correction.raiseM != 0)
        corrected.heightM.reset();
    const auto without = misfitOfOutlines(correctedViews(views[0], views[1], none), shape),
               with = misfitOfOutlines(correctedViews(views[0], views[1], correction), corrected);
    return without && (!with || *with > clearlyBetter * *without);
}

/// A robot's form is bent by what makes two views contradict each other, and may hide it. So that is looked
/// for with a plain form as well; where there is something, the form is found once more as if it were put
/// right, and the views are then taken as they are with that form.
bool positionUnbent(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                    const RobotShape &shape, PositionedRobot &placed)
{
    constexpr int mostTimes = 3;
    if (placed.strays)
        return false;
    const bool isMark = shape.heightM && isMarkAtTop(views, *shape.heightM);
    const auto plain = [&](const std::vector<ViewTrack> &seen, const RobotShape &given) {
        return isMark ? std::nullopt : positionPlainSolid(seen, times, given);
    };
    const auto correctionOf = [&](const PositionedRobot &robot, double least = leastEvidence) {
        return likelyCorrection(views, robot.views, planeOf(robot, shape), least);
    };
    auto correction = correctionOf(placed);
    if (!correction) {
        auto unlearned = plain(views, shape);
        correction = unlearned ? correctionOf(*unlearned, leastPlainEvidence) : std::nullopt;
        if (correction && isRefuted(*correction, views, shape))
            correction.reset();
        if (correction)
            placed = std::move(*unlearned);
    }
    const bool isSuspicious = correction || views.size() > 2;
    for (int i = 0; correction && i < mostTimes; ++i) {
        const bool isHeightWrong = correction->raiseM != 0;
        RobotShape corrected = shape;
        if (isHeightWrong)
            corrected.heightM.reset();
        const std::vector<ViewTrack> agreeing = correctedViews(views[0], views[1], *correction);
        auto unbent = plain(agreeing, corrected);
        if (!unbent) {
            auto other = positionRobot(agreeing, times, corrected);
            if (!other)
                return isSuspicious;
            unbent = std::move(*other);
        }
        placed = std::move(*unbent);
        placed.views = withoutCorrection(std::move(placed.views), *views[0].floorView, *views[1].floorView,
                                         *correction, placed.planeM);
        if (isHeightWrong)
            moveToGivenHeight(placed, *shape.heightM);
        if (shape.heightM)
            placed.heightM = *shape.heightM;
        correction = correctionOf(placed);
    }
    return isSuspicious;
}

/// Settles what makes the views contradict each other, first by its causes; gives how far apart they are.
std::vector<double> settle(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                           const RobotShape &shape, PositionedRobot &placed,
                           std::optional<ViewsContradiction> &contradiction)
{
    PositionedRobot unbent = placed;
    const bool isSuspicious = positionUnbent(views, times, shape, unbent);
    auto explained =
        isSuspicious ? explainContradiction(views, unbent.views, planeOf(unbent, shape)) : std::nullopt;
    if (explained)
        placed = std::move(unbent);
    std::vector<double> apartM = settleContradictions(placed.views);
    if (!explained)
        return apartM;
    for (std::size_t i = 0; i < apartM.size(); ++i)
        apartM[i] = std::max(apartM[i], explained->apartM[i]);
    contradiction = std::move(explained->contradiction);
    for (ContradictionCause &cause : contradiction->causes)
        if (cause.kind == ContradictionCause::Kind::Height) // from that of the plane to that of the top
            cause.size *= placed.planeM > 0 ? placed.heightM / placed.planeM : 1;
    return apartM;
}

/// The track of a robot whose views have been settled.
FusedTrack trackOf(const PositionedRobot &placed, const std::vector<ViewTrack> &views,
                   const std::vector<Nanoseconds> &times, const std::vector<double> &apartM,
                   const FusionSettings &settings, const AnalysisOptions &options)
{
    std::vector<std::int64_t> frames;
    for (const Observation &observation : views.front().observations)
        frames.push_back(observation.frame);
    FusedTrack track = fuseViews(times, frames, placed.views, settings);
    flagContradictions(track, apartM);
    chooseByMotion(track, settings, options.longestBridgedGap);
    alignSingleViews(track, placed.views, views);
    return track;
}

/// Leaves out the false sightings of views: those by which they disagree for less than a second. Whether
/// there are any.
bool leaveOutFalse(const std::vector<Sample> &samples, std::vector<ViewTrack> &views)
{
    constexpr Nanoseconds longestFalse = std::chrono::seconds(1), near = std::chrono::milliseconds(20);
    const auto disagrees = [](const Sample &sample) {
        return hasFlag(sample.flags, SampleFlag::ViewsDisagree);
    };
    bool isAny = false;
    for (auto end = samples.begin(); end != samples.end();) {
        const auto first = std::find_if(end, samples.end(), disagrees);
        end = std::find_if_not(first, samples.end(), disagrees);
        if (first == end)
            break;
        const Nanoseconds from = first->time - near, to = std::prev(end)->time + near;
        if (to - from > longestFalse)
            continue;
        isAny = true;
        for (ViewTrack &view : views)
            for (Observation &one : view.observations)
                if (const Nanoseconds time = timeOf(view, one); time >= from && time <= to)
                    one.found = false;
    }
    return isAny;
}

/// Leaves out the outlines of a view that are smaller than usual, for where the robot is: something hides a
/// part of it. Whether there are any.
bool leaveOutParts(const std::vector<Sample> &samples, ViewTrack &view)
{
    constexpr double leastShare = 0.85; // of the usual radius
    if (!view.floorView)
        return false;
    std::vector<std::pair<Observation *, double>> sizes;
    auto sample = samples.begin();
    for (Observation &one : view.observations) {
        sample = std::find_if(sample, samples.end(),
                              [&](const Sample &next) { return next.time >= timeOf(view, one); });
        if (sample == samples.end())
            break;
        if (!one.found || one.touchesBorder || one.isByHand || !sample->position)
            continue;
        const Eigen::Vector3d at(sample->position->x(), sample->position->y(), 0);
        sizes.emplace_back(&one, std::sqrt(one.areaPx) * (at - view.floorView->cameraInWorld()).norm());
    }
    if (sizes.empty())
        return false;
    std::vector<double> all;
    for (const auto &[observation, size] : sizes)
        all.push_back(size);
    const double usual = upperMedian(std::move(all));
    bool isAny = false;
    for (const auto &[observation, size] : sizes) {
        observation->found = size >= leastShare * usual;
        isAny |= !observation->found;
    }
    return isAny;
}

/// Whether views still contradict each other by a cause where false sightings, and those of a part of the
/// robot, are left out.
bool isContradictedWithout(const FusedTrack &plain, std::vector<ViewTrack> views, const RobotShape &shape)
{
    bool isAny = leaveOutFalse(plain.samples, views);
    for (ViewTrack &view : views)
        isAny |= leaveOutParts(plain.samples, view);
    if (!isAny)
        return true;
    const std::vector<Nanoseconds> times = timesOf(views.front());
    auto placed = positionRobot(views, times, shape);
    std::optional<ViewsContradiction> contradiction;
    if (placed)
        settle(views, times, shape, *placed, contradiction);
    return contradiction.has_value();
}

Result<MeasuredRobot> measureAs(const std::vector<ViewTrack> &views, const RobotShape &shape,
                                const AnalysisOptions &options)
{
    const std::vector<Nanoseconds> times = timesOf(views.front());
    auto placed = ODO_TRY(positionRobot(views, times, shape));
    FusionSettings settings;
    settings.planeSigmaM = placed.planeSigmaM;
    settings.measurement = estimateOutlineNoise(placed.views);
    std::optional<ViewsContradiction> contradiction;
    std::vector<double> apartM;
    PositionedRobot unexplained = placed;
    if (!shape.heightVaries) {
        if (const auto exchanged = exchangedViews(views, placed.views, placed.planeM))
            return viewsExchanged(views[exchanged->first], views[exchanged->second]);
        apartM = settle(views, times, shape, placed, contradiction);
    }
    FusedTrack track = trackOf(placed, views, times, apartM, settings, options);
    if (contradiction) {
        const std::vector<double> plainApartM = settleContradictions(unexplained.views);
        FusedTrack plain = trackOf(unexplained, views, times, plainApartM, settings, options);
        if (!isContradictedWithout(plain, views, shape)) {
            track = std::move(plain);
            placed = std::move(unexplained);
            contradiction.reset();
        }
    }
    for (std::size_t i = 0; i < placed.headings.size(); ++i)
        track.samples[i].heading = placed.headings[i];
    applyOverrides(track.samples, options.overrides);
    return MeasuredRobot{std::move(track), settings.measurement, placed.heightM,
                         placed.estimated, placed.clearanceM,    std::move(contradiction)};
}

} // namespace

Result<MeasuredRobot> measureRobot(const std::vector<ViewTrack> &views, const RobotShape &shape,
                                   const AnalysisOptions &options)
{
    constexpr double sameHeight = 0.95;
    auto asTold = ODO_TRY(measureAs(views, shape, options));
    if (!asTold.contradiction || !shape.heightM || shape.heightVaries)
        return asTold;
    RobotShape free = shape;
    free.heightM.reset();
    const bool isSizeTold = shape.lengthM || shape.widthM;
    for (int i = 0; i < (isSizeTold ? 2 : 1); ++i) {
        auto freely = measureAs(views, free, options);
        // a robot is lower than told where its top is a thing that the outlines hardly show
        if (freely && !freely->contradiction && sameHeight * freely->heightM <= *shape.heightM) {
            freely->heightM = *shape.heightM;
            freely->heightEstimated = false;
            return std::move(*freely);
        }
        free.lengthM.reset();
        free.widthM.reset();
    }
    return asTold;
}

} // namespace odo
