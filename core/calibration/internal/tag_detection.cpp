// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_detection.h"

#include "core/base/job_control.h"
#include "core/calibration/internal/luma_matrix.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/tag_alignment.h"
#include "core/geometry/least_squares.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}

namespace odo {

namespace {

using Eigen::Matrix3d;

constexpr int mostMendedBits = 1;
constexpr int leastSidePx = 32;
constexpr int longestSidePx = 32767; // that libapriltag counts; it ends the program at more
constexpr double largestEnlargement = 2, mostEnlargedPixels = 2 * mostSearchedPixels; // for small tags
constexpr double leastTagSigmaPx = 0.02; // what distortion within a tag and the fit's grid leave

using Family = std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t *)>;

TagCells cellsOf(const apriltag_family_t &family, int number)
{
    TagCells cells{
        family.width_at_border,
        std::vector<bool>(static_cast<std::size_t>(family.width_at_border * family.width_at_border), false)};
    const std::uint64_t code = family.codes[number];
    for (std::uint32_t i = 0; i < family.nbits; ++i) {
        const auto cell = static_cast<std::size_t>(
            static_cast<int>(family.bit_y[i]) * family.width_at_border + static_cast<int>(family.bit_x[i]));
        cells.white[cell] = (code >> (family.nbits - i - 1)) & 1;
    }
    return cells;
}

/// libapriltag counts from the corner of the first pixel, we from its centre.
Matrix3d mapOf(const apriltag_detection_t &tag, double scale)
{
    const Matrix3d map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(tag.H->data);
    Matrix3d toPixels;
    toPixels << 1 / scale, 0, -0.5, 0, 1 / scale, -0.5, 0, 0, 1;
    return toPixels * map;
}

/// The tags of an image that is `scale` times as large as `luma`.
std::vector<SeenTag> read(const cv::Mat &luma, image_u8_t image, double scale)
{
    const Family family(tag36h11_create(), tag36h11_destroy);
    const std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t *)> detector(
        apriltag_detector_create(), apriltag_detector_destroy);
    apriltag_detector_add_family_bits(detector.get(), family.get(), mostMendedBits);
    detector->quad_decimate = 1; // a registration is made once; small tags matter more than milliseconds
    detector->quad_sigma = 0;
    detector->refine_edges = true;
    zarray_t *found = apriltag_detector_detect(detector.get(), &image);
    std::vector<SeenTag> tags;
    for (int i = 0; i < zarray_size(found); ++i) {
        apriltag_detection_t *tag = nullptr;
        zarray_get(found, i, static_cast<void *>(&tag));
        const Matrix3d map = mapOf(*tag, scale);
        const auto aligned = alignTag(luma, cellsOf(*family, tag->id), map);
        if (aligned && aligned->likeness >= leastTagLikeness)
            tags.push_back({tag->id, aligned->middle(), std::max(leastTagSigmaPx, aligned->sigmaPx),
                            aligned->pixelFromTag});
    }
    apriltag_detections_destroy(found);
    return tags;
}

std::vector<SeenTag> readPart(const Frame &frame, std::optional<PixelRect> part, bool enlarged)
{
    const PixelRect all{0, 0, frame.y.width, frame.y.height};
    const PixelRect rect = part ? part->clipped(all) : all;
    if (frame.y.data == nullptr || rect.width() < leastSidePx || rect.height() < leastSidePx)
        return {};
    const cv::Mat luma = lumaMatrix(frame)(cv::Rect(rect.x0, rect.y0, rect.width(), rect.height()));
    const double enlargement =
        std::min(largestEnlargement, std::sqrt(mostEnlargedPixels / (double(luma.cols) * luma.rows)));
    const double scale = enlarged ? enlargement : searchScale(luma);
    if (scale * std::max(rect.width(), rect.height()) > longestSidePx)
        return {};
    endIfCancelled();
    cv::Mat image;
    if (scale > 1)
        cv::resize(luma, image, {}, scale, scale, cv::INTER_CUBIC);
    else
        image = reduced(luma, scale);
    // Undecimated and unsmoothed, the detector only reads this.
    auto tags = read(luma, {image.cols, image.rows, static_cast<int>(image.step), image.data}, scale);
    const Eigen::Projective2d origin(Eigen::Translation2d(rect.x0, rect.y0));
    for (SeenTag &tag : tags) {
        tag.pixelFromTag = origin.matrix() * tag.pixelFromTag;
        tag.pixel = tag.pixelFromTag.col(2).hnormalized();
    }
    return tags;
}

} // namespace

TagCells tagCells(int number)
{
    const Family family(tag36h11_create(), tag36h11_destroy);
    return cellsOf(*family, number);
}

std::vector<SeenTag> findTags(const Frame &frame, std::optional<PixelRect> part)
{
    return readPart(frame, part, false);
}

std::vector<SeenTag> findSmallTags(const Frame &frame, std::optional<PixelRect> part)
{
    return readPart(frame, part, true);
}

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nearOfHalfSide = 0.15; // of the prediction: 0.6 cells
constexpr double worstFitPx = 1;        // RMS of the read tags' corners

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

