// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/metrics.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A metric of one run in the course of a term.
struct TermValue
{
    double day = 0; ///< when, in days since any moment
    double value = 0;
};

/// How a metric changed over a term. Pure values.
struct TermProgress
{
    int count = 0;
    double best = 0, median = 0;
    /// Repeatability: the standard deviation of one run about the straight line through all (with less than
    /// three runs, or all on one moment: about their mean). nullopt for one run.
    std::optional<double> spread;
    /// Of the line: how much it rises from the first day to the last, its σ, and its value on the first day.
    /// nullopt for less than three runs, or all at one moment.
    std::optional<UncertainValue> change;
    double atStart = 0;
    /// Whether the change is more than the spread of the runs explains: |change| > t σ with t of 95 % and
    /// count − 2 degrees of freedom.
    bool isBeyondSpread = false;
};

/// The line of least squares through the runs, each of the same weight, and the σ of its slope from what is
/// left over (JCGM 100:2008, H.3.2, equations H.13); the test of the slope is Student's (the same, G.3.2).
/// The runs' own σ is contained in what is left over; what they have in common (the calibration) changes no
/// slope. isLessBetter: what best means. metrics must not be empty.
TermProgress termProgress(const std::vector<TermValue> &metrics, bool isLessBetter);

/// What one team has to be ranked by.
struct TeamStatistics
{
    std::vector<double> values; ///< of its runs
    double runSigma = 0;        ///< root mean square of its runs' own σ; 0: none is known
    double median = 0;          ///< of them; rank
    double sigma = 0;           ///< of the median
    int rank = 1;               ///< one more than the number of teams that are significantly better
};

/// Fills median, sigma and rank of each team. The spread of one run is assumed the same for all teams and
/// pooled over them (JCGM 100:2008, 4.2.4), so a team with one run has a σ too. It contains what the runs
/// were measured with; where it is less than a team's own runSigma (few runs, or none repeated), that counts
/// instead. σ of a median of n runs is that σ of one times √(π/2n), of one or two runs (where it is the mean)
/// over √n. A team is significantly better if the medians differ by more than 1.96 σ of their difference.
/// Without any σ each difference counts. Empty teams have rank 0.
void rankTeams(std::vector<TeamStatistics> &teams, bool isLessBetter);

/// Whether a smaller value of a metric is better, by its name: for times and distances from the path; for
/// speeds larger is.
bool isLessBetter(const std::string &metric);

} // namespace odo
