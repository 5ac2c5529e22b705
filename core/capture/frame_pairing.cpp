// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/frame_pairing.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds remembered = 10s;
constexpr double binS = 0.001;

/// A bin of 1 ms each, the middle one around 0, as many as the tolerance reaches.
std::vector<std::uint32_t> histogramOf(const std::vector<double> &errorsS, Nanoseconds tolerance)
{
    const auto side = static_cast<std::ptrdiff_t>(std::ceil(toSeconds(tolerance) / binS));
    std::vector<std::uint32_t> bins(static_cast<std::size_t>(2 * side + 1));
    for (const double errorS : errorsS)
        ++bins[static_cast<std::size_t>(side +
                                        std::clamp<std::ptrdiff_t>(std::lround(errorS / binS), -side, side))];
    return bins;
}

} // namespace

FramePairing::FramePairing(Synchroniser::Settings settings)
    : m_tolerance(settings.tolerance), m_synchroniser(settings)
{
}

void FramePairing::add(std::size_t view, TimedFrame frame, Nanoseconds now)
{
    const std::lock_guard lock(m_mutex);
    m_synchroniser.add(view, std::move(frame));
    m_synchroniser.take(now);
    const PairFigures fresh = m_synchroniser.takeFigures();
    m_pairs += fresh.pairs;
    m_unpaired += fresh.unpaired;
    for (const double errorS : fresh.errorsS)
        m_recent.push_back({now, errorS});
    while (!m_recent.empty() && m_recent.front().at < now - remembered)
        m_recent.pop_front();
}

PairHealth FramePairing::health(Nanoseconds now) const
{
    PairHealth health;
    std::vector<double> errorsS;
    {
        const std::lock_guard lock(m_mutex);
        health.pairs = m_pairs;
        health.unpaired = m_unpaired;
        for (const PairError &error : m_recent) {
            if (error.at >= now - remembered)
                errorsS.push_back(error.errorS);
        }
    }
    health.binS = binS;
    health.histogram = histogramOf(errorsS, m_tolerance);
    for (double &errorS : errorsS)
        errorS = std::abs(errorS);
    health.medianS = percentile(errorsS, 50);
    health.p95S = percentile(errorsS, 95);
    health.largestS = percentile(std::move(errorsS), 100);
    return health;
}

PairFigures pairFigures(const std::vector<std::vector<Nanoseconds>> &takenOfViews, Nanoseconds tolerance)
{
    Synchroniser synchroniser({takenOfViews.size(), tolerance, std::chrono::years(100)});
    std::vector<std::size_t> next(takenOfViews.size());
    for (;;) {
        std::optional<std::size_t> earliest;
        for (std::size_t view = 0; view < takenOfViews.size(); ++view) {
            if (next[view] == takenOfViews[view].size())
                continue;
            if (!earliest || takenOfViews[view][next[view]] < takenOfViews[*earliest][next[*earliest]])
                earliest = view;
        }
        if (!earliest)
            break;
        synchroniser.add(*earliest, {{}, takenOfViews[*earliest][next[*earliest]++]});
        synchroniser.take({});
    }
    synchroniser.takeRest();
    return synchroniser.takeFigures();
}

} // namespace odo
