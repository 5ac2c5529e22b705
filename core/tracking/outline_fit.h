// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/region_moments.h"
#include "core/tracking/edge_profile.h"
#include "core/tracking/scan_lines.h"
#include "core/video/frame.h"

namespace odo {

/// The outline of a convex region at sub-pixel precision, luma pixels.
struct Outline
{
    std::vector<Eigen::Vector2d> points; ///< in order, clockwise on the screen
    std::vector<std::uint8_t> found;     ///< 1 where an edge was found, 0 where the hull stands in
    RegionMoments moments;
    Eigen::Matrix2d centreCovariance = Eigen::Matrix2d::Zero();
    double solidity = 1;  ///< share of its hull that the region fills
    double goodShare = 0; ///< of the scan lines that found a clear edge
};

/// What is known of the region beforehand.
struct OutlineHint
{
    Chroma colour = Chroma::Zero();                     ///< of the robot
    Eigen::Vector2d motionPx = Eigen::Vector2d::Zero(); ///< since the last frame: what moves is blurred
};

/// Finds the edge of a convex region on the full-resolution planes.
///
/// Scan lines run along the planes' own rows and columns, so that nothing is interpolated. On each the chroma
/// says where the edge is to a pixel, and then the luma where it must be for the samples about it to be the
/// sum of inside and outside. That is exact for a straight edge of any symmetric blur, so that neither motion
/// nor subsampling moves or widens the outline. The references are taken as close to the edge as the
/// picture's sharpness (measured as well, and followed) allows: an edge between two faces of the robot
/// farther in is not reached, and of a shadow at its foot only the slope matters, which is led on to the
/// edge. Where the luma has no contrast, or disagrees by more than a pixel and a half, the chroma's edge
/// stands. It is the worse one: blurred over three pixels, it puts the edge of a dark side narrower than that
/// too far in. Where the chroma's samples lie is told by how far its edges keep from the luma's, in all
/// outlines up to the present one. Lines whose edge strays from their neighbours' are put aside, and their
/// part of the outline is taken from the mask's hull, shifted as their neighbours were; likewise at corners
/// too narrow for a line. The covariance is that of the lines' scatter about their neighbours; codec noise,
/// of which neighbours share a part, counts by how much more lines two apart scatter than lines side by side.
class OutlineFit
{
public:
    /// False when the region is small or too few lines found an edge: then the outline is meaningless.
    bool fit(const Frame &frame, const ChromaGrid &grid, const RegionMask &mask, const OutlineHint &hint,
             Outline &outline);

private:
    struct Edge
    {
        float outward = 0; ///< from the line's start, luma pixels
        float lag = 0;     ///< luma's place less chroma's, along the line
        bool good = false, byLuma = false;
    };
    Edge locate(const Frame &frame, const ChromaGrid &grid, const ScanLine &line, const OutlineHint &hint);
    bool locateInLuma(const Frame &frame, const ScanLine &line, int lines, float motion, float &place);
    void putOutliersAside();
    void fillGaps(const std::vector<ScanLine> &lines);
    void gather(const ChromaGrid &grid, const std::vector<ScanLine> &lines, Outline &outline);
    double varianceOfEdges(const std::vector<ScanLine> &lines);

    /// How much wider an edge is than a sharp picture's, luma pixels.
    float blurBeyondSharp() const { return m_sharpness < 0.9f ? 4 * (0.9f - m_sharpness) : 0.0f; }
    static Eigen::Vector2d alongLine(const ScanLine &line);
    void learnLag(const std::vector<ScanLine> &lines);

    /// By how much the chroma planes must be shifted to lie on the luma plane: a sum of normal equations.
    Eigen::Matrix2d m_lagNormal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d m_lagRight = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_lag = Eigen::Vector2d::Zero(); ///< by which the chroma's places are corrected
    int m_lagFits = 0;
    ScanLines m_scanLines;
    std::vector<Edge> m_edges;
    float m_sharpness = 1; ///< share of the contrast that the closest references show
    float m_sharpnessSum = 0;
    int m_sharpnessCount = 0;
    std::vector<float> m_near, m_far; ///< scatter of the lines
};

} // namespace odo
