// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/synchroniser.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

Nanoseconds apart(Nanoseconds a, Nanoseconds b)
{
    return a > b ? a - b : b - a;
}

} // namespace

Synchroniser::Synchroniser(Settings settings)
    : m_settings(settings), m_waiting(settings.views), m_newest(settings.views)
{
}

void Synchroniser::add(std::size_t view, TimedFrame frame)
{
    if (m_newest[view] && frame.taken <= *m_newest[view]) {
        ++m_statistics.unpaired;
        return;
    }
    m_newest[view] = frame.taken;
    m_waiting[view].push_back(std::move(frame));
}

/// Whether no frame that is still to come can change which ones belong to a frame of the first view that
/// was taken then: the other views have gone past its reach, and its own follower is there, for which a
/// frame in between might be the nearer one.
bool Synchroniser::isDecided(Nanoseconds time, Nanoseconds now) const
{
    if (now - time >= m_settings.longestWait)
        return true;
    const Nanoseconds reach = time + m_settings.tolerance;
    const bool followed = m_waiting.front().size() > 1 || (m_newest.front() && *m_newest.front() > time);
    return followed && std::all_of(m_newest.begin() + 1, m_newest.end(),
                                   [&](const auto &newest) { return newest && *newest >= reach; });
}

std::vector<FrameSet> Synchroniser::take(Nanoseconds now)
{
    std::vector<FrameSet> sets;
    while (!m_waiting.front().empty() && isDecided(m_waiting.front().front().taken, now))
        sets.push_back(takeFirst());
    // Where the first view stalls, nothing else would ever remove the others' frames.
    const Nanoseconds givenUp = now - m_settings.longestWait - m_settings.tolerance;
    for (std::size_t view = 1; view < m_waiting.size(); ++view) {
        while (!m_waiting[view].empty() && m_waiting[view].front().taken < givenUp)
            dropUnpaired(view);
    }
    return sets;
}

std::vector<FrameSet> Synchroniser::takeRest()
{
    std::vector<FrameSet> sets;
    while (!m_waiting.front().empty())
        sets.push_back(takeFirst());
    for (std::size_t view = 1; view < m_waiting.size(); ++view) {
        while (!m_waiting[view].empty())
            dropUnpaired(view);
    }
    return sets;
}

PairStatistics Synchroniser::takeStatistics()
{
    return std::exchange(m_statistics, {});
}

void Synchroniser::dropUnpaired(std::size_t view)
{
    m_waiting[view].pop_front();
    ++m_statistics.unpaired;
}

FrameSet Synchroniser::takeFirst()
{
    FrameSet set;
    set.views.resize(m_settings.views);
    TimedFrame first = std::move(m_waiting.front().front());
    m_waiting.front().pop_front();
    std::optional<Nanoseconds> following;
    if (!m_waiting.front().empty())
        following = m_waiting.front().front().taken;
    bool alone = true;
    for (std::size_t view = 1; view < m_settings.views; ++view) {
        set.views[view] = takePartner(view, first.taken, following);
        if (!set.views[view])
            continue;
        alone = false;
        ++m_statistics.pairs;
        m_statistics.errorsS.push_back(toSeconds(set.views[view]->taken - first.taken));
    }
    if (alone && m_settings.views > 1)
        ++m_statistics.unpaired;
    set.views.front() = std::move(first);
    return set;
}

std::optional<TimedFrame> Synchroniser::takePartner(std::size_t view, Nanoseconds time,
                                                    std::optional<Nanoseconds> following)
{
    auto &waiting = m_waiting[view];
    // Before the nearest one, all are further from this frame, and further still from those after it.
    while (waiting.size() > 1 && apart(waiting[1].taken, time) <= apart(waiting[0].taken, time))
        dropUnpaired(view);
    if (!waiting.empty() && waiting.front().taken + m_settings.tolerance < time)
        dropUnpaired(view);
    if (waiting.empty() || apart(waiting.front().taken, time) > m_settings.tolerance)
        return std::nullopt;
    if (following && apart(*following, waiting.front().taken) < apart(waiting.front().taken, time))
        return std::nullopt; // it is the nearest of the frame after this one
    TimedFrame partner = std::move(waiting.front());
    waiting.pop_front();
    return partner;
}

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
    const PairStatistics fresh = m_synchroniser.takeStatistics();
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

PairStatistics pairStatistics(const std::vector<std::vector<Nanoseconds>> &takenOfViews,
                              Nanoseconds tolerance)
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
    return synchroniser.takeStatistics();
}

} // namespace odo
