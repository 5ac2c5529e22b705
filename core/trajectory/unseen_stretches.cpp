// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/unseen_stretches.h"

#include <algorithm>
#include <cstdio>

namespace odo {

namespace {

constexpr Nanoseconds longestAtEnd = std::chrono::milliseconds(500);

/// Rejected spikes in between do not show where it is; but mostly spikes is another matter than not seen.
bool mostlyUnseen(const std::vector<Sample> &samples, std::size_t begin, std::size_t end)
{
    std::size_t unseen = 0;
    for (std::size_t i = begin; i < end; ++i)
        unseen += !samples[i].position;
    return 2 * unseen > end - begin;
}

std::string sentence(const Sample &left, const Sample *back)
{
    char text[256];
    std::snprintf(text, sizeof text, " (it was at X %.2f m, Y %.2f m); ", left.position->x(),
                  left.position->y());
    char when[96];
    if (back)
        std::snprintf(when, sizeof when, "no view sees it from %.1f s to %.1f s", toSeconds(left.time),
                      toSeconds(back->time));
    else
        std::snprintf(when, sizeof when, "no view sees it after %.1f s", toSeconds(left.time));
    return std::string(when) + text +
           "move or add a camera so that the whole task is seen; the figures are of the part that was seen";
}

} // namespace

std::vector<std::string> describeUnseenStretches(const Profile &profile, Nanoseconds longestBridgedGap)
{
    const std::vector<Sample> &samples = profile.samples;
    std::vector<std::string> sentences;
    const Sample *last = nullptr;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!isUsed(samples[i]))
            continue;
        const Sample &next = samples[i];
        const auto since = last ? static_cast<std::size_t>(last - samples.data()) + 1 : i;
        if (last && next.time - last->time > longestBridgedGap && mostlyUnseen(samples, since, i))
            sentences.push_back(sentence(*last, &next));
        last = &next;
    }
    if (!last)
        return sentences;
    const auto since = static_cast<std::size_t>(last - samples.data()) + 1;
    if (samples.back().time - last->time > longestAtEnd && mostlyUnseen(samples, since, samples.size()))
        sentences.push_back(sentence(*last, nullptr));
    return sentences;
}

} // namespace odo
