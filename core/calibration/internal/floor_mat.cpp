// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_mat.h"

#include "core/base/units.h"
#include "core/calibration/internal/tag_detection.h"
#include "core/geometry/homography.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr std::size_t fewestTags = 4;
constexpr double farthestM = 0.08; // of a tag that belongs to it: less than half way to the next one

/// How the tags of one paper are numbered and where a sheet has them.
struct MatKind
{
    FloorMat::Paper paper;
    const char *name;
    Vector2d sheetM;
    int firstTag, tagsPerSheet;
    double firstTagX, nextTagX, tagY; ///< metres, of the middles
};

const std::array<MatKind, 3> kinds{{
    {FloorMat::Paper::A4, "A4", {0.2770, 0.1900}, 100, 1, 0.1585, 0, 0.100},
    {FloorMat::Paper::Letter, "Letter", {0.2594, 0.1959}, 180, 1, 0.1594, 0, 0.105},
    {FloorMat::Paper::A3, "A3", {0.4000, 0.2770}, 260, 2, 0.1000, 0.2, 0.150},
}};

const MatKind &kindOf(FloorMat::Paper paper)
{
    return kinds[static_cast<std::size_t>(paper)];
}

/// A position of a sheet as one of the whole mat.
Vector2d onMat(const MatKind &kind, int column, int row, const Vector2d &onSheet)
{
    return onSheet + Vector2d(column * kind.sheetM.x(), row * kind.sheetM.y());
}

/// A tag of a mat, and where it should be.
struct MatPoint
{
    int column, row;
    Eigen::Matrix3d pixelFromTag;
    Vector2d pixel, pointInMat;
};

/// nullopt: a tag of something else.
std::optional<MatPoint> pointOf(const MatKind &kind, const SeenTag &tag)
{
    const int index = tag.number - kind.firstTag, sheet = index / kind.tagsPerSheet;
    if (index < 0 || sheet >= FloorMat::mostColumns * FloorMat::mostRows)
        return std::nullopt;
    const int column = sheet % FloorMat::mostColumns, row = sheet / FloorMat::mostColumns;
    const MatTag place =
        matTags(kind.paper, column, row)[static_cast<std::size_t>(index % kind.tagsPerSheet)];
    return MatPoint{column, row, tag.pixelFromTag, tag.pixel, onMat(kind, column, row, place.middle)};
}

/// Mean side of its square on the mat, in metres; nullopt: part of it is beyond the horizon.
std::optional<double> sideM(const MatPoint &point, const Homography &matFromPixel)
{
    double around = 0;
    const Eigen::Matrix<double, 2, 4> corners{{-1, 1, 1, -1}, {-1, -1, 1, 1}};
    const auto corner = [&](int i) {
        return matFromPixel.map((point.pixelFromTag * corners.col(i % 4).homogeneous()).hnormalized());
    };
    for (int i = 0; i < 4; ++i) {
        const auto from = corner(i), to = corner(i + 1);
        if (!from || !to)
            return std::nullopt;
        around += (*to - *from).norm();
    }
    return around / 4;
}

/// How far a tag is from what the mat has there, in metres.
double misfitM(const MatPoint &point, const Homography &matFromPixel)
{
    const auto at = matFromPixel.map(point.pixel);
    const auto side = sideM(point, matFromPixel);
    if (!at || !side)
        return std::numeric_limits<double>::infinity();
    return std::max((*at - point.pointInMat).norm(), 2 * std::abs(*side - matTagM));
}

/// A pixel on the mat, in metres, as one tag alone shows it; far from that tag it is rough.
std::optional<Vector2d> byTag(const MatPoint &tag, const Vector2d &pixel)
{
    const Eigen::Matrix3d tagFromPixel = tag.pixelFromTag.inverse();
    const Eigen::Vector3d inTag = tagFromPixel * pixel.homogeneous();
    if (!(inTag.z() * (tagFromPixel * tag.pixel.homogeneous()).z() > 0)) // beyond the horizon
        return std::nullopt;
    const Vector2d fromMiddle = 0.5 * matTagM * inTag.hnormalized();
    return tag.pointInMat + Vector2d(fromMiddle.x(), -fromMiddle.y()); // a print's y goes down
}

