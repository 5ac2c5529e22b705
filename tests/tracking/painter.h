// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <random>

namespace odo {

/// Paints small test pictures with exactly known shapes straight into planes: antialiased by 16×16
/// sub-samples at the edges, chroma filtered to the format's siting, noise added to the samples.
class Painter
{
public:
    explicit Painter(const FrameFormat &format, RgbColour background = {150, 146, 138});

    /// A convex shape is given by its signed distance to a point: negative inside.
    using Distance = std::function<double(const Eigen::Vector2d &)>;
    void shape(const Distance &distance, const Eigen::Vector2d &low, const Eigen::Vector2d &high,
               RgbColour colour);
    void disc(const Eigen::Vector2d &centre, double radius, RgbColour colour);
    void ellipse(const Eigen::Vector2d &centre, double a, double b, double angleRad, RgbColour colour);
    void rectangle(const Eigen::Vector2d &low, const Eigen::Vector2d &high, RgbColour colour);
    /// Multiplies what was painted so far, in RGB; or the pixels of a rectangle, as a shadow does.
    void light(double gain);
    void shade(const Eigen::Vector2d &low, const Eigen::Vector2d &high, double gain);

    Frame frame(std::int64_t index, double timeS, double noiseSigma, std::mt19937 &random) const;

private:
    Eigen::Vector3d &at(int x, int y) { return m_rgb[static_cast<std::size_t>(y) * m_format.width + x]; }
    static std::array<double, 3> taps(int shift, double offset);
    Eigen::Vector3d filtered(int x, int y) const;

    FrameFormat m_format;
    std::vector<Eigen::Vector3d> m_rgb;
};

FrameFormat testFormat(int width, int height, ChromaSiting siting = ChromaSiting::Left, int shiftX = 1,
                       int shiftY = 1);

} // namespace odo
