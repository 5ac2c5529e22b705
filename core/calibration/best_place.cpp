// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/best_place.h"

#include "core/base/units.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr int placesAcross = 13, gridAcross = 12, rounds = 4;
constexpr double aims[] = {-0.2, 0, 0.2}; // of the extent, from the middle towards the camera

struct Score
{
    int unseen = std::numeric_limits<int>::max();
    double worstM = std::numeric_limits<double>::infinity();
    bool operator<(const Score &other) const { return std::tie(unseen, worstM) < std::tie(other.unseen, other.worstM); }
};

class Searcher
{
public:
    Searcher(const PlannedCamera &like, const MarkerLayout &layout, std::span<const FloorView> others, const PlaceSearch &search)
        : m_like(like), m_layout(layout), m_search(search), m_views(others.begin(), others.end()), m_grid(gridOver(layout, 0, gridAcross))
    {
        for (const Marker &marker : layout.markers)
            m_floor.extend(marker.pointInWorld);
    }

    /// Tries every place of a square of so many places about a point.
    void tryAbout(const Vector2d &middle, const Vector2d &halfSize, int across)
    {
        for (int i = 0; i < across * across; ++i) {
            const int row = i / across;
            const Vector2d share(2.0 * (i % across) / (across - 1) - 1, 2.0 * row / (across - 1) - 1);
            tryPlace(middle + halfSize.cwiseProduct(share));
        }
    }
    const Eigen::AlignedBox2d &floor() const { return m_floor; }
    const std::optional<PlannedCamera> &best() const { return m_best; }

private:
    void tryPlace(const Vector2d &foot)
    {
        Eigen::AlignedBox2d room(m_floor.min() - Vector2d::Constant(m_search.reachM), m_floor.max() + Vector2d::Constant(m_search.reachM));
        if (!room.contains(foot) || (!m_search.aboveTheFloor && m_floor.contains(foot)))
            return;
        const Vector2d middle = m_floor.center(), towards = foot - middle;
        for (const double aim : aims) {
            PlannedCamera camera = m_like;
            camera.aimM = middle;
            if (towards.norm() > 0)
                camera.aimM += aim * m_floor.sizes().minCoeff() * towards.normalized();
            camera.standAt(foot);
            judge(camera);
        }
    }

    void judge(const PlannedCamera &camera)
    {
        auto view = plannedView(camera, m_layout);
        if (!view)
            return;
        m_views.push_back(std::move(*view));
        const AccuracyMap map = accuracyMap(m_views, m_grid, m_search.sigmaPx, m_search.robotHeightM);
        m_views.pop_back();
        Score score{0, 0};
        for (const double sigma : map.fusedSigmaM) {
            score.unseen += std::isnan(sigma);
            score.worstM = std::isnan(sigma) ? score.worstM : std::max(score.worstM, sigma);
        }
        if (score < m_bestScore) {
            m_bestScore = score;
            m_best = camera;
        }
    }

    const PlannedCamera &m_like;
    const MarkerLayout &m_layout;
    const PlaceSearch &m_search;
    std::vector<FloorView> m_views;
    FloorGrid m_grid;
    Eigen::AlignedBox2d m_floor;
    std::optional<PlannedCamera> m_best;
    Score m_bestScore;
};

} // namespace

Result<PlannedCamera> bestPlace(const PlannedCamera &like, const MarkerLayout &layout, std::span<const FloorView> others,
                                const PlaceSearch &search, const JobControl &control)
{
    const std::string what = "the best place for a camera";
    Searcher searcher(like, layout, others, search);
    if (layout.markers.size() < 4)
        return fail(ErrorCode::InvalidInput, what, "the layout has " + std::to_string(layout.markers.size()) + " markers, four are needed",
                    "make a layout of four markers or more");
    Vector2d halfSize = 0.5 * searcher.floor().sizes() + Vector2d::Constant(search.reachM);
    searcher.tryAbout(searcher.floor().center(), halfSize, placesAcross);
    for (int round = 0; round < rounds && searcher.best(); ++round) {
        if (control.isCancelled())
            return cancelled(what);
        control.report(double(round + 1) / (rounds + 1), "looking about the best place");
        halfSize *= round == 0 ? 1.5 / (placesAcross - 1) : 0.5;
        searcher.tryAbout(searcher.best()->footM(), halfSize, 5);
    }
    if (control.isCancelled())
        return cancelled(what);
    if (searcher.best())
        return *searcher.best();
    // Why not even the plainest place will do tells more than that none will.
    PlannedCamera plain = like;
    plain.aimM = searcher.floor().center();
    plain.standAt(plain.aimM - Vector2d(0, 0.5 * searcher.floor().sizes().y() + search.reachM));
    if (const auto view = plannedView(plain, layout); !view && view.error().why.find("it would see") == std::string::npos)
        return tl::unexpected(view.error());
    return fail(ErrorCode::Undetermined, what,
                "from nowhere within " + formatNumber(search.reachM, 1) + " m beyond the markers would it see four of them at the height and with the lens given",
                "let it stand higher or farther away, or choose a wider lens");
}

} // namespace odo
