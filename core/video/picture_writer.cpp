// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture_writer.h"

#include "core/video/picture.h"

#include <fstream>
#include <opencv2/imgcodecs.hpp>

namespace odo {

namespace {

cv::Mat coloursOf(const Frame &frame)
{
    const ScreenPicture picture = toScreen(frame, frame.format.width, frame.format.height);
    cv::Mat colours(picture.height, picture.width, CV_8UC3);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::uint32_t pixel = picture.pixels[static_cast<std::size_t>(y) * picture.width + x];
            colours.at<cv::Vec3b>(y, x) = {static_cast<std::uint8_t>(pixel), static_cast<std::uint8_t>(pixel >> 8),
                                           static_cast<std::uint8_t>(pixel >> 16)};
        }
    }
    return colours;
}

Result<std::vector<unsigned char>> packed(const cv::Mat &picture)
{
    std::vector<unsigned char> bytes;
    try {
        if (!picture.empty() && cv::imencode(".png", picture, bytes))
            return bytes;
    } catch (const cv::Exception &) {
    }
    return fail(ErrorCode::Internal, "picture", "it could not be packed", "use another picture");
}

} // namespace

Result<void> writePicture(const Frame &frame, const std::filesystem::path &file)
{
    const auto failed = [&](const std::string &why) {
        return fail(ErrorCode::Io, "picture '" + file.string() + "'", why,
                    "check the folder, the free space, and that the name ends in .png or .jpg");
    };
    std::vector<unsigned char> bytes;
    try {
        if (!cv::imencode(file.extension().string(), coloursOf(frame), bytes))
            return failed("it could not be packed");
    } catch (const cv::Exception &) {
        return failed("its format is not known");
    }
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.close(); // where the last bytes are written
    if (out)
        return {};
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return failed("it could not be written");
}

Result<std::vector<unsigned char>> colourPng(const Frame &frame) { return packed(coloursOf(frame)); }

Result<std::vector<unsigned char>> greyPng(const Frame &frame)
{
    return packed(cv::Mat(frame.y.height, frame.y.width, CV_8UC1, const_cast<std::uint8_t *>(frame.y.data),
                          static_cast<std::size_t>(frame.y.stride)));
}

} // namespace odo
