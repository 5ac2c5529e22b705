// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_mode.h"

#include "core/capture/camera_errors.h"
#include "core/capture/camera_source.h"
#include "core/capture/v4l2/internal/v4l2_pictures.h"

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
                    ODO_TEXT("capture.no_readable_format", "it has no format that can be read"),
                    ODO_TEXT("capture.take_another_camera", "take another camera"));
    return fail(ErrorCode::NotFound, cameraAtAddress(uri),
                ODO_TEXT("capture.not_offered", "it does not offer what was asked for"),
                joined({ODO_TEXT("capture.choose_of_offer", "choose of what it offers"), offerWords(modes)},
                       Join::Colon));
}

} // namespace odo
