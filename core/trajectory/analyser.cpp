// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/analyser.h"

#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/internal/view_alignment.h"
#include "core/trajectory/solid_choice.h"
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
    double planeSigmaM = 0; ///< of the plane used
    double heightM = 0;     ///< of the robot's top
    bool estimated = false;
    std::optional<double> clearanceM;                          ///< of a solid
    std::vector<std::optional<MeasuredHeading>> headings = {}; ///< of a solid, one a frame; or none at all
};

/// Sightings on one plane. Where the views show that the point strays from it (a person's head, a wrong
/// height given), each ray is trusted less along its own direction: two views then determine the position by
/// their bearings.
std::vector<std::vector<Sighting>> lookAtPlane(const std::vector<ViewTrack> &views,
                                               const std::vector<Nanoseconds> &times, double planeM)
{
    auto sightings = viewFromAllSides(views, times, planeM);
    const double scatterM = heightScatterM(viewFromAllSides(views, times, 0), planeM);
    if (scatterM < leastScatterM)
        return sightings;
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
                                             const std::vector<Nanoseconds> &times, const RobotShape &given)
{
    auto solid = findSolid(views, given);
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
        if (auto solid = positionSolid(views, times, shape))
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
    PositionedRobot placed{known ? lookAtPlane(views, times, plane.planeM)
                                 : viewFromAllSides(views, times, 0),
                           plane.sigmaM,
                           plane.heightM,
                           plane.estimated,
                           {}};
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
    return PositionedRobot{std::move(placed->views), freePlaneSigmaM, placed->medianHeightM, true, {}};
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
};

Result<MeasuredRobot> measure(const std::vector<ViewTrack> &views, const RobotShape &shape,
                              const AnalysisOptions &options)
{
    std::vector<Nanoseconds> times;
    std::vector<std::int64_t> frames;
    for (const Observation &observation : views.front().observations) {
        times.push_back(timeOf(views.front(), observation));
        frames.push_back(observation.frame);
    }
    auto placed = ODO_TRY(position(views, times, shape));
    FusionSettings settings;
    settings.planeSigmaM = placed.planeSigmaM;
    settings.measurement = estimateOutlineNoise(placed.views);
    const std::vector<double> apartM =
        shape.heightVaries ? std::vector<double>() : settleContradictions(placed.views);
    MeasuredRobot robot{fuseViews(times, frames, placed.views, settings), settings.measurement,
                        placed.heightM, placed.estimated, placed.clearanceM};
    flagContradictions(robot.track, apartM);
    chooseByMotion(robot.track, settings, options.longestBridgedGap);
    alignSingleViews(robot.track, placed.views, views);
    for (std::size_t i = 0; i < placed.headings.size(); ++i)
        robot.track.samples[i].heading = placed.headings[i];
    applyOverrides(robot.track.samples, options.overrides);
    return robot;
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
    return profile;
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
