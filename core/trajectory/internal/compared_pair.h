// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/cause_model.h"
#include "core/trajectory/internal/floor_positions.h"

#include <functional>
#include <span>
#include <vector>

namespace odo {

/// What is known of two views' positions besides their covariances.
struct PairPriors
{
    double planeM = 0, planeSigmaM = 0; ///< height of the plane of the positions
    bool isHeightGiven = false;         ///< and not estimated from these positions
    double offsetSigmaS = 0;            ///< of the time offset of the one view against the other
};

/// A time at which both views saw the robot clearly, and what follows from neighbouring ones.
struct CommonTime
{
    std::size_t index = 0; ///< of the sightings
    double timeS = 0, travelM = 0;
    Eigen::Vector2d velocityMps = Eigen::Vector2d::Zero();
};

struct PairPositions
{
    Eigen::Vector2d a = Eigen::Vector2d::Zero(), b = Eigen::Vector2d::Zero();
};

/// Found and whole.
bool isClear(const Sighting &sighting);

/// Two views' positions of one robot at the same times, and what a cause would make of them. Refers to what
/// it is made from.
class ComparedPair
{
public:
    ComparedPair(const FloorView &viewA, const FloorView &viewB, std::span<const Sighting> a,
                 std::span<const Sighting> b, const PairPriors &priors);

    const FloorView &viewA() const { return m_viewA; }
    const FloorView &viewB() const { return m_viewB; }
    std::span<const Sighting> a() const { return m_a; }
    std::span<const Sighting> b() const { return m_b; }
    const PairPriors &priors() const { return m_priors; }
    const std::vector<CommonTime> &common() const { return m_common; }
    /// Those of common() that are compared; none where there are too few.
    const std::vector<std::size_t> &compared() const { return m_compared; }
    double middleS() const { return m_middleS; } ///< of the common times

    /// What lasts in all outlines of a view, on the floor.
    Eigen::Matrix2d lastingOf(const FloorView &view, const FloorPosition &position) const;
    /// Covariance of a view's position as it is stated without what the fit of a solid left open.
    Eigen::Matrix2d statedOf(const FloorView &view, const FloorPosition &position) const;

    /// The positions at common()[i] with a cause of this size removed.
    PairPositions corrected(std::size_t i, const CauseModel &by, const Eigen::VectorXd &parameters) const;
    /// By what a view's position is off at a time at which the other one does not see it.
    Eigen::Vector2d offAlone(std::size_t index, bool isA, const CauseModel &by,
                             const Eigen::VectorXd &parameters) const;
    /// Differences of the positions at the compared times, x and y in turn.
    Eigen::VectorXd residuals(const CauseModel &by, const Eigen::VectorXd &parameters) const;
    /// Derivatives of the residuals by the parameters; there: the residuals at them.
    Eigen::MatrixXd slopes(const CauseModel &by, const Eigen::VectorXd &parameters,
                           const Eigen::VectorXd &there) const;

private:
    void collect();
    PairPositions apply(const CauseModel &by, const Eigen::VectorXd &parameters, double timeS,
                        PairPositions positions, const std::function<Eigen::Vector2d(double)> &laterB,
                        const Eigen::Vector2d &perHeightA, const Eigen::Vector2d &perHeightB) const;
    Eigen::Vector2d at(std::span<const Sighting> view, std::size_t i, double laterS) const;

    const FloorView &m_viewA, &m_viewB;
    std::span<const Sighting> m_a, m_b;
    PairPriors m_priors;
    std::vector<CommonTime> m_common;
    std::vector<std::size_t> m_compared;
    double m_middleS = 0;
};

} // namespace odo
