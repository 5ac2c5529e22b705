// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/chroma.h"

#include "core/tracking/internal/chroma_density.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace odo {

namespace {

struct LumaShares
{
    double red, blue;
};

/// H.273 table 4.
LumaShares lumaSharesOf(YuvMatrix matrix)
{
    switch (matrix) {
    case YuvMatrix::Bt709:
        return {0.2126, 0.0722};
    case YuvMatrix::Bt2020:
        return {0.2627, 0.0593};
    default:
        return {0.299, 0.114};
    }
}

/// Shares of red and blue in luma, and the code values of chroma for a whole one.
struct Coding
{
    double kr, kb, range;

    explicit Coding(const FrameFormat &format)
        : kr(lumaSharesOf(format.matrix).red), kb(lumaSharesOf(format.matrix).blue),
          range(format.fullRange ? 1.0 : 224.0 / 255.0)
    {
    }
};

} // namespace

Chroma chromaOf(RgbColour colour, const FrameFormat &format)
{
    const auto [kr, kb, range] = Coding(format);
    const double luma = kr * colour.red + (1 - kr - kb) * colour.green + kb * colour.blue;
    return {range * (colour.blue - luma) / (2 * (1 - kb)), range * (colour.red - luma) / (2 * (1 - kr))};
}

RgbColour colourOf(double luma, const Chroma &chroma, const FrameFormat &format)
{
    const auto [kr, kb, range] = Coding(format);
    const double y = format.fullRange ? luma : (luma - 16) * 255.0 / 219.0;
    const double blue = y + 2 * (1 - kb) * chroma.x() / range, red = y + 2 * (1 - kr) * chroma.y() / range;
    const double green = (y - kr * red - kb * blue) / (1 - kr - kb);
    const auto channel = [](double value) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    };
    return {channel(red), channel(green), channel(blue)};
}

ChromaRect ChromaRect::grownBy(int samples) const
{
    return {left - samples, top - samples, right + samples, bottom + samples};
}

