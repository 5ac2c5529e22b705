// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/compared_window.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr float plainSteps = 6;                    // of the least step: half of black on grey
constexpr float textureJitter = 0.08F;             // of the luma's slope: what coding and a lens that breathes move, pixels
constexpr float darkest = 0.40F, lightest = 0.99F; // of the floor in shadow against the floor in light
constexpr float darkestFloor = 12;                 // code values above black: on a darker one a shadow is not seen
constexpr int patch = 7;                           // pixels of the patches whose texture is compared
constexpr float leastPatch = 16, flatness = 0.25F; // of the texture's variance
constexpr float otherHue = 2.2F;                   // code values, of a patch's mean chroma against that of the floor in shadow
constexpr float clearTexture = 6;                  // its variance against the noise's

/// A chroma plane about neutral, brought to the resolution of the luma.
template <class RowOf>
void enlarge(const FrameFormat &format, const PixelRect &rect, const RowOf &rowOf, int width, int height, cv::Mat1f &into)
{
    const int sx = format.chromaShiftX, sy = format.chromaShiftY;
    const double offsetX = format.chromaOffsetX(), offsetY = format.chromaOffsetY();
    into.create(rect.height(), rect.width());
    for (int y = 0; y < into.rows; ++y) {
        const double at = (rect.y0 + y - offsetY) / (1 << sy);
        const int y0 = std::clamp(static_cast<int>(std::floor(at)), 0, height - 1), y1 = std::min(y0 + 1, height - 1);
        const auto fy = static_cast<float>(std::clamp(at - y0, 0.0, 1.0));
        const std::uint8_t *above = rowOf(y0), *below = rowOf(y1);
        float *out = into[y];
        for (int x = 0; x < into.cols; ++x) {
            const double along = (rect.x0 + x - offsetX) / (1 << sx);
            const int x0 = std::clamp(static_cast<int>(std::floor(along)), 0, width - 1), x1 = std::min(x0 + 1, width - 1);
            const auto fx = static_cast<float>(std::clamp(along - x0, 0.0, 1.0));
            const float top = float(above[x0]) + fx * float(above[x1] - above[x0]);
            const float bottom = float(below[x0]) + fx * float(below[x1] - below[x0]);
            out[x] = top + fy * (bottom - top) - 128;
        }
    }
}

} // namespace

void ComparedWindow::compare(const Frame &frame, const Background &background, const LightGain &gain, const PixelRect &part)
{
    rect = part;
    read(frame, background, gain);
    findDifferences(float(LightGain::mostLuma - gain.black));
    findShade();
}

void ComparedWindow::read(const Frame &frame, const Background &background, const LightGain &gain)
{
    luma.create(rect.height(), rect.width());
    lumaBehind.create(luma.size());
    lumaNoise2.create(luma.size());
    chromaNoise2.create(luma.size());
    const int sx = frame.format.chromaShiftX, sy = frame.format.chromaShiftY;
    for (int y = 0; y < rect.height(); ++y) {
        const int cy = std::min((rect.y0 + y) >> sy, frame.u.height - 1);
        const std::uint8_t *now = frame.y.row(rect.y0 + y), *behind = background.y.row(rect.y0 + y);
        const std::uint8_t *sigma = background.y.sigmaRow(rect.y0 + y), *uSigma = background.u.sigmaRow(cy), *vSigma = background.v.sigmaRow(cy);
        for (int x = 0; x < rect.width(); ++x) {
            const int px = rect.x0 + x, cx = std::min(px >> sx, frame.u.width - 1);
            luma(y, x) = float(now[px] - gain.black);
            lumaBehind(y, x) = gain.factor * float(behind[px] - gain.black);
            lumaNoise2(y, x) = squared(float(sigma[px]) * Background::sigmaUnit);
            chromaNoise2(y, x) = squared(float(std::max(uSigma[cx], vSigma[cx])) * Background::sigmaUnit);
        }
    }
    const auto enlarged = [&](const auto &plane, cv::Mat1f &into) {
        enlarge(frame.format, rect, [&](int y) { return plane.row(y); }, plane.width, plane.height, into);
    };
    enlarged(frame.u, u);
    enlarged(frame.v, v);
    enlarged(background.u, uBehind);
    enlarged(background.v, vBehind);
    uBehind *= gain.factor;
    vBehind *= gain.factor;
}

