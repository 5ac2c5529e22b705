// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/record/internal/live_following.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <utility>

namespace odo {

namespace {

constexpr std::size_t mostSeen = 4096; // of what nobody asks for, half a minute of two cameras

using TriggerKind = RunTrigger::Kind;

bool isOf(const std::optional<RunTrigger> &trigger, std::initializer_list<TriggerKind> kinds)
{
    return trigger && std::ranges::find(kinds, trigger->kind) != kinds.end();
}

bool needsRobots(const std::optional<RunTrigger> &trigger)
{
    return isOf(trigger, {TriggerKind::Gate, TriggerKind::Entry, TriggerKind::Exit});
}

bool needsFloor(const RecordSettings &settings)
{
    return isOf(settings.start, {TriggerKind::Motion}) || isOf(settings.stop, {TriggerKind::Motion});
}

/// The task has what starts or ends the run.
Result<void> checkTrigger(Project &project, const RecordSettings &settings, const RunTrigger &trigger)
{
    if (!needsRobots(trigger))
        return {};
    const Message what = recordingSubject(settings.trial);
    if (settings.task.empty())
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.no_task_for_gate", "gates and zones are a task's, and none was given"),
                    ODO_TEXT("workflow.give_their_task", "give the task that has them"));
    const TaskRecord task = ODO_TRY(project.tasks().find(settings.task));
    const auto isStart = [](const Gate &gate) {
        return gate.role == GateRole::Start || gate.role == GateRole::StartFinish;
    };
    if (trigger.kind == TriggerKind::Gate)
        return std::ranges::any_of(task.task.gates, isStart)
                   ? Result<void>()
                   : fail(ErrorCode::NotFound, what,
                          ODO_TEXT("workflow.task_without_start",
                                   "task '%1' has no start gate")(Named::task(settings.task)),
                          ODO_TEXT("workflow.start_otherwise",
                                   "start it in another manner, such as by motion"));
    if (std::ranges::find(task.task.zones, trigger.zone, &Zone::name) != task.task.zones.end())
        return {};
    return fail(ErrorCode::NotFound, what,
                ODO_TEXT("workflow.task_without_zone",
                         "task '%1' has no zone '%2'")(Named::task(settings.task), trigger.zone),
                ODO_TEXT("workflow.give_zone_of_task", "give the name of one of its zones"));
}

Result<std::optional<FloorArea>> areaOf(Project &project, RecordId camera)
{
    const auto registration = ODO_TRY(project.cameras().currentRegistration(camera));
    if (!registration)
        return std::nullopt;
    const auto layout = ODO_TRY(project.layouts().get(registration->layout));
    return watchedArea(layout.layout);
}

Result<void> readViews(Project &project, const RecordSettings &settings, Followed &followed)
{
    for (const auto &[name, address] : settings.cameras) {
        LiveView view{name, {}};
        std::optional<FloorArea> area;
        if (const auto camera = project.cameras().find(name)) {
            view.floorView = ODO_TRY(floorViewInForce(project, camera->id));
            if (needsFloor(settings))
                area = ODO_TRY(areaOf(project, camera->id));
        }
        followed.views.push_back(std::move(view));
        followed.areas.push_back(std::move(area));
    }
    const auto isRegistered = [](const LiveView &view) { return view.floorView.has_value(); };
    if (std::ranges::any_of(followed.views, isRegistered))
        return {};
    if (settings.broadcast)
        return fail(
            ErrorCode::Undetermined, recordingSubject(settings.trial),
            ODO_TEXT(
                "workflow.no_live_positions",
                "none of its cameras is registered to the floor, so there are no live positions to send"),
            ODO_TEXT("workflow.register_or_do_not_send",
                     "run odograph register for one of them, or leave --ssl-vision out"));
    return fail(
        ErrorCode::Undetermined, recordingSubject(settings.trial),
        ODO_TEXT("workflow.no_floor_to_watch",
                 "none of its cameras is registered to the floor, so nothing there starts or ends it"),
        ODO_TEXT("workflow.register_or_give_seconds",
                 "register one of them, or give the seconds to record instead"));
}

} // namespace

Result<Followed> readFollowed(Project &project, const Result<std::vector<RobotRecord>> &robots,
                              const RecordSettings &settings)
{
    Followed followed;
    for (const auto *trigger : {&settings.start, &settings.stop}) {
        if (*trigger)
            ODO_TRY(checkTrigger(project, settings, **trigger));
    }
    const bool robotsMatter = settings.broadcast || needsRobots(settings.start) || needsRobots(settings.stop);
    if (!robotsMatter && !needsFloor(settings))
        return followed;
    ODO_TRY(readViews(project, settings, followed));
    if (!robotsMatter)
        return followed;
    if (!robots)
        return tl::unexpected(robots.error());
    followed.robots = *robots;
    if (settings.broadcast)
        followed.broadcast = ODO_TRY(LiveBroadcast::create(*settings.broadcast, *robots));
    return followed;
}

LiveFollowing::LiveFollowing(Followed followed) : m_followed(std::move(followed))
{
    for (std::size_t v = 0; v < m_followed.views.size(); ++v) {
        m_floors.emplace_back();
        if (m_followed.areas[v] && m_followed.views[v].floorView)
            m_floors.back().emplace(*m_followed.views[v].floorView, *m_followed.areas[v]);
    }
}

Result<std::unique_ptr<LiveFollowing>> LiveFollowing::begin(Followed followed, CaptureSession &session)
{
    std::unique_ptr<LiveFollowing> following(new LiveFollowing(std::move(followed)));
    const Followed &all = following->m_followed;
    if (!all.isNeeded())
        return following;
    std::vector<LiveTracker::Feed> feeds;
    for (std::size_t view = 0; view < all.views.size(); ++view)
        feeds.push_back(session.subscribeFrames(view, 2));
    auto tracker = LiveTracker::create(all.views, all.robots, std::move(feeds),
                                       {[&into = *following](const LiveSight &sight) { into.take(sight); },
                                        [&into = *following](const LiveMoment &moment) {
                                            if (into.m_followed.broadcast)
                                                into.m_followed.broadcast->take(moment);
                                            into.add(moment);
                                        }});
    if (!tracker)
        return tl::unexpected(tracker.error());
    following->m_tracker = std::move(*tracker);
    return following;
}

void LiveFollowing::take(const LiveSight &sight)
{
    auto &floor = m_floors[sight.view];
    if (!floor)
        return;
    if (const auto seen = floor->add(sight.timedFrame.captured.frame, sight.timedFrame.taken))
        add(*seen);
}

void LiveFollowing::add(Seen seen)
{
    const std::lock_guard lock(m_mutex);
    m_seen.push_back(std::move(seen));
    if (m_seen.size() > mostSeen)
        m_seen.pop_front();
}

std::optional<RunOrder> LiveFollowing::advance(RunControl &control)
{
    std::deque<Seen> seen;
    {
        const std::lock_guard lock(m_mutex);
        seen.swap(m_seen);
    }
    while (!seen.empty()) {
        const Seen next = std::move(seen.front());
        seen.pop_front();
        const auto *moment = std::get_if<LiveMoment>(&next);
        const auto order = moment ? control.robotAt(moment->robot, moment->position)
                                  : control.floorAt(std::get<MotionSight>(next));
        if (!order)
            continue;
        const std::lock_guard lock(m_mutex); // what is left comes with the next call
        m_seen.insert(m_seen.begin(), seen.begin(), seen.end());
        return order;
    }
    return control.tick();
}

} // namespace odo
