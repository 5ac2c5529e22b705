// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture.h"

#include "core/base/shortage.h"
#include "core/video/picture_size.h"

#include <fstream>
#include <libyuv/convert_argb.h>
#include <libyuv/convert_from_argb.h>
#include <libyuv/scale.h>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace odo {

namespace {

constexpr std::uint64_t maximumPixels = 100'000'000;
constexpr std::uintmax_t maximumFileBytes = 1'000'000'000;

/// A plane scaled to a size, or the plane itself where it has that size already.
struct ScaledPlane
{
    ScaledPlane(const PlaneView &plane, int width, int height)
    {
        if (plane.width == width && plane.height == height) {
            view = plane;
            return;
        }
        memory = std::make_unique_for_overwrite<std::uint8_t[]>(static_cast<std::size_t>(width) *
                                                                static_cast<std::size_t>(height));
        // Bilinear keeps things within half a pixel of their place; over more than two source pixels it would
        // skip some and shimmer, there the average is better.
        const bool shrinksMuch = plane.width > 2 * width || plane.height > 2 * height;
        libyuv::ScalePlane(plane.data, static_cast<int>(plane.stride), plane.width, plane.height,
                           memory.get(), width, width, height,
                           shrinksMuch ? libyuv::kFilterBox : libyuv::kFilterBilinear);
        view = {memory.get(), width, height, width};
    }
    std::unique_ptr<std::uint8_t[]> memory;
    PlaneView view;
};

const libyuv::YuvConstants *matrixOf(const FrameFormat &format)
{
    if (format.matrix == YuvMatrix::Bt709)
        return format.fullRange ? &libyuv::kYuvF709Constants : &libyuv::kYuvH709Constants;
    return format.fullRange ? &libyuv::kYuvJPEGConstants : &libyuv::kYuvI601Constants;
}

std::string cannotRead(const std::filesystem::path &file)
{
    return "cannot read the picture " + file.string();
}

Result<std::vector<std::uint8_t>> readFile(const std::filesystem::path &file)
{
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
        return fail(ErrorCode::NotFound, cannotRead(file), "there is no such file",
                    "check the name and the folder");
    if (status.type() != std::filesystem::file_type::regular)
        return fail(ErrorCode::InvalidInput, cannotRead(file), "it is not an ordinary file",
                    "name a picture");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size > maximumFileBytes)
        return fail(ErrorCode::InvalidInput, cannotRead(file), "the file is larger than 1 GB",
                    "name a picture");
    std::vector<std::uint8_t> bytes(size);
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(reinterpret_cast<char *>(bytes.data()), static_cast<std::streamsize>(size)))
        return fail(ErrorCode::Io, cannotRead(file), "the file could not be read",
                    "check that you may read the file");
    return bytes;
}

/// An empty matrix when the decoder refuses.
cv::Mat decode(const std::vector<std::uint8_t> &bytes)
{
    try {
        // Orientation ignored: cameras are calibrated on the sensor's own rows and columns.
        return cv::imdecode(bytes, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception &problem) {
        if (problem.code == cv::Error::StsNoMem)
            throw std::bad_alloc();
        return {};
    }
}

/// BT.601 at full range as JFIF 1.02 defines it, in 16-bit fixed point.
void convertRow(const cv::Vec3b *bgr, int width, std::uint8_t *y, std::uint8_t *u, std::uint8_t *v)
{
    constexpr int half = 1 << 15, middle = (128 << 16) + half - 1; // -1 keeps pure blue and red at 255
    for (int x = 0; x < width; ++x) {
        const int b = bgr[x][0], g = bgr[x][1], r = bgr[x][2];
        y[x] = static_cast<std::uint8_t>((19595 * r + 38470 * g + 7471 * b + half) >> 16);
        u[x] = static_cast<std::uint8_t>((-11059 * r - 21709 * g + 32768 * b + middle) >> 16);
        v[x] = static_cast<std::uint8_t>((32768 * r - 27439 * g - 5329 * b + middle) >> 16);
    }
}

} // namespace

ScreenPicture toScreen(const Frame &frame, int width, int height)
{
    ScreenPicture picture;
    if (width <= 0 || height <= 0 || frame.y.data == nullptr)
        return picture;
    picture.width = width;
    picture.height = height;
    picture.pixels = std::make_unique_for_overwrite<std::uint32_t[]>(static_cast<std::size_t>(width) *
                                                                     static_cast<std::size_t>(height));
    auto *to = reinterpret_cast<std::uint8_t *>(picture.pixels.get());
    const bool halved = frame.format.chromaShiftX == 1 && frame.format.chromaShiftY == 1;
    const int chromaWidth = halved ? (width + 1) / 2 : width,
              chromaHeight = halved ? (height + 1) / 2 : height;
    const ScaledPlane y(frame.y, width, height);
    const ScaledPlane u(frame.u, chromaWidth, chromaHeight), v(frame.v, chromaWidth, chromaHeight);
    const auto convert = halved ? libyuv::I420ToARGBMatrix : libyuv::I444ToARGBMatrix;
    convert(y.view.data, static_cast<int>(y.view.stride), u.view.data, static_cast<int>(u.view.stride),
            v.view.data, static_cast<int>(v.view.stride), to, width * 4, matrixOf(frame.format), width,
            height);
    return picture;
}

Frame fromScreen(const std::uint32_t *pixels, int width, int height, std::ptrdiff_t strideBytes, Nanoseconds time)
{
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.siting = ChromaSiting::Center; // libyuv takes the mean of four pixels
    auto buffer = std::make_shared<FrameBuffer>(format);
    libyuv::ARGBToI420(reinterpret_cast<const std::uint8_t *>(pixels), static_cast<int>(strideBytes), buffer->yRow(0),
                       width, buffer->uRow(0), buffer->chromaWidth(), buffer->vRow(0), buffer->chromaWidth(), width,
                       height);
    return FrameBuffer::toFrame(std::move(buffer), 0, time);
}

namespace {

Result<Frame> readPictureChecked(const std::filesystem::path &file)
{
    const auto bytes = readFile(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const auto size = pictureSize(*bytes);
    if (!size)
        return fail(ErrorCode::InvalidInput, cannotRead(file), "it is no PNG, JPEG, BMP, TIFF or PNM picture",
                    "convert it to PNG or JPEG");
    if (std::uint64_t(size->width) * size->height > maximumPixels)
        return fail(ErrorCode::InvalidInput, cannotRead(file),
                    "it says that it has " + std::to_string(size->width) + "x" +
                        std::to_string(size->height) + " pixels; more than 100 megapixels are not read",
                    "make it smaller");
    const cv::Mat bgr = decode(*bytes);
    if (bgr.empty() || bgr.type() != CV_8UC3)
        return fail(ErrorCode::InvalidInput, cannotRead(file), "its content is damaged or cut short",
                    "copy it again");
    FrameFormat format;
    format.width = bgr.cols;
    format.height = bgr.rows;
    format.chromaShiftX = format.chromaShiftY = 0;
    format.fullRange = true;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < bgr.rows; ++y)
        convertRow(bgr.ptr<cv::Vec3b>(y), bgr.cols, buffer->yRow(y), buffer->uRow(y), buffer->vRow(y));
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

} // namespace

Result<Frame> readPicture(const std::filesystem::path &file)
{
    return orShortage(cannotRead(file), [&file] { return readPictureChecked(file); });
}

} // namespace odo
