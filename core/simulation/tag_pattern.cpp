// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/tag_pattern.h"

#include <apriltag/apriltag.h>
#include <apriltag/common/image_u8.h>
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
    const std::unique_ptr<image_u8_t, decltype(&image_u8_destroy)> image(apriltag_to_image(family.get(), id),
                                                                         image_u8_destroy);
    TagPattern pattern{image->width, {}};
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x)
            pattern.black.push_back(image->buf[y * image->stride + x] < 128);
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
