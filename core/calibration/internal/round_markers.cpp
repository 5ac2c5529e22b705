// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/round_markers.h"

#include "core/base/job_control.h"
#include "core/calibration/internal/image_edges.h"
#include "core/calibration/internal/luma_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace odo {

namespace {

using Eigen::Vector2d;
using Contour = std::vector<cv::Point>;

constexpr double leastSemiAxisPx = 2.5, flattest = 0.12;
constexpr double areaSlack = 0.16;                 // of a contour against its ellipse
constexpr double leastHole = 0.06, mostHole = 0.6; // area of a ring's hole, of the ring's
constexpr double speck = 0.03;                     // of the area: a smaller hole is a reflection
constexpr double offCentre = 0.2;                  // of the outer axis
constexpr double worstOutlineMisfit = 0.03, leastMisfitPx = 0.25; // of the longer axis
constexpr int darkerBy = 8;                                       // than the neighbourhood's mean

/// The ellipse with a contour's moments, if the contour fills it.
std::optional<EllipseOutline> roughOutline(const Contour &contour)
{
    if (contour.size() < 8)
        return std::nullopt;
    const cv::Moments m = cv::moments(contour);
    if (!(m.m00 > EIGEN_PI * leastSemiAxisPx * leastSemiAxisPx * 0.6))
        return std::nullopt;
    Eigen::Matrix2d spread;
    spread << m.mu20, m.mu11, m.mu11, m.mu02;
    spread /= m.m00;
    const double middle = 0.5 * spread.trace(),
                 off = std::sqrt(std::max(0.0, middle * middle - spread.determinant()));
    EllipseOutline outline{{m.m10 / m.m00, m.m01 / m.m00},
                           {2 * std::sqrt(middle + off), 2 * std::sqrt(std::max(0.0, middle - off))},
                           0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1))};
    // Contours run through the middles of the border's pixels: half a pixel within the shape's edge.
    if (std::abs(m.m00 / outline.area() - 1) > areaSlack)
        return std::nullopt;
    outline.semiAxes.array() += 0.5;
    if (outline.semiAxes.y() < leastSemiAxisPx || outline.semiAxes.y() < flattest * outline.semiAxes.x())
        return std::nullopt;
    return outline;
}

bool isEllipse(const EllipseEdge &edge)
{
    return edge.misfitPx < std::max(leastMisfitPx, worstOutlineMisfit * edge.outline.semiAxes.x()) &&
           edge.outline.semiAxes.y() >= leastSemiAxisPx - 1 &&
           edge.outline.semiAxes.y() > flattest * edge.outline.semiAxes.x();
}

std::optional<RoundMarker> dotOf(const cv::Mat &luma, const EllipseOutline &rough, double reachShare)
{
    const auto edge = fitEdge(luma, rough, reachShare, true);
    if (!edge || !isEllipse(*edge))
        return std::nullopt;
    return RoundMarker{RoundMarker::Kind::Dot, edge->outline.centre, edge->sigmaPx, edge->outline};
}

std::optional<RoundMarker> ringOf(const cv::Mat &luma, const EllipseOutline &rough,
                                  const EllipseOutline &roughHole)
{
    // Half the ring's width, so that no edge sees the other one; the hole is half as wide or so.
    const double share = roughHole.semiAxes.x() / rough.semiAxes.x();
    const auto outer = fitEdge(luma, rough, 0.5 * (1 - share), true);
    const auto inner = fitEdge(luma, roughHole, 0.5 * (1 / share - 1), false);
    if (!outer || !inner || !isEllipse(*outer) || !isEllipse(*inner))
        return std::nullopt;
    const double ratio = inner->outline.area() / outer->outline.area();
    if (ratio < leastHole || ratio > mostHole ||
        (inner->outline.centre - outer->outline.centre).norm() > offCentre * outer->outline.semiAxes.x())
        return std::nullopt;
    const Vector2d centre = (inner->outline.centre - ratio * outer->outline.centre) / (1 - ratio);
    const double sigma = std::hypot(inner->sigmaPx, ratio * outer->sigmaPx) / (1 - ratio);
    return RoundMarker{RoundMarker::Kind::Ring, centre, sigma, outer->outline};
}

/// Holes are about half a pixel larger than their contour in OpenCV, which traces the dark pixels around
/// them.
EllipseOutline shrunk(EllipseOutline outline)
{
    outline.semiAxes.array() -= 1;
    return outline;
}

EllipseOutline unscaled(EllipseOutline outline, double scale)
{
    outline.centre = {odo::unscaled(outline.centre.x(), scale), odo::unscaled(outline.centre.y(), scale)};
    outline.semiAxes /= scale;
    return outline;
}

