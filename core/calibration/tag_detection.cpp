// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/tag_detection.h"

#include "core/base/cancel_scope.h"
#include "core/calibration/luma_matrix.h"
#include "core/calibration/search_scale.h"

extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>

namespace odo {

namespace {

using Eigen::Matrix3d;

constexpr int mostMendedBits = 1;
constexpr int leastSidePx = 32;
constexpr int longestSidePx = 32767; // that libapriltag counts; it ends the program at more
constexpr double largestEnlargement = 2, mostEnlargedPixels = 2 * mostSearchedPixels; // for small tags
constexpr double leastTagSigmaPx = 0.02; // what the lens bends within a tag and the fit's grid leave

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

/// The tags of a picture that is `scale` times as large as `luma`.
std::vector<SeenTag> read(const cv::Mat &luma, image_u8_t picture, double scale)
{
    const Family family(tag36h11_create(), tag36h11_destroy);
    const std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t *)> detector(
        apriltag_detector_create(), apriltag_detector_destroy);
    apriltag_detector_add_family_bits(detector.get(), family.get(), mostMendedBits);
    detector->quad_decimate = 1; // a registration is made once; small tags matter more than milliseconds
    detector->quad_sigma = 0;
    detector->refine_edges = true;
    zarray_t *found = apriltag_detector_detect(detector.get(), &picture);
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
    const double enlargement = std::min(largestEnlargement, std::sqrt(mostEnlargedPixels / (double(luma.cols) * luma.rows)));
    const double scale = enlarged ? enlargement : searchScale(luma);
    if (scale * std::max(rect.width(), rect.height()) > longestSidePx)
        return {};
    endIfCancelled();
    cv::Mat picture;
    if (scale > 1)
        cv::resize(luma, picture, {}, scale, scale, cv::INTER_CUBIC);
    else
        picture = reduced(luma, scale);
    // Undecimated and unsmoothed, the detector only reads this.
    auto tags = read(luma, {picture.cols, picture.rows, static_cast<int>(picture.step), picture.data}, scale);
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

} // namespace odo
