// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_prediction.h"

#include "core/calibration/internal/luma_matrix.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/pose_step.h"
#include "core/geometry/least_squares.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nearOfHalfSide = 0.15;    // of the prediction: 0.6 cells
constexpr double leastContrastShare = 0.3; // of the read tag with the least: where tiles meet, some tag fits
constexpr double worstFitPx = 1;           // RMS of the read tags' corners

const std::array<Vector2d, 4> corners{Vector2d(-1, -1), Vector2d(1, -1), Vector2d(1, 1), Vector2d(-1, 1)};

/// What all tags on a floor have in common, and how each is turned.
struct Tags
{
    RigidTransform worldFromCamera;
    double halfSideM = 0;
    std::vector<double> turnsRad; ///< from +X, of a tag's own right; one a read tag
};

/// Seen from above a tag's rows run down its print, the world's Y up.
Vector2d onFloor(const Vector2d &inTag, double turnRad)
{
    return Eigen::Rotation2Dd(turnRad) * Vector2d(inTag.x(), -inTag.y());
}

bool isOf(const SeenTag &tag, const FloorTag &floorTag)
{
    return TagName{tag.family, tag.number} == floorTag.name;
}

Vector2d positionOf(std::span<const FloorTag> floor, const SeenTag &tag)
{
    return std::ranges::find_if(floor, [&](const FloorTag &one) { return isOf(tag, one); })->pointInWorld;
}

Vector2d pixelOf(const SeenTag &tag, const Vector2d &inTag)
{
    return (tag.pixelFromTag * inTag.homogeneous()).hnormalized();
}

std::optional<Vector2d> rayOf(const CameraModel &camera, const Vector2d &pixel)
{
    const auto ray = camera.unproject(pixel);
    return ray && ray->z() > 0.1 ? std::optional(Vector2d(ray->hnormalized())) : std::nullopt;
}

double tagAreaOf(const SeenTag &tag)
{
    const Vector2d across = pixelOf(tag, corners[2]) - pixelOf(tag, corners[0]),
                   aside = pixelOf(tag, corners[3]) - pixelOf(tag, corners[1]);
    return std::abs(across.x() * aside.y() - across.y() * aside.x());
}

/// The rays through a tag, from its plane.
std::optional<Homography> raysFromTag(const SeenTag &tag, const CameraModel &camera)
{
    std::vector<PointPair> pairs;
    for (const Vector2d &corner : corners) {
        const auto ray = rayOf(camera, pixelOf(tag, corner));
        if (!ray)
            return std::nullopt;
        pairs.push_back({corner, *ray, {}});
    }
    const auto map = Homography::estimate(pairs);
    return map ? std::optional(*map) : std::nullopt;
}

/// From the largest tag's own plane, mapped to the floor so that the others' middles fit.
std::optional<Tags> roughTags(std::span<const FloorTag> floor, const std::vector<SeenTag> &read,
                              const CameraModel &camera)
{
    const SeenTag &largest = *std::ranges::max_element(read, {}, tagAreaOf);
    const auto rays = raysFromTag(largest, camera);
    if (!rays)
        return std::nullopt;
    const Homography tagFromRays = rays->inverse();
    // Of a turn and a scale together, as one complex number: least squares over the other tags.
    Vector2d product = Vector2d::Zero();
    double squares = 0;
    for (const SeenTag &tag : read) {
        const auto ray = rayOf(camera, tag.pixel);
        if (!ray)
            return std::nullopt;
        const Vector3d mapped = tagFromRays.matrix() * ray->homogeneous();
        const Vector2d q = onFloor(mapped.hnormalized(), 0),
                       wanted = positionOf(floor, tag) - positionOf(floor, largest);
        product += Vector2d(q.dot(wanted), q.x() * wanted.y() - q.y() * wanted.x());
        squares += q.squaredNorm();
    }
    Tags tags;
    tags.halfSideM = product.norm() / squares;
    const double turn = std::atan2(product.y(), product.x());
    if (!(tags.halfSideM > 0) || !std::isfinite(turn))
        return std::nullopt;
    Matrix3d floorFromTag = Matrix3d::Identity();
    floorFromTag.col(0).head<2>() = tags.halfSideM * onFloor({1, 0}, turn);
    floorFromTag.col(1).head<2>() = tags.halfSideM * onFloor({0, 1}, turn);
    floorFromTag.col(2).head<2>() = positionOf(floor, largest);
    const Homography raysFromFloor(rays->matrix() * floorFromTag.inverse());
    tags.worldFromCamera = poseFromHomography(raysFromFloor);
    const Homography floorFromRays = raysFromFloor.inverse();
    for (const SeenTag &tag : read) {
        const auto left = rayOf(camera, pixelOf(tag, {-1, 0})), right = rayOf(camera, pixelOf(tag, {1, 0}));
        if (!left || !right)
            return std::nullopt;
        const Vector2d along = (floorFromRays.matrix() * right->homogeneous()).hnormalized() -
                               (floorFromRays.matrix() * left->homogeneous()).hnormalized();
        tags.turnsRad.push_back(std::atan2(along.y(), along.x()));
    }
    return tags;
}

