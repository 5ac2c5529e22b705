// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/residual_pattern.h"

#include "core/calibration/internal/marker_pairs.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/intrinsics_influence.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace odo {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr std::size_t leastOfKnownLens = 8, leastOfEstimatedLens = 12;
constexpr std::size_t leastForOneMarker = 6; // where the lens is known
constexpr double believedOfMarker = 4;       // residuals more, as large as usualMarkSigmaPx
constexpr double beyondChance = 4;           // σ: 1 in 30,000
constexpr double beyondChanceOfMany = 4.8;   // of all markers the worst: 1 in a million each
constexpr double alikeBeyondChance = 3.5;
constexpr double leastShiftPx = 0.3; // of the markers that a cause shifts: less is in the floor's σ
constexpr double smoothPx = 0.4;     // neighbours that err alike by less are in the floor's σ
constexpr double leastFreedom = 3;

/// How much of the residuals a cause explains.
struct Explanation
{
    double clearness = 0;   ///< σ beyond chance
    double explainedPx = 0; ///< RMS over the markers
    double information = 0; ///< Schwarz's criterion: the smaller, the better it explains with as few numbers
    VectorXd size;          ///< of what it frees
};

using Factors = Eigen::CompleteOrthogonalDecomposition<MatrixXd>;

class Residuals
{
public:
    /// base: the derivatives by what the fit determined.
    Residuals(VectorXd off, MatrixXd base) : m_off(std::move(off)), m_base(std::move(base))
    {
        const Factors factors(m_base);
        m_rank = factors.rank();
        m_left = m_off - m_base * factors.solve(m_off);
    }

    const VectorXd &left() const { return m_left; }

    /// columns: the derivatives by what a cause frees. believed: how many residuals of a marker's usual σ
    /// count with those that are left. nullopt where they add nothing.
    std::optional<Explanation> test(const MatrixXd &columns, double believed) const
    {
        MatrixXd all(m_base.rows(), m_base.cols() + columns.cols());
        all << m_base, columns;
        const VectorXd norms = all.colwise().norm().cwiseMax(1e-300).transpose();
        const Factors factors(all * norms.cwiseInverse().asDiagonal());
        const double by = double(factors.rank() - m_rank);
        const double freedom = double(m_off.size() - factors.rank());
        if (by < 1 || freedom < leastFreedom)
            return std::nullopt;
        const VectorXd solution = factors.solve(m_off).cwiseQuotient(norms);
        const double after = (m_off - all * solution).squaredNorm();
        const double explained = std::max(0.0, m_left.squaredNorm() - after);
        const double counted = freedom + believed,
                     variance = (after + believed * usualMarkSigmaPx * usualMarkSigmaPx) / counted;
        const double ratio = (explained / by) / std::max(variance, 1e-12);
        return Explanation{normalTail(ratio, by, counted), std::sqrt(2 * explained / double(m_off.size())),
                           m_off.size() * std::log(std::max(after, 1e-12)) +
                               by * std::log(double(m_off.size())),
                           solution.tail(columns.cols())};
    }

private:
    /// Of an F-distributed ratio.
    static double normalTail(double ratio, double by, double freedom)
    {
        const double root = std::cbrt(ratio), a = 2 / (9 * by), b = 2 / (9 * freedom);
        return ((1 - b) * root - (1 - a)) / std::sqrt(b * root * root + a);
    }

    VectorXd m_off, m_left;
    MatrixXd m_base;
    Index m_rank;
};

