// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/free_height.h"

#include "core/base/percentile.h"
#include "core/trajectory/internal/fused_track.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t leastHeights = 10;
constexpr double highestJumpM = 0.15;
constexpr double unknownChangeSigmaM = 0.03; // of a height that is never seen twice in a row
constexpr double leastCrossing = 0.2;        // sine of the angle between two bearings on the floor
constexpr std::size_t medianReach = 8;       // frames to either side; a quarter of a second at 30 frames/s
constexpr double leastParallax =
    0.05; // metres on the floor per metre of height: below it the rays are as good as one

struct TimedHeight
{
    double heightM = 0, varianceM2 = 0;
};

/// Those that are not are left out when views are joined.
bool isTrusted(const Sighting &sighting)
{
    return sighting.seen && !sighting.cut && sighting.score >= FusionSettings().leastScore;
}

/// The height at which the views' rays come nearest at one time, and its variance from frame to frame. The
/// registrations weigh as well: views that are registered badly at that height do not decide it by their
/// sharp outlines.
std::optional<TimedHeight> heightAt(const std::vector<std::vector<Sighting>> &views, std::size_t i)
{
    double information = 0, projection = 0, variance = 0, parallax = 0;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            if (!isTrusted(views[a][i]) || !isTrusted(views[b][i]))
                continue;
            const FloorPosition &first = views[a][i].position, &second = views[b][i].position;
            const Eigen::Vector2d perMetre =
                first.displacementPerMetreHeight - second.displacementPerMetreHeight;
            const Eigen::Vector2d lever =
                (totalCovariance(first) + totalCovariance(second)).inverse() * perMetre;
            information += perMetre.dot(lever);
            projection -= lever.dot(first.pointInWorld - second.pointInWorld);
            variance += lever.dot((first.pixelCovariance + second.pixelCovariance) * lever);
            parallax = std::max(parallax, perMetre.norm());
        }
    }
    if (parallax < leastParallax || !(information > 0))
        return std::nullopt;
    return TimedHeight{projection / information, variance / (information * information)};
}

/// Median of the known heights near a time, the reach widened until there are some.
double medianNear(const std::vector<std::optional<TimedHeight>> &heights, std::size_t i)
{
    for (std::size_t reach = medianReach;; reach *= 2) {
        std::vector<double> near;
        const std::size_t begin = i > reach ? i - reach : 0, end = std::min(heights.size(), i + reach + 1);
        for (std::size_t k = begin; k < end; ++k) {
            if (heights[k])
                near.push_back(heights[k]->heightM);
        }
        if (!near.empty())
            return upperMedian(std::move(near));
    }
}

/// By how much a height changes within a number of frames, as the known heights of the run show it.
class HeightChange
{
public:
    explicit HeightChange(const std::vector<std::optional<TimedHeight>> &heights)
    {
        double largest = 0;
        for (std::size_t lag = 1; lag < heights.size(); lag *= 2) {
            double squares = 0, count = 0;
            for (std::size_t i = lag; i < heights.size(); ++i) {
                if (!heights[i] || !heights[i - lag])
                    continue;
                const double change = heights[i]->heightM - heights[i - lag]->heightM;
                squares += change * change;
                count += 1;
            }
            if (count < double(leastHeights))
                break;
            largest = std::max(largest, squares / count);
            m_variances.push_back(largest);
        }
    }

    /// Beyond the longest time that is known, as if it went on rising or falling.
    double varianceWithin(std::size_t frames) const
    {
        if (m_variances.empty())
            return unknownChangeSigmaM * unknownChangeSigmaM;
        std::size_t lag = 1;
        for (std::size_t k = 1; k < m_variances.size(); ++k, lag *= 2)
            if (frames <= 2 * lag)
                return m_variances[k - 1] +
                       (m_variances[k] - m_variances[k - 1]) * (double(frames) / double(lag) - 1);
        const double beyond = std::max(1.0, double(frames) / double(lag));
        return beyond * beyond * m_variances.back();
    }

private:
    std::vector<double> m_variances; ///< for 1, 2, 4, … frames
};

/// The height at a time at which it is not known, from those known before and after. The error is the same in
/// all times between those, which must not average it away.
TimedHeight between(const std::vector<std::optional<TimedHeight>> &heights, std::size_t i,
                    const HeightChange &change)
{
    double sum = 0, information = 0;
    const auto take = [&](std::size_t from, std::size_t frames) {
        const double weight = 1 / (heights[from]->varianceM2 + change.varianceWithin(frames));
        sum += weight * heights[from]->heightM;
        information += weight;
    };
    std::size_t before = i, behind = i;
    while (before > 0 && !heights[before])
        --before;
    while (behind + 1 < heights.size() && !heights[behind])
        ++behind;
    if (heights[before])
        take(before, i - before);
    if (heights[behind])
        take(behind, behind - i);
    const double alike = double(std::max<std::size_t>(1, behind - before - 1));
    return {sum / information, alike / information};
}

