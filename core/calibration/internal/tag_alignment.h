// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

namespace odo {

/// The cells of a tag, from the top left, row by row: true where they are printed white.
struct TagCells
{
    int side = 0;
    std::vector<bool> white;
    /// Where they end in the tag's plane, in which its border square goes from (-1, -1) to (1, 1): a tag with
    /// cells outside its border goes beyond.
    double reach = 1;
};

/// A tag aligned with an image.
struct TagAlignment
{
    /// Pixel from the tag's plane: its border square goes from (-1, -1) at the top left of its print to (1,
    /// 1).
    Eigen::Matrix3d pixelFromTag;
    double likeness = 0; ///< correlation of the image with the tag as it would be seen, at most 1
    double sigmaPx = 0;  ///< of one coordinate of the tag's middle, from what is left of the image
    double contrast = 0; ///< grey values between black and white, at its middle

    /// The image of the tag's middle.
    Eigen::Vector2d middle() const { return pixelFromTag.col(2).hnormalized(); }
};

/// The likeness from which a tag is one: of one read out of noise, or aligned with nothing, it is less than
/// 0.5.
inline constexpr double leastTagLikeness = 0.7;

/// Aligns a tag of known cells with the image for the smallest difference in grey values: eight values of the
/// map, the blur, black, white and a gradient of the light, by Gauss–Newton on the grey values (Lucas and
/// Kanade 1981, forwards), pixels that do not agree counting less (Huber). All edges of the tag count, not
/// only its outline, so that it holds for tags of a pixel a cell. start: within about a cell of it. luma: 8
/// bit, read only; pixel (0,0) is the centre of the first. nullopt where a third of it lies beyond the image,
/// and where it leaves the start or leads nowhere. Any thread.
std::optional<TagAlignment> alignTag(const cv::Mat &luma, const TagCells &cells,
                                     const Eigen::Matrix3d &start);

} // namespace odo
