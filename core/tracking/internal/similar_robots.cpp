// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/similar_robots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odo {

namespace {

constexpr double leastPart = 0.1; ///< of the smallest robot's area; smaller regions are noise
constexpr std::size_t mostRegions = 6;

ChromaRect joined(const ChromaRect &a, const ChromaRect &b)
{
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

/// Half the squared distance, in standard deviations, by which a point is outside a region.
double costOutside(const TrackedFrame &frame, const Blob &region, const Eigen::Vector2d &positionPx)
{
    constexpr double inside =
        3.0; ///< squared, in the region's own standard deviations; its edge is at 3 to 4
    const Eigen::Vector2d off = frame.grid().fromLuma(positionPx) - region.centre();
    return 0.5 * std::max(0.0, off.dot(region.covariance().inverse() * off) - inside);
}

} // namespace

std::vector<int> SimilarRobots::share(const TrackedFrame &frame,
                                      const std::vector<RobotFollower *> &robots) const
{
    SharingProblem problem;
    for (const Blob &region : m_regions)
        problem.regionAreas.push_back(region.area() * frame.lumaPerSample());
    for (const RobotFollower *robot : robots) {
        problem.robotAreas.push_back(robot->areaPx());
        auto &alone = problem.alone.emplace_back();
        auto &together = problem.together.emplace_back();
        for (const Blob &region : m_regions) {
            alone.push_back(robot->costOf(frame, region));
            together.push_back(costOutside(frame, region, robot->predictedPx(frame)));
        }
    }
    return shareRegions(problem);
}

/// The shared region, with the regions that are nobody's: a robot that comes out behind another one is at
/// first too small to be recognised.
void SimilarRobots::paintShared(const RobotFollower &finder, const std::vector<int> &choices, int region)
{
    ChromaRect area = m_regions[region].box;
    const auto belongs = [&](int other) {
        return other == region || std::find(choices.begin(), choices.end(), other) == choices.end();
    };
    for (int other = 0; other < static_cast<int>(m_regions.size()); ++other) {
        if (belongs(other))
            area = joined(area, m_regions[other].box);
    }
    m_shared.reset(area);
    for (int other = 0; other < static_cast<int>(m_regions.size()); ++other) {
        if (!belongs(other))
            continue;
        finder.paint(m_regions[other], m_piece);
        const ChromaRect box = m_regions[other].box;
        for (int y = box.top; y < box.bottom; ++y) {
            const std::uint8_t *from = m_piece.row(y) + (box.left - m_piece.area.left);
            std::uint8_t *to = m_shared.row(y) + (box.left - m_shared.area.left);
            for (int i = 0; i < box.width(); ++i)
                to[i] |= from[i];
        }
    }
}

void SimilarRobots::separate(const TrackedFrame &frame, const std::vector<RobotFollower *> &robots,
                             const std::vector<Observation *> &observations, const std::vector<int> &choices,
                             int region)
{
    std::vector<std::size_t> members;
    std::vector<Silhouette> silhouettes;
    for (std::size_t i = 0; i < robots.size(); ++i) {
        if (choices[i] != region)
            continue;
        members.push_back(i);
        silhouettes.push_back({&robots[i]->silhouette(), robots[i]->silhouetteCentre(),
                               frame.grid().fromLuma(robots[i]->predictedPx(frame))});
    }
    paintShared(*robots[members.front()], choices, region);
    const auto centres = laySilhouettes(m_shared, silhouettes);
    for (std::size_t k = 0; k < members.size(); ++k)
        robots[members[k]]->acceptTogether(frame, frame.grid().toLuma(centres[k]), *observations[members[k]]);
}

void SimilarRobots::follow(const TrackedFrame &frame, const std::vector<RobotFollower *> &robots,
                           const std::vector<Observation *> &observations)
{
    ChromaRect window = robots.front()->windowOf(frame);
    ChromaTable table = robots.front()->model().table();
    double smallestPx = robots.front()->areaPx();
    for (std::size_t i = 1; i < robots.size(); ++i) {
        window = joined(window, robots[i]->windowOf(frame));
        table.add(robots[i]->model().table());
        smallestPx = std::min(smallestPx, robots[i]->areaPx());
    }
    for (RobotFollower *robot : robots)
        robot->lookAt(frame, window, table);
    m_regions = robots.front()->regions();
    std::erase_if(m_regions, [&](const Blob &region) {
        return region.area() * frame.lumaPerSample() < leastPart * smallestPx;
    });
    std::sort(m_regions.begin(), m_regions.end(),
              [](const Blob &a, const Blob &b) { return a.count > b.count; });
    if (m_regions.size() > mostRegions)
        m_regions.resize(mostRegions);

    const std::vector<int> choices = share(frame, robots);
    for (int region = 0; region < static_cast<int>(m_regions.size()); ++region) {
        const auto sharers = std::count(choices.begin(), choices.end(), region);
        if (sharers > 1) {
            separate(frame, robots, observations, choices, region);
        } else if (sharers == 1) {
            const auto robot =
                static_cast<std::size_t>(std::find(choices.begin(), choices.end(), region) - choices.begin());
            const Blob &blob = m_regions[region];
            robots[robot]->accept(frame, {blob, frame.grid().toLuma(blob.centre()), 1.0},
                                  *observations[robot]);
        }
    }
}

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

constexpr int rowStep = 2; ///< every other row is enough
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
