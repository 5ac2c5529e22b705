// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/reach_learning.h"

#include "core/trajectory/internal/level_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int nodes = ReachCorrection::nodes;
enum : int { WiderOutlines = nodes, unknowns };
constexpr double likelyWiderPx = 0.1;   // against the solid's own fit
constexpr double leastDoubtedM = 0.002; // amplitude for the σ
constexpr double smoothRad = 0.26;      // over which the difference is correlated
constexpr double alikeSides = 0.9;      // correlation of left and right
constexpr double nugget = 1e-4;         // of the prior's variance: what is not smooth
constexpr double likelyShiftM = 0.05;   // of a position that is wrong with the solid alone
constexpr double givenSizeSigmaM = 0.001;
constexpr double amplitudesM[] = {0.0003, 0.001, 0.002, 0.004, 0.008, 0.016, 0.032};
// times whose outlines have errors of their own; those of all others repeat them
constexpr double sameErrors = 12;

/// The prior's covariance between the nodes, of amplitude 1.
Eigen::MatrixXd priorCovariance()
{
    std::vector<Eigen::Vector3d> directions;
    for (int node = 0; node < nodes; ++node)
        directions.push_back(ReachCorrection::directionOf(node));
    const auto smooth = [](const Eigen::Vector3d &a, const Eigen::Vector3d &b) {
        const double angle = std::acos(std::clamp(a.dot(b), -1.0, 1.0)) / smoothRad;
        return std::exp(-0.5 * angle * angle);
    };
    Eigen::MatrixXd covariance(nodes, nodes);
    for (int i = 0; i < nodes; ++i) {
        for (int j = 0; j <= i; ++j) {
            const Eigen::Vector3d mirrored(directions[std::size_t(j)].x(), -directions[std::size_t(j)].y(),
                                           directions[std::size_t(j)].z());
            const double here = smooth(directions[std::size_t(i)], directions[std::size_t(j)]) +
                                alikeSides * smooth(directions[std::size_t(i)], mirrored);
            covariance(i, j) = covariance(j, i) = here / (1 + alikeSides) + (i == j ? nugget : 0);
        }
    }
    return covariance;
}

/// The difference between a direction and its opposite, or their sum, as a row over the nodes.
Eigen::VectorXd acrossBody(const Eigen::Vector3d &direction, double sign)
{
    Eigen::VectorXd row = Eigen::VectorXd::Zero(unknowns);
    const auto add = [&row](const Eigen::Vector3d &to, double by) {
        const auto weights = ReachCorrection::weightsAt(to);
        for (std::size_t i = 0; i < weights.node.size(); ++i)
            row[weights.node[i]] += by * weights.weight[i];
    };
    add(direction, 1);
    add(-direction, sign);
    return row;
}

/// What the outlines of one time say: about its position, and jointly with the nodes.
struct TimeRows
{
    double headingRad = 0;
    Eigen::Matrix2d positionPrecision = Eigen::Matrix2d::Zero();
    /// of the position and the unknowns
    Eigen::Matrix<double, 2, Eigen::Dynamic> coupling =
        Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, unknowns);
    Eigen::Vector2d pull = Eigen::Vector2d::Zero();
};

class ReachProblem
{
public:
    ReachProblem(const std::vector<CommonOutlines> &times, const LevelFit &fit, const RobotShape &given);
    std::optional<LearnedReach> solve(double widerPx) const;

private:
    struct Solution
    {
        Eigen::LLT<Eigen::MatrixXd> factor;
        Eigen::VectorXd values;
        double logEvidence = -HUGE_VAL;
    };

    void addOutline(const CommonOutlines::Outline &outline, const BodyPose &pose, const LevelFit &fit,
                    double weight, TimeRows &time);
    void keepGiven(const LevelFit &fit, const RobotShape &given);
    Solution solvedWith(double amplitudeM, const Eigen::MatrixXd &priorPrecision,
                        double priorLogDeterminant) const;

