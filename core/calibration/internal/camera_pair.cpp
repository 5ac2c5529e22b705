// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/camera_pair.h"

#include "core/base/percentile.h"
#include "core/calibration/internal/lens_spread.h"
#include "core/calibration/internal/pair_verdict.h"
#include "core/calibration/internal/posed_pairs.h"
#include "core/calibration/internal/triangulated_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double medianOfExcess = 0.891; // of χ² of six degrees of freedom, over six
constexpr double contradictingAt = 25;   // times the usual excess: five σ
constexpr int weighings = 12;
constexpr double otherwiseTimes = 1.5; // the RMS of a numbering that is clearly wrong
constexpr double noRelationTimes = 8, noRelationPx = 2;

std::vector<PairedBoards> boardsNumberedBy(const std::vector<PosedPair> &pairs,
                                           const PairHypothesis &hypothesis)
{
    std::vector<PairedBoards> boards;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        boards.push_back(pairs[i].boards);
        for (Vector2d &point : boards.back().b.pointsOnBoard)
            point = hypothesis.turns[i] * point;
    }
    return boards;
}

/// The pairs of a numbering with the weights that their agreement gives them, and which of them contradict.
struct Weighing
{
    std::optional<PairFit> fit;
    std::vector<double> excess; ///< of each pair: squares over those of each image alone, by six σ²
    std::vector<bool> contradicts;
};

double usualExcess(const std::vector<double> &excess)
{
    return std::max(1.0, upperMedian(excess) / medianOfExcess);
}

Weighing weighedPairs(const std::vector<PairedBoards> &boards, const PosedPairs &posed, const CameraModel &a,
                      const CameraModel &b, const PairHypothesis &start, const JobControl &control)
{
    PairFitStart state{start.bFromA, {}};
    for (const PosedPair &pair : posed.pairs)
        state.aFromBoard.push_back(pair.aFromBoard);
    const double variance = std::max(1e-12, posed.sigmaPx * posed.sigmaPx);
    Weighing weighing;
    const double usualPx = std::max(1.0, upperMedian(start.misfitsPx));
    std::vector<double> weights;
    for (const double misfit : start.misfitsPx)
        weights.push_back(1 / std::pow(1 + std::pow(misfit / (2 * usualPx), 2), 2));
    for (int round = 0; round < weighings; ++round) {
        weighing.fit = fitPair(boards, a, b, state, weights, control);
        if (!weighing.fit)
            return weighing;
        state = {weighing.fit->bFromA, weighing.fit->aFromBoard};
        weighing.excess.clear();
        for (std::size_t i = 0; i < boards.size(); ++i)
            weighing.excess.push_back(std::max(0.0, weighing.fit->squares[i] - posed.squares[i]) /
                                      (6 * variance));
        const double usual = usualExcess(weighing.excess);
        for (std::size_t i = 0; i < boards.size(); ++i)
            weights[i] = 1 / (1 + weighing.excess[i] / (4 * usual));
    }
    const double limit = contradictingAt * usualExcess(weighing.excess);
    for (const double excess : weighing.excess)
        weighing.contradicts.push_back(excess > limit);
    return weighing;
}

double rmsPx(const PairFit &fit)
{
    return std::sqrt(fit.sumOfSquares() / double(std::max<std::size_t>(1, fit.corners())));
}

std::size_t cornersIn(const PairedBoards &boards)
{
    return boards.a.pixels.size() + boards.b.pixels.size();
}

/// The pairs that agree, fitted alike, with their outcome in the answer.
Result<PairFit> fitAgreeing(const std::vector<PairedBoards> &boards, const PosedPairs &posed,
                            const Weighing &weighing, const CameraModel &a, const CameraModel &b,
                            const JobControl &control, CameraPair &answer,
                            std::vector<PairedBoards> &agreeing)
{
    PairFitStart state{weighing.fit->bFromA, {}};
    double freeSquares = 0;
    for (std::size_t i = 0; i < boards.size(); ++i) {
        const std::string &sourceA = boards[i].a.source, &sourceB = boards[i].b.source;
        if (weighing.contradicts[i]) {
            answer.rejected.push_back(
                {sourceA, sourceB,
                 ODO_TEXT("calibration.pair_contradicts", "it contradicts the other pairs by %1 RMS")(
                     quantity(std::sqrt(weighing.fit->squares[i] / double(cornersIn(boards[i]))), 1, "px"))});
            continue;
        }
        agreeing.push_back(boards[i]);
        state.aFromBoard.push_back(weighing.fit->aFromBoard[i]);
        answer.used.push_back({sourceA, sourceB, 0, posed.leftOut[i]});
        freeSquares += posed.squares[i];
    }
    const std::vector<double> alike(agreeing.size(), 1);
    auto fit = fitPair(agreeing, a, b, state, alike, control);
    if (control.isCancelled())
        return cancelled(relationOfCameras());
    if (!fit)
        return refusePair(noRelation(), showBoardToBoth());
    for (std::size_t i = 0; i < agreeing.size(); ++i)
        answer.used[i].rmsPx = std::sqrt(fit->squares[i] / double(cornersIn(agreeing[i])));
    answer.rmsPx = rmsPx(*fit);
    answer.freeRmsPx = std::sqrt(freeSquares / double(fit->corners()));
    return *fit;
}

