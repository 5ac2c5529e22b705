// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/edge_profile.h"

namespace odo {

// Not inline: between two frames the decoder drives this code out of the processor's cache, and one copy of
// it is sooner back than one for each use.

Float4 EdgeProfiles::mean(Float4 from, Float4 to) const
{
    return (upTo(to) - upTo(from)) / (to - from);
}

Float4 moveToEdges(const EdgeProfiles &profiles, const EdgeSearch &search, float leastContrast,
                   Float4 &places)
{
    const Float4 h = search.halfWidth, d = search.inward, perR = d / search.reference;
    const Float4 toEnd = d * h, toOuter = d * (h + search.reference);
    // Sums up to the ends of the stretches, from the inside outwards.
    const Float4 inner = profiles.upTo(places + toOuter), innerEnd = profiles.upTo(places + toEnd),
                 outerEnd = profiles.upTo(places - toEnd), outer = profiles.upTo(places - toOuter);
    const Float4 in = perR * (inner - innerEnd);
    Float4 out = perR * (outerEnd - outer);
    if (search.leadOn) {
        const Float4 farther = perR * (outer - profiles.upTo(places - toOuter - d * search.reference));
        out += (out - farther) * (0.5f + 0.5f * h / search.reference);
    }
    const Float4 contrasts = in - out;
    const Float4 across = d * (innerEnd - outerEnd) / (2 * h);
    const Float4 inside = atMost(atLeast((across - out) / contrasts, Float4{}), same(1));
    places = magnitudeOf(contrasts) < leastContrast ? places : places + toEnd * (1 - 2 * inside);
    return contrasts;
}

} // namespace odo