void ComparedWindow::findDifferences(float cutOff)
{
    differs.create(luma.size());
    plain.create(luma.size());
    for (int y = 0; y < luma.rows; ++y) {
        const float *above = lumaBehind[std::max(0, y - 1)], *here = lumaBehind[y], *below = lumaBehind[std::min(luma.rows - 1, y + 1)];
        for (int x = 0; x < luma.cols; ++x) {
            const float slopeX = here[std::min(luma.cols - 1, x + 1)] - here[std::max(0, x - 1)], slopeY = below[x] - above[x];
            const float noise2 = lumaNoise2(y, x) + squared(textureJitter) * (slopeX * slopeX + slopeY * slopeY);
            lumaNoise2(y, x) = noise2;
            const float darker = luma(y, x) - here[x];
            const float dy = luma(y, x) >= cutOff ? std::max(0.0F, darker) : darker; // it may be as light as foreseen
            const float du = u(y, x) - uBehind(y, x), dv = v(y, x) - vBehind(y, x);
            const float excess = dy * dy / noise2 + (du * du + dv * dv) / chromaNoise2(y, x);
            const float lumaSteps = std::abs(dy) / leastLumaStep, chromaSteps = std::max(std::abs(du), std::abs(dv)) / leastChromaStep;
            const float steps = std::max(lumaSteps, chromaSteps);
            differs(y, x) = steps > 1 && excess > differsInSigmas2 ? 1 : 0;
            plain(y, x) = differs(y, x) && steps > plainSteps ? 1 : 0;
        }
    }
}

/// Marks what may be floor in shadow: darker by a factor, with the floor's chroma darkened alike. Of a flat surface of the floor's own
/// hue that could be said too; where the floor behind has texture and what is seen has none, it is no shadow.
void ComparedWindow::findShade()
{
    shade.create(luma.size());
    byHue = cv::Mat1b::zeros(luma.size());
    cv::Mat1f mask(luma.size()), seen(luma.size()), behind(luma.size()), offU(luma.size()), offV(luma.size());
    for (int y = 0; y < luma.rows; ++y) {
        for (int x = 0; x < luma.cols; ++x) {
            const float floor = std::max(1.0F, lumaBehind(y, x)), ratio = luma(y, x) / floor;
            const float tolerance = 3 * std::sqrt(chromaNoise2(y, x)) + 1.5F;
            const auto isDarkened = [&](float chroma, float chromaBehind) {
                return std::abs(chroma - ratio * chromaBehind) < tolerance + 0.1F * std::abs(chromaBehind);
            };
            const bool mayBe = floor > darkestFloor && ratio > darkest && ratio < lightest && isDarkened(u(y, x), uBehind(y, x)) &&
                               isDarkened(v(y, x), vBehind(y, x));
            shade(y, x) = mayBe ? 1 : 0;
            mask(y, x) = mayBe && differs(y, x) ? 1.0F : 0.0F;
            seen(y, x) = mask(y, x) * std::log(std::max(1.0F, luma(y, x)));
            behind(y, x) = mask(y, x) * std::log(floor);
            offU(y, x) = mask(y, x) * (u(y, x) - ratio * uBehind(y, x));
            offV(y, x) = mask(y, x) * (v(y, x) - ratio * vBehind(y, x));
        }
    }
    const auto sum = [](const cv::Mat1f &values) {
        cv::Mat1f result;
        cv::boxFilter(values, result, -1, {patch, patch}, {-1, -1}, false, cv::BORDER_CONSTANT);
        return result;
    };
    const cv::Mat1f n = sum(mask), i = sum(seen), ii = sum(seen.mul(seen)), b = sum(behind), bb = sum(behind.mul(behind)), du = sum(offU), dv = sum(offV);
    for (int y = 0; y < luma.rows; ++y) {
        for (int x = 0; x < luma.cols; ++x) {
            if (mask(y, x) == 0 || n(y, x) < leastPatch)
                continue;
            const float varI = ii(y, x) / n(y, x) - squared(i(y, x) / n(y, x)), varB = bb(y, x) / n(y, x) - squared(b(y, x) / n(y, x));
            const float noise = lumaNoise2(y, x) / squared(std::max(1.0F, luma(y, x)));
            byHue(y, x) = std::max(std::abs(du(y, x)), std::abs(dv(y, x))) > otherHue * n(y, x) ? 1 : 0;
            if (byHue(y, x) || (varB > clearTexture * noise && varI < flatness * varB))
                shade(y, x) = 0;
        }
    }
}

} // namespace odo
