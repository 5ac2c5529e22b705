// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/region_sharing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr double costOfSharing = 1.0;    ///< a robot: two regions explain two robots better than one
constexpr double sharedAreaSigma = 0.15; ///< of the logarithm, beyond what overlap explains
constexpr double leastOfLargest = 0.85;  ///< the hindmost may be hidden wholly, the foremost not

class Sharing
{
public:
    explicit Sharing(const SharingProblem &problem)
        : m_problem(problem), m_choice(problem.alone.size(), -1), m_best(m_choice)
    {
    }

    std::vector<int> solve()
    {
        choose(0, 0);
        return m_best;
    }

private:
    /// What is sure already: the costs of sharing and of areas are only known at the end, and never negative.
    void choose(std::size_t robot, double surely)
    {
        if (surely >= m_leastCost)
            return;
        if (robot == m_choice.size()) {
            const double cost = total();
            if (cost < m_leastCost) {
                m_leastCost = cost;
                m_best = m_choice;
            }
            return;
        }
        for (std::size_t region = 0; region < m_problem.regionAreas.size(); ++region) {
            m_choice[robot] = static_cast<int>(region);
            choose(robot + 1,
                   surely + std::min(m_problem.alone[robot][region], m_problem.together[robot][region]));
        }
        m_choice[robot] = -1;
        choose(robot + 1, surely + m_problem.costOfNone);
    }

    double total() const
    {
        double cost = 0;
        for (const int choice : m_choice)
            cost += choice < 0 ? m_problem.costOfNone : 0;
        for (std::size_t region = 0; region < m_problem.regionAreas.size(); ++region)
            cost += costOfRegion(region);
        return cost;
    }

    double costOfRegion(std::size_t region) const
    {
        double alone = 0, together = 0, largest = 0, sum = 0;
        int robots = 0;
        for (std::size_t robot = 0; robot < m_choice.size(); ++robot) {
            if (m_choice[robot] != static_cast<int>(region))
                continue;
            ++robots;
            alone += m_problem.alone[robot][region];
            together += costOfSharing + m_problem.together[robot][region];
            largest = std::max(largest, m_problem.robotAreas[robot]);
            sum += m_problem.robotAreas[robot];
        }
        if (robots < 2)
            return alone;
        const double area = m_problem.regionAreas[region];
        const double off = std::max({0.0, std::log(leastOfLargest * largest / area), std::log(area / sum)}) /
                           sharedAreaSigma;
        return together + 0.5 * off * off;
    }

    const SharingProblem &m_problem;
    std::vector<int> m_choice, m_best;
    double m_leastCost = std::numeric_limits<double>::infinity();
};

} // namespace

std::vector<int> shareRegions(const SharingProblem &problem)
{
    return Sharing(problem).solve();
}

namespace {

constexpr int rowStep = 2; ///< every other row tells enough
constexpr int mostRounds = 4;
constexpr int mostMoves = 6;   ///< a robot, a round
constexpr double pull = 0.004; ///< of the prediction: the part of the outline's area lost a squared sample

struct Shift
{
    int x = 0, y = 0;
};

class Layout
{
public:
    Layout(const RegionMask &region, const std::vector<Silhouette> &silhouettes)
        : m_region(region), m_silhouettes(silhouettes), m_shifts(silhouettes.size()),
          m_start(silhouettes.size())
    {
        for (std::size_t i = 0; i < silhouettes.size(); ++i) {
            const Eigen::Vector2d moved = silhouettes[i].predicted - silhouettes[i].centre;
            m_start[i] = m_shifts[i] = {static_cast<int>(std::lround(moved.x())),
                                        static_cast<int>(std::lround(moved.y()))};
        }
    }

    std::vector<Eigen::Vector2d> lay()
    {
        for (int step : {3, 1}) {
            bool moved = true;
            for (int round = 0; moved && round < mostRounds; ++round) {
                moved = false;
                for (std::size_t i = 0; i < m_shifts.size(); ++i)
                    moved |= improve(i, step);
            }
        }
        std::vector<Eigen::Vector2d> centres;
        for (std::size_t i = 0; i < m_shifts.size(); ++i)
            centres.emplace_back(m_silhouettes[i].predicted +
                                 Eigen::Vector2d(m_shifts[i].x - m_start[i].x, m_shifts[i].y - m_start[i].y));
        return centres;
    }

private:
    bool improve(std::size_t i, int step)
    {
        double best = gainOf(i, m_shifts[i]);
        bool improved = false;
        for (int move = 0; move < mostMoves; ++move) {
            Shift next = m_shifts[i];
            for (const Shift &way : {Shift{step, 0}, Shift{-step, 0}, Shift{0, step}, Shift{0, -step}}) {
                const Shift tried{m_shifts[i].x + way.x, m_shifts[i].y + way.y};
                const double gain = gainOf(i, tried);
                if (gain > best) {
                    best = gain;
                    next = tried;
                }
            }
            if (next.x == m_shifts[i].x && next.y == m_shifts[i].y)
                break;
            m_shifts[i] = next;
            improved = true;
        }
        return improved;
    }

    bool coveredByOthers(std::size_t i, int x, int y) const
    {
        for (std::size_t other = 0; other < m_shifts.size(); ++other) {
            if (other != i && m_silhouettes[other].mask->at(x - m_shifts[other].x, y - m_shifts[other].y))
                return true;
        }
        return false;
    }

    /// Samples of the region that only this silhouette explains, less those that it covers outside of it.
    double gainOf(std::size_t i, Shift shift) const
    {
        const RegionMask &mask = *m_silhouettes[i].mask;
        int gain = 0, area = 0;
        for (int y = mask.area.top; y < mask.area.bottom; y += rowStep) {
            const std::uint8_t *row = mask.row(y) - mask.area.left;
            for (int x = mask.area.left; x < mask.area.right; ++x) {
                if (!row[x])
                    continue;
                ++area;
                const int px = x + shift.x, py = y + shift.y;
                if (!coveredByOthers(i, px, py))
                    gain += m_region.at(px, py) ? 1 : -1;
            }
        }
        const double dx = shift.x - m_start[i].x, dy = shift.y - m_start[i].y;
        return gain - pull * area * (dx * dx + dy * dy);
    }

    const RegionMask &m_region;
    const std::vector<Silhouette> &m_silhouettes;
    std::vector<Shift> m_shifts, m_start;
};

} // namespace

std::vector<Eigen::Vector2d> laySilhouettes(const RegionMask &region,
                                            const std::vector<Silhouette> &silhouettes)
{
    return Layout(region, silhouettes).lay();
}

} // namespace odo
