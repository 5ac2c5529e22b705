// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/homography.h"

#include "core/geometry/least_squares.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace odo {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double leastDeterminant = 1e-12; // of a matrix of unit norm; metres to far pixels come to 1e-9

tl::unexpected<Error> noHomography(Message why, Message advice, ErrorCode code = ErrorCode::Undetermined)
{
    return fail(code, ODO_TEXT("geometry.no_homography", "no homography"), std::move(why), std::move(advice));
}

Message nameOf(std::span<const PointPair> pairs, int index)
{
    const std::string &label = pairs[static_cast<std::size_t>(index)].label;
    return label.empty() ? ODO_TEXT("geometry.point", "point %1")(index + 1)
                         : nameAlone(Named::marker(label));
}

MessageArgument namesOf(std::span<const PointPair> pairs, std::span<const int> indices)
{
    std::vector<Message> names;
    for (const int index : indices)
        names.push_back(nameOf(pairs, index));
    return listed(std::move(names));
}

/// Moves the points' centroid to the origin and their mean distance to √2 (Hartley 1997).
Matrix3d normalisation(const std::vector<Vector2d> &points)
{
    const auto count = static_cast<double>(points.size());
    Vector2d centroid = Vector2d::Zero();
    for (const Vector2d &point : points)
        centroid += point / count;
    double distance = 0;
    for (const Vector2d &point : points)
        distance += (point - centroid).norm() / count;
    const double scale = std::numbers::sqrt2 / distance;
    Matrix3d matrix;
    matrix << scale, 0, -scale * centroid.x(), 0, scale, -scale * centroid.y(), 0, 0, 1;
    return matrix;
}

Matrix3d directLinearTransform(const std::vector<Vector2d> &sources, const std::vector<Vector2d> &targets)
{
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(2 * sources.size()), 9);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Eigen::RowVector3d source = sources[i].homogeneous().transpose();
        const auto row = static_cast<Eigen::Index>(2 * i);
        rows.block<1, 3>(row, 0) = source;
        rows.block<1, 3>(row, 6) = -targets[i].x() * source;
        rows.block<1, 3>(row + 1, 3) = source;
        rows.block<1, 3>(row + 1, 6) = -targets[i].y() * source;
    }
    const Eigen::Matrix<double, 9, 9> normal = rows.transpose() * rows;
    // The normal matrix would square the condition; with as few rows as this the SVD itself is cheap.
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows.rows() > 200 ? Eigen::MatrixXd(normal) : rows,
                                                Eigen::ComputeFullV);
    const Eigen::Matrix<double, 9, 1> h = svd.matrixV().col(8);
    Matrix3d matrix;
    matrix << h.segment<3>(0).transpose(), h.segment<3>(3).transpose(), h.segment<3>(6).transpose();
    return matrix;
}

Matrix3d refine(const Matrix3d &start, const std::vector<Vector2d> &sources,
                const std::vector<Vector2d> &targets)
{
    LeastSquaresProblem<Matrix3d> problem;
    problem.evaluate = [&](const Matrix3d &h, Eigen::VectorXd &residuals, Eigen::MatrixXd *byStep) {
        residuals.resize(static_cast<Eigen::Index>(2 * sources.size()));
        if (byStep)
            byStep->setZero(residuals.size(), 9);
        for (std::size_t i = 0; i < sources.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(2 * i);
            const Vector3d source = sources[i].homogeneous();
            const Vector3d mapped = h * source;
            if (!(mapped.z() > 0))
                return false;
            const Vector2d target = mapped.hnormalized();
            residuals.segment<2>(row) = target - targets[i];
            if (!byStep)
                continue;
            byStep->block<1, 3>(row, 0) = source.transpose() / mapped.z();
            byStep->block<1, 3>(row + 1, 3) = source.transpose() / mapped.z();
            byStep->block<2, 3>(row, 6) = -target * source.transpose() / mapped.z();
        }
        return true;
    };
    problem.move = [](const Matrix3d &h, const Eigen::VectorXd &step) {
        Matrix3d moved = h;
        for (int row = 0; row < 3; ++row)
            moved.row(row) += step.segment<3>(3 * row).transpose();
        return Matrix3d(moved / moved.norm());
    };
    return minimise(problem, start);
}

