// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/accuracy_map.h"

#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/wording.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

bool isInImage(const Vector2d &pixel, const Intrinsics &lens)
{
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= lens.widthPx - 0.5 &&
           pixel.y() <= lens.heightPx - 0.5;
}

std::optional<Matrix2d> covarianceAt(const FloorView &view, const Vector3d &position, double sigmaPx)
{
    const auto pixel = view.pixelFromWorld(position);
    if (!pixel || !isInImage(*pixel, view.camera().intrinsics()))
        return std::nullopt;
    const auto seen = view.locate(*pixel, sigmaPx * sigmaPx * Matrix2d::Identity(), position.z());
    if (!seen)
        return std::nullopt;
    return seen->pixelCovariance + seen->calibrationCovariance;
}

double largestSigma(const Matrix2d &covariance)
{
    return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Matrix2d>(covariance).eigenvalues().y()));
}

tl::unexpected<Error> noCamera(Message why, Message advice)
{
    return fail(ErrorCode::InvalidInput, ODO_TEXT("calibration.planned_camera", "the planned camera"),
                std::move(why), std::move(advice));
}

/// What a registration by these markers would leave of the pose: σ²(JᵀJ)⁻¹.
Result<Eigen::Matrix<double, 6, 6>> poseCovariance(const FloorView &view, const MarkerLayout &layout,
                                                   double sigmaPx)
{
    std::vector<PointPair> pairs;
    std::vector<std::string> seen;
    for (const Marker &marker : layout.markers) {
        const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
        if (!pixel || !isInImage(*pixel, view.camera().intrinsics()))
            continue;
        pairs.push_back({marker.pointInWorld, *pixel, marker.label});
        seen.push_back(marker.label);
    }
    if (seen.size() < 4)
        return noCamera(
            ODO_TEXT("calibration.planned_sees_too_few",
                     "it would see only %1 of the layout's markers (%2), four are needed")(
                seen.size(), listed(seen, MessageArgument::Kind::Marker)),
            ODO_TEXT("calibration.move_planned_back", "move it back or up, or choose a wider lens"));
    const auto pose = fitPlanePose(pairs, view.camera(), FocalLength::Known);
    if (!pose)
        return noCamera(joined({ODO_TEXT("calibration.planned_not_held",
                                         "the markers it would see do not determine its pose"),
                                pose.error().why},
                               Join::Colon),
                        pose.error().advice);
    return Eigen::Matrix<double, 6, 6>(sigmaPx * sigmaPx * pose->inverseNormal);
}

} // namespace

FloorGrid gridOver(const MarkerLayout &layout, double marginM, int mostAcross)
{
    if (layout.markers.empty() || mostAcross < 2)
        return {};
    Vector2d lower = layout.markers.front().pointInWorld, upper = lower;
    for (const Marker &marker : layout.markers) {
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    const Vector2d margin = Vector2d::Constant(marginM), size = upper - lower + 2 * margin;
    FloorGrid grid;
    grid.lowerM = lower - margin;
    grid.stepM = std::max(size.maxCoeff() / (mostAcross - 1), 1e-3);
    grid.columns = 1 + static_cast<int>(std::floor(size.x() / grid.stepM + 1e-9));
    grid.rows = 1 + static_cast<int>(std::floor(size.y() / grid.stepM + 1e-9));
    return grid;
}

AccuracyMap accuracyMap(std::span<const FloorView> views, const FloorGrid &grid, double sigmaPx,
                        double heightM)
{
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    const std::size_t positions = static_cast<std::size_t>(std::max(0, grid.columns)) *
                                  static_cast<std::size_t>(std::max(0, grid.rows));
    AccuracyMap map{grid,
                    std::vector<std::vector<double>>(views.size(), std::vector<double>(positions, unseen)),
                    std::vector<double>(positions, unseen)};
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d point = grid.at(column, row);
            Matrix2d information = Matrix2d::Zero();
            for (std::size_t i = 0; i < views.size(); ++i) {
                const auto covariance = covarianceAt(views[i], {point.x(), point.y(), heightM}, sigmaPx);
                if (!covariance)
                    continue;
                map.cameraSigmaM[i][grid.index(column, row)] = largestSigma(*covariance);
                information += covariance->inverse();
            }
            if (information.determinant() > 0)
                map.fusedSigmaM[grid.index(column, row)] = largestSigma(information.inverse());
        }
    }
    return map;
}

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
        return noCamera(ODO_TEXT("calibration.planned_height",
                                 "its height above the floor cannot be %1")(quantity(camera.heightM, 2, "m")),
                        ODO_TEXT("calibration.give_height", "give a height of 0.05 m to 100 m"));
    if (!(camera.distanceM >= 0 && camera.distanceM <= 1000))
        return noCamera(ODO_TEXT("calibration.planned_distance",
                                 "its distance cannot be %1")(quantity(camera.distanceM, 2, "m")),
                        ODO_TEXT("calibration.give_distance", "give a distance of 0 m to 1000 m"));
    if (!(camera.fieldOfViewDegrees >= 2 && camera.fieldOfViewDegrees <= 150) || camera.widthPx <= 0 ||
        camera.heightPx <= 0)
        return noCamera(ODO_TEXT("calibration.planned_field_of_view",
                                 "its field of view is %1")(quantity(camera.fieldOfViewDegrees, 1, "°")),
                        ODO_TEXT("calibration.give_field_of_view", "give 2° to 150°, and the image size"));
    const double direction = camera.directionDegrees * EIGEN_PI / 180;
    const Vector2d away(std::cos(direction), std::sin(direction));
    const Vector2d foot = camera.footM();
    const Vector3d position(foot.x(), foot.y(), camera.heightM);
    const Vector3d forward = (Vector3d(camera.aimM.x(), camera.aimM.y(), 0) - position).normalized();
    // Along the floor, so that the image is upright; straight down it has no up, and the direction gives one.
    const Vector3d right(-away.y(), away.x(), 0);
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    Intrinsics lens = CameraModel::assumed(camera.widthPx, camera.heightPx).intrinsics();
    lens.fxPx = lens.fyPx = 0.5 * camera.widthPx / std::tan(0.5 * camera.fieldOfViewDegrees * EIGEN_PI / 180);
    const auto model = ODO_TRY(CameraModel::create(std::move(lens)));
    return FloorView(model, {Eigen::Quaterniond(axes), position}, Eigen::Matrix<double, 6, 6>::Zero());
}

} // namespace

