// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/tag_pattern.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <cassert>
#include <memory>
#include <opencv2/aruco.hpp>

namespace odo {

TagPattern aprilTagPattern(int id)
{
    const std::unique_ptr<apriltag_family_t, decltype(&tag36h11_destroy)> family(tag36h11_create(),
                                                                                 tag36h11_destroy);
    assert(id >= 0 && static_cast<std::uint32_t>(id) < family->ncodes);
    const int side = family->total_width, rim = (family->total_width - family->width_at_border) / 2;
    TagPattern pattern{side, std::vector<bool>(static_cast<std::size_t>(side * side), false)};
    const auto cell = [&](int column, int row) { return pattern.black.begin() + row * side + column; };
    for (int row = rim; row < side - rim; ++row)
        std::fill_n(cell(rim, row), side - 2 * rim, true);
    const std::uint64_t code = family->codes[id];
    for (std::uint32_t i = 0; i < family->nbits; ++i)
        if (code >> (family->nbits - i - 1) & 1)
            *cell(static_cast<int>(family->bit_x[i]) + rim, static_cast<int>(family->bit_y[i]) + rim) = false;
    return pattern;
}

TagPattern arucoPattern(int id)
{
    constexpr int side = 8;
    const cv::Ptr<cv::aruco::Dictionary> dictionary =
        cv::aruco::getPredefinedDictionary(cv::aruco::DICT_6X6_250);
    assert(id >= 0 && id < dictionary->bytesList.rows);
    cv::Mat image;
    cv::aruco::drawMarker(dictionary, id, side, image, 1);
    TagPattern pattern{side, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            pattern.black.push_back(image.at<std::uint8_t>(y, x) < 128);
    return pattern;
}

} // namespace odo
