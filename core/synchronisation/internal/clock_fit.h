// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/track_sampling.h"

#include <Eigen/Core>
#include <vector>

namespace odo {

/// Fewer common positions determine nothing.
inline constexpr std::size_t fewestPairs = 30;

/// How the second view's times are mapped to the first's.
struct ClockGuess
{
    double offsetS = 0, rate = 0;
};

/// The two tracks at equal times under a guess.
struct Pairs
{
    std::vector<double> sinceStartS;                              ///< of the second clip
    std::vector<Eigen::Vector2d> differences, velocities, points; ///< points about their mean
    std::vector<double> velocityVariances;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero(); ///< that mean
    double motionVariance = 0; ///< m², of the second track's positions about their mean

    std::size_t size() const { return differences.size(); }
};

Pairs pairsAt(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
              const ClockGuess &guess, std::size_t stride);

/// A moment from which on the lag is fitted by itself: of the first view's clock less the offset.
struct LagChange
{
    double fromS = 0;
};

/// How well the tracks match under a guess, and how to improve it. The parameters are the offset, the rate
/// and what the lag changes by at each change.
struct Agreement
{
    double variance = 0;         ///< m², of what shift and scale leave
    double predicted = 0;        ///< of what the step is to leave
    std::vector<double> leftM2;  ///< of each pair, likewise
    Lie lie;                     ///< the shift and scale that leave least
    double correlatedS = 0;      ///< over which what is left is alike
    Eigen::VectorXd step;        ///< Gauss–Newton step
    Eigen::MatrixXd information; ///< per m² of noise
};

/// One linear least-squares problem in (offset, rate, changes, shift x, shift y, scale). Near the guess the
/// difference changes by +v for each second of offset and by −v·u for each unit of rate, u the time since the
/// clip's start. noiseM2: variance of an independent residual, against which the scale's prior weighs.
Agreement agreementOf(const Pairs &pairs, bool withRate, const std::vector<LagChange> &changes,
                      double noiseM2);

/// Variance of one residual as if each stood alone, though neighbours share what is left.
double independentVariance(double variance, double frameS);

/// A guess bettered as far as it goes.
struct Fit
{
    ClockGuess clock;
    Agreement agreement;
    double motionVariance = 0;
    std::size_t pairs = 0;
};

/// Gauss–Newton from a guess.
Fit refine(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
           ClockGuess guess, bool withRate, double frameS);

} // namespace odo
