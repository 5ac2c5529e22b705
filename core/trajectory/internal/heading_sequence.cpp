// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/heading_sequence.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace odo {

namespace {

constexpr double fastestChange = 6;   // rad/s, of the rate from one heading to the next
constexpr double mostChanging = 5;    // rad/s², over headings that are left out
constexpr double mostBeyondRad = 0.4; // there
constexpr double leastLimitRad = 0.17, mostScatterRad = std::numbers::pi / 4;
constexpr double scatters = 5;                     // normal scatter, of a step
constexpr double costAtLimit = 8, freeShare = 0.7; // headings; up to a share of the limit a turn is free
constexpr std::size_t stepsAround = 4, mostLeftOut = 60;
constexpr double leastShare = 0.7;
constexpr double normalSigma = 1.4826; // over the median of the amounts

double turned(double fromRad, double toRad)
{
    return std::remainder(toRad - fromRad, 2 * std::numbers::pi);
}

/// The rate of turning around each heading: the median of the steps there, so that few wrong ones don't
/// count.
std::vector<double> ratesAround(const std::vector<TimedHeading> &headings)
{
    std::vector<double> rates, around;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        around.clear();
        const std::size_t first = i < stepsAround ? 1 : i - stepsAround + 1;
        for (std::size_t k = first; k < std::min(headings.size(), i + stepsAround + 1); ++k)
            if (const double seconds = headings[k].timeS - headings[k - 1].timeS; seconds > 0)
                around.push_back(turned(headings[k - 1].radians, headings[k].radians) / seconds);
        rates.push_back(around.size() < 3 ? 0 : median(around));
    }
    return rates;
}

class Sequence
{
public:
    explicit Sequence(const std::vector<TimedHeading> &headings)
        : m_headings(headings), m_rates(ratesAround(headings))
    {
        if (headings.size() < 2)
            return;
        std::vector<double> away, steps;
        for (std::size_t i = 1; i < headings.size(); ++i) {
            away.push_back(std::min(beyond(i - 1, i, m_rates[i - 1]), beyond(i - 1, i, m_rates[i])));
            steps.push_back(headings[i].timeS - headings[i - 1].timeS);
        }
        const double scatter = normalSigma * median(std::move(away));
        m_usualStepS = median(std::move(steps));
        m_leastRad = std::clamp(scatters * scatter, leastLimitRad, mostScatterRad);
    }

    /// What it costs to have the one after the other, in headings; nullopt: no robot turns like that.
    std::optional<double> cost(std::size_t from, std::size_t to) const
    {
        const double seconds = m_headings[to].timeS - m_headings[from].timeS,
                     leftOutS = double(to - from - 1) * m_usualStepS,
                     limit = std::max(m_leastRad, fastestChange * (seconds - leftOutS)) +
                             std::min(mostChanging / 2 * leftOutS * leftOutS, mostBeyondRad);
        // A spin begins within a step; over what is left out, both sides must agree.
        const auto [least, most] =
            std::minmax({beyond(from, to, m_rates[from]), beyond(from, to, m_rates[to])});
        const double share = (to - from > 1 ? most : least) / limit;
        return share <= 1 ? std::optional(costAtLimit *
                                          std::pow(std::max(0.0, (share - freeShare) / (1 - freeShare)), 2))
                          : std::nullopt;
    }

private:
    /// How far the turn from one to the other differs from one at a rate.
    double beyond(std::size_t from, std::size_t to, double rate) const
    {
        const double seconds = m_headings[to].timeS - m_headings[from].timeS;
        return std::abs(turned(m_headings[from].radians + rate * seconds, m_headings[to].radians));
    }

    const std::vector<TimedHeading> &m_headings;
    std::vector<double> m_rates;
    double m_leastRad = leastLimitRad, m_usualStepS = 0;
};

} // namespace

std::vector<std::size_t> headingsInSequence(const std::vector<TimedHeading> &headings)
{
    struct Link
    {
        double worth = 1; ///< the headings of its chain, less what they cost
        double length = 1;
        std::optional<std::size_t> before;
    };
    const Sequence sequence(headings);
    std::vector<Link> links(headings.size());
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        for (std::size_t back = 1; back <= std::min(i, mostLeftOut); ++back) {
            const Link &before = links[i - back];
            if (before.worth + 1 <= links[i].worth)
                continue;
            const auto cost = sequence.cost(i - back, i);
            if (cost && before.worth + 1 - *cost > links[i].worth)
                links[i] = {before.worth + 1 - *cost, before.length + 1, i - back};
        }
        if (!last || links[i].worth > links[*last].worth)
            last = i;
    }
    if (!last || links[*last].length < leastShare * double(headings.size()))
        return {};
    std::vector<std::size_t> kept;
    for (std::optional<std::size_t> i = last; i; i = links[*i].before)
        kept.push_back(*i);
    std::ranges::reverse(kept);
    return kept;
}

} // namespace odo