/// Residuals in pixels of all corners over (rotation, position, log of the side, turns).
LeastSquaresProblem<Tags> problemOf(std::span<const FloorTag> floor, const std::vector<SeenTag> &read,
                                    const CameraModel &camera)
{
    LeastSquaresProblem<Tags> problem;
    problem.evaluate = [&camera, &read, floor](const Tags &tags, Eigen::VectorXd &residuals,
                                               Eigen::MatrixXd *byStep) {
        const auto rows = static_cast<Eigen::Index>(8 * read.size());
        residuals.resize(rows);
        if (byStep)
            byStep->setZero(rows, 7 + static_cast<Eigen::Index>(read.size()));
        const Matrix3d cameraAxes = tags.worldFromCamera.rotation.conjugate().toRotationMatrix();
        for (Eigen::Index i = 0; i < rows / 2; ++i) {
            const auto tag = static_cast<std::size_t>(i / 4);
            const Vector2d &corner = corners[static_cast<std::size_t>(i % 4)];
            const Vector2d arm = tags.halfSideM * onFloor(corner, tags.turnsRad[tag]),
                           position = positionOf(floor, read[tag]) + arm;
            const Vector3d fromCamera =
                Vector3d(position.x(), position.y(), 0) - tags.worldFromCamera.translation;
            Eigen::Matrix<double, 2, 3> byPoint;
            const auto pixel = camera.project(cameraAxes * fromCamera, byPoint);
            if (!pixel)
                return false;
            residuals.segment<2>(2 * i) = *pixel - pixelOf(read[tag], corner);
            if (!byStep)
                continue;
            const Eigen::Matrix<double, 2, 3> byWorld = byPoint * cameraAxes;
            for (int axis = 0; axis < 3; ++axis)
                byStep->block<2, 1>(2 * i, axis) = -byWorld * Vector3d::Unit(axis).cross(fromCamera);
            byStep->block<2, 3>(2 * i, 3) = -byWorld;
            byStep->block<2, 1>(2 * i, 6) = byWorld.leftCols<2>() * arm;
            byStep->block<2, 1>(2 * i, 7 + i / 4) = byWorld.leftCols<2>() * Vector2d(-arm.y(), arm.x());
        }
        return true;
    };
    problem.move = [](const Tags &tags, const Eigen::VectorXd &step) {
        Tags moved = tags;
        moved.worldFromCamera = stepped(tags.worldFromCamera, step.head<6>());
        moved.halfSideM *= std::exp(std::clamp(step(6), -0.5, 0.5));
        for (std::size_t i = 0; i < moved.turnsRad.size(); ++i)
            moved.turnsRad[i] += step(7 + static_cast<Eigen::Index>(i));
        return moved;
    };
    return problem;
}

