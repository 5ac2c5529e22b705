// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/analyser.h"

#include "core/trajectory/internal/contradiction_model.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/free_height.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/internal/view_alignment.h"
#include "core/trajectory/solid_choice.h"
#include "core/trajectory/view_contradiction.h"
#include "core/trajectory/view_disagreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

// Where the height is triangulated in every frame.
constexpr double freePlaneSigmaM = 0.002;
// A ruler's: both of its ends are read to the nearest millimetre, 1 mm/√12 each.
constexpr double givenHeightSigmaM = 0.00041;
// Pixel noise alone moves the height of a frame by some millimetres.
constexpr double leastScatterM = 0.02;

constexpr std::array<std::pair<Smoother, std::string_view>, 4> smootherNames{{{Smoother::Rts, "rts"},
                                                                              {Smoother::SavGol, "savgol"},
                                                                              {Smoother::Tracker, "tracker"},
                                                                              {Smoother::None, "none"}}};

MessageArgument camerasOf(const std::vector<ViewTrack> &views)
{
    std::vector<std::string> names;
    for (const ViewTrack &view : views)
        names.push_back(view.view);
    return listed(names, MessageArgument::Kind::Camera);
}

Result<void> checkViews(const std::vector<ViewTrack> &views)
{
    if (views.empty())
        return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                    ODO_TEXT("trajectory.no_view", "the trial has no view"),
                    ODO_TEXT("trajectory.import_video", "import at least one video for it"));
    const bool registered = std::any_of(views.begin(), views.end(),
                                        [](const ViewTrack &view) { return view.floorView.has_value(); });
    if (!registered)
        return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                    views.size() == 1
                        ? ODO_TEXT("trajectory.camera_not_registered",
                                   "camera %1 is not registered to the floor")(camerasOf(views))
                        : ODO_TEXT("trajectory.cameras_not_registered",
                                   "cameras %1 are not registered to the floor")(camerasOf(views)),
                    ODO_TEXT("trajectory.register_one", "run odograph register for at least one of them"));
    if (views.front().observations.empty())
        return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                    ODO_TEXT("trajectory.view_without_frame",
                             "view %1 has no frame")(Named::camera(views.front().view)),
                    ODO_TEXT("trajectory.track_first", "track the trial's videos first"));
    std::size_t found = 0, foundRegistered = 0;
    for (const ViewTrack &view : views) {
        const auto count = static_cast<std::size_t>(
            std::count_if(view.observations.begin(), view.observations.end(),
                          [](const Observation &observation) { return observation.found; }));
        found += count;
        foundRegistered += view.floorView ? count : 0;
    }
    if (found == 0)
        return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                    ODO_TEXT("trajectory.robot_not_found",
                             "the robot was not found in any frame of %1")(camerasOf(views)),
                    ODO_TEXT("trajectory.check_robot_and_light",
                             "check that the robot moves in the video, that its colour, if set, matches the "
                             "video, and that the light is sufficient"));
    if (foundRegistered == 0)
        return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                    ODO_TEXT("trajectory.only_unregistered",
                             "only cameras that are not registered to the floor saw the robot"),
                    ODO_TEXT("trajectory.register_them", "run odograph register for them"));
    return {};
}

/// What all views saw, projected at the robot's height.
struct PositionedRobot
{
    std::vector<std::vector<Sighting>> views;
    double planeM = 0, planeSigmaM = 0; ///< of the plane used
    double heightM = 0;                 ///< of the robot's top
    bool estimated = false;
    std::optional<double> clearanceM;                          ///< of a solid
    std::vector<std::optional<MeasuredHeading>> headings = {}; ///< of a solid, one a frame; or none at all
    bool strays = false; ///< a mark, from its plane: the views then agree by their bearings
};

bool areSilhouettes(const std::vector<ViewTrack> &views)
{
    return std::ranges::any_of(views, [](const ViewTrack &view) {
        return std::ranges::any_of(view.observations,
                                   [](const Observation &one) { return !one.supportPx.empty(); });
    });
}

