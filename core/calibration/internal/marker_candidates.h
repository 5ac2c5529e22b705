// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <opencv2/aruco/dictionary.hpp>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

namespace odo {

/// The quadrilaterals of an image that may be ArUco markers, found once for all dictionaries, in an image of
/// at most 1.5 megapixels. Which dictionaries are worth a search at full size follows from their cells: six
/// searches of each image take seconds.
class MarkerCandidates
{
public:
    /// An 8-bit image, which must live as long as this.
    explicit MarkerCandidates(const cv::Mat &grey);

    /// How many of them read as a marker of this dictionary. Errors in cells are forgiven up to what it can
    /// correct.
    int countIn(const cv::aruco::Dictionary &dictionary);

private:
    /// The cells of a marker of so many across inside its border, one byte each; of the candidates whose
    /// border is dark.
    const std::vector<cv::Mat> &cellsOf(int across);

    cv::Mat m_grey;
    std::vector<std::array<cv::Point2f, 4>> m_outlines; ///< in pixels of the image
    std::map<int, std::vector<cv::Mat>> m_cells;        ///< by the number of cells across
};

} // namespace odo