Result<void> checkPoints(std::span<const PointPair> pairs, const std::vector<Vector2d> &sources,
                         const std::vector<Vector2d> &targets)
{
    if (pairs.size() < 4)
        return noHomography(
            ODO_TEXT("geometry.four_points_needed", "four points are needed, %1 given")(pairs.size()),
            ODO_TEXT("geometry.add_points", "add points"));
    for (int i = 0; i < static_cast<int>(pairs.size()); ++i) {
        if (!pairs[static_cast<std::size_t>(i)].source.allFinite() ||
            !pairs[static_cast<std::size_t>(i)].target.allFinite())
            return noHomography(ODO_TEXT("geometry.coordinate_not_finite",
                                         "a coordinate of %1 is not a finite number")(nameOf(pairs, i)),
                                ODO_TEXT("geometry.correct_it", "correct it"), ErrorCode::InvalidInput);
    }
    for (const auto *points : {&sources, &targets}) {
        if (const auto twice = coincidentPoints(*points))
            return noHomography(
                points == &sources
                    ? ODO_TEXT("geometry.at_one_place", "%1 have the same position")(namesOf(pairs, *twice))
                    : ODO_TEXT("geometry.at_one_place_in_picture",
                               "%1 have the same position in the image")(namesOf(pairs, *twice)),
                ODO_TEXT("geometry.correct_one", "correct one of them"));
    }
    for (const auto *points : {&sources, &targets}) {
        const double least = points == &sources ? 0.01 : 0.003;
        const Spread spread = widestQuadrilateral(*points, least);
        if (spread.flatness < least)
            return noHomography(
                points == &sources
                    ? ODO_TEXT("geometry.on_one_line", "%1 lie on one line")(namesOf(pairs, spread.flattest))
                    : ODO_TEXT("geometry.on_one_line_in_picture",
                               "%1 lie on one line in the image")(namesOf(pairs, spread.flattest)),
                ODO_TEXT("geometry.use_four_points", "use four points of which no three are in line"));
    }
    return {};
}

} // namespace

Homography::Homography(const Matrix3d &targetFromSource)
    : m_matrix(targetFromSource / targetFromSource.norm())
{
}

Result<Homography> Homography::estimate(std::span<const PointPair> pairs)
{
    std::vector<Vector2d> sources, targets;
    for (const PointPair &pair : pairs) {
        sources.push_back(pair.source);
        targets.push_back(pair.target);
    }
    ODO_TRY(checkPoints(pairs, sources, targets));
    const Matrix3d sourceScale = normalisation(sources), targetScale = normalisation(targets);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        sources[i] = (sourceScale * sources[i].homogeneous()).hnormalized();
        targets[i] = (targetScale * targets[i].homogeneous()).hnormalized();
    }
    Matrix3d matrix = directLinearTransform(sources, targets);
    // All points must lie on one side of the horizon; the third coordinate says on which side each lies.
    std::vector<int> before, beyond;
    for (int i = 0; i < static_cast<int>(sources.size()); ++i)
        (matrix.row(2).dot(sources[static_cast<std::size_t>(i)].homogeneous()) > 0 ? before : beyond)
            .push_back(i);
    if (!before.empty() && !beyond.empty())
        return noHomography(
            joined({ODO_TEXT("geometry.beyond_horizon", "%1 would be beyond the horizon")(
                        namesOf(pairs, before.size() < beyond.size() ? before : beyond)),
                    ODO_TEXT("geometry.bow_tie", "the order of the points crosses over like a bow tie")},
                   Join::Colon),
            ODO_TEXT("geometry.check_points", "check which point is which"));
    if (before.empty())
        matrix = -matrix;
    matrix = targetScale.inverse() * refine(matrix, sources, targets) * sourceScale;
    if (!matrix.allFinite() || !(std::abs((matrix / matrix.norm()).determinant()) > 0))
        return noHomography(ODO_TEXT("geometry.points_do_not_tell", "the points do not determine it"),
                            ODO_TEXT("geometry.spread_points", "spread the points"));
    return Homography(matrix);
}

