// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_detection.h"

#include "core/base/job_control.h"
#include "core/calibration/internal/luma_matrix.h"
#include "core/calibration/internal/tag_alignment.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
extern "C" {
#include <apriltag/apriltag.h>
}

namespace odo {

namespace {

using Eigen::Matrix3d;

constexpr int leastSidePx = 32;
constexpr int longestSidePx = 32767; // that libapriltag counts; it ends the program at more
constexpr double largestEnlargement = 2, mostEnlargedPixels = 2 * mostSearchedPixels; // for small tags
constexpr double leastTagSigmaPx = 0.02; // what distortion within a tag and the fit's grid leave

/// libapriltag counts from the corner of the first pixel, we from its centre.
Matrix3d mapOf(const apriltag_detection_t &tag, double scale)
{
    const Matrix3d map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(tag.H->data);
    Matrix3d toPixels;
    toPixels << 1 / scale, 0, -0.5, 0, 1 / scale, -0.5, 0, 0, 1;
    return toPixels * map;
}

/// The tags of an image that is `scale` times as large as `luma`.
std::vector<SeenTag> read(const cv::Mat &luma, image_u8_t image, double scale,
                          std::span<const TagFamily> families)
{
    std::vector<ReadFamily> made;
    for (const TagFamily family : families)
        made.push_back(readFamily(family));
    const std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t *)> detector(
        apriltag_detector_create(), apriltag_detector_destroy);
    for (std::size_t i = 0; i < made.size(); ++i)
        apriltag_detector_add_family_bits(detector.get(), made[i].get(), mendedCells(families[i]));
    detector->quad_decimate = 1; // a registration is made once; small tags matter more than milliseconds
    detector->quad_sigma = 0;
    detector->refine_edges = true;
    zarray_t *found = apriltag_detector_detect(detector.get(), &image);
    std::vector<SeenTag> tags;
    for (int i = 0; i < zarray_size(found); ++i) {
        apriltag_detection_t *tag = nullptr;
        zarray_get(found, i, static_cast<void *>(&tag));
        const auto of = std::ranges::find(made, tag->family, &ReadFamily::get) - made.begin();
        const TagFamily family = families[static_cast<std::size_t>(of)];
        const auto cells = tagCells({family, tag->id});
        const auto aligned = cells ? alignTag(luma, *cells, mapOf(*tag, scale)) : std::nullopt;
        if (aligned && aligned->likeness >= leastTagLikeness)
            tags.push_back({tag->id, family, aligned->middle(), std::max(leastTagSigmaPx, aligned->sigmaPx),
                            aligned->pixelFromTag, aligned->contrast});
    }
    apriltag_detections_destroy(found);
    return tags;
}

std::vector<SeenTag> readPart(const Frame &frame, std::optional<PixelRect> part, bool enlarged,
                              std::span<const TagFamily> families)
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
    auto tags =
        read(luma, {image.cols, image.rows, static_cast<int>(image.step), image.data}, scale, families);
    const Eigen::Projective2d origin(Eigen::Translation2d(rect.x0, rect.y0));
    for (SeenTag &tag : tags) {
        tag.pixelFromTag = origin.matrix() * tag.pixelFromTag;
        tag.pixel = tag.pixelFromTag.col(2).hnormalized();
    }
    return tags;
}

} // namespace

std::vector<SeenTag> findTags(const Frame &frame, std::optional<PixelRect> part,
                              std::span<const TagFamily> families)
{
    return readPart(frame, part, false, families);
}

std::vector<SeenTag> findSmallTags(const Frame &frame, std::optional<PixelRect> part,
                                   std::span<const TagFamily> families)
{
    return readPart(frame, part, true, families);
}

} // namespace odo