/// Sightings on one plane. Where the views show that the point strays from it (a person's head, a wrong
/// height given), each ray is trusted less along its own direction: two views then determine the position by
/// their bearings.
std::vector<std::vector<Sighting>> lookAtPlane(const std::vector<ViewTrack> &views,
                                               const std::vector<Nanoseconds> &times, double planeM,
                                               bool &strays)
{
    auto sightings = viewFromAllSides(views, times, planeM);
    const double scatterM = heightScatterM(viewFromAllSides(views, times, 0), planeM);
    if (scatterM < leastScatterM)
        return sightings;
    strays = !areSilhouettes(views);
    for (auto &view : sightings) {
        for (Sighting &sighting : view) {
            const Eigen::Vector2d shift = scatterM * sighting.position.displacementPerMetreHeight;
            if (sighting.seen)
                sighting.position.calibrationCovariance += shift * shift.transpose();
        }
    }
    return sightings;
}

/// The outlines are a solid's silhouettes: each gives the floor position of that solid.
std::optional<PositionedRobot> positionSolid(const std::vector<ViewTrack> &views,
                                             const std::vector<Nanoseconds> &times, const RobotShape &given,
                                             std::optional<FoundSolid> solid)
{
    if (!solid)
        return std::nullopt;
    PositionedRobot placed;
    for (std::size_t v = 0; v < views.size(); ++v) {
        placed.views.push_back(views[v].floorView ? sightingsAt(times, solid->seen[v])
                                                  : std::vector<Sighting>(times.size()));
        solid->seen[v] = {};
    }
    const double ofTop =
        given.heightM ? givenHeightSigmaM * middleHeightM(solid->shape) / solid->shape.topM : 0;
    placed.planeM = middleHeightM(solid->shape);
    placed.planeSigmaM = std::hypot(ofTop, solid->sigmaMiddleM);
    placed.heightM = solid->shape.topM;
    placed.estimated = !given.heightM;
    placed.clearanceM = solid->shape.baseM;
    placed.headings = std::move(solid->headings);
    return placed;
}

/// Whole silhouettes that no solid explains show now one part of the robot and now another (it looks like the
/// floor, or like its shadow): the position in them is hardly better known than they are large.
void uncertaintyUnexplained(const std::vector<ViewTrack> &views,
                            std::vector<std::vector<Sighting>> &sightings)
{
    constexpr double shareOfRadius = 0.7;
    for (std::size_t v = 0; v < views.size(); ++v) {
        double largestPx = 0;
        for (const Observation &observation : views[v].observations)
            if (observation.found && !observation.supportPx.empty())
                largestPx = std::max(largestPx, observation.areaPx);
        if (largestPx == 0 || !views[v].floorView)
            continue;
        const double radiusPx = std::sqrt(largestPx / std::numbers::pi);
        const Eigen::Vector3d camera = views[v].floorView->cameraInWorld();
        const double focalPx = views[v].floorView->camera().intrinsics().fxPx;
        for (Sighting &sighting : sightings[v]) {
            const Eigen::Vector2d &position = sighting.position.pointInWorld;
            const double awayM = (camera - Eigen::Vector3d(position.x(), position.y(), 0)).norm(),
                         uncertaintyM = shareOfRadius * radiusPx * awayM / focalPx;
            sighting.position.calibrationCovariance +=
                Eigen::Matrix2d::Identity() * uncertaintyM * uncertaintyM;
        }
    }
}

/// One height for the whole run: given, or estimated from the views, or (from one view alone) unknown.
Result<PositionedRobot> positionAtOneHeight(const std::vector<ViewTrack> &views,
                                            const std::vector<Nanoseconds> &times, const RobotShape &shape)
{
    const bool markShown = shape.heightM && isMarkAtTop(views, *shape.heightM);
    if (!markShown) {
        if (auto solid = positionSolid(views, times, shape, findSolid(views, shape)))
            return std::move(*solid);
    }
    if (!shape.referenceM.isZero())
        return fail(
            ErrorCode::Undetermined, cannotMeasurePath(),
            ODO_TEXT("trajectory.heading_unknown", "its reference point is not the centre of its footprint, "
                                                   "but its outlines do not show its heading"),
            ODO_TEXT("trajectory.centre_reference", "set its reference point to 0,0 and track again"));
    const PlaneChoice plane = choosePlane(views, times, shape);
    const bool known = plane.heightM > 0;
    bool strays = false;
    PositionedRobot placed{known ? lookAtPlane(views, times, plane.planeM, strays)
                                 : viewFromAllSides(views, times, 0),
                           known ? plane.planeM : 0,
                           plane.sigmaM,
                           plane.heightM,
                           plane.estimated,
                           {}};
    placed.strays = strays;
    uncertaintyUnexplained(views, placed.views);
    return placed;
}

