// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record_trial.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/hash_job.h"
#include "core/workflow/line_up.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

namespace odo {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto lookEach = 50ms, appendEach = 1000ms, longestStart = 10000ms;
constexpr double longestS = 24 * 3600, longestPreRollS = 10;

std::string whatOf(const RecordSettings &settings)
{
    return "recording of trial '" + settings.trial + "'";
}

Result<void> checkSettings(Project &project, const RecordSettings &settings)
{
    const std::string what = whatOf(settings);
    if (settings.cameras.empty())
        return fail(ErrorCode::InvalidInput, what, "no camera was given",
                    "give one or more, like --camera A=sim:A");
    if (!(settings.seconds > 0 && settings.seconds <= longestS))
        return fail(ErrorCode::InvalidInput, what, "it would take no time, or more than a day",
                    "give the seconds, like 10");
    if (!(settings.preRollS >= 0 && settings.preRollS <= longestPreRollS))
        return fail(ErrorCode::InvalidInput, what, "what is kept from before is no time, or more than 10 s",
                    "give a pre-roll of 0 to 10 seconds");
    if (project.trials().find(settings.trial))
        return fail(ErrorCode::AlreadyExists, what, "the project has a trial of that name",
                    "choose another name");
    std::set<std::string> names, addresses;
    for (const auto &[camera, address] : settings.cameras) {
        if (!names.insert(camera).second || !addresses.insert(address).second)
            return fail(ErrorCode::InvalidInput, what,
                        "camera '" + camera + "' or its address '" + address + "' was given twice",
                        "give each view its own camera");
    }
    return {};
}

Result<std::vector<std::unique_ptr<CameraSource>>> openCameras(const RecordSettings &settings)
{
    std::vector<std::unique_ptr<CameraSource>> cameras;
    for (const auto &[name, address] : settings.cameras) {
        auto source = openCamera(address);
        if (!source)
            return tl::unexpected(source.error());
        cameras.push_back(std::move(*source));
    }
    return cameras;
}

/// The time counts from when all cameras deliver, which may take them a moment.
Result<void> waitForPictures(const CaptureSession &session, const RecordSettings &settings,
                             const JobControl &control)
{
    const auto until = Clock::now() + longestStart;
    for (;;) {
        const std::vector<ViewHealth> views = session.health().views;
        const auto silent = std::ranges::find(views, 0u, &ViewHealth::delivered);
        if (silent == views.end())
            return {};
        if (control.isCancelled())
            return cancelled(whatOf(settings));
        if (silent->state == ViewHealth::State::Ended || Clock::now() > until)
            return fail(ErrorCode::Io, whatOf(settings),
                        "camera '" +
                            settings.cameras[static_cast<std::size_t>(silent - views.begin())].first +
                            "' gave no picture" +
                            (silent->trouble ? ": " + silent->trouble->error.why : std::string()),
                        "check that it is connected and not used by another program");
        std::this_thread::sleep_for(lookEach);
    }
}

/// The pre-roll.
Result<void> letRun(const RecordSettings &settings, const JobControl &control)
{
    const auto until = Clock::now() + fromSeconds(settings.preRollS);
    while (Clock::now() < until) {
        if (control.isCancelled())
            return cancelled(whatOf(settings));
        std::this_thread::sleep_for(std::min<Nanoseconds>(lookEach, until - Clock::now()));
    }
    return {};
}

/// Until its time is over, or nothing more can be recorded.
Result<void> keepRecording(Project &project, LiveTrial &live, const CaptureSession &session,
                           const RecordSettings &settings, const JobControl &control)
{
    const auto hasEnded = [](const ViewHealth &view) { return view.state == ViewHealth::State::Ended; };
    const auto begun = Clock::now();
    auto appended = begun;
    for (;;) {
        std::this_thread::sleep_for(lookEach);
        const auto now = Clock::now();
        const double passedS = std::chrono::duration<double>(now - begun).count();
        control.report(std::min(1.0, passedS / settings.seconds), "recording");
        const CaptureHealth health = session.health();
        if (passedS >= settings.seconds || control.isCancelled() || health.disk.ended ||
            std::ranges::any_of(health.views, hasEnded))
            return {};
        if (now - appended < appendEach)
            continue;
        appended = now;
        if (auto kept = live.append(project); !kept)
            return kept;
    }
}

} // namespace

Result<std::shared_ptr<LiveTrial>> recordTrial(Project &project, const RecordSettings &settings,
                                               const JobControl &control)
{
    if (auto checked = checkSettings(project, settings); !checked)
        return tl::unexpected(checked.error());
    auto trial = trialOf(project, {.robots = settings.robots, .trial = settings.trial});
    if (!trial)
        return tl::unexpected(trial.error());
    auto cameras = openCameras(settings);
    if (!cameras)
        return tl::unexpected(cameras.error());
    const Nanoseconds preRoll = fromSeconds(settings.preRollS);
    CaptureSession session(std::move(*cameras), {.preRoll = preRoll});
    if (auto delivering = waitForPictures(session, settings, control); !delivering)
        return tl::unexpected(delivering.error());
    if (auto warm = letRun(settings, control); !warm)
        return tl::unexpected(warm.error());
    std::vector<std::string> names;
    for (const auto &[name, address] : settings.cameras)
        names.push_back(name);
    auto live = LiveTrial::begin(project, std::move(*trial), names, session, preRoll);
    if (!live)
        return live;
    const auto kept = keepRecording(project, **live, session, settings, control);
    if (control.isCancelled()) {
        if (auto discarded = (*live)->discard(project); !discarded)
            return tl::unexpected(discarded.error());
        return cancelled(whatOf(settings));
    }
    // Where the project could not be written to, the end tries once more, with all that is missing.
    if (auto ended = runToEnd(**live, project, control); !ended)
        return tl::unexpected(kept ? ended.error() : kept.error());
    HashJob hashes; // what is left of them is made the next time
    if (auto done = runToEnd(hashes, project, control); !done && done.error().code != ErrorCode::Cancelled)
        return tl::unexpected(done.error());
    return live;
}

} // namespace odo
