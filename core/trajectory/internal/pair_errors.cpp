// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/pair_errors.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double lastingLengthM = 0.5; // of what lasts in outlines

/// The square root of a part of a covariance, which two times share by a correlation.
Eigen::Matrix2d rootOf(const Eigen::Matrix2d &covariance)
{
    const Eigen::Matrix2d positive = covariance + Eigen::Matrix2d::Identity() * 1e-14;
    return positive.llt().matrixL();
}

/// The compared times of a pair.
class ComparedTimes
{
public:
    explicit ComparedTimes(const ComparedPair &pair) : m_pair(pair) {}

    Eigen::Index size() const { return static_cast<Eigen::Index>(m_pair.compared().size()); }
    const CommonTime &time(Eigen::Index i) const
    {
        return m_pair.common()[m_pair.compared()[static_cast<std::size_t>(i)]];
    }
    const FloorPosition &a(Eigen::Index i) const { return m_pair.a()[time(i).index].position; }
    const FloorPosition &b(Eigen::Index i) const { return m_pair.b()[time(i).index].position; }
    double wayM(Eigen::Index i, Eigen::Index j) const { return std::abs(time(i).travelM - time(j).travelM); }

private:
    const ComparedPair &m_pair;
};

/// Adds a noise of these roots of covariances, alike by a share between two times.
template <class Alike>
void addNoise(Eigen::MatrixXd &all, const std::vector<Eigen::Matrix2d> &roots, const Alike &alike)
{
    const auto n = static_cast<Eigen::Index>(roots.size());
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            all.block<2, 2>(2 * i, 2 * j) += alike(i, j) * roots[static_cast<std::size_t>(i)] *
                                             roots[static_cast<std::size_t>(j)].transpose();
}

/// Covariance of the differences, without the outlines' noise.
Eigen::MatrixXd lastingCovariance(const ComparedPair &pair, const ComparedTimes &times)
{
    const Eigen::Index n = times.size();
    const PairPriors &priors = pair.priors();
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::VectorXd byHeight(2 * n), byTime(2 * n);
    std::vector<Eigen::Matrix2d> lasting;
    const auto shared = [&](const FloorView &view, const FloorPosition &p,
                            const FloorPosition &q) -> Eigen::Matrix2d {
        return view.sharedCovariance(p.pointInWorld, q.pointInWorld, priors.planeM)
            .value_or(Eigen::Matrix2d::Zero());
    };
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) {
            const Eigen::Matrix2d both =
                shared(pair.viewA(), times.a(i), times.a(j)) + shared(pair.viewB(), times.b(i), times.b(j));
            all.block<2, 2>(2 * i, 2 * j) = both;
            all.block<2, 2>(2 * j, 2 * i) = both.transpose();
        }
        lasting.push_back(
            rootOf(pair.lastingOf(pair.viewA(), times.a(i)) + pair.lastingOf(pair.viewB(), times.b(i))));
        byHeight.segment<2>(2 * i) =
            times.a(i).displacementPerMetreHeight - times.b(i).displacementPerMetreHeight;
        byTime.segment<2>(2 * i) = times.time(i).velocityMps;
    }
    addNoise(all, lasting,
             [&](Eigen::Index i, Eigen::Index j) { return std::exp(-times.wayM(i, j) / lastingLengthM); });
    return all + priors.planeSigmaM * priors.planeSigmaM * byHeight * byHeight.transpose() +
           priors.offsetSigmaS * priors.offsetSigmaS * byTime * byTime.transpose();
}

} // namespace

std::vector<OutlineNoise> noisesToTry(bool isFirstLook)
{
    if (isFirstLook)
        return {{0.5, 0.8, 0.1}, {2, 0.8, 0.1}, {8, 0.8, 0.1}};
    std::vector<OutlineNoise> all;
    for (double scale = 0.25; scale < 100; scale *= 2)
        for (const auto &[share, lengthM] :
             {std::pair(0.3, 0.1), std::pair(0.8, 0.05), std::pair(0.8, 0.1), std::pair(0.9, 0.2)})
            all.push_back({scale, share, lengthM});
    return all;
}

PairErrors::PairErrors(const ComparedPair &pair, std::vector<OutlineNoise> noises)
    : m_noises(std::move(noises))
{
    const ComparedTimes times(pair);
    const Eigen::MatrixXd lasting = lastingCovariance(pair, times);
    std::vector<Eigen::Matrix2d> roots;
    for (Eigen::Index i = 0; i < times.size(); ++i)
        roots.push_back(rootOf(times.a(i).pixelCovariance + times.b(i).pixelCovariance));
    for (const OutlineNoise &noise : m_noises) {
        Eigen::MatrixXd all = lasting;
        addNoise(all, roots, [&](Eigen::Index i, Eigen::Index j) {
            const double slow = noise.slowShare * std::exp(-times.wayM(i, j) / noise.slowLengthM);
            return noise.scale * (slow + (i == j ? 1 - noise.slowShare : 0));
        });
        m_roots.emplace_back(all);
        m_logDeterminants.push_back(2 * m_roots.back().matrixLLT().diagonal().array().log().sum());
    }
}

/// Of a factor that is usually about one.
double PairErrors::logPrior(std::size_t k) const
{
    const double logScale = std::log(m_noises[k].scale);
    return -logScale * logScale / 2;
}

std::size_t PairErrors::usual() const
{
    const auto found = std::ranges::find_if(m_noises, [](const OutlineNoise &noise) {
        return noise.scale >= 2 && noise.slowShare == 0.8 && noise.slowLengthM == 0.1;
    });
    return static_cast<std::size_t>(found - m_noises.begin());
}

double PairErrors::logEvidence(const Eigen::VectorXd &differences) const
{
    double best = -HUGE_VAL;
    for (std::size_t k = 0; k < m_noises.size(); ++k)
        best = std::max(best, -(differences.dot(m_roots[k].solve(differences)) + m_logDeterminants[k]) / 2 +
                                  logPrior(k));
    return best;
}

} // namespace odo
