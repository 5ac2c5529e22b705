// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/repeated_pictures.h"

#include <algorithm>
#include <optional>

namespace odo {

namespace {

constexpr double stillPx = 0.06, stillShare = 0.06; // of a usual step
constexpr double leastStepPx = 0.8;
constexpr std::size_t mostRepeats = 4;
constexpr double missedShare = 0.35; // of what was to be caught up may be explained by acceleration

bool isUsable(const Observation &observation)
{
    return observation.found && !observation.duplicateFrame && observation.ellipse.centrePx.allFinite();
}

/// Pixels a second between two neighbouring observations; nullopt where there is none.
std::optional<Eigen::Vector2d> velocityBetween(const Observation &a, const Observation &b)
{
    const double dt = toSeconds(b.time - a.time);
    if (!isUsable(a) || !isUsable(b) || !(dt > 0))
        return std::nullopt;
    return Eigen::Vector2d((b.ellipse.centrePx - a.ellipse.centrePx) / dt);
}

/// Whether observations [first, last] repeat the picture of first − 1.
bool isRepeat(const std::vector<Observation> &all, std::size_t first, std::size_t last)
{
    if (first < 2 || last + 2 >= all.size())
        return false;
    const Observation &before = all[first - 1], &after = all[last + 1];
    const auto in = velocityBetween(all[first - 2], before), out = velocityBetween(after, all[last + 2]);
    if (!in || !out || !isUsable(after))
        return false;
    const Eigen::Vector2d usual = (*in + *out) / 2;
    const double frameS = toSeconds(after.time - before.time) / static_cast<double>(last - first + 2);
    const double stepPx = usual.norm() * frameS;
    if (stepPx < leastStepPx || (*in - *out).norm() > usual.norm())
        return false;
    for (std::size_t i = first; i <= last; ++i) {
        if (!isUsable(all[i]) || (all[i].ellipse.centrePx - before.ellipse.centrePx).norm() >
                                     std::max(stillPx, stillShare * stepPx))
            return false;
    }
    const Eigen::Vector2d expected = usual * toSeconds(after.time - before.time);
    const double missedPx = stepPx * static_cast<double>(last - first + 1);
    return (after.ellipse.centrePx - before.ellipse.centrePx - expected).norm() < missedShare * missedPx;
}

} // namespace

std::vector<bool> repeatedPictures(const std::vector<Observation> &observations)
{
    std::vector<bool> repeated(observations.size());
    for (std::size_t i = 2; i < observations.size(); ++i) {
        for (std::size_t count = 1; count <= mostRepeats; ++count) {
            if (!isRepeat(observations, i, i + count - 1))
                continue;
            std::fill_n(repeated.begin() + static_cast<std::ptrdiff_t>(i), count, true);
            i += count;
            break;
        }
    }
    return repeated;
}

} // namespace odo
