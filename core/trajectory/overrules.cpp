// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/overrules.h"

#include <algorithm>

namespace odo {

void applyOverrules(std::vector<Sample> &samples, std::span<const Overrule> overrules)
{
    for (const Overrule &overrule : overrules) {
        const auto sample = std::find_if(samples.begin(), samples.end(),
                                         [&](const Sample &one) { return one.frame == overrule.frame; });
        if (sample == samples.end() || !sample->position)
            continue;
        sample->flags |= flagBit(SampleFlag::ByHand);
        if (overrule.isSpike)
            sample->flags |= flagBit(SampleFlag::Jump);
        else
            sample->flags &= ~rejectingFlags;
    }
}

std::vector<Overrule> withOverrule(std::vector<Overrule> overrules, Overrule added)
{
    overrules = withoutOverrule(std::move(overrules), added.frame);
    const auto behind = std::find_if(overrules.begin(), overrules.end(),
                                     [&](const Overrule &one) { return one.frame > added.frame; });
    overrules.insert(behind, added);
    return overrules;
}

std::vector<Overrule> withoutOverrule(std::vector<Overrule> overrules, std::int64_t frame)
{
    std::erase_if(overrules, [&](const Overrule &one) { return one.frame == frame; });
    return overrules;
}

} // namespace odo