/// dark: of the image at a scale.
void findIn(const cv::Mat &luma, const cv::Mat &dark, double scale, std::vector<RoundMarker> &found)
{
    std::vector<Contour> contours;
    std::vector<cv::Vec4i> tree; // next, previous, first child, parent
    cv::findContours(dark, contours, tree, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
    for (std::size_t i = 0; i < contours.size(); ++i) {
        if (tree[i][3] >= 0)
            continue;
        endIfCancelled();
        auto rough = roughOutline(contours[i]);
        if (!rough)
            continue;
        rough = unscaled(*rough, scale);
        int hole = -1;
        double largest = 0;
        for (int child = tree[i][2]; child >= 0; child = tree[static_cast<std::size_t>(child)][0]) {
            const double area = cv::contourArea(contours[static_cast<std::size_t>(child)]);
            if (area > largest) {
                largest = area;
                hole = child;
            }
        }
        std::optional<RoundMarker> marker;
        if (hole < 0 || largest / (scale * scale) < speck * rough->area())
            marker = dotOf(luma, *rough, 0.4);
        else if (const auto roughHole = roughOutline(contours[static_cast<std::size_t>(hole)]);
                 roughHole && roughHole->semiAxes.y() > 1.5)
            marker = ringOf(luma, *rough, unscaled(shrunk(*roughHole), scale));
        // A ring so small that its hole cannot be measured: its outer edge is that of a dot.
        if (!marker && hole >= 0)
            marker = dotOf(luma, *rough, 0.25);
        if (marker)
            found.push_back(*marker);
    }
}

/// Of shapes found at both thresholds the surer one stays; a ring before a dot.
std::vector<RoundMarker> withoutDoubles(std::vector<RoundMarker> found)
{
    std::ranges::sort(found, [](const RoundMarker &a, const RoundMarker &b) {
        return std::pair(a.kind, a.sigmaPx) < std::pair(b.kind, b.sigmaPx);
    });
    std::vector<RoundMarker> kept;
    for (const RoundMarker &marker : found) {
        const bool isDouble = std::ranges::any_of(kept, [&](const RoundMarker &other) {
            return (other.centrePx - marker.centrePx).norm() < 0.5 * other.outline.semiAxes.x();
        });
        if (!isDouble)
            kept.push_back(marker);
    }
    std::ranges::sort(kept, {}, [](const RoundMarker &marker) { return -marker.outline.area(); });
    return kept;
}

} // namespace

std::vector<RoundMarker> findRoundMarkers(const Frame &frame, std::optional<PixelRect> part)
{
    const cv::Mat whole = lumaMatrix(frame);
    const PixelRect all{0, 0, whole.cols, whole.rows};
    const PixelRect rect = part ? part->clipped(all) : all;
    if (rect.width() < 16 || rect.height() < 16)
        return {};
    const cv::Mat luma = whole(cv::Rect(rect.x0, rect.y0, rect.width(), rect.height()));
    const double scale = searchScale(luma);
    cv::Mat smooth, dark;
    cv::GaussianBlur(reduced(luma, scale), smooth, {3, 3}, 0);
    std::vector<RoundMarker> found;
    // A window narrower than a shape sees only its border, one much wider no gradient of the light.
    for (const int divisor : {36, 10}) {
        const int side =
            std::max(15, static_cast<int>(scale * std::max(whole.cols, whole.rows)) / divisor) | 1;
        cv::adaptiveThreshold(smooth, dark, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV, side,
                              darkerBy);
        findIn(luma, dark, scale, found);
    }
    for (RoundMarker &marker : found) {
        marker.centrePx += Vector2d(rect.x0, rect.y0);
        marker.outline.centre += Vector2d(rect.x0, rect.y0);
    }
    return withoutDoubles(std::move(found));
}

using Eigen::Vector2d;

std::optional<Vector2d> dotCentre(const EllipseOutline &outline, const FloorView &view)
{
    constexpr int corners = 48;
    std::array<Vector2d, corners> floor;
    for (int i = 0; i < corners; ++i) {
        const auto position = view.floorFromPixel(outline.pointAt(2 * EIGEN_PI * i / corners), 0);
        if (!position)
            return std::nullopt;
        floor[static_cast<std::size_t>(i)] = *position;
    }
    Vector2d sum = Vector2d::Zero();
    double area = 0;
    for (std::size_t i = 0; i < corners; ++i) {
        const Vector2d a = floor[i] - floor[0], b = floor[(i + 1) % corners] - floor[0];
        const double part = a.x() * b.y() - a.y() * b.x();
        area += part;
        sum += part * (a + b) / 3;
    }
    const Vector2d middle = floor[0] + sum / area;
    return view.pixelFromWorld({middle.x(), middle.y(), 0});
}

} // namespace odo