    Eigen::MatrixXd m_precision = Eigen::MatrixXd::Zero(unknowns, unknowns); ///< the positions eliminated
    Eigen::VectorXd m_pull = Eigen::VectorXd::Zero(unknowns);
    std::vector<TimeRows> m_times;
};

ReachProblem::ReachProblem(const std::vector<CommonOutlines> &times, const LevelFit &fit,
                           const RobotShape &given)
{
    const double share = std::min(1.0, sameErrors / double(std::max<std::size_t>(1, fit.poses.size())));
    for (const BodyPose &pose : fit.poses) {
        const auto common = std::ranges::lower_bound(times, pose.time, {}, &CommonOutlines::time);
        if (common == times.end() || common->time != pose.time)
            continue;
        TimeRows time;
        time.headingRad = pose.headingRad;
        time.positionPrecision.diagonal().setConstant(1 / (likelyShiftM * likelyShiftM));
        for (const CommonOutlines::Outline &outline : common->outlines)
            if (outline.supportPx.size() == supportDirections)
                addOutline(outline, pose, fit, share / (supportSigmaPx * supportSigmaPx), time);
        if (time.coupling.isZero(0)) // no outline with a support
            continue;
        const Eigen::Matrix<double, 2, Eigen::Dynamic> byPosition =
            time.positionPrecision.inverse() * time.coupling;
        m_precision.noalias() -= time.coupling.transpose() * byPosition;
        m_pull.noalias() -= byPosition.transpose() * time.pull;
        m_times.push_back(std::move(time));
    }
    keepGiven(fit, given);
}

void ReachProblem::addOutline(const CommonOutlines::Outline &outline, const BodyPose &pose,
                              const LevelFit &fit, double weight, TimeRows &time)
{
    const double position[] = {pose.position.x(), pose.position.y(), pose.headingRad};
    std::array<double, supportDirections> reach{};
    std::array<Eigen::Vector3d, supportDirections> slopes; // of the reach by a point of the body, px/m
    const auto keepSlope = [&slopes](std::size_t k, const Eigen::Vector3d &slope) {
        slopes[k] = slope;
        return 0.0;
    };
    if (!reachOfLevels(*outline.view, levelsOfShape<double>(fit.shape), fit.shape.roundShare, position, reach,
                       keepSlope))
        return;
    std::array<double, supportDirections> residual{}; // in σ, limited
    reachDifferences(outline.supportPx, outline.moments.centrePx, fit.widerPx, reach, residual.data());
    const Eigen::AngleAxisd toRobot(-pose.headingRad, Eigen::Vector3d::UnitZ());
    for (std::size_t k = 0; k < supportDirections; ++k) {
        const double scale = slopes[k].norm(), offPx = residual[k] * supportSigmaPx;
        const Eigen::Vector2d byPosition = slopes[k].head<2>();
        const auto weights = ReachCorrection::weightsAt(toRobot * slopes[k]);
        std::array<std::pair<int, double>, 5> row{{{WiderOutlines, 1}}};
        for (std::size_t i = 0; i < weights.node.size(); ++i)
            row[i + 1] = {weights.node[i], scale * weights.weight[i]};
        for (const auto &[i, a] : row) {
            for (const auto &[j, b] : row)
                m_precision(i, j) += weight * a * b;
            m_pull[i] += weight * a * offPx;
            time.coupling.col(i) += weight * a * byPosition;
        }
        time.positionPrecision += weight * byPosition * byPosition.transpose();
        time.pull += weight * offPx * byPosition;
    }
}

