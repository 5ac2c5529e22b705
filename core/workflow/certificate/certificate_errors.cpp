// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/certificate/internal/certificate_errors.h"

#include "core/analysis/quantity_curve.h"
#include "core/workflow/known_truth.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// Gathers the errors of one quantity.
class ErrorSums
{
public:
    void add(double error)
    {
        m_errors.push_back(std::abs(error));
        m_squares += error * error;
    }
    void addStated(double error, double sigma)
    {
        ++m_stated;
        m_variances += sigma * sigma;
        m_inside += std::abs(error) <= coverage95 * sigma;
    }

    CertificateErrors figure(double coordinates = 1) const
    {
        CertificateErrors figure;
        if (m_errors.empty())
            return figure;
        std::vector<double> sorted = m_errors;
        std::ranges::sort(sorted);
        figure.rms = std::sqrt(m_squares / double(sorted.size()));
        figure.p95 = sorted[std::size_t(std::ceil(0.95 * double(sorted.size()))) - 1];
        if (m_stated == 0)
            return figure;
        figure.sigma = std::sqrt(coordinates * m_variances / double(m_stated));
        figure.covered = double(m_inside) / double(m_stated);
        return figure;
    }

private:
    std::vector<double> m_errors;
    double m_squares = 0, m_variances = 0;
    std::int64_t m_stated = 0, m_inside = 0;
};

} // namespace

void addErrors(CertificateOutcome &outcome)
{
    ErrorSums position, velocity, speed, acceleration, amount;
    for (const CertificateRun &run : outcome.runs) {
        outcome.frames += std::int64_t(run.truth.times.size());
        outcome.largestSyncErrorS = std::max(outcome.largestSyncErrorS, run.largestSyncErrorS.value_or(0));
        for (std::size_t i = 0; i < run.profile.points.size(); ++i) {
            const ProfilePoint &point = run.profile.points[i];
            const auto truth = truthAt(run.truth, run.profile.samples[i].time);
            if (!point.valid || !truth)
                continue;
            ++outcome.compared;
            const Eigen::Vector2d apart = point.position - run.truth.positions[*truth];
            position.add(apart.norm());
            position.addStated(apart.x(), point.sigmaXM);
            position.addStated(apart.y(), point.sigmaYM);
            const Eigen::Vector2d &v = run.truth.velocities[*truth], &a = run.truth.accelerations[*truth];
            velocity.add((point.velocity - v).norm());
            speed.add(point.speedMps - v.norm());
            speed.addStated(point.speedMps - v.norm(), point.sigmaSpeedMps);
            acceleration.add((point.acceleration - a).norm());
            amount.add(point.accelMps2 - a.norm());
            amount.addStated(point.accelMps2 - a.norm(), point.sigmaAccelMps2);
        }
    }
    outcome.position = position.figure(2);
    outcome.velocity = velocity.figure();
    outcome.speed = speed.figure();
    outcome.acceleration = acceleration.figure();
    outcome.accelerationAmount = amount.figure();
}

} // namespace odo
