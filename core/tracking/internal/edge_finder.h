// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/scan_lines.h"

namespace odo {

/// What is known of a region before its edge is searched.
struct OutlineHint
{
    Chroma colour = Chroma::Zero();                     ///< of the robot
    Eigen::Vector2d motionPx = Eigen::Vector2d::Zero(); ///< since the last frame: what moves is blurred
};

/// Where a scan line crosses the edge of a region.
struct LineEdge
{
    float outward = 0; ///< from the line's start, luma pixels
    float lag = 0;     ///< luma's position minus chroma's, along the line; 0 without luma's
    bool good = false, byLuma = false;
};

/// Finds where scan lines cross the edge of a region on the full-resolution planes, so that nothing is
/// interpolated. On each line the chroma says where the edge is to a pixel, and then the luma where it must
/// be for the samples about it to be the sum of inside and outside. That is exact for a straight edge of any
/// symmetric blur, so that neither motion nor subsampling moves or widens the outline. The references are as
/// close to the edge as the image's sharpness (measured as well, and followed) allows: an edge between two
/// faces of the robot farther in is not reached, and of a shadow at its foot only the slope matters, which is
/// led on to the edge. Where the luma has no contrast, or disagrees by more than a pixel and a half, the
/// chroma's edge counts.
class EdgeFinder
{
public:
    /// For the lines of one region of one frame, which must outlive their search. `lagPx`: by which the
    /// chroma's positions are corrected.
    void begin(const Frame &frame, const ChromaGrid &grid, const OutlineHint &hint,
               const Eigen::Vector2d &lagPx);
    /// Of `count` lines, at most EdgeProfiles::lines: so many at once cost hardly more than one.
    void find(const ScanLine *lines, int count, LineEdge *edges);
    /// After the lines of a region that is a robot: follows the image's sharpness.
    void learnSharpness();

private:
    /// A plane as lines of one direction go through it.
    struct LinedPlane
    {
        const std::uint8_t *data = nullptr;
        std::ptrdiff_t along = 1, across = 1; ///< bytes from sample to sample, and from line to line

        LinedPlane() = default;
        LinedPlane(const PlaneView &plane, bool alongX);
        const std::uint8_t *at(int line, int sample) const { return data + line * across + sample * along; }
    };
    /// All that is the same for lines along rows, or along columns.
    struct Direction
    {
        LinedPlane u, v, y;
        int samples = 0, lumaSamples = 0; ///< on a line
        int lumaLines = 0;                ///< of the plane
        int spacing = 1, pitch = 1;       ///< luma pixels from chroma sample to sample, and from line to line
        float offset = 0, shift = 0; ///< of the chroma, along, and across from the middle of its luma lines
        float lagAlong = 0, lagAcross = 0;
        float motionAlong = 0, motionAcross = 0;
    };
    static Direction directionOf(const Frame &frame, const ChromaGrid &grid, const OutlineHint &hint,
                                 const Eigen::Vector2d &lagPx, bool alongX);
    /// Four lines at once; the last one again and again where there are fewer.
    struct Lines
    {
        std::array<const ScanLine *, EdgeProfiles::lines> line;
        std::array<const Direction *, EdgeProfiles::lines> direction;
        Float4 start, inward, slope, margin;

        template <class Function>
        Float4 each(Function of) const
        {
            return Float4{of(*line[0], *direction[0]), of(*line[1], *direction[1]),
                          of(*line[2], *direction[2]), of(*line[3], *direction[3])};
        }
    };
    Lines gather(const ScanLine *lines, int count) const;
    Int4 findInChroma(const Lines &lines, Float4 &positions) const;
    Int4 findInLuma(const Lines &lines, Float4 &positions);
    void measureSharpness(const EdgeProfiles &luma, const Lines &lines, Float4 positions, Int4 wanted);

    Direction m_rows, m_columns;
    int m_colourU = 0, m_colourV = 0; ///< the robot's, of length colourLength
    float m_sharpness = 1;            ///< share of the contrast that the closest references show
    float m_blur = 0;                 ///< luma pixels of margin for the image's own blur
    int m_lumaCount = 0;              ///< samples of the luma that are read on a line
    float m_sharpnessSum = 0;
    int m_sharpnessCount = 0;
    int m_searches = 0; ///< of four lines each
};

} // namespace odo
