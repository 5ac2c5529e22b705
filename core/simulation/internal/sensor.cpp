// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/sensor.h"

#include "core/simulation/scene.h"

#include <cmath>
#include <numbers>

namespace odo {
namespace {

// Planes are kept in 1/64 of a code value.
constexpr int fractionBits = 6;
constexpr int fraction = 1 << fractionBits;
constexpr int lumaBlack = 16 * fraction, chromaZero = 128 * fraction;
constexpr std::size_t noiseCount = 1u << 20;

// BT.601 limited range of R'G'B' in 0..255 (ITU-R BT.601-7, 2.5.1 to 2.5.3), in the planes' unit.
const Rgb lumaWeights = Rgb(0.299f, 0.587f, 0.114f, 0.f) * (219.f / 255.f * fraction);
const Rgb blueWeights =
    (Rgb(0, 0, 1, 0) - Rgb(0.299f, 0.587f, 0.114f, 0.f)) * (224.f / 255.f / 1.772f * fraction);
const Rgb redWeights =
    (Rgb(1, 0, 0, 0) - Rgb(0.299f, 0.587f, 0.114f, 0.f)) * (224.f / 255.f / 1.402f * fraction);

float weighted(const Rgb &pixel, const Rgb &weights)
{
    return pixel[0] * weights[0] + pixel[1] * weights[1] + pixel[2] * weights[2];
}

std::int16_t toPlane(float value)
{
    return static_cast<std::int16_t>(std::lrint(value));
}

/// Normally distributed numbers of unit variance, the same in every run (Box and Muller 1958).
const std::vector<float> &normalNumbers()
{
    static const std::vector<float> numbers = [] {
        std::vector<float> values(noiseCount);
        for (std::size_t i = 0; i < noiseCount; i += 2) {
            const double uniform = (static_cast<double>(randomHash(1, i) >> 11) + 1) * 0x1p-53;
            const double angle = std::numbers::pi * randomSigned(2, i);
            const double radius = std::sqrt(-2 * std::log(uniform));
            values[i] = static_cast<float>(radius * std::cos(angle));
            values[i + 1] = static_cast<float>(radius * std::sin(angle));
        }
        return values;
    }();
    return numbers;
}

/// Adds rows of noise to values, weighted; each row starts at its own position in the table.
void addNoise(std::vector<int> &values, const std::vector<std::int16_t> &noise, std::uint64_t key, int weight)
{
    const std::size_t start = randomHash(key, 0) % (noise.size() - values.size());
    const std::int16_t *source = noise.data() + start;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += source[i] * weight;
}

/// Rounds values, of which 2^shift make one code value.
void storeRow(const std::vector<int> &values, int shift, std::uint8_t *row)
{
    // 0 and 255 are reserved for timing (BT.601).
    const int half = 1 << (shift - 1);
    for (std::size_t i = 0; i < values.size(); ++i)
        row[i] = static_cast<std::uint8_t>(std::clamp((values[i] + half) >> shift, 1, 254));
}

} // namespace

Sensor::Sensor(const SensorModel &model, int width, int height, std::uint64_t key)
    : m_width(width), m_height(height), m_chromaWidth((width + 1) / 2), m_chromaHeight((height + 1) / 2),
      m_key(key)
{
    m_format.width = width;
    m_format.height = height;
    m_format.siting = model.siting;
    // Where the sample lies on a luma column (or row) the filter is centred there, else it is the mean of
    // two.
    const Kernel onSample{0.25f, 0.5f, 0.25f}, between{0.f, 0.5f, 0.5f};
    m_across = m_format.chromaOffsetX() == 0.0 ? onSample : between;
    m_down = m_format.chromaOffsetY() == 0.0 ? onSample : between;

    const auto lumaCount = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto chromaCount =
        static_cast<std::size_t>(m_chromaWidth) * static_cast<std::size_t>(m_chromaHeight);
    m_now = {std::vector<std::int16_t>(lumaCount), std::vector<std::int16_t>(chromaCount),
             std::vector<std::int16_t>(chromaCount)};
    if (model.noiseSigma <= 0)
        return;
    const auto sigma = static_cast<float>(model.noiseSigma * fraction);
    const std::vector<float> &numbers = normalNumbers();
    for (const float number : numbers)
        m_lumaNoise.push_back(toPlane(number * sigma));
    for (std::size_t i = 1; i + 1 < numbers.size(); i += 2)
        m_chromaNoise.push_back(toPlane(sigma * (m_across.before * numbers[i - 1] + m_across.at * numbers[i] +
                                                 m_across.after * numbers[i + 1])));
}

void Sensor::take(const RgbImage &part)
{
    const PixelRect rect = part.rect();
    for (int y = rect.y0; y < rect.y1; ++y) {
        const Rgb *pixels = part.row(y);
        std::int16_t *row = m_now.y.data() + static_cast<std::ptrdiff_t>(y) * m_width + rect.x0;
        for (int i = 0; i < rect.width(); ++i)
            row[i] = toPlane(weighted(pixels[i], lumaWeights) + lumaBlack);
    }
    takeChroma(part);
}

PixelRect Sensor::chromaRect(const PixelRect &rect) const
{
    // Only samples whose whole kernel lies in the rectangle.
    return {rect.x0 == 0 ? 0 : (rect.x0 + 2) / 2, rect.y0 == 0 ? 0 : (rect.y0 + 2) / 2,
            rect.x1 == m_width ? m_chromaWidth : (rect.x1 - 2) / 2 + 1,
            rect.y1 == m_height ? m_chromaHeight : (rect.y1 - 2) / 2 + 1};
}

void Sensor::takeChroma(const RgbImage &part)
{
    const PixelRect rect = part.rect(), chroma = chromaRect(rect);
    const int lastX = rect.width() - 1, lastY = rect.y1 - 1;
    for (int cy = chroma.y0; cy < chroma.y1; ++cy) {
        const Rgb *above = part.row(std::max(2 * cy - 1, rect.y0));
        const Rgb *at = part.row(std::min(2 * cy, lastY));
        const Rgb *below = part.row(std::min(2 * cy + 1, lastY));
        std::int16_t *u = m_now.u.data() + static_cast<std::ptrdiff_t>(cy) * m_chromaWidth;
        std::int16_t *v = m_now.v.data() + static_cast<std::ptrdiff_t>(cy) * m_chromaWidth;
        const auto column = [&](int x) -> Rgb {
            const int i = std::clamp(x - rect.x0, 0, lastX);
            return above[i] * m_down.before + at[i] * m_down.at + below[i] * m_down.after;
        };
        for (int cx = chroma.x0; cx < chroma.x1; ++cx) {
            const Rgb mean = column(2 * cx - 1) * m_across.before + column(2 * cx) * m_across.at +
                             column(2 * cx + 1) * m_across.after;
            u[cx] = toPlane(weighted(mean, blueWeights) + chromaZero);
            v[cx] = toPlane(weighted(mean, redWeights) + chromaZero);
        }
    }
}

void Sensor::keepStill()
{
    m_still = m_now;
}

void Sensor::restore(const PixelRect &rect)
{
    const auto copyRows = [](const PixelRect &part, int width, const std::vector<std::int16_t> &from,
                             std::vector<std::int16_t> &to) {
        for (int y = part.y0; y < part.y1; ++y) {
            const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(y) * width + part.x0;
            std::copy_n(from.data() + start, part.width(), to.data() + start);
        }
    };
    copyRows(rect, m_width, m_still.y, m_now.y);
    const PixelRect chroma = chromaRect(rect);
    copyRows(chroma, m_chromaWidth, m_still.u, m_now.u);
    copyRows(chroma, m_chromaWidth, m_still.v, m_now.v);
}

std::shared_ptr<FrameBuffer> Sensor::read(double gain, std::uint64_t image) const
{
    auto frame = std::make_shared<FrameBuffer>(m_format);
    const std::uint64_t key = randomHash(m_key, image);
    readLuma(*frame, gain, randomHash(key, 1));
    readChroma(m_now.u, *frame, true, gain, randomHash(key, 2));
    readChroma(m_now.v, *frame, false, gain, randomHash(key, 3));
    return frame;
}

void Sensor::readLuma(FrameBuffer &frame, double gain, std::uint64_t key) const
{
    const int gain14 = static_cast<int>(std::lrint(gain * (1 << 14)));
    std::vector<int> values(static_cast<std::size_t>(m_width));
    for (int y = 0; y < m_height; ++y) {
        const std::int16_t *row = m_now.y.data() + static_cast<std::ptrdiff_t>(y) * m_width;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = (((row[i] - lumaBlack) * gain14) >> 14) + lumaBlack;
        if (!m_lumaNoise.empty())
            addNoise(values, m_lumaNoise, randomHash(key, static_cast<std::uint64_t>(y)), 1);
        storeRow(values, fractionBits, frame.yRow(y));
    }
}

void Sensor::readChroma(const std::vector<std::int16_t> &plane, FrameBuffer &frame, bool isU, double gain,
                        std::uint64_t key) const
{
    // Noise is drawn for each luma row and then filtered as the frame is, so that it has the right size and
    // correlation; in quarters, the unit of the kernel down.
    const int gain14 = static_cast<int>(std::lrint(gain * (1 << 14)));
    std::vector<int> values(static_cast<std::size_t>(m_chromaWidth));
    for (int cy = 0; cy < m_chromaHeight; ++cy) {
        const std::int16_t *row = plane.data() + static_cast<std::ptrdiff_t>(cy) * m_chromaWidth;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = ((((row[i] - chromaZero) * gain14) >> 14) + chromaZero) * 4;
        const float weights[] = {m_down.before, m_down.at, m_down.after};
        for (int k = 0; k < 3 && !m_chromaNoise.empty(); ++k)
            if (weights[k] > 0)
                addNoise(values, m_chromaNoise, randomHash(key, static_cast<std::uint64_t>(2 * cy + k)),
                         static_cast<int>(4 * weights[k]));
        storeRow(values, fractionBits + 2, isU ? frame.uRow(cy) : frame.vRow(cy));
    }
}

} // namespace odo
