// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/internal/polygon_layer.h"
#include "core/simulation/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace odo {

/// Turns light into the planes of a frame: Y'CbCr by BT.601 (limited range), chroma filtered and sampled
/// where its siting says, gain, and noise. Keeps the planes of one frame; parts of it can be replaced.
class Sensor
{
public:
    /// key: makes the noise of two sensors differ.
    Sensor(const SensorModel &model, int width, int height, std::uint64_t key);

    const FrameFormat &format() const { return m_format; }

    /// Takes over a part of the frame. Its border of two pixels (where it is not the frame's) must be as
    /// before.
    void take(const RgbImage &part);
    /// Remembers the whole frame as it is now, for restore.
    void keepStill();
    /// Puts a part back to what keepStill remembered; a rectangle that was taken before.
    void restore(const PixelRect &rect);

    /// The frame: planes · gain + noise, rounded. The noise is that of this frame number.
    std::shared_ptr<FrameBuffer> read(double gain, std::uint64_t image) const;

private:
    struct Planes
    {
        std::vector<std::int16_t> y, u, v;
    };
    /// Weights of luma columns (or rows) 2c-1, 2c, 2c+1 in chroma sample c.
    struct Kernel
    {
        float before, at, after;
    };
    void takeChroma(const RgbImage &part);
    PixelRect chromaRect(const PixelRect &rect) const;
    void readLuma(FrameBuffer &frame, double gain, std::uint64_t key) const;
    void readChroma(const std::vector<std::int16_t> &plane, FrameBuffer &frame, bool isU, double gain,
                    std::uint64_t key) const;

    int m_width, m_height, m_chromaWidth, m_chromaHeight;
    std::uint64_t m_key;
    FrameFormat m_format;
    Kernel m_across{}, m_down{};
    Planes m_now, m_still;
    std::vector<std::int16_t> m_lumaNoise,
        m_chromaNoise; ///< empty without noise; chroma's is filtered across
};

} // namespace odo