std::optional<Tags> fitted(std::span<const FloorTag> floor, const std::vector<SeenTag> &read,
                           const CameraModel &camera)
{
    const auto start = roughTags(floor, read, camera);
    if (!start)
        return std::nullopt;
    const auto problem = problemOf(floor, read, camera);
    Tags tags = minimise(problem, *start);
    Eigen::VectorXd residuals;
    if (!problem.evaluate(tags, residuals, nullptr) ||
        !(residuals.norm() < worstFitPx * std::sqrt(4.0 * static_cast<double>(read.size()))))
        return std::nullopt;
    return tags;
}

/// The map of a tag at a floor position.
std::optional<Matrix3d> mapAt(const Vector2d &position, double turnRad, const Tags &tags,
                              const CameraModel &camera)
{
    const RigidTransform cameraFromWorld = tags.worldFromCamera.inverse();
    std::vector<PointPair> pairs;
    for (const Vector2d &corner : corners) {
        const Vector2d point = position + tags.halfSideM * onFloor(corner, turnRad);
        const auto pixel = camera.project(cameraFromWorld * Vector3d(point.x(), point.y(), 0));
        if (!pixel)
            return std::nullopt;
        pairs.push_back({corner, *pixel, {}});
    }
    const auto map = Homography::estimate(pairs);
    return map ? std::optional(map->matrix()) : std::nullopt;
}

/// The turn of the nearest read tag and its quarter turns: tags are turned like their neighbours.
double turnNear(const Vector2d &position, std::span<const FloorTag> floor, const std::vector<SeenTag> &read,
                const Tags &tags)
{
    const auto nearest = std::ranges::min_element(
        read, {}, [&](const SeenTag &tag) { return (positionOf(floor, tag) - position).norm(); });
    return tags.turnsRad[static_cast<std::size_t>(nearest - read.begin())];
}

bool isNear(const Matrix3d &map, const Vector2d &pixel)
{
    return (map.inverse() * pixel.homogeneous()).hnormalized().norm() < nearOfHalfSide;
}

std::optional<CameraModel> estimatedCamera(const Frame &frame, std::span<const FloorTag> floor,
                                           const std::vector<SeenTag> &read)
{
    if (read.size() < 4)
        return std::nullopt;
    std::vector<PointPair> pairs;
    for (const SeenTag &tag : read)
        pairs.push_back({positionOf(floor, tag), tag.pixel, {}});
    const auto pose =
        fitPlanePose(pairs, CameraModel::assumed(frame.y.width, frame.y.height), FocalLength::Free);
    return pose && pose->focalSigmaPx ? std::optional(pose->camera) : std::nullopt;
}

} // namespace

std::vector<SeenTag> predictedTags(const Frame &frame, std::span<const FloorTag> floor,
                                   const std::vector<SeenTag> &read, const std::optional<CameraModel> &camera)
{
    const auto lens = camera ? camera : estimatedCamera(frame, floor, read);
    if (!lens || read.size() < 2)
        return {};
    const auto tags = fitted(floor, read, *lens);
    if (!tags)
        return {};
    const double leastContrast =
        leastContrastShare * std::ranges::min_element(read, {}, &SeenTag::contrast)->contrast;
    std::vector<SeenTag> found;
    for (const FloorTag &missing : floor) {
        const auto cells = tagCells(missing.name);
        if (!cells || std::ranges::any_of(read, [&](const SeenTag &tag) { return isOf(tag, missing); }))
            continue;
        std::optional<TagAlignment> best;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const double turn = turnNear(missing.pointInWorld, floor, read, *tags) + 0.5 * EIGEN_PI * quarter;
            const auto map = mapAt(missing.pointInWorld, turn, *tags, *lens);
            const auto aligned = map ? alignTag(lumaMatrix(frame), *cells, *map) : std::nullopt;
            // A cut-off tag may look like itself a cell beside its position, but it cannot be there.
            if (aligned && aligned->likeness >= leastTagLikeness && aligned->contrast >= leastContrast &&
                isNear(*map, aligned->middle()) && (!best || aligned->likeness > best->likeness))
                best = aligned;
        }
        if (best)
            found.push_back({missing.name.number, missing.name.family, best->middle(), best->sigmaPx,
                             best->pixelFromTag, best->contrast});
    }
    return found;
}

} // namespace odo