/// By how far the heights differ at which each of two views has the point where their bearings cross, m².
struct BearingMismatch
{
    double squared = 0, expected = 0; ///< as it is, and by the stated covariances
};

std::optional<BearingMismatch> mismatchOf(const Sighting &a, const Sighting &b)
{
    if (!isTrusted(a) || !isTrusted(b))
        return std::nullopt;
    Eigen::Matrix2d perMetre;
    perMetre << a.position.displacementPerMetreHeight, -b.position.displacementPerMetreHeight;
    if (std::abs(perMetre.determinant()) < leastCrossing * perMetre.col(0).norm() * perMetre.col(1).norm())
        return std::nullopt;
    const Eigen::RowVector2d toHeights = Eigen::RowVector2d(1, -1) * perMetre.inverse();
    const double mismatch = toHeights * (b.position.pointInWorld - a.position.pointInWorld);
    return BearingMismatch{mismatch * mismatch,
                           toHeights * (totalCovariance(a.position) + totalCovariance(b.position)) *
                               toHeights.transpose()};
}

/// Where the views' rays miss each other by more than is stated, throughout the run (a lens, a registration),
/// each is trusted less along its own direction: seen nearly level, a little of height is much of floor.
void widenByMismatch(std::vector<std::vector<Sighting>> &views)
{
    constexpr double medianOfChiSquared1 = 0.455;
    std::vector<double> squared, expected;
    for (std::size_t a = 0; a < views.size(); ++a)
        for (std::size_t b = a + 1; b < views.size(); ++b)
            for (std::size_t i = 0; i < std::min(views[a].size(), views[b].size()); ++i)
                if (const auto mismatch = mismatchOf(views[a][i], views[b][i])) {
                    squared.push_back(mismatch->squared);
                    expected.push_back(mismatch->expected);
                }
    if (squared.size() < leastHeights)
        return;
    const double excess =
        upperMedian(std::move(squared)) / medianOfChiSquared1 - upperMedian(std::move(expected));
    for (auto &view : views)
        for (Sighting &sighting : view) {
            const Eigen::Vector2d &perMetre = sighting.position.displacementPerMetreHeight;
            sighting.position.calibrationCovariance +=
                std::max(0.0, excess) / 2 * perMetre * perMetre.transpose();
        }
}

} // namespace

std::optional<FreeHeightSightings> freeHeight(std::vector<std::vector<Sighting>> views)
{
    const std::size_t times = views.empty() ? 0 : views.front().size();
    widenByMismatch(views);
    std::vector<std::optional<TimedHeight>> heights(times), sure(times);
    for (std::size_t i = 0; i < times; ++i)
        heights[i] = heightAt(views, i);
    std::vector<double> known;
    for (std::size_t i = 0; i < times; ++i) {
        if (!heights[i] || std::abs(heights[i]->heightM - medianNear(heights, i)) > highestJumpM)
            continue;
        sure[i] = heights[i];
        known.push_back(sure[i]->heightM);
    }
    if (known.size() < leastHeights)
        return std::nullopt;
    const HeightChange change(sure);
    for (std::size_t i = 0; i < times; ++i) {
        const TimedHeight height = sure[i] ? *sure[i] : between(sure, i, change);
        for (auto &view : views) {
            FloorPosition &position = view[i].position;
            position.pointInWorld += height.heightM * position.displacementPerMetreHeight;
            position.pixelCovariance += height.varianceM2 * position.displacementPerMetreHeight *
                                        position.displacementPerMetreHeight.transpose();
        }
    }
    return FreeHeightSightings{std::move(views), upperMedian(std::move(known))};
}

double heightScatterM(const std::vector<std::vector<Sighting>> &views, double heightM)
{
    std::vector<double> deviations;
    for (std::size_t i = 0; i < (views.empty() ? 0 : views.front().size()); ++i) {
        if (const auto height = heightAt(views, i))
            deviations.push_back(std::abs(height->heightM - heightM));
    }
    return deviations.size() < leastHeights ? 0 : 1.4826 * upperMedian(std::move(deviations));
}

} // namespace odo
