// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/aravis_picture.h"

#include "core/video/bayer_planes.h"
#include "core/video/rgb_planes.h"

#include <algorithm>
#include <array>

namespace odo {

namespace {

enum Code : std::uint32_t {
    Mono8 = 0x01080001,
    BayerGr8 = 0x01080008,
    BayerRg8 = 0x01080009,
    BayerGb8 = 0x0108000a,
    BayerBg8 = 0x0108000b,
    Rgb8 = 0x02180014,
    Bgr8 = 0x02180015
};

constexpr std::array<GenicamFormat, 7> formats{{{BayerRg8, "BayerRG8", 1},
                                                {BayerGr8, "BayerGR8", 1},
                                                {BayerGb8, "BayerGB8", 1},
                                                {BayerBg8, "BayerBG8", 1},
                                                {Rgb8, "RGB8", 3},
                                                {Bgr8, "BGR8", 3},
                                                {Mono8, "Mono8", 1}}};

} // namespace

std::span<const GenicamFormat> usableGenicamFormats()
{
    return formats;
}

std::optional<GenicamFormat> usableGenicamFormat(std::uint32_t code)
{
    const auto found = std::ranges::find(formats, code, &GenicamFormat::code);
    return found == formats.end() ? std::nullopt : std::optional(*found);
}

std::string namesOfUsableFormats()
{
    std::string names;
    for (const GenicamFormat &format : formats)
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    return names;
}

Frame genicamPlanes(const GenicamFormat &format, const std::uint8_t *bytes, int widthPx, int heightPx)
{
    const PlaneView raw{bytes, widthPx, heightPx, widthPx};
    const auto packed = [&](RgbView::Order order) {
        return RgbView{bytes, widthPx, heightPx, std::ptrdiff_t{3} * widthPx, order};
    };
    switch (format.code) {
    case BayerRg8:
        return bayerPlanes(raw, BayerOrder::Rggb, 0, {});
    case BayerGr8:
        return bayerPlanes(raw, BayerOrder::Grbg, 0, {});
    case BayerGb8:
        return bayerPlanes(raw, BayerOrder::Gbrg, 0, {});
    case BayerBg8:
        return bayerPlanes(raw, BayerOrder::Bggr, 0, {});
    case Rgb8:
        return rgbPlanes(packed(RgbView::Order::Rgb), 0, {});
    case Bgr8:
        return rgbPlanes(packed(RgbView::Order::Bgr), 0, {});
    default:
        return monoPlanes(raw, 0, {});
    }
}

} // namespace odo
