// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/accuracy_map.h"
#include "core/calibration/internal/planned_registration.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace odo {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d PlannedCamera::footM() const
{
    const double direction = directionDegrees * EIGEN_PI / 180;
    return aimM + distanceM * Vector2d(std::cos(direction), std::sin(direction));
}

void PlannedCamera::moveCameraTo(const Vector2d &footM)
{
    const Vector2d away = footM - aimM;
    distanceM = away.norm();
    if (distanceM > 0) // straight above, the direction stays what it was
        directionDegrees = std::atan2(away.y(), away.x()) * 180 / EIGEN_PI;
}

namespace {

/// Its view, as if its pose were exact.
Result<FloorView> exactView(const PlannedCamera &camera)
{
    if (!(camera.heightM >= 0.05 && camera.heightM <= 100))
        return noPlannedCamera(
            ODO_TEXT("calibration.planned_height",
                     "its height above the floor cannot be %1")(quantity(camera.heightM, 2, "m")),
            ODO_TEXT("calibration.give_height", "give a height of 0.05 m to 100 m"));
    if (!(camera.distanceM >= 0 && camera.distanceM <= 1000))
        return noPlannedCamera(ODO_TEXT("calibration.planned_distance",
                                        "its distance cannot be %1")(quantity(camera.distanceM, 2, "m")),
                               ODO_TEXT("calibration.give_distance", "give a distance of 0 m to 1000 m"));
    if (!(camera.fieldOfViewDegrees >= 2 && camera.fieldOfViewDegrees <= 150) || camera.widthPx <= 0 ||
        camera.heightPx <= 0)
        return noPlannedCamera(
            ODO_TEXT("calibration.planned_field_of_view",
                     "its field of view is %1")(quantity(camera.fieldOfViewDegrees, 1, "°")),
            ODO_TEXT("calibration.give_field_of_view", "give 2° to 150°, and the image size"));
    const double direction = camera.directionDegrees * EIGEN_PI / 180;
    const Vector2d away(std::cos(direction), std::sin(direction));
    const Vector2d foot = camera.footM();
    const Vector3d position(foot.x(), foot.y(), camera.heightM);
    // Along the floor, so that the image is upright; straight down it has no up, and the direction gives one.
    const RigidTransform pose = lookingAt(position, camera.aimM, Vector2d(-away.y(), away.x()));
    Intrinsics lens = CameraModel::assumed(camera.widthPx, camera.heightPx).intrinsics();
    lens.fxPx = lens.fyPx = 0.5 * camera.widthPx / std::tan(0.5 * camera.fieldOfViewDegrees * EIGEN_PI / 180);
    const auto model = ODO_TRY(CameraModel::create(std::move(lens)));
    return FloorView(model, pose, Eigen::Matrix<double, 6, 6>::Zero());
}

} // namespace

Result<FloorView> plannedView(const PlannedCamera &camera, const MarkerLayout &layout, double sigmaPx)
{
    const auto exact = ODO_TRY(exactView(camera));
    return registeredByMarkers(exact, layout, sigmaPx);
}

namespace {

constexpr int positionsAcross = 13, gridAcross = 12, rounds = 4;
constexpr double aims[] = {-0.2, 0, 0.2}; // of the extent, from the middle towards the camera

class Searcher
{
public:
    Searcher(const PlannedCamera &like, const MarkerLayout &layout, std::span<const FloorView> others,
             const CameraPositionSearch &search)
        : m_like(like), m_layout(layout), m_search(search), m_views(others.begin(), others.end()),
          m_grid(gridOver(layout, 0, gridAcross))
    {
        for (const Marker &marker : layout.markers)
            m_floor.extend(marker.pointInWorld);
    }

