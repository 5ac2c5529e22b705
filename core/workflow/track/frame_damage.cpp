// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/frame_damage.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace odo {

namespace {

/// Calls visit(frame) for each frame without an observation, in order.
template <class Visit>
void forEachDamaged(const std::vector<Observation> &observations, std::size_t frames, const Visit &visit)
{
    if (observations.empty() || observations.size() >= frames)
        return;
    auto next = observations.begin();
    for (std::size_t frame = 0; frame < frames; ++frame) {
        if (next != observations.end() && next->frame == static_cast<std::int64_t>(frame))
            ++next;
        else
            visit(frame);
    }
}

} // namespace

FrameDamage damageOf(const std::vector<Observation> &observations, const std::vector<Nanoseconds> &frameTimes)
{
    FrameDamage damage;
    forEachDamaged(observations, frameTimes.size(), [&](std::size_t frame) {
        if (damage.frames++ == 0)
            damage.span.begin = frameTimes[frame];
        damage.span.end = frameTimes[frame];
    });
    return damage;
}

void insertDamaged(std::vector<Observation> &observations, const std::vector<Nanoseconds> &frameTimes)
{
    std::vector<Observation> damaged;
    forEachDamaged(observations, frameTimes.size(), [&](std::size_t frame) {
        Observation &one = damaged.emplace_back();
        one.frame = static_cast<std::int64_t>(frame);
        one.time = frameTimes[frame];
        one.isDamaged = true;
    });
    if (damaged.empty())
        return;
    std::vector<Observation> all;
    all.reserve(observations.size() + damaged.size());
    std::merge(observations.begin(), observations.end(), damaged.begin(), damaged.end(),
               std::back_inserter(all),
               [](const Observation &a, const Observation &b) { return a.frame < b.frame; });
    observations = std::move(all);
}

void removeDamaged(std::vector<Observation> &observations)
{
    std::erase_if(observations, [](const Observation &one) { return one.isDamaged; });
}

} // namespace odo
