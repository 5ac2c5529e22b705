// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/cause_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace odo {

namespace {

constexpr int gaussNewtonSteps = 6, firstSteps = 2;
constexpr std::size_t changePoints = 24, firstChangePoints = 6; // tried along the run
constexpr double edgeShare = 0.04;                              // of the run, where none is tried
constexpr double logRare = -2;                                  // two things at once are rarer than one

class CauseFitter
{
public:
    CauseFitter(const ComparedPair &pair, const PairErrors &errors, bool isFirstLook)
        : m_pair(pair), m_errors(errors), m_isFirstLook(isFirstLook)
    {
    }

    std::optional<CauseFit> fit(const CauseModel &by) const;
    std::optional<CauseFit> fitChange(const CauseModel &lasting) const;

private:
    bool approach(CauseFit &fit, Eigen::VectorXd &misfit) const;
    void weigh(CauseFit &fit, const Eigen::VectorXd &misfit) const;

    const ComparedPair &m_pair;
    const PairErrors &m_errors;
    bool m_isFirstLook = false;
};

/// Gauss–Newton steps to the parameters, by the widest prior and the usual noise. Whether it converges.
bool CauseFitter::approach(CauseFit &fit, Eigen::VectorXd &misfit) const
{
    const CauseModel &by = fit.model;
    Eigen::VectorXd precision(by.size());
    for (Eigen::Index p = 0; p < by.size(); ++p)
        precision[p] = 1 / std::pow(by.scales.back() * by.sigmas[static_cast<std::size_t>(p)], 2);
    const auto &root = m_errors.root(m_errors.usual());
    for (int step = 0; step < (m_isFirstLook ? firstSteps : gaussNewtonSteps); ++step) {
        const Eigen::MatrixXd slope = m_pair.slopes(by, fit.parameters, misfit);
        const Eigen::MatrixXd weighted = root.solve(slope);
        Eigen::MatrixXd normal = weighted.transpose() * slope;
        normal.diagonal() += precision;
        fit.parameters -=
            normal.ldlt().solve(weighted.transpose() * misfit + precision.cwiseProduct(fit.parameters));
        misfit = m_pair.residuals(by, fit.parameters);
        if (!misfit.allFinite() || !fit.parameters.allFinite())
            return false;
    }
    return true;
}

/// Evidence, parameters and covariance by the best noise and prior, the model being linear near by.
void CauseFitter::weigh(CauseFit &fit, const Eigen::VectorXd &misfit) const
{
    const CauseModel &by = fit.model;
    const Eigen::MatrixXd slope = m_pair.slopes(by, fit.parameters, misfit);
    const Eigen::Map<const Eigen::VectorXd> sigmas(by.sigmas.data(), by.size());
    const Eigen::VectorXd straight = misfit - slope * fit.parameters; // of a linear model, at no cause
    for (std::size_t k = 0; k < m_errors.size(); ++k) {
        const Eigen::MatrixXd weighted = m_errors.root(k).solve(slope);
        const Eigen::VectorXd pull = weighted.transpose() * straight;
        const Eigen::MatrixXd information = weighted.transpose() * slope;
        const double whole = straight.dot(m_errors.root(k).solve(straight));
        for (const double scale : by.scales) {
            Eigen::MatrixXd normal = information;
            normal.diagonal() += (scale * sigmas).cwiseAbs2().cwiseInverse();
            const double logPriorDeterminant = 2 * (scale * sigmas).array().log().sum();
            const Eigen::LLT<Eigen::MatrixXd> root(normal);
            const Eigen::VectorXd estimate = -root.solve(pull);
            const double chiSquared = whole + estimate.dot(pull);
            const double logDeterminant = m_errors.logDeterminant(k) + logPriorDeterminant +
                                          2 * root.matrixLLT().diagonal().array().log().sum();
            const double evidence = -(chiSquared + logDeterminant) / 2 + m_errors.logPrior(k) -
                                    std::log(double(by.scales.size()));
            if (evidence > fit.logEvidence) {
                fit.logEvidence = evidence;
                fit.parameters = estimate;
                fit.covariance = root.solve(Eigen::MatrixXd::Identity(by.size(), by.size()));
            }
        }
    }
}

/// nullopt where it diverges.
std::optional<CauseFit> CauseFitter::fit(const CauseModel &by) const
{
    CauseFit fit{by, Eigen::VectorXd::Zero(by.size()), {}, -HUGE_VAL};
    Eigen::VectorXd misfit = m_pair.residuals(by, fit.parameters);
    if (!approach(fit, misfit))
        return std::nullopt;
    weigh(fit, misfit);
    return fit;
}

/// The same cause, from that time on by which it is likeliest.
std::optional<CauseFit> CauseFitter::fitChange(const CauseModel &lasting) const
{
    const std::vector<CommonTime> &common = m_pair.common();
    const double beginS = common.front().timeS, spanS = common.back().timeS - beginS;
    std::optional<CauseFit> best;
    const auto tryAt = [&](double share) {
        CauseModel from = lasting;
        from.sinceS = beginS + share * spanS;
        auto its = fit(from);
        if (its && (!best || its->logEvidence > best->logEvidence))
            best = std::move(its);
    };
    const std::size_t points = m_isFirstLook ? firstChangePoints : changePoints;
    for (std::size_t k = 0; k < points; ++k)
        tryAt(edgeShare + (1 - 2 * edgeShare) * double(k) / double(points - 1));
    if (!best || m_isFirstLook)
        return best;
    const double around = (*best->model.sinceS - beginS) / spanS, step = 1.0 / double(changePoints);
    for (const double beside : {-0.75, -0.5, -0.25, 0.25, 0.5, 0.75})
        tryAt(around + beside * step);
    best->logEvidence -= std::log(double(changePoints));
    return best;
}

} // namespace

std::vector<CauseFit> fitAllCauses(const ComparedPair &pair, const PairErrors &errors, bool isFirstLook)
{
    const CauseFitter fitter(pair, errors, isFirstLook);
    std::vector<CauseFit> fits;
    for (const CauseModel &one : lastingCauses(pair.priors().isHeightGiven)) {
        if (auto fitted = fitter.fit(one)) {
            if (one.changesRate || (one.rotatesA && one.rotatesB))
                fitted->logEvidence += logRare;
            fits.push_back(std::move(*fitted));
        }
        if (one.kind == ContradictionCause::Kind::CameraMoved)
            if (auto fitted = fitter.fitChange(one))
                fits.push_back(std::move(*fitted));
    }
    std::ranges::sort(fits, std::greater(), &CauseFit::logEvidence);
    return fits;
}

} // namespace odo