ChromaRect ChromaRect::clippedTo(const ChromaRect &other) const
{
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

ChromaGrid::ChromaGrid(const Frame &frame)
    : u(frame.u), v(frame.v), scale(1 << frame.format.chromaShiftX, 1 << frame.format.chromaShiftY),
      offset(frame.format.chromaOffsetX(), frame.format.chromaOffsetY())
{
}

namespace {

constexpr int leastSamples = 4;              // of the box, along each axis
constexpr double leastPickedSaturation = 12; // code values of 128; the tracker needs 8 in the shade too
constexpr double leastShareOfBox = 0.08;     // of the box
constexpr double likeTheSame = 0.3;          // likeness to the commonest hue
constexpr double clearlyCommoner = 3;        // inside than around
constexpr int smoothings = 2;                // of the densities: noise spreads a colour over several bins

Message colourInBox()
{
    return ODO_TEXT("tracking.colour_in_box", "colour in the box");
}

ChromaRect chromaRectOf(const ChromaGrid &grid, const PixelRect &box)
{
    const Eigen::Vector2d first = grid.fromLuma({box.x0, box.y0}),
                          end = grid.fromLuma({box.x1 - 1, box.y1 - 1});
    const auto up = [](double position) { return static_cast<int>(std::ceil(position - 1e-9)); };
    return ChromaRect{up(first.x()), up(first.y()), static_cast<int>(std::floor(end.x() + 1e-9)) + 1,
                      static_cast<int>(std::floor(end.y() + 1e-9)) + 1}
        .clippedTo(grid.bounds());
}

ChromaDensity densityOf(const ChromaGrid &grid, const ChromaRect &area)
{
    ChromaDensity density;
    density.count(grid, area, 1);
    density.normalise();
    density.blur(smoothings);
    return density;
}

/// What lies in a frame around the box; nothing if the box fills the frame.
ChromaDensity densityAround(const ChromaGrid &grid, const ChromaRect &box)
{
    const int margin = std::max({leastSamples, box.width() / 2, box.height() / 2});
    ChromaDensity density;
    density.count(grid, box.grownBy(margin).clippedTo(grid.bounds()), 1);
    density.count(grid, box, 1, -1.0f);
    density.normalise();
    density.blur(smoothings);
    return density;
}

/// Which bins differ from the surroundings, and which of them are one colour.
struct Standing
{
    std::vector<bool> own;         ///< bins of the colour
    double coloured = 0, grey = 0; ///< shares of the box with such a colour, and of grey
};

Standing findStanding(const ChromaDensity &inside, const ChromaDensity &around)
{
    const auto excess = [&](std::size_t bin) {
        return inside[bin] > clearlyCommoner * around[bin] ? double(inside[bin]) : 0.0;
    };
    Standing standing;
    standing.own.resize(ChromaDensity::binCount);
    double most = 0;
    Chroma hue = Chroma::Zero();
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin) {
        const Chroma seen = ChromaDensity::centreOf(bin);
        if (seen.norm() < leastPickedSaturation) {
            standing.grey += excess(bin);
        } else if (excess(bin) > most) {
            most = excess(bin);
            hue = seen;
        }
    }
    for (std::size_t bin = 0; bin < ChromaDensity::binCount && most > 0; ++bin) {
        const Chroma seen = ChromaDensity::centreOf(bin);
        if (seen.norm() < leastPickedSaturation || excess(bin) <= 0 || likeness(seen, hue) < likeTheSame)
            continue;
        standing.own[bin] = true;
        standing.coloured += excess(bin);
    }
    return standing;
}

/// The mean of all samples of the box that are of the bins.
RgbColour meanColour(const Frame &frame, const ChromaGrid &grid, const ChromaRect &box,
                     const std::vector<bool> &bins)
{
    double luma = 0, count = 0;
    Chroma chroma = Chroma::Zero();
    for (int y = box.top; y < box.bottom; ++y) {
        for (int x = box.left; x < box.right; ++x) {
            if (!bins[ChromaDensity::binOf(grid.u.at(x, y), grid.v.at(x, y))])
                continue;
            luma += frame.y.at(std::min(x << frame.format.chromaShiftX, frame.y.width - 1),
                               std::min(y << frame.format.chromaShiftY, frame.y.height - 1));
            chroma += grid.at(x, y);
            count += 1;
        }
    }
    return colourOf(luma / count, chroma / count, frame.format);
}

} // namespace

Result<PickedColour> pickColour(const Frame &frame, const PixelRect &box)
{
    const ChromaGrid grid(frame);
    const ChromaRect area = chromaRectOf(grid, box);
    if (area.width() < leastSamples || area.height() < leastSamples)
        return fail(
            ErrorCode::InvalidInput, colourInBox(),
            ODO_TEXT("tracking.box_too_small", "the box is too small or outside the image"),
            ODO_TEXT("tracking.draw_box_larger", "draw it round the robot, at least 8 pixels wide and high"));
    const ChromaDensity around = densityAround(grid, area);
    if (!(around.sum() > 0.5))
        return fail(
            ErrorCode::InvalidInput, colourInBox(),
            ODO_TEXT("tracking.box_leaves_nothing", "the box leaves no floor around it to compare with"),
            ODO_TEXT("tracking.draw_box_closely", "draw it closely round the robot"));
    const Standing standing = findStanding(densityOf(grid, area), around);
    if (standing.coloured >= leastShareOfBox)
        return PickedColour{meanColour(frame, grid, area, standing.own), std::min(1.0, standing.coloured)};
    if (standing.grey >= leastShareOfBox)
        return fail(ErrorCode::Undetermined, colourInBox(),
                    ODO_TEXT("tracking.box_is_grey", "the robot in it is grey, black or white"),
                    ODO_TEXT("tracking.add_without_colour",
                             "add the robot without a colour; background subtraction then finds it"));
    return fail(ErrorCode::Undetermined, colourInBox(),
                ODO_TEXT("tracking.box_without_colour",
                         "it contains no colour that differs from the floor around it"),
                ODO_TEXT("tracking.put_plate_on_it",
                         "draw it closely round the robot, or put a plate of another colour on it"));
}

} // namespace odo