/// The most of them that are where one tag has them.
std::vector<MatPoint> aroundOneTag(const std::vector<MatPoint> &points)
{
    constexpr double allowed = 0.15, leastM = 0.001; // of the distance
    std::vector<MatPoint> best;
    for (const MatPoint &tag : points) {
        std::vector<MatPoint> near;
        std::ranges::copy_if(points, std::back_inserter(near), [&](const MatPoint &point) {
            const auto at = byTag(tag, point.pixel);
            const double distance = (point.pointInMat - tag.pointInMat).norm();
            return at && (*at - point.pointInMat).norm() <= allowed * distance + leastM;
        });
        if (near.size() > best.size())
            best = std::move(near);
    }
    return best;
}

/// Without those that do not fit all others; empty where no four of them fit.
std::vector<MatPoint> fitting(std::vector<MatPoint> points)
{
    while (points.size() >= fewestTags) {
        std::vector<PointPair> pairs;
        for (const MatPoint &point : points)
            pairs.push_back({point.pixel, point.pointInMat, {}});
        const auto matFromPixel = Homography::estimate(pairs);
        const auto off = [&](const MatPoint &point) {
            return matFromPixel ? misfitM(point, *matFromPixel) : std::numeric_limits<double>::infinity();
        };
        const auto worst = std::ranges::max_element(points, {}, off);
        if (off(*worst) <= farthestM)
            return points;
        points.erase(worst);
    }
    return {};
}

} // namespace

Vector2d matSheetM(FloorMat::Paper paper)
{
    return kindOf(paper).sheetM;
}

double matLineM(const FloorMat &mat)
{
    return mat.columns * matSheetM(mat.paper).x() > matLinesM[0] + matLineStartM.x() ? matLinesM[0]
                                                                                     : matLinesM[1];
}

std::vector<MatTag> matTags(FloorMat::Paper paper, int column, int row)
{
    const MatKind &kind = kindOf(paper);
    const int sheet = row * FloorMat::mostColumns + column;
    std::vector<MatTag> tags;
    for (int i = 0; i < kind.tagsPerSheet; ++i)
        tags.push_back(
            {kind.firstTag + sheet * kind.tagsPerSheet + i, {kind.firstTagX + i * kind.nextTagX, kind.tagY}});
    return tags;
}

MarkerLayout matLayout(const FloorMat &mat)
{
    MarkerLayout layout{matName(mat), {}};
    const MatKind &kind = kindOf(mat.paper);
    for (int row = 0; row < mat.rows; ++row) {
        for (int column = 0; column < mat.columns; ++column) {
            for (const MatTag &tag : matTags(mat.paper, column, row))
                layout.markers.push_back(
                    {std::to_string(tag.number), mat.scale * onMat(kind, column, row, tag.middle)});
        }
    }
    return layout;
}

std::string matName(const FloorMat &mat)
{
    std::string name = std::string("Mat ") + kindOf(mat.paper).name + ' ' + std::to_string(mat.columns) +
                       'x' + std::to_string(mat.rows);
    if (mat.scale != 1)
        name += ", " + formatNumber(100 * mat.scale, 2) + " %";
    return name;
}

namespace {

std::optional<FloorMat> matOf(const std::vector<SeenTag> &tags)
{
    std::optional<FloorMat> found;
    std::size_t most = 0;
    for (const MatKind &kind : kinds) {
        std::vector<MatPoint> points;
        for (const SeenTag &tag : tags) {
            if (const auto point = pointOf(kind, tag))
                points.push_back(*point);
        }
        points = fitting(aroundOneTag(points));
        if (points.size() <= most)
            continue;
        most = points.size();
        found = FloorMat{kind.paper, std::ranges::max_element(points, {}, &MatPoint::column)->column + 1,
                         std::ranges::max_element(points, {}, &MatPoint::row)->row + 1, 1};
    }
    return found;
}

} // namespace

std::optional<FloorMat> findMat(const Frame &frame)
{
    const auto mat = matOf(findTags(frame));
    return mat ? mat : matOf(findSmallTags(frame));
}

std::optional<FloorMat> joined(const FloorMat &one, const FloorMat &other)
{
    if (one.paper != other.paper)
        return std::nullopt;
    return FloorMat{one.paper, std::max(one.columns, other.columns), std::max(one.rows, other.rows),
                    one.scale};
}

} // namespace odo