Vector2d positionOf(const MarkerLayout &layout, const SeenTag &tag)
{
    return layout.markers[static_cast<std::size_t>(tag.number)].pointInWorld;
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
std::optional<Tags> roughTags(const MarkerLayout &layout, const std::vector<SeenTag> &read,
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
                       wanted = positionOf(layout, tag) - positionOf(layout, largest);
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
    floorFromTag.col(2).head<2>() = positionOf(layout, largest);
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
LeastSquaresProblem<Tags> problemOf(const MarkerLayout &layout, const std::vector<SeenTag> &read,
                                    const CameraModel &camera)
{
    LeastSquaresProblem<Tags> problem;
    problem.evaluate = [&](const Tags &tags, Eigen::VectorXd &residuals, Eigen::MatrixXd *byStep) {
        const auto rows = static_cast<Eigen::Index>(8 * read.size());
        residuals.resize(rows);
        if (byStep)
            byStep->setZero(rows, 7 + static_cast<Eigen::Index>(read.size()));
        const Matrix3d cameraAxes = tags.worldFromCamera.rotation.conjugate().toRotationMatrix();
        for (Eigen::Index i = 0; i < rows / 2; ++i) {
            const auto tag = static_cast<std::size_t>(i / 4);
            const Vector2d &corner = corners[static_cast<std::size_t>(i % 4)];
            const Vector2d arm = tags.halfSideM * onFloor(corner, tags.turnsRad[tag]),
                           position = positionOf(layout, read[tag]) + arm;
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
        const Vector3d turn = step.head<3>();
        if (turn.norm() > 0)
            moved.worldFromCamera.rotation =
                (Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) *
                 tags.worldFromCamera.rotation)
                    .normalized();
        moved.worldFromCamera.translation += step.segment<3>(3);
        moved.halfSideM *= std::exp(std::clamp(step(6), -0.5, 0.5));
        for (std::size_t i = 0; i < moved.turnsRad.size(); ++i)
            moved.turnsRad[i] += step(7 + static_cast<Eigen::Index>(i));
        return moved;
    };
    return problem;
}

std::optional<Tags> fitted(const MarkerLayout &layout, const std::vector<SeenTag> &read,
                           const CameraModel &camera)
{
    const auto start = roughTags(layout, read, camera);
    if (!start)
        return std::nullopt;
    const auto problem = problemOf(layout, read, camera);
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
double turnNear(const Vector2d &position, const MarkerLayout &layout, const std::vector<SeenTag> &read,
                const Tags &tags)
{
    const auto nearest = std::ranges::min_element(
        read, {}, [&](const SeenTag &tag) { return (positionOf(layout, tag) - position).norm(); });
    return tags.turnsRad[static_cast<std::size_t>(nearest - read.begin())];
}

bool isNear(const Matrix3d &map, const Vector2d &pixel)
{
    return (map.inverse() * pixel.homogeneous()).hnormalized().norm() < nearOfHalfSide;
}

std::optional<CameraModel> estimatedCamera(const Frame &frame, const MarkerLayout &layout,
                                           const std::vector<SeenTag> &read)
{
    if (read.size() < 4)
        return std::nullopt;
    std::vector<PointPair> pairs;
    for (const SeenTag &tag : read)
        pairs.push_back({positionOf(layout, tag), tag.pixel, {}});
    const auto pose =
        fitPlanePose(pairs, CameraModel::assumed(frame.y.width, frame.y.height), FocalLength::Free);
    return pose && pose->focalSigmaPx ? std::optional(pose->camera) : std::nullopt;
}

} // namespace

std::vector<SeenTag> predictedTags(const Frame &frame, const MarkerLayout &layout,
                                   const std::vector<SeenTag> &read, const std::optional<CameraModel> &camera)
{
    const auto lens = camera ? camera : estimatedCamera(frame, layout, read);
    if (!lens || read.size() < 2)
        return {};
    const auto tags = fitted(layout, read, *lens);
    if (!tags)
        return {};
    std::vector<SeenTag> found;
    for (int number = 0; number < static_cast<int>(layout.markers.size()); ++number) {
        if (std::ranges::find(read, number, &SeenTag::number) != read.end())
            continue;
        const Vector2d &position = layout.markers[static_cast<std::size_t>(number)].pointInWorld;
        std::optional<TagAlignment> best;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const double turn = turnNear(position, layout, read, *tags) + 0.5 * EIGEN_PI * quarter;
            const auto map = mapAt(position, turn, *tags, *lens);
            const auto aligned = map ? alignTag(lumaMatrix(frame), tagCells(number), *map) : std::nullopt;
            // A cut-off tag may look like itself a cell beside its position, but it cannot be there.
            if (aligned && aligned->likeness >= leastTagLikeness && isNear(*map, aligned->middle()) &&
                (!best || aligned->likeness > best->likeness))
                best = aligned;
        }
        if (best)
            found.push_back({number, best->middle(), best->sigmaPx, best->pixelFromTag});
    }
    return found;
}

} // namespace odo
