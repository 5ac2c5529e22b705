// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/run_events.h"

#include "core/trajectory/motion_stretches.h"
#include "ui/models/core_words.h"
#include "ui/models/figure_text.h"
#include "ui/models/profile_place.h"

#include <QCoreApplication>
#include <algorithm>
#include <optional>

namespace odo {

namespace {

class RunEventsWords
{
    Q_DECLARE_TR_FUNCTIONS(RunEvents)
};

/// An event with how much it matters: of two the one of less weight goes first.
struct Weighed
{
    RunEvent event;
    int weight = 0;
};
constexpr int motionWeight = 30000, gateWeight = 20000, mostSpikeWeight = 10000;

std::optional<Eigen::Vector2d> placeAt(const Profile &profile, Nanoseconds time)
{
    const std::ptrdiff_t index = pointIndexAt(profile, time);
    if (index < 0)
        return std::nullopt;
    return profile.points[std::size_t(index)].position;
}

void addMotion(const Profile &profile, std::vector<Weighed> &events)
{
    const std::vector<RunInstant> instants = validInstants(profile.samples, profile.points);
    const std::vector<MotionStretch> motions = findMotions(instants);
    if (motions.empty())
        return;
    const auto add = [&](const RunInstant &at, double timeS, const QString &words) {
        events.push_back({{RunEvent::Kind::Motion, 0, fromSeconds(timeS), fromSeconds(timeS),
                           at.point->position, words},
                          motionWeight});
    };
    add(instants[motions.front().first], motions.front().startS,
        motions.front().first == 0 ? RunEventsWords::tr("First seen, moving already")
                                   : RunEventsWords::tr("Starts to move"));
    add(instants[motions.back().last], motions.back().stopS,
        motions.back().last + 1 == instants.size() ? RunEventsWords::tr("Last seen, still moving")
                                                   : RunEventsWords::tr("Stops"));
}

void addTopSpeed(const Profile &profile, std::vector<Weighed> &events)
{
    // As max_speed of core/trajectory/metrics.h: a badly known point does not win by its error.
    const auto sureSpeed = [](const ProfilePoint &point) {
        return point.valid ? point.speedMps - 2 * point.sigmaSpeedMps : -1;
    };
    const auto top = std::ranges::max_element(profile.points, {}, sureSpeed);
    if (top == profile.points.end() || sureSpeed(*top) <= 0)
        return;
    const Nanoseconds time = profile.samples[std::size_t(top - profile.points.begin())].time;
    events.push_back({{RunEvent::Kind::TopSpeed, 0, time, time, top->position,
                       RunEventsWords::tr("Top speed, %1").arg(speedText(top->speedMps, top->sigmaSpeedMps))},
                      motionWeight});
}

void addGates(const Profile &profile, std::vector<Weighed> &events)
{
    for (const GatePassage &passage : profile.passages) {
        const auto place = placeAt(profile, passage.time);
        if (place)
            events.push_back({{RunEvent::Kind::Gate, 0, passage.time, passage.time, *place,
                               RunEventsWords::tr("Passes %1").arg(QString::fromStdString(passage.gate))},
                              gateWeight});
    }
}

void addSpikes(const Profile &profile, std::vector<Weighed> &events)
{
    constexpr std::int64_t apart = 5; // samples, that still are one event
    for (std::size_t first = 0; first < profile.spikes.size();) {
        std::size_t end = first + 1;
        while (end < profile.spikes.size() &&
               profile.spikes[end].sampleIndex - profile.spikes[end - 1].sampleIndex <= apart)
            ++end;
        const Spike &spike = profile.spikes[first];
        const auto count = int(end - first);
        const auto &sample = profile.samples[std::size_t(spike.sampleIndex)];
        const auto place = sample.position ? sample.position : placeAt(profile, spike.time);
        if (place) {
            QString words = RunEventsWords::tr("Spike: %1").arg(shownWords(spike.reason));
            if (count > 1)
                words += QStringLiteral(" ") + RunEventsWords::tr("(%n samples)", "", count);
            events.push_back({{RunEvent::Kind::Spike, 0, spike.time, profile.spikes[end - 1].time, *place, words},
                              std::min(count, mostSpikeWeight)});
        }
        first = end;
    }
}

} // namespace

std::vector<RunEvent> runEvents(const Profile &profile, std::size_t most)
{
    std::vector<Weighed> found;
    addMotion(profile, found);
    addTopSpeed(profile, found);
    addGates(profile, found);
    addSpikes(profile, found);
    std::ranges::stable_sort(found, std::ranges::greater(), &Weighed::weight);
    found.resize(std::min(found.size(), most));
    std::ranges::stable_sort(found, {}, [](const Weighed &each) { return each.event.time; });
    std::vector<RunEvent> events;
    for (Weighed &each : found) {
        each.event.number = int(events.size()) + 1;
        events.push_back(std::move(each.event));
    }
    return events;
}

} // namespace odo