/// Derivative of the markers' pixels by their floor positions along directions that change with the position.
template <class Direction>
VectorXd byPositions(std::span<const PointPair> pairs, const FloorView &view, Direction direction)
{
    VectorXd column(Index(2 * pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Vector2d &at = pairs[i].source;
        Eigen::Matrix<double, 2, 3> byWorld = Eigen::Matrix<double, 2, 3>::Zero();
        view.pixelFromWorld({at.x(), at.y(), 0}, byWorld);
        column.segment<2>(Index(2 * i)) = byWorld.leftCols<2>() * direction(at);
    }
    return column;
}

VectorXd residualsOf(std::span<const PointPair> pairs, const FloorView &view)
{
    VectorXd off = VectorXd::Zero(Index(2 * pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (const auto pixel = view.pixelFromWorld({pairs[i].source.x(), pairs[i].source.y(), 0}))
            off.segment<2>(Index(2 * i)) = pairs[i].target - *pixel;
    }
    return off;
}

/// How alike the residuals of nearest neighbours are: σ beyond chance.
double alikeness(std::span<const PointPair> pairs, const VectorXd &off)
{
    double sum = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        std::size_t nearest = i == 0 ? 1 : 0;
        for (std::size_t j = 0; j < pairs.size(); ++j) {
            if (j != i && (pairs[j].source - pairs[i].source).squaredNorm() <
                              (pairs[nearest].source - pairs[i].source).squaredNorm())
                nearest = j;
        }
        sum += off.segment<2>(Index(2 * i)).dot(off.segment<2>(Index(2 * nearest)));
    }
    return sum / std::max(off.squaredNorm(), 1e-12) * std::sqrt(double(pairs.size()));
}

Message lensSentence(double explainedPx)
{
    return ODO_TEXT("calibration.pattern_lens",
                    "The residuals follow the lens: %1 of them disappear with another focal length and "
                    "distortion; calibrate the lens again, at the zoom and focus that it records with.")(
        quantity(explainedPx, 1, "px"));
}

Message layoutSentence(const VectorXd &size)
{
    return ODO_TEXT(
        "calibration.pattern_layout",
        "The residuals follow the layout: they disappear with X longer than Y by %1 % and the axes "
        "%2° off the right angle; measure both sides and both diagonals of the layout again.")(
        quantity(100 * size(0), 2), quantity(size(1) * 180 / EIGEN_PI, 2));
}

Message markerSentence(const std::string &label, double offM)
{
    return ODO_TEXT("calibration.pattern_marker",
                    "Marker %1 is %2 from where the others expect it: measure and mark it again.")(
        Named::marker(label), millimetres(offM));
}

Message alikeSentence(double rmsPx)
{
    return ODO_TEXT(
        "calibration.pattern_alike",
        "Neighbouring markers err alike, by %1 RMS: check that the floor is flat, and calibrate the "
        "lens at the zoom and focus that it records with.")(quantity(rmsPx, 1, "px"));
}

/// The focal length, the principal point and the first two coefficients of the distortion.
MatrixXd lensColumns(const CameraModel &camera, const MatrixXd &byIntrinsics)
{
    const Intrinsics &lens = camera.intrinsics();
    const Index coefficients = std::min<Index>(2, Index(lens.distortion.size()));
    MatrixXd columns(byIntrinsics.rows(), 3 + coefficients);
    columns << lens.fxPx * byIntrinsics.col(0) + lens.fyPx * byIntrinsics.col(1),
        byIntrinsics.middleCols(2, 2 + coefficients);
    return columns;
}

class PatternSearch
{
public:
    PatternSearch(std::span<const PointPair> pairs, const FloorView &view, const MarkerDerivatives &slopes,
                  bool intrinsicsKnown)
        : m_pairs(pairs), m_view(view), m_residuals(residualsOf(pairs, view), baseOf(slopes, intrinsicsKnown))
    {
        tryEachMarker();
        if (pairs.size() < leastOfKnownLens)
            return;
        tryLayout();
        if (intrinsicsKnown)
            consider(lensColumns(view.camera(), slopes.byIntrinsics), beyondChance, double(pairs.size()),
                     [](const Explanation &cause) {
                         return ResidualJudgement{ResidualPattern::Intrinsics, false,
                                                  lensSentence(cause.explainedPx)};
                     });
        if (!m_best)
            tryNeighbours();
    }

    ResidualJudgement judgement() const { return m_judgement; }

private:
    static MatrixXd baseOf(const MarkerDerivatives &slopes, bool intrinsicsKnown)
    {
        if (intrinsicsKnown)
            return slopes.byPose;
        MatrixXd base(slopes.byPose.rows(), slopes.byPose.cols() + slopes.byIntrinsics.cols());
        base << slopes.byPose, slopes.byIntrinsics;
        return base;
    }

    /// limit: σ beyond chance. sharing: of so many markers a cause shifts.
    template <class Judged>
    void consider(const MatrixXd &columns, double limit, double sharing, const Judged &judged)
    {
        const auto cause = m_residuals.test(columns, sharing == 1 ? believedOfMarker : 0);
        const double shiftPx = cause ? cause->explainedPx * std::sqrt(double(m_pairs.size()) / sharing) : 0;
        if (!cause || cause->clearness < limit || shiftPx < leastShiftPx ||
            (m_best && m_best->information < cause->information))
            return;
        m_best = cause;
        m_judgement = judged(*cause);
    }

    void tryLayout()
    {
        Vector2d middle = Vector2d::Zero();
        for (const PointPair &pair : m_pairs)
            middle += pair.source / double(m_pairs.size());
        MatrixXd sides(Index(2 * m_pairs.size()), 2);
        sides << byPositions(m_pairs, m_view,
                             [&](const Vector2d &at) {
                                 return Vector2d(0.5 * (at.x() - middle.x()), -0.5 * (at.y() - middle.y()));
                             }),
            byPositions(m_pairs, m_view, [&](const Vector2d &at) {
                return Vector2d(0.5 * (at.y() - middle.y()), 0.5 * (at.x() - middle.x()));
            });
        consider(sides, beyondChance, double(m_pairs.size()), [](const Explanation &cause) {
            return ResidualJudgement{ResidualPattern::Layout, false, layoutSentence(cause.size)};
        });
    }

    void tryEachMarker()
    {
        for (std::size_t i = 0; i < m_pairs.size(); ++i) {
            MatrixXd one = MatrixXd::Zero(Index(2 * m_pairs.size()), 2);
            Eigen::Matrix<double, 2, 3> byWorld = Eigen::Matrix<double, 2, 3>::Zero();
            m_view.pixelFromWorld({m_pairs[i].source.x(), m_pairs[i].source.y(), 0}, byWorld);
            one.middleRows<2>(Index(2 * i)) = byWorld.leftCols<2>();
            consider(one, beyondChanceOfMany, 1, [&](const Explanation &cause) {
                return ResidualJudgement{ResidualPattern::Layout, true,
                                         markerSentence(m_pairs[i].label, cause.size.norm())};
            });
        }
    }

    void tryNeighbours()
    {
        const VectorXd &left = m_residuals.left();
        const double rmsPx = std::sqrt(left.squaredNorm() / double(m_pairs.size()));
        if (rmsPx > smoothPx && alikeness(m_pairs, left) > alikeBeyondChance)
            m_judgement = {ResidualPattern::Intrinsics, false, alikeSentence(rmsPx)};
    }

    std::span<const PointPair> m_pairs;
    const FloorView &m_view;
    Residuals m_residuals;
    std::optional<Explanation> m_best;
    ResidualJudgement m_judgement;
};

} // namespace

ResidualJudgement judgeResiduals(std::span<const PointPair> pairs, const PlanePose &pose,
                                 bool intrinsicsKnown)
{
    if (pairs.size() < (intrinsicsKnown ? leastForOneMarker : leastOfEstimatedLens))
        return {};
    const auto slopes = markerDerivatives(pose.camera, pose.worldFromCamera, positionsOf(pairs));
    if (!slopes)
        return {};
    const FloorView view(pose.camera, pose.worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    return PatternSearch(pairs, view, *slopes, intrinsicsKnown).judgement();
}

} // namespace odo
