// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/similar_robots.h"

#include "core/tracking/region_sharing.h"

#include <algorithm>
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

/// Half the squared distance, in standard deviations, by which a place lies outside a region.
double costOutside(const TrackedFrame &frame, const Blob &region, const Eigen::Vector2d &placePx)
{
    constexpr double inside =
        3.0; ///< squared, in the region's own standard deviations; its edge is at 3 to 4
    const Eigen::Vector2d off = frame.grid().fromLuma(placePx) - region.centre();
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
/// first too small to be taken for itself.
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

} // namespace odo
