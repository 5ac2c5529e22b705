// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/connected_parts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace odo {

namespace {

/// The runs of a set, and for each another one of its part, which leads on to the part's first.
class LinkedRuns
{
public:
    /// touch: by how much runs of two rows may be apart in x; 1: at a corner.
    LinkedRuns(const BitMask &set, int touch)
    {
        m_runs.reserve(std::size_t(set.height()) * 4);
        m_leads.reserve(std::size_t(set.height()) * 4);
        std::size_t above = 0, here = 0; // first runs of the two rows
        for (int y = 0; y < set.height(); ++y) {
            above = here;
            here = m_runs.size();
            for (int x = set.nextSet(0, y); x < set.width(); x = set.nextSet(m_runs.back().x1, y)) {
                m_runs.push_back({y, x, set.nextClear(x, y)});
                m_leads.push_back(m_runs.size() - 1);
            }
            for (std::size_t a = above, b = here; a < here && b < m_runs.size();) {
                if (m_runs[a].x0 < m_runs[b].x1 + touch && m_runs[b].x0 < m_runs[a].x1 + touch)
                    join(a, b);
                (m_runs[a].x1 < m_runs[b].x1 ? a : b) += 1;
            }
        }
    }

    ConnectedParts parts()
    {
        std::vector<std::size_t> numbers(m_runs.size()), places; // of each run its part's; of each part where its next run belongs
        for (std::size_t i = 0; i < m_runs.size(); ++i) {
            const std::size_t first = firstOf(i);
            numbers[i] = first == i ? places.size() : numbers[first];
            if (first == i)
                places.push_back(0);
            ++places[numbers[i]];
        }
        std::exclusive_scan(places.begin(), places.end(), places.begin(), std::size_t(0));
        std::vector<PixelRun> runs(m_runs.size());
        for (std::size_t i = 0; i < m_runs.size(); ++i)
            runs[places[numbers[i]]++] = m_runs[i];
        return ConnectedParts(std::move(runs), places);
    }

private:
    std::size_t firstOf(std::size_t run)
    {
        while (m_leads[run] != run)
            run = m_leads[run] = m_leads[m_leads[run]];
        return run;
    }
    void join(std::size_t a, std::size_t b)
    {
        const std::size_t firstOfA = firstOf(a), firstOfB = firstOf(b);
        m_leads[std::max(firstOfA, firstOfB)] = std::min(firstOfA, firstOfB);
    }

    std::vector<PixelRun> m_runs;
    std::vector<std::size_t> m_leads;
};

} // namespace

ConnectedParts::ConnectedParts(std::vector<PixelRun> runs, const std::vector<std::size_t> &ends) : m_runs(std::move(runs))
{
    m_parts.reserve(ends.size());
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        m_parts.emplace_back(m_runs.data() + begin, end - begin);
        begin = end;
    }
}

ConnectedParts connectedParts(const BitMask &set)
{
    return LinkedRuns(set, 1).parts();
}

PixelRect boundsOf(const ConnectedPart &part)
{
    PixelRect box;
    for (const PixelRun &run : part)
        box = box.united({run.x0, run.y, run.x1, run.y + 1});
    return box;
}

bool contains(const ConnectedPart &part, int x, int y)
{
    return std::ranges::any_of(part, [&](const PixelRun &run) { return run.y == y && run.x0 <= x && x < run.x1; });
}

bool enclosesAny(const ConnectedPart &part)
{
    // Where nothing is enclosed, the runs that touch those of the next row hang together as a tree: there is one such link less than runs.
    std::size_t links = 0, above = 0;
    for (const PixelRun &run : part) {
        const auto isPassed = [&](const PixelRun &one) { return one.y < run.y - 1 || (one.y == run.y - 1 && one.x1 < run.x0); };
        while (isPassed(part[above]))
            ++above;
        for (std::size_t i = above; part[i].y == run.y - 1 && part[i].x0 <= run.x1; ++i)
            ++links;
    }
    return links >= part.size();
}

BitMask withoutHoles(const BitMask &set)
{
    // What encloses pixels even where it only touches at a corner: around it the rest hangs together by sides.
    const ConnectedParts rest = LinkedRuns(set.padded(1).complement(), 0).parts();
    if (rest.size() == 1)
        return set;
    BitMask filled = set;
    for (std::size_t i = 1; i < rest.size(); ++i) // the first is what lies outside
        for (const PixelRun &run : rest[i])
            filled.setRun(run.y - 1, run.x0 - 1, run.x1 - 1);
    return filled;
}

} // namespace odo
