// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_mode.h"

#include "core/capture/camera_source.h"
#include "core/video/jpeg.h"
#include "core/video/planes/camera_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <linux/videodev2.h>
#include <tuple>

namespace odo {

namespace {

struct Size
{
    __u32 width, height;
};
constexpr std::array<Size, 6> usualSizes{
    {{640, 480}, {640, 360}, {1280, 720}, {1280, 960}, {1920, 1080}, {320, 240}}};
constexpr std::array<__u32, 5> usualRates{120, 60, 30, 25, 15};
constexpr double wantedRate = 30, rateTolerance = 0.02, wantedPixels = 1280.0 * 720.0;
constexpr std::size_t mostModesNamed = 12;

std::vector<v4l2_fract> periodsWithin(const v4l2_frmival_stepwise &range)
{
    const auto seconds = [](const v4l2_fract &period) {
        return static_cast<double>(period.numerator) / period.denominator;
    };
    std::vector<v4l2_fract> periods{range.min};
    for (const __u32 rate : usualRates) {
        const v4l2_fract period{1, rate};
        if (seconds(period) > seconds(range.min) && seconds(period) <= seconds(range.max))
            periods.push_back(period);
    }
    return periods;
}

/// The one that is set now, for drivers that cannot say what they offer.
std::vector<v4l2_fract> presentPeriod(const V4l2Device &device)
{
    v4l2_streamparm parameters{};
    parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (device.call(VIDIOC_G_PARM, &parameters) != 0)
        return {{1, 30}};
    return {parameters.parm.capture.timeperframe};
}

std::vector<v4l2_fract> periodsOf(const V4l2Device &device, __u32 format, Size size)
{
    std::vector<v4l2_fract> periods;
    v4l2_frmivalenum query{};
    query.pixel_format = format;
    query.width = size.width;
    query.height = size.height;
    for (; device.call(VIDIOC_ENUM_FRAMEINTERVALS, &query) == 0; ++query.index) {
        if (query.type != V4L2_FRMIVAL_TYPE_DISCRETE)
            return periodsWithin(query.stepwise);
        periods.push_back(query.discrete);
    }
    return periods.empty() ? presentPeriod(device) : periods;
}

std::vector<Size> sizesWithin(const v4l2_frmsize_stepwise &range)
{
    std::vector<Size> sizes;
    const auto fits = [](__u32 value, __u32 least, __u32 most, __u32 step) {
        return value >= least && value <= most && (step == 0 || (value - least) % step == 0);
    };
    for (const Size size : usualSizes) {
        if (fits(size.width, range.min_width, range.max_width, range.step_width) &&
            fits(size.height, range.min_height, range.max_height, range.step_height))
            sizes.push_back(size);
    }
    if (sizes.empty())
        sizes.push_back({range.max_width, range.max_height});
    return sizes;
}

std::vector<Size> sizesOf(const V4l2Device &device, __u32 format)
{
    std::vector<Size> sizes;
    v4l2_frmsizeenum query{};
    query.pixel_format = format;
    for (; device.call(VIDIOC_ENUM_FRAMESIZES, &query) == 0; ++query.index) {
        if (query.type != V4L2_FRMSIZE_TYPE_DISCRETE)
            return sizesWithin(query.stepwise);
        sizes.push_back({query.discrete.width, query.discrete.height});
    }
    v4l2_format present{};
    present.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (sizes.empty() && device.call(VIDIOC_G_FMT, &present) == 0)
        sizes.push_back({present.fmt.pix.width, present.fmt.pix.height});
    return sizes;
}

bool fits(const V4l2Mode &mode, const V4l2Request &request)
{
    const auto differs = [](const auto &wanted, auto value) { return wanted && *wanted != value; };
    return !differs(request.format, mode.format) && !differs(request.widthPx, mode.widthPx) &&
           !differs(request.heightPx, mode.heightPx) &&
           (!request.framesPerSecond ||
            std::abs(mode.framesPerSecond() / *request.framesPerSecond - 1) <= rateTolerance);
}

auto merit(const V4l2Mode &mode)
{
    const double pixels = static_cast<double>(mode.widthPx) * mode.heightPx;
    return std::tuple(mode.framesPerSecond() < (1 - rateTolerance) * wantedRate,
                      std::abs(std::log(pixels / wantedPixels)), -mode.framesPerSecond(),
                      v4l2FormatRank(mode.format));
}

Message offerWords(const std::vector<V4l2Mode> &modes)
{
    std::vector<Message> named;
    for (std::size_t i = 0; i < std::min(modes.size(), mostModesNamed); ++i)
        named.push_back(modeWords(modes[i]));
    const MessageArgument list = listed(std::move(named), MessageArgument::Joint::Comma);
    return modes.size() > mostModesNamed ? ODO_TEXT("capture.these_and_others", "%1 and others")(list)
                                         : nameAlone(list);
}

} // namespace

std::string fourccWords(std::uint32_t fourcc)
{
    std::string words;
    for (int shift = 0; shift < 32; shift += 8)
        words += static_cast<char>(fourcc >> shift & 0x7f);
    words.erase(words.find_last_not_of(' ') + 1);
    return words;
}

Message modeWords(const V4l2Mode &mode)
{
    return formatWords(fourccWords(mode.format), mode.widthPx, mode.heightPx, mode.framesPerSecond());
}

std::vector<V4l2Mode> v4l2Modes(const V4l2Device &device)
{
    std::vector<V4l2Mode> modes;
    v4l2_fmtdesc format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    for (; device.call(VIDIOC_ENUM_FMT, &format) == 0; ++format.index) {
        if (v4l2FormatRank(format.pixelformat) < 0)
            continue;
        for (const Size size : sizesOf(device, format.pixelformat)) {
            for (const v4l2_fract period : periodsOf(device, format.pixelformat, size)) {
                if (period.numerator > 0 && period.denominator > 0)
                    modes.push_back({format.pixelformat, static_cast<int>(size.width),
                                     static_cast<int>(size.height), period.numerator, period.denominator});
            }
        }
    }
    return modes;
}

void sortByMerit(std::vector<V4l2Mode> &modes)
{
    std::ranges::stable_sort(modes, {}, merit);
}

Result<V4l2Mode> chooseMode(const std::vector<V4l2Mode> &modes, const V4l2Request &request,
                            const std::string &uri)
{
    const V4l2Mode *best = nullptr;
    for (const V4l2Mode &mode : modes) {
        if (fits(mode, request) && (!best || merit(mode) < merit(*best)))
            best = &mode;
    }
    if (best)
        return *best;
    if (modes.empty())
        return fail(ErrorCode::NotFound, cameraAtAddress(uri),
                    ODO_TEXT("capture.no_readable_format", "it offers no supported format"),
                    ODO_TEXT("capture.take_another_camera", "use another camera"));
    return fail(ErrorCode::NotFound, cameraAtAddress(uri),
                ODO_TEXT("capture.not_offered", "it does not offer the requested mode"),
                joined({ODO_TEXT("capture.choose_of_offer", "choose one that it offers"), offerWords(modes)},
                       Join::Colon));
}

namespace {

using Bytes = std::span<const std::uint8_t>;

/// In the order of preference: coded frames leave bandwidth on the bus for a second camera, grey ones have no
/// colour to track.
constexpr std::array<std::uint32_t, 12> readable{
    V4L2_PIX_FMT_MJPEG,  V4L2_PIX_FMT_JPEG,   V4L2_PIX_FMT_YUYV,   V4L2_PIX_FMT_UYVY,
    V4L2_PIX_FMT_NV12,   V4L2_PIX_FMT_RGB24,  V4L2_PIX_FMT_BGR24,  V4L2_PIX_FMT_SRGGB8,
    V4L2_PIX_FMT_SGRBG8, V4L2_PIX_FMT_SGBRG8, V4L2_PIX_FMT_SBGGR8, V4L2_PIX_FMT_GREY};

std::optional<PackedLayout> packedLayout(std::uint32_t fourcc)
{
    switch (fourcc) {
    case V4L2_PIX_FMT_YUYV:
        return PackedLayout::Yuyv;
    case V4L2_PIX_FMT_UYVY:
        return PackedLayout::Uyvy;
    case V4L2_PIX_FMT_NV12:
        return PackedLayout::Nv12;
    default:
        return std::nullopt;
    }
}

std::optional<BayerOrder> bayerOrder(std::uint32_t fourcc)
{
    switch (fourcc) {
    case V4L2_PIX_FMT_SRGGB8:
        return BayerOrder::Rggb;
    case V4L2_PIX_FMT_SGRBG8:
        return BayerOrder::Grbg;
    case V4L2_PIX_FMT_SGBRG8:
        return BayerOrder::Gbrg;
    case V4L2_PIX_FMT_SBGGR8:
        return BayerOrder::Bggr;
    default:
        return std::nullopt;
    }
}

/// What the driver leaves open follows from the colour space, by the rules of the interface.
PackedFormat packedFormat(const v4l2_pix_format &format, PackedLayout layout)
{
    const __u32 encoding = format.ycbcr_enc != V4L2_YCBCR_ENC_DEFAULT
                               ? format.ycbcr_enc
                               : __u32(V4L2_MAP_YCBCR_ENC_DEFAULT(format.colorspace));
    const __u32 quantization = format.quantization != V4L2_QUANTIZATION_DEFAULT
                                   ? format.quantization
                                   : __u32(V4L2_MAP_QUANTIZATION_DEFAULT(false, format.colorspace, encoding));
    PackedFormat packed{layout, static_cast<int>(format.width), static_cast<int>(format.height),
                        static_cast<int>(format.bytesperline)};
    packed.matrix = encoding == V4L2_YCBCR_ENC_709 || encoding == V4L2_YCBCR_ENC_XV709 ? YuvMatrix::Bt709
                                                                                       : YuvMatrix::Bt601;
    packed.fullRange = quantization == V4L2_QUANTIZATION_FULL_RANGE;
    return packed;
}

/// Reads uncoded frames.
std::function<Frame(Bytes)> rawReader(const v4l2_pix_format &format)
{
    const int width = static_cast<int>(format.width), height = static_cast<int>(format.height);
    const auto stride = static_cast<std::ptrdiff_t>(format.bytesperline);
    if (const auto layout = packedLayout(format.pixelformat)) {
        const auto planes = std::make_shared<PackedPlanes>(packedFormat(format, *layout));
        return [planes](Bytes bytes) { return *planes->toPlanes(bytes); };
    }
    if (const auto order = bayerOrder(format.pixelformat))
        return [=](Bytes bytes) { return bayerPlanes({bytes.data(), width, height, stride}, *order, 0, {}); };
    if (format.pixelformat == V4L2_PIX_FMT_GREY)
        return [=](Bytes bytes) { return monoPlanes({bytes.data(), width, height, stride}, 0, {}); };
    const auto order = format.pixelformat == V4L2_PIX_FMT_RGB24 ? RgbView::Order::Rgb : RgbView::Order::Bgr;
    return [=](Bytes bytes) { return rgbPlanes({bytes.data(), width, height, stride, order}, 0, {}); };
}

bool isCoded(std::uint32_t fourcc)
{
    return fourcc == V4L2_PIX_FMT_MJPEG || fourcc == V4L2_PIX_FMT_JPEG;
}

bool areAlike(const FrameFormat &a, const FrameFormat &b)
{
    return a.chromaShiftX == b.chromaShiftX && a.chromaShiftY == b.chromaShiftY;
}

} // namespace

int v4l2FormatRank(std::uint32_t fourcc)
{
    const auto found = std::ranges::find(readable, fourcc);
    return found == readable.end() ? -1 : static_cast<int>(found - readable.begin());
}

V4l2Frames::V4l2Frames(const v4l2_pix_format &format)
    : m_width(static_cast<int>(format.width)), m_height(static_cast<int>(format.height)),
      m_leastBytes(isCoded(format.pixelformat) ? 0 : format.sizeimage)
{
    if (!isCoded(format.pixelformat))
        m_raw = rawReader(format);
}

std::optional<V4l2Frame> V4l2Frames::read(Bytes buffer)
{
    if (!m_raw)
        return readJpeg(buffer);
    if (buffer.size() < m_leastBytes)
        return std::nullopt;
    return V4l2Frame{m_raw(buffer), nullptr};
}

std::optional<V4l2Frame> V4l2Frames::readJpeg(Bytes buffer)
{
    const auto format = jpegFormat(buffer);
    if (!format || format->width != m_width || format->height != m_height)
        return std::nullopt;
    if (!m_decoder || !areAlike(*format, m_jpegFormat)) {
        m_decoder = std::make_unique<JpegDecoder>(*format);
        m_jpegFormat = *format;
    }
    V4l2Frame decoded{{}, std::make_shared<const std::vector<std::uint8_t>>(withHuffmanTables(buffer))};
    if (m_decoder->decode(*decoded.jpeg, std::nullopt, decoded.frame) != JpegDecoder::Outcome::Decoded)
        return std::nullopt;
    return decoded;
}

} // namespace odo
