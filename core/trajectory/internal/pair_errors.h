// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/compared_pair.h"

#include <Eigen/Cholesky>
#include <vector>

namespace odo {

/// Noise of the outlines: the stated one times a factor, a part of it slow.
struct OutlineNoise
{
    double scale = 1, slowShare = 0.8, slowLengthM = 0.1;
};

/// Noises to try: few for a first look.
std::vector<OutlineNoise> noisesToTry(bool isFirstLook);

/// The differences of two views' positions as errors that are stated would make them: a normal distribution
/// for each noise that the outlines may have.
class PairErrors
{
public:
    PairErrors(const ComparedPair &pair, std::vector<OutlineNoise> noises);

    std::size_t size() const { return m_noises.size(); }
    const Eigen::LLT<Eigen::MatrixXd> &root(std::size_t k) const { return m_roots[k]; } ///< of the covariance
    double logDeterminant(std::size_t k) const { return m_logDeterminants[k]; }
    double logPrior(std::size_t k) const;
    std::size_t usual() const; ///< index of a noise that is most often right
    /// Log evidence of the differences by the noise that explains them best.
    double logEvidence(const Eigen::VectorXd &differences) const;

private:
    std::vector<OutlineNoise> m_noises;
    std::vector<Eigen::LLT<Eigen::MatrixXd>> m_roots;
    std::vector<double> m_logDeterminants;
};

} // namespace odo