Result<PositionedRobot> position(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                                 const RobotShape &shape)
{
    if (!shape.heightVaries)
        return positionAtOneHeight(views, times, shape);
    auto placed = freeHeight(viewFromAllSides(views, times, 0));
    if (!placed)
        return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                    ODO_TEXT("trajectory.seldom_together", "its height is set to be triangulated, but two "
                                                           "registered views rarely saw it at the same time"),
                    ODO_TEXT("trajectory.add_view", "add a second view, or set one height for the robot"));
    return PositionedRobot{std::move(placed->views), 0, freePlaneSigmaM, placed->medianHeightM, true, {}};
}

double meanDisagreement(const std::vector<Sample> &samples)
{
    double sum = 0, count = 0;
    for (const Sample &sample : samples) {
        if (sample.viewDisagreementM && !isRejected(sample.flags)) {
            sum += *sample.viewDisagreementM;
            count += 1;
        }
    }
    return count > 0 ? sum / count : 0;
}

} // namespace

Result<Smoother> parseSmoother(std::string_view name)
{
    for (const auto &[smoother, itsName] : smootherNames) {
        if (itsName == name)
            return smoother;
    }
    return fail(ErrorCode::NotFound, ODO_TEXT("trajectory.smoother", "smoother %1")(std::string(name)),
                ODO_TEXT("trajectory.no_such_smoother", "no smoother has this name"),
                ODO_TEXT("trajectory.use_smoother", "use rts, savgol, tracker or none"));
}

std::string_view smootherName(Smoother smoother)
{
    for (const auto &[one, name] : smootherNames) {
        if (one == smoother)
            return name;
    }
    return {};
}

AnalysisOptions withTask(AnalysisOptions options, const Task &task)
{
    options.task = task;
    options.maxSpeedMps = task.limits.maxSpeedMps.value_or(options.maxSpeedMps);
    options.maxAccelMps2 = task.limits.maxAccelMps2.value_or(options.maxAccelMps2);
    return options;
}