/// The covariance of the corners' noise, where the pairs scatter more than that: at least so much in each
/// direction as they scatter along it (a sandwich of the pairs' scores: Liang and Zeger 1986).
Matrix6d scattered(const Matrix6d &noise, const PairFit &fit, double overdispersion)
{
    const auto pairs = double(fit.scores.size());
    Matrix6d scores = Matrix6d::Zero();
    for (const auto &score : fit.scores)
        scores += score * score.transpose() * (pairs / std::max(1.0, pairs - 1));
    const Matrix6d scatter = fit.inverseNormal * scores * fit.inverseNormal;
    const Matrix6d root = noise.llt().matrixL();
    const Matrix6d inverseRoot = root.inverse();
    const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(inverseRoot * scatter * inverseRoot.transpose());
    const Matrix6d stretched = root * axes.eigenvectors();
    return stretched * axes.eigenvalues().cwiseMax(overdispersion).asDiagonal() * stretched.transpose();
}

void setCovariance(const PairFit &fit, const CameraModel &a, const CameraModel &b, CameraPair &answer)
{
    constexpr double clearSigmas = 4;
    const auto pairs = double(answer.used.size());
    const auto corners = double(fit.corners());
    const double freeSquares = std::pow(answer.freeRmsPx, 2) * corners;
    const double variance = std::max(1e-16, freeSquares / std::max(1.0, 2 * corners - 12 * pairs));
    const double freedom = std::max(1.0, 6 * pairs - 6);
    const double excess = (fit.sumOfSquares() - freeSquares) / freedom;
    answer.overdispersion = pairs > 1 ? std::max(1.0, excess / variance) : 1;
    const Matrix6d noise = variance * fit.inverseNormal;
    const bool isClear = answer.overdispersion > 1 + clearSigmas * std::sqrt(2 / freedom);
    answer.covariance =
        isClear ? scattered(noise, fit, answer.overdispersion) : Matrix6d(answer.overdispersion * noise);
    const auto carry = [&](const CameraModel &camera, const Eigen::MatrixXd &byIntrinsics) {
        const Intrinsics &lens = camera.intrinsics();
        const bool isStated = lens.covariance.rows() == byIntrinsics.cols();
        answer.areIntrinsicsSigmasStated = answer.areIntrinsicsSigmasStated && isStated;
        answer.covariance += byIntrinsics *
                             (isStated ? lens.covariance : covarianceOf(lens, importedLensSpread)) *
                             byIntrinsics.transpose();
    };
    carry(a, fit.byIntrinsicsA);
    carry(b, fit.byIntrinsicsB);
    answer.bFromA = fit.bFromA;
    answer.baselineM = fit.bFromA.translation.norm();
    const Vector3d along = fit.bFromA.translation.normalized();
    answer.baselineSigmaM = std::sqrt(along.dot(answer.covariance.bottomRightCorner<3, 3>() * along));
}

/// Whether the other numbering fits about as well: as many of its pairs, the best ones.
bool isNumberingOpen(const PairHypotheses &hypotheses, const PosedPairs &posed, const CameraPair &found,
                     const CameraModel &a, const CameraModel &b, const JobControl &control)
{
    if (!hypotheses.other)
        return false;
    const auto boards = boardsNumberedBy(posed.pairs, *hypotheses.other);
    const Weighing other = weighedPairs(boards, posed, a, b, *hypotheses.other, control);
    if (!other.fit)
        return false;
    std::vector<double> meanSquares;
    for (std::size_t i = 0; i < boards.size(); ++i)
        meanSquares.push_back(other.fit->squares[i] / double(cornersIn(boards[i])));
    std::ranges::sort(meanSquares);
    double sum = 0;
    for (std::size_t i = 0; i < found.used.size(); ++i)
        sum += meanSquares[i];
    return std::sqrt(sum / double(found.used.size())) < otherwiseTimes * found.rmsPx;
}

} // namespace

std::size_t CameraPair::cornersLeftOut() const
{
    std::size_t count = 0;
    for (const UsedPair &pair : used)
        count += pair.cornersLeftOut;
    return count;
}

Result<CameraPair> relateCameras(const std::vector<BoardPair> &pairs, const CameraModel &a,
                                 const CameraModel &b, const JobControl &control)
{
    CameraPair answer;
    const PosedPairs posed = ODO_TRY(posedPairs(pairs, a, b, answer.rejected, control));
    const PairHypotheses hypotheses = startRelation(posed.pairs, b);
    const auto boards = boardsNumberedBy(posed.pairs, *hypotheses.best);
    const Weighing weighing = weighedPairs(boards, posed, a, b, *hypotheses.best, control);
    if (control.isCancelled())
        return cancelled(relationOfCameras());
    if (!weighing.fit)
        return refusePair(noRelation(), showBoardToBoth());
    const auto contradicting = std::size_t(std::ranges::count(weighing.contradicts, true));
    std::vector<PairedBoards> agreeing;
    const PairFit fit = ODO_TRY(fitAgreeing(boards, posed, weighing, a, b, control, answer, agreeing));
    if (2 * contradicting > boards.size() ||
        answer.rmsPx > std::max(noRelationPx, noRelationTimes * answer.freeRmsPx))
        return refusePair(pairsContradict(answer), takeAtSameMoment());
    if (isNumberingOpen(hypotheses, posed, answer, a, b, control))
        return refusePair(
            ODO_TEXT("calibration.pair_turned",
                     "the board looks the same when turned by half, and %1 pairs fit both ways")(
                boards.size()),
            ODO_TEXT("calibration.tilt_or_charuco",
                     "show it in more positions with different tilts, or use a ChArUco board"));
    setCovariance(fit, a, b, answer);
    answer.squares = triangulatedSquares(agreeing, a, b, fit);
    answer.verdict = pairVerdict(answer);
    return answer;
}

} // namespace odo
