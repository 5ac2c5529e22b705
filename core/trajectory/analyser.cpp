// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/analyser.h"

#include "core/analysis/range/run_range.h"
#include "core/trajectory/internal/measured_robot.h"
#include "core/trajectory/internal/track_profile.h"
#include "core/trajectory/view_disagreement.h"

#include <algorithm>
#include <array>

namespace odo {

namespace {

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

void markBreaks(const std::vector<ViewTrack> &views, std::vector<Sample> &samples)
{
    for (const ViewTrack &view : views) {
        for (const Nanoseconds own : view.breaks) {
            const auto sample =
                std::ranges::find_if(samples, [time = clockOf(view).commonTime(own)](const Sample &one) {
                    return one.time >= time;
                });
            if (sample != samples.end())
                sample->isAfterBreak = true;
        }
    }
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

Result<Profile> analyse(const std::vector<ViewTrack> &views, const RobotShape &shape,
                        const AnalysisOptions &options)
{
    ODO_TRY(checkViews(views));
    auto robot = ODO_TRY(measureRobot(views, shape, options));
    ODO_TRY(checkAgreement(robot.track.samples));
    markBreaks(views, robot.track.samples);
    auto profile = ODO_TRY(profileOfTrack(std::move(robot.track), options, robot.noise));
    profile.heightM = robot.heightM;
    profile.heightEstimated = robot.heightEstimated;
    profile.clearanceM = robot.clearanceM;
    profile.meanViewDisagreementM = meanViewDisagreement(profile.samples);
    profile.contradiction = std::move(robot.contradiction);
    return profile;
}

std::optional<ViewsContradiction> contradictionOf(const std::vector<ViewTrack> &views,
                                                  const RobotShape &shape)
{
    if (shape.heightVaries || !checkViews(views))
        return std::nullopt;
    auto robot = measureRobot(views, shape, {});
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