namespace {

/// The views joined, before the search for spikes.
struct MeasuredRobot
{
    FusedTrack track;
    MeasurementNoise noise;
    double heightM = 0;
    bool heightEstimated = false;
    std::optional<double> clearanceM;
    std::optional<ViewsContradiction> contradiction;
};

std::vector<Nanoseconds> timesOf(const ViewTrack &view)
{
    std::vector<Nanoseconds> times;
    for (const Observation &observation : view.observations)
        times.push_back(timeOf(view, observation));
    return times;
}

tl::unexpected<Error> viewsExchanged(const ViewTrack &a, const ViewTrack &b)
{
    return fail(ErrorCode::Undetermined, cannotMeasurePath(),
                ODO_TEXT("trajectory.views_exchanged",
                         "the videos of %1 and %2 seem to be exchanged: exchanged, they agree")(
                    Named::camera(a.view), Named::camera(b.view)),
                ODO_TEXT("trajectory.import_exchanged", "import them again, each for its own camera"));
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
    const auto plain = [&](const std::vector<ViewTrack> &seen, const RobotShape &told) {
        return isMark ? std::nullopt : positionSolid(seen, times, told, findPlainSolid(seen, told));
    };
    const auto correctionOf = [&](const PositionedRobot &robot, double least = leastEvidence) {
        return likelyCorrection(views, robot.views,
                                {robot.planeM, robot.planeSigmaM, shape.heightM.has_value()}, least);
    };
    auto correction = correctionOf(placed);
    if (!correction) {
        auto unlearned = plain(views, shape);
        correction = unlearned ? correctionOf(*unlearned, leastPlainEvidence) : std::nullopt;
        if (correction)
            placed = std::move(*unlearned);
    }
    const bool isSuspicious = correction || views.size() > 2;
    const double toldPlaneM = placed.planeM;
    for (int i = 0; correction && i < mostTimes; ++i) {
        RobotShape corrected = shape;
        if (shape.heightM && toldPlaneM > 0)
            *corrected.heightM *= std::max(0.1, 1 + correction->raiseM / toldPlaneM);
        const std::vector<ViewTrack> agreeing = correctedViews(views[0], views[1], *correction);
        auto unbent = plain(agreeing, corrected);
        if (!unbent) {
            auto other = position(agreeing, times, corrected);
            if (!other)
                return isSuspicious;
            unbent = std::move(*other);
        }
        placed = std::move(*unbent);
        placed.views = withoutCorrection(std::move(placed.views), *views[0].floorView, *views[1].floorView,
                                         *correction, placed.planeM);
        if (correction->raiseM != 0) {
            for (auto &view : placed.views)
                for (Sighting &one : view)
                    one.position.pointInWorld +=
                        (toldPlaneM - placed.planeM) * one.position.displacementPerMetreHeight;
            placed.planeM = toldPlaneM;
        }
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
        isSuspicious ? explainContradiction(views, unbent.views,
                                            {unbent.planeM, unbent.planeSigmaM, shape.heightM.has_value()})
                     : std::nullopt;
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

/// Whether views still contradict each other by a cause where their false sightings are left out: those by
/// which they disagree for less than a second.
bool isContradictedWithout(const FusedTrack &plain, std::vector<ViewTrack> views, const RobotShape &shape)
{
    constexpr Nanoseconds longestFalse = std::chrono::seconds(1), near = std::chrono::milliseconds(20);
    const std::vector<Sample> &samples = plain.samples;
    const auto disagrees = [](const Sample &sample) {
        return hasFlag(sample.flags, SampleFlag::ViewsDisagree);
    };
    for (auto first = std::ranges::find_if(samples, disagrees); first != samples.end();) {
        const auto end = std::find_if_not(first, samples.end(), disagrees);
        const Nanoseconds from = first->time - near, to = std::prev(end)->time + near;
        for (ViewTrack &view : views) {
            if (to - from > longestFalse)
                break;
            for (Observation &one : view.observations)
                if (const Nanoseconds time = timeOf(view, one); time >= from && time <= to)
                    one.found = false;
        }
        first = std::find_if(end, samples.end(), disagrees);
    }
    const std::vector<Nanoseconds> times = timesOf(views.front());
    auto placed = position(views, times, shape);
    std::optional<ViewsContradiction> contradiction;
    if (placed)
        settle(views, times, shape, *placed, contradiction);
    return contradiction.has_value();
}

Result<MeasuredRobot> measure(const std::vector<ViewTrack> &views, const RobotShape &shape,
                              const AnalysisOptions &options)
{
    const std::vector<Nanoseconds> times = timesOf(views.front());
    auto placed = ODO_TRY(position(views, times, shape));
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

Result<Profile> analyse(const std::vector<ViewTrack> &views, const RobotShape &shape,
                        const AnalysisOptions &options)
{
    ODO_TRY(checkViews(views));
    auto robot = ODO_TRY(measure(views, shape, options));
    ODO_TRY(checkAgreement(robot.track.samples));
    auto profile = ODO_TRY(profileOfTrack(std::move(robot.track), options, robot.noise));
    profile.heightM = robot.heightM;
    profile.heightEstimated = robot.heightEstimated;
    profile.clearanceM = robot.clearanceM;
    profile.meanViewDisagreementM = meanDisagreement(profile.samples);
    profile.contradiction = std::move(robot.contradiction);
    return profile;
}

std::optional<ViewsContradiction> contradictionOf(const std::vector<ViewTrack> &views,
                                                  const RobotShape &shape)
{
    if (shape.heightVaries || !checkViews(views))
        return std::nullopt;
    auto robot = measure(views, shape, {});
    return robot ? std::move(robot->contradiction) : std::nullopt;
}

void applyOverrides(std::vector<Sample> &samples, std::span<const ManualOverride> overrides)
{
    for (const ManualOverride &manualOverride : overrides) {
        const auto sample = std::find_if(samples.begin(), samples.end(), [&](const Sample &one) {
            return one.frame == manualOverride.frame;
        });
        if (sample == samples.end() || !sample->position)
            continue;
        sample->flags |= flagBit(SampleFlag::ByHand);
        if (manualOverride.isSpike)
            sample->flags |= flagBit(SampleFlag::Jump);
        else
            sample->flags &= ~rejectingFlags;
    }
}

std::vector<ManualOverride> withOverride(std::vector<ManualOverride> overrides, ManualOverride added)
{
    overrides = withoutOverride(std::move(overrides), added.frame);
    const auto behind = std::find_if(overrides.begin(), overrides.end(),
                                     [&](const ManualOverride &one) { return one.frame > added.frame; });
    overrides.insert(behind, added);
    return overrides;
}

std::vector<ManualOverride> withoutOverride(std::vector<ManualOverride> overrides, std::int64_t frame)
{
    std::erase_if(overrides, [&](const ManualOverride &one) { return one.frame == frame; });
    return overrides;
}

} // namespace odo