Result<FloorView> plannedView(const PlannedCamera &camera, const MarkerLayout &layout, double sigmaPx)
{
    const auto exact = ODO_TRY(exactView(camera));
    const auto covariance = ODO_TRY(poseCovariance(exact, layout, sigmaPx));
    return FloorView(exact.camera(), exact.worldFromCamera(), covariance);
}

namespace {

using Eigen::Vector2d;

constexpr double nearABorder = 0.15; // of the extent

/// The sentence about the values. position: of the worst one.
Message metricWords(const AccuracySummary &summary, const Vector2d &position, const Vector2d &lower,
                    const Vector2d &upper, const MarkerLayout &layout)
{
    const auto nearest = std::ranges::min_element(
        layout.markers, {}, [&](const Marker &marker) { return (marker.pointInWorld - position).norm(); });
    const auto isAtBorder = [&](int axis) {
        const double room = nearABorder * (upper[axis] - lower[axis]);
        return position[axis] < lower[axis] + room || position[axis] > upper[axis] - room;
    };
    const int borders = int(isAtBorder(0)) + int(isAtBorder(1));
    const MessageArgument worst = millimetres(summary.worstM), marker = Named::marker(nearest->label);
    if (std::isnan(summary.middleM)) {
        const MessageText &words =
            borders == 2 ? ODO_TEXT("calibration.unseen_middle_corner",
                                    "The middle is out of view, ±%1 in the corner near %2.")
            : borders == 1
                ? ODO_TEXT("calibration.unseen_middle_edge",
                           "The middle is out of view, ±%1 at the edge near %2.")
                : ODO_TEXT("calibration.unseen_middle_near", "The middle is out of view, ±%1 near %2.");
        return words(worst, marker);
    }
    const MessageText &words =
        borders == 2
            ? ODO_TEXT("calibration.middle_and_corner", "±%1 in the middle, ±%2 in the corner near %3.")
        : borders == 1
            ? ODO_TEXT("calibration.middle_and_edge", "±%1 in the middle, ±%2 at the edge near %3.")
            : ODO_TEXT("calibration.middle_and_near", "±%1 in the middle, ±%2 near %3.");
    return words(millimetres(summary.middleM), worst, marker);
}

} // namespace

AccuracySummary summariseAccuracy(const FloorGrid &grid, const std::vector<double> &sigmaM,
                                  const MarkerLayout &layout)
{
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    AccuracySummary summary{
        unseen, unseen, 0,
        ODO_TEXT("calibration.floor_unseen", "None of the floor between the markers is in view.")};
    if (layout.markers.empty())
        return summary;
    Vector2d lower = layout.markers.front().pointInWorld, upper = lower, worst = lower;
    for (const Marker &marker : layout.markers) {
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    const Vector2d middle = 0.5 * (lower + upper), slack = Vector2d::Constant(0.5 * grid.stepM);
    double fromMiddle = std::numeric_limits<double>::infinity();
    int positions = 0, seen = 0;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d position = grid.at(column, row);
            if (((position - lower).array() < -slack.array()).any() ||
                ((position - upper).array() > slack.array()).any())
                continue;
            const double sigma = sigmaM[grid.index(column, row)];
            ++positions;
            if ((position - middle).norm() < fromMiddle) {
                fromMiddle = (position - middle).norm();
                summary.middleM = sigma;
            }
            if (std::isnan(sigma))
                continue;
            ++seen;
            if (!(sigma <= summary.worstM)) {
                summary.worstM = sigma;
                worst = position;
            }
        }
    }
    if (seen == 0)
        return summary;
    summary.seenPart = double(seen) / positions;
    summary.words = metricWords(summary, worst, lower, upper, layout);
    if (seen < positions)
        summary.words = joined(
            {std::move(summary.words),
             ODO_TEXT("calibration.floor_part_unseen", "%1 of the floor between the markers is out of view.")(
                 quantity(std::max(1.0, 100 * (1 - summary.seenPart)), 0, "%"))},
            Join::Space);
    return summary;
}

namespace {

using Eigen::Vector2d;

constexpr int positionsAcross = 13, gridAcross = 12, rounds = 4;
constexpr double aims[] = {-0.2, 0, 0.2}; // of the extent, from the middle towards the camera

struct Score
{
    int unseen = std::numeric_limits<int>::max();
    double worstM = std::numeric_limits<double>::infinity();
    bool operator<(const Score &other) const
    {
        return std::tie(unseen, worstM) < std::tie(other.unseen, other.worstM);
    }
};

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
    const CameraPositionSearch &m_search;
    std::vector<FloorView> m_views;
    FloorGrid m_grid;
    Eigen::AlignedBox2d m_floor;
    std::optional<PlannedCamera> m_best;
    Score m_bestScore;
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
