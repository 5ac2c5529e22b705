// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/floor_positions.h"

#include <optional>
#include <vector>

namespace odo {

/// The plane on which views were compared.
struct ComparedPlane
{
    double heightM = 0, sigmaM = 0;
    bool isGiven = false; ///< and not estimated from these views
    /// by a box or a cylinder that explains the outlines: nothing of a contradiction is in the robot's form
    bool isFormSure = false;
};

/// Log evidence in nats from which on a cause counts; from a plain form, which is not all of a robot, more.
inline constexpr double leastEvidence = 5, leastPlainEvidence = 8;

/// What was found of views that contradict each other for a reason.
struct ExplainedContradiction
{
    ViewsContradiction contradiction;
    std::vector<double> apartM; ///< at each time; 0 where the cause moves the position by less than its σ
};

struct PairCorrection;

/// The correction by which two views would agree, where they seem to contradict each other: a form of the
/// robot that is found with it is not bent by the contradiction. least: log evidence; less is enough where
/// the form is sure. nullopt: they agree, or there are not just two registered ones. Pure.
std::optional<PairCorrection> likelyCorrection(const std::vector<ViewTrack> &views,
                                               const std::vector<std::vector<Sighting>> &sightings,
                                               const ComparedPlane &plane, double least);

/// Finds whether two views contradict each other by something that changes over floor and time as a known
/// cause does (a camera was moved before or during the run, the time offset or its rate is wrong, a given
/// height is wrong): then that explains their differences e⁵ times better than the errors that are stated,
/// and moves the position by more than 1.5 σ (where the form is sure, e^1.5 times and 2.5 σ). The covariances
/// of both are widened by what it moves the position by, at each time and in its direction, for which of the
/// views is right cannot be known for sure. Of more than two views nothing is widened (settleContradictions
/// leaves out the odd one), and the cause is one that explains all contradictions. nullopt: there is none.
/// views: as long as sightings, which are at the same times. Pure.
std::optional<ExplainedContradiction> explainContradiction(const std::vector<ViewTrack> &views,
                                                           std::vector<std::vector<Sighting>> &sightings,
                                                           const ComparedPlane &plane);

/// Whether each of two views has the other one's video: exchanged, they agree four times as well. plane: one
/// on which they may agree. nullopt: no two do.
std::optional<std::pair<std::size_t, std::size_t>>
exchangedViews(const std::vector<ViewTrack> &views, const std::vector<std::vector<Sighting>> &sightings,
               double planeM);

} // namespace odo