void ReachProblem::keepGiven(const LevelFit &fit, const RobotShape &given)
{
    const auto keep = [this](const Eigen::Vector3d &direction, double offM) {
        const Eigen::VectorXd row = acrossBody(direction, 1) / givenSizeSigmaM;
        m_precision.noalias() += row * row.transpose();
        m_pull += row * (offM / givenSizeSigmaM);
    };
    if (given.lengthM)
        keep(Eigen::Vector3d::UnitX(), *given.lengthM - fit.shape.lengthM);
    if (given.widthM)
        keep(Eigen::Vector3d::UnitY(), *given.widthM - fit.shape.widthM);
}

ReachProblem::Solution ReachProblem::solvedWith(double amplitudeM, const Eigen::MatrixXd &priorPrecision,
                                                double priorLogDeterminant) const
{
    const double precision = 1 / (amplitudeM * amplitudeM);
    Eigen::MatrixXd all = m_precision;
    all.topLeftCorner(nodes, nodes) += precision * priorPrecision;
    all(WiderOutlines, WiderOutlines) += 1 / (likelyWiderPx * likelyWiderPx);
    Solution solution{Eigen::LLT<Eigen::MatrixXd>(all), {}, -HUGE_VAL};
    if (solution.factor.info() != Eigen::Success)
        return solution;
    solution.values = solution.factor.solve(m_pull);
    const double logDeterminant = 2 * solution.factor.matrixLLT().diagonal().array().log().sum();
    solution.logEvidence = 0.5 * (m_pull.dot(solution.values) + priorLogDeterminant +
                                  nodes * std::log(precision) - logDeterminant);
    return solution;
}

std::optional<LearnedReach> ReachProblem::solve(double widerPx) const
{
    if (m_times.empty())
        return std::nullopt;
    static const Eigen::LLT<Eigen::MatrixXd> prior(priorCovariance());
    static const Eigen::MatrixXd priorPrecision = prior.solve(Eigen::MatrixXd::Identity(nodes, nodes));
    static const double priorLogDeterminant = -2 * prior.matrixLLT().diagonal().array().log().sum();
    Solution best;
    LearnedReach learned;
    for (const double amplitudeM : amplitudesM) {
        Solution solution = solvedWith(amplitudeM, priorPrecision, priorLogDeterminant);
        if (solution.logEvidence > best.logEvidence) {
            best = std::move(solution);
            learned.amplitudeM = amplitudeM;
        }
    }
    if (best.values.size() == 0)
        return std::nullopt;
    const Eigen::VectorXd ahead = acrossBody(Eigen::Vector3d::UnitX(), -1) / 2,
                          aside = acrossBody(Eigen::Vector3d::UnitY(), -1) / 2;
    learned.middleM = {ahead.dot(best.values), aside.dot(best.values)};
    learned.outlines = {widerPx + best.values[WiderOutlines], ReachCorrection(best.values.head(nodes))};
    if (learned.amplitudeM < leastDoubtedM)
        best = solvedWith(leastDoubtedM, priorPrecision, priorLogDeterminant);
    double forward = 0, left = 0;
    for (const TimeRows &time : m_times) {
        // Of the middle, at this time, by the unknowns: the position follows them, and the middle is offset
        // from it.
        const Eigen::Matrix<double, 2, Eigen::Dynamic> inRobot =
            -(Eigen::Rotation2Dd(-time.headingRad).toRotationMatrix() * time.positionPrecision.inverse()) *
            time.coupling;
        const auto variance = [&best](const Eigen::VectorXd &row) { return row.dot(best.factor.solve(row)); };
        forward += variance(inRobot.row(0).transpose() + ahead) / double(m_times.size());
        left += variance(inRobot.row(1).transpose() + aside) / double(m_times.size());
    }
    learned.sigmaForwardM = std::sqrt(std::max(0.0, forward));
    learned.sigmaLeftM = std::sqrt(std::max(0.0, left));
    return learned;
}

} // namespace

std::optional<LearnedReach> learnReach(const std::vector<CommonOutlines> &times, const LevelFit &fit,
                                       const RobotShape &given)
{
    return ReachProblem(times, fit, given).solve(fit.widerPx);
}

} // namespace odo