    /// Tries every position of a square grid around a point.
    void tryAbout(const Vector2d &middle, const Vector2d &halfSize, int across)
    {
        for (int i = 0; i < across * across; ++i) {
            const int row = i / across;
            const Vector2d share(2.0 * (i % across) / (across - 1) - 1, 2.0 * row / (across - 1) - 1);
            tryPosition(middle + halfSize.cwiseProduct(share));
        }
    }
    const Eigen::AlignedBox2d &floor() const { return m_floor; }
    const std::optional<PlannedCamera> &best() const { return m_best; }

private:
    void tryPosition(const Vector2d &foot)
    {
        Eigen::AlignedBox2d room(m_floor.min() - Vector2d::Constant(m_search.reachM),
                                 m_floor.max() + Vector2d::Constant(m_search.reachM));
        if (!room.contains(foot) || (!m_search.aboveTheFloor && m_floor.contains(foot)))
            return;
        const Vector2d middle = m_floor.center(), towards = foot - middle;
        for (const double aim : aims) {
            PlannedCamera camera = m_like;
            camera.aimM = middle;
            if (towards.norm() > 0)
                camera.aimM += aim * m_floor.sizes().minCoeff() * towards.normalized();
            camera.moveCameraTo(foot);
            judge(camera);
        }
    }

    void judge(const PlannedCamera &camera)
    {
        auto view = plannedView(camera, m_layout);
        if (!view)
            return;
        m_views.push_back(std::move(*view));
        FloorScore score = floorScore(m_views, m_grid, m_search.sigmaPx, m_search.robotHeightM);
        m_views.pop_back();
        if (!m_best ||
            std::tie(score.unseen, score.worstM) < std::tie(m_bestScore.unseen, m_bestScore.worstM)) {
            m_bestScore = std::move(score);
            m_best = camera;
        }
    }

    const PlannedCamera &m_like;
    const MarkerLayout &m_layout;
    const CameraPositionSearch &m_search;
    std::vector<FloorView> m_views;
    FloorGrid m_grid;
    Eigen::AlignedBox2d m_floor;
    std::optional<PlannedCamera> m_best;
    FloorScore m_bestScore;
};

} // namespace

Result<PlannedCamera> bestCameraPosition(const PlannedCamera &like, const MarkerLayout &layout,
                                         std::span<const FloorView> others,
                                         const CameraPositionSearch &search, const JobControl &control)
{
    const Message what = ODO_TEXT("calibration.best_place", "the best camera position");
    Searcher searcher(like, layout, others, search);
    if (layout.markers.size() < 4)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("calibration.layout_too_small",
                             "the layout has %1 markers, four are needed")(layout.markers.size()),
                    ODO_TEXT("calibration.make_larger_layout", "make a layout of four markers or more"));
    Vector2d halfSize = 0.5 * searcher.floor().sizes() + Vector2d::Constant(search.reachM);
    searcher.tryAbout(searcher.floor().center(), halfSize, positionsAcross);
    for (int round = 0; round < rounds && searcher.best(); ++round) {
        if (control.isCancelled())
            return cancelled(what);
        control.report(double(round + 1) / (rounds + 1),
                       ODO_TEXT("calibration.looking_about", "searching around the best position"));
        halfSize *= round == 0 ? 1.5 / (positionsAcross - 1) : 0.5;
        searcher.tryAbout(searcher.best()->footM(), halfSize, 5);
    }
    if (control.isCancelled())
        return cancelled(what);
    if (searcher.best())
        return *searcher.best();
    // Why even the plainest position fails says more than that all of them do.
    PlannedCamera plain = like;
    plain.aimM = searcher.floor().center();
    plain.moveCameraTo(plain.aimM - Vector2d(0, 0.5 * searcher.floor().sizes().y() + search.reachM));
    ODO_TRY(exactView(plain));
    return fail(
        ErrorCode::Undetermined, what,
        ODO_TEXT("calibration.sees_too_few_anywhere",
                 "at this height and field of view, no position within %1 of the markers shows four of them")(
            quantity(search.reachM, 1, "m")),
        ODO_TEXT("calibration.stand_higher", "mount it higher or farther away, or choose a wider lens"));
}

} // namespace odo
