// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"
#include "core/video/frame.h"

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

namespace odo {

/// Red, green, blue in 0..255 and unused; a colour of the sensor's linear range.
using Rgb = Eigen::Array4f;

inline Rgb toRgb(const RgbColour &colour)
{
    return {static_cast<float>(colour.red), static_cast<float>(colour.green), static_cast<float>(colour.blue),
            0.f};
}

/// Full-resolution colour of a part of a frame.
class RgbImage
{
public:
    explicit RgbImage(const PixelRect &rect)
        : m_rect(rect),
          m_pixels(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()))
    {
    }

    const PixelRect &rect() const { return m_rect; }
    /// The pixels of row y of the whole frame, from rect().x0 on.
    Rgb *row(int y) { return m_pixels.data() + static_cast<std::ptrdiff_t>(y - m_rect.y0) * m_rect.width(); }
    const Rgb *row(int y) const
    {
        return m_pixels.data() + static_cast<std::ptrdiff_t>(y - m_rect.y0) * m_rect.width();
    }
    /// A copy of a part, which must lie inside.
    RgbImage part(const PixelRect &rect) const
    {
        RgbImage copy(rect);
        for (int y = rect.y0; y < rect.y1; ++y)
            std::copy_n(row(y) + (rect.x0 - m_rect.x0), rect.width(), copy.row(y));
        return copy;
    }

private:
    PixelRect m_rect;
    std::vector<Rgb> m_pixels;
};

/// The exact share of every pixel that polygons cover, each with a colour. Polygons of one layer add up: they
/// must not overlap (the faces of a body, the cells of a tag), or share the time (the sub-steps of an
/// exposure, each with a weight), so that seams between neighbours and blurred edges come out exactly.
///
/// Signed-area accumulation: each edge writes the change that it makes to the coverage of the pixels on its
/// row, and one running sum a row gives the coverage of all polygons at once (the method of FreeType's smooth
/// rasteriser and of font-rs). A pixel is the square of side 1 about its centre.
class PolygonLayer
{
public:
    explicit PolygonLayer(const PixelRect &rect);

    /// Adds a closed polygon, in luma pixels, in either orientation; parts outside the rectangle are cut off.
    void add(std::span<const Eigen::Vector2d> outline, const Rgb &colour, double weight = 1.0);
    /// Paints the layer over a frame. The layer is used up by it.
    void paintOver(RgbImage &image);

private:
    void addEdge(Eigen::Vector2d from, Eigen::Vector2d to, const Rgb &premultiplied);
    void addSpan(Rgb *row, double xa, double xb, double cover, const Rgb &premultiplied) const;

    PixelRect m_rect;
    int m_stride;
    std::vector<Rgb> m_changes; ///< premultiplied colour and, fourth, coverage
};

/// Turns flat polygons in space into their outlines in the frame: cut to what the camera can see, and with
/// the edges divided finely enough to follow the lens distortion to a thousandth of a pixel. Immutable.
class ImageOutline
{
public:
    ImageOutline(CameraModel camera, RigidTransform cameraFromSource);

    /// Outline in luma pixels of a convex polygon (points in the source frame, metres); empty where it is out
    /// of sight.
    std::vector<Eigen::Vector2d> of(std::span<const Eigen::Vector3d> polygon) const;

    PixelRect imageRect() const;

private:
    std::vector<Eigen::Vector3d> clipped(std::vector<Eigen::Vector3d> polygon) const;

    CameraModel m_camera;
    RigidTransform m_cameraFromSource;
    std::vector<Eigen::Vector3d> m_inward; ///< of the planes through the camera that bound what it sees
};

/// The smallest rectangle of whole pixels that an outline touches.
PixelRect boundsOf(std::span<const Eigen::Vector2d> outline);

/// A convex polygon in a plane, corners anticlockwise.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// Positive where the corners run anticlockwise; of any polygon.
double signedArea(std::span<const Eigen::Vector2d> polygon);

/// What of a polygon lies outside another one, in convex pieces that meet at their edges only.
std::vector<ConvexPolygon> outsideOf(const ConvexPolygon &hole, const ConvexPolygon &polygon);

} // namespace odo