std::optional<Vector2d> Homography::map(const Vector2d &source) const
{
    const Vector3d mapped = m_matrix * source.homogeneous();
    // Relative to the parts it is summed from: beneath that the sign is rounding noise.
    const double scale = m_matrix.row(2).cwiseAbs() * source.homogeneous().cwiseAbs();
    if (!(mapped.z() > 1e-12 * scale))
        return std::nullopt;
    return Vector2d(mapped.hnormalized());
}

Homography Homography::inverse() const
{
    return Homography(m_matrix.inverse());
}

Homography Homography::operator*(const Homography &middleFromSource) const
{
    return Homography(m_matrix * middleFromSource.m_matrix);
}

Result<Homography> Homography::chain(std::span<const Homography> links)
{
    if (links.empty())
        return noHomography(ODO_TEXT("geometry.empty_chain", "the chain has no links"),
                            ODO_TEXT("geometry.give_one_link", "give at least one"));
    Homography whole(Matrix3d::Identity());
    for (std::size_t i = 0; i < links.size(); ++i) {
        // Written so that a determinant that is not a number is refused too.
        if (!(std::abs(links[i].m_matrix.determinant()) > leastDeterminant))
            return noHomography(ODO_TEXT("geometry.singular_link",
                                         "link %1 of %2 of the chain is singular")(i + 1, links.size()),
                                ODO_TEXT("geometry.use_four_points_in_it",
                                         "use four points in it of which no three are in line"));
        whole = links[i] * whole;
    }
    return whole;
}

namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

constexpr std::size_t triedPoints = 16; // 1820 quadrilaterals

double heightOfTriangle(const Vector2d &a, const Vector2d &b, const Vector2d &c)
{
    const Vector2d ab = b - a, ac = c - a;
    const double area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
    const double longest = std::max({ab.norm(), ac.norm(), (c - b).norm()});
    return longest > 0 ? area / longest : 0;
}

std::vector<int> candidates(const Points &points)
{
    std::vector<int> chosen(points.size());
    std::iota(chosen.begin(), chosen.end(), 0);
    if (points.size() <= triedPoints)
        return chosen;
    chosen.clear();
    for (int i = 0; i < 8; ++i) {
        const double angle = i * std::numbers::pi / 4;
        const Vector2d direction(std::cos(angle), std::sin(angle));
        const auto farthest =
            std::ranges::max_element(points, {}, [&](const Vector2d &point) { return point.dot(direction); });
        chosen.push_back(static_cast<int>(farthest - points.begin()));
        chosen.push_back(static_cast<int>(points.size() * static_cast<std::size_t>(i) / 8));
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

/// The flattest of the four triangles of four points.
Spread spreadOf(const Points &points, const std::array<int, 4> &four)
{
    Spread spread{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t left = 0; left < 4; ++left) {
        std::array<int, 3> three{};
        std::copy_if(four.begin(), four.end(), three.begin(), [&](int i) { return i != four[left]; });
        const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(three[i])]; };
        const double height = heightOfTriangle(at(0), at(1), at(2));
        if (height < spread.flatness)
            spread = {height, three};
    }
    return spread;
}

} // namespace

double extentOf(const Points &points)
{
    if (points.empty())
        return 0;
    Vector2d low = points.front(), high = points.front();
    for (const Vector2d &point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return (high - low).norm();
}

std::optional<std::array<int, 2>> coincidentPoints(const Points &points)
{
    const double least = 1e-4 * extentOf(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            if ((points[i] - points[j]).norm() <= least)
                return std::array{static_cast<int>(i), static_cast<int>(j)};
        }
    }
    return std::nullopt;
}

Spread widestQuadrilateral(const Points &points, double enough)
{
    const std::vector<int> chosen = candidates(points);
    const double extent = extentOf(points);
    Spread widest{-1, {}};
    for (std::size_t a = 0; a < chosen.size() && !(widest.flatness >= enough * extent); ++a) {
        for (std::size_t b = a + 1; b < chosen.size(); ++b) {
            for (std::size_t c = b + 1; c < chosen.size(); ++c) {
                for (std::size_t d = c + 1; d < chosen.size(); ++d) {
                    const Spread spread = spreadOf(points, {chosen[a], chosen[b], chosen[c], chosen[d]});
                    if (spread.flatness > widest.flatness)
                        widest = spread;
                }
            }
        }
    }
    widest.flatness = extent > 0 ? widest.flatness / extent : 0;
    return widest;
}

} // namespace odo
