// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tracking/painter.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

Eigen::Vector3d vectorOf(RgbColour colour)
{
    return {double(colour.red), double(colour.green), double(colour.blue)};
}

/// Y, Cb, Cr in code values (H.273 §8.3), not rounded.
Eigen::Vector3d coded(const Eigen::Vector3d &rgb, const FrameFormat &format)
{
    const bool bt709 = format.matrix == YuvMatrix::Bt709;
    const double kr = bt709 ? 0.2126 : 0.299, kb = bt709 ? 0.0722 : 0.114;
    const Eigen::Vector3d c = rgb.cwiseMin(255.0);
    const double y = kr * c[0] + (1 - kr - kb) * c[1] + kb * c[2];
    const double cb = (c[2] - y) / (2 * (1 - kb)), cr = (c[0] - y) / (2 * (1 - kr));
    if (format.fullRange)
        return {y, 128 + cb, 128 + cr};
    return {16 + y * 219 / 255, 128 + cb * 224 / 255, 128 + cr * 224 / 255};
}

std::uint8_t rounded(double value)
{
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

} // namespace

FrameFormat testFormat(int width, int height, ChromaSiting siting, int shiftX, int shiftY)
{
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.siting = siting;
    format.chromaShiftX = shiftX;
    format.chromaShiftY = shiftY;
    return format;
}

Painter::Painter(const FrameFormat &format, RgbColour background)
    : m_format(format), m_rgb(static_cast<std::size_t>(format.width) * format.height, vectorOf(background))
{
}

void Painter::shape(const Distance &distance, const Eigen::Vector2d &low, const Eigen::Vector2d &high,
                    RgbColour colour)
{
    constexpr int parts = 16;
    const Eigen::Vector3d paint = vectorOf(colour);
    const int x0 = std::max(0, static_cast<int>(std::floor(low.x())) - 1);
    const int y0 = std::max(0, static_cast<int>(std::floor(low.y())) - 1);
    const int x1 = std::min(m_format.width - 1, static_cast<int>(std::ceil(high.x())) + 1);
    const int y1 = std::min(m_format.height - 1, static_cast<int>(std::ceil(high.y())) + 1);
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            int inside = 0, corners = 0;
            for (const double down : {-0.5, 0.5})
                for (const double across : {-0.5, 0.5})
                    corners += distance({x + across, y + down}) < 0;
            if (corners == 4) { // shapes are convex
                at(x, y) = paint;
                continue;
            }
            for (int k = 0; k < parts * parts; ++k) {
                const int row = k / parts;
                const Eigen::Vector2d sub(x + (k % parts + 0.5) / parts - 0.5, y + (row + 0.5) / parts - 0.5);
                inside += distance(sub) < 0;
            }
            const double part = inside / double(parts * parts);
            at(x, y) += part * (paint - at(x, y));
        }
    }
}

void Painter::disc(const Eigen::Vector2d &centre, double radius, RgbColour colour)
{
    ellipse(centre, radius, radius, 0, colour);
}

void Painter::ellipse(const Eigen::Vector2d &centre, double a, double b, double angleRad, RgbColour colour)
{
    const double c = std::cos(angleRad), s = std::sin(angleRad), largest = std::max(a, b);
    const auto distance = [=](const Eigen::Vector2d &p) {
        const Eigen::Vector2d d = p - centre;
        return std::hypot((c * d.x() + s * d.y()) / a, (c * d.y() - s * d.x()) / b) - 1;
    };
    shape(distance, centre.array() - largest, centre.array() + largest, colour);
}

void Painter::rectangle(const Eigen::Vector2d &low, const Eigen::Vector2d &high, RgbColour colour)
{
    const auto distance = [=](const Eigen::Vector2d &p) {
        return std::max((low - p).maxCoeff(), (p - high).maxCoeff());
    };
    shape(distance, low, high, colour);
}

void Painter::light(double gain)
{
    for (Eigen::Vector3d &pixel : m_rgb)
        pixel *= gain;
}

void Painter::shade(const Eigen::Vector2d &low, const Eigen::Vector2d &high, double gain)
{
    for (int y = std::max(0, int(low.y())); y < std::min(m_format.height, int(high.y())); ++y)
        for (int x = std::max(0, int(low.x())); x < std::min(m_format.width, int(high.x())); ++x)
            at(x, y) *= gain;
}

/// The weights of the luma pixels −1, 0 and +1 from the first one that a chroma sample stands for.
std::array<double, 3> Painter::taps(int shift, double offset)
{
    if (shift == 0)
        return {0, 1, 0};
    if (offset > 0)
        return {0, 0.5, 0.5};
    return {0.25, 0.5, 0.25};
}

/// The mean colour that a chroma sample stands for.
Eigen::Vector3d Painter::filtered(int cx, int cy) const
{
    const auto across = taps(m_format.chromaShiftX, m_format.chromaOffsetX());
    const auto down = taps(m_format.chromaShiftY, m_format.chromaOffsetY());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int j = 0; j < 3; ++j) {
        const int y = std::clamp((cy << m_format.chromaShiftY) + j - 1, 0, m_format.height - 1);
        for (int i = 0; i < 3; ++i) {
            const int x = std::clamp((cx << m_format.chromaShiftX) + i - 1, 0, m_format.width - 1);
            sum += across[i] * down[j] * m_rgb[static_cast<std::size_t>(y) * m_format.width + x];
        }
    }
    return sum;
}

Frame Painter::frame(std::int64_t index, double timeS, double noiseSigma, std::mt19937 &random) const
{
    // Draws from a fixed set of normal numbers: the tests paint a thousand pictures.
    static const std::vector<double> normals = [] {
        std::mt19937 own(1);
        std::normal_distribution<double> normal(0.0, 1.0);
        std::vector<double> values(1 << 16);
        std::generate(values.begin(), values.end(), [&] { return normal(own); });
        return values;
    }();
    std::uint32_t state = static_cast<std::uint32_t>(random());
    const auto noise = [&] {
        state = state * 1664525u + 1013904223u;
        return noiseSigma * normals[state >> 16];
    };
    auto buffer = std::make_shared<FrameBuffer>(m_format);
    for (int y = 0; y < m_format.height; ++y) {
        for (int x = 0; x < m_format.width; ++x) {
            const Eigen::Vector3d &rgb = m_rgb[static_cast<std::size_t>(y) * m_format.width + x];
            buffer->yRow(y)[x] = rounded(coded(rgb, m_format)[0] + noise());
        }
    }
    for (int y = 0; y < buffer->chromaHeight(); ++y) {
        for (int x = 0; x < buffer->chromaWidth(); ++x) {
            const Eigen::Vector3d yuv = coded(filtered(x, y), m_format);
            buffer->uRow(y)[x] = rounded(yuv[1] + noise());
            buffer->vRow(y)[x] = rounded(yuv[2] + noise());
        }
    }
    return FrameBuffer::toFrame(buffer, index, fromSeconds(timeS));
}

} // namespace odo
