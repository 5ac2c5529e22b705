// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_catalogue.h"

#include <QByteArray>
#include <optional>
#include <vector>

namespace odo::test {

/// Sums over the frames of one robot or of many: they are added up and turned into figures at the end.
struct AccuracySums
{
    long frames = 0, withPosition = 0;
    Eigen::Vector2d errorSumMm = Eigen::Vector2d::Zero(); ///< over withPosition
    double squaredMm = 0;                                 ///< position
    long curveFrames = 0;                                 ///< those away from impacts
    double squaredMmS = 0, squaredMmS2 = 0;               ///< velocity, acceleration
    long insideX = 0, insideY = 0, insideSpeed = 0;       ///< of withPosition: truth within 1.96 sigma
    double sigmaSumMm = 0;                                ///< of sigma x and y, over withPosition
    long trueSpikes = 0, foundSpikes = 0; ///< raw place more than 20 mm off; those that are flagged
    /// flagged frames; those with a raw place more than 4 mm off, or disturbed
    long flagged = 0, justlyFlagged = 0;
    long disturbed = 0; ///< frames with a reflection or a board near the robot
    long hiddenInOneView = 0, hiddenWithPosition = 0;
    /// raw places farther from the truth than any part of a robot: something else was taken for it
    long elsewhere = 0;
    long exchanges = 0; ///< more than three frames on end nearer to another robot's truth

    AccuracySums &operator+=(const AccuracySums &other);

    /// Length of the mean error: what all frames have in common.
    double biasMm() const { return withPosition > 0 ? errorSumMm.norm() / double(withPosition) : 0; }
    double positionRmsMm() const;
    double velocityRmsMmS() const;
    double accelerationRmsMmS2() const;
    double share(long count) const { return withPosition > 0 ? double(count) / double(withPosition) : 0; }
    std::optional<double> recall() const;
    std::optional<double> precision() const;
};

/// Compares an exported CSV (style analysis) with where the robot truly was; the truth is asked at the
/// stamps' times of the first camera's clock. Empty when the table is not what is promised.
std::optional<AccuracySums> compareWithTruth(const QByteArray &csv, const AccuracyScene &scene,
                                             std::size_t robot);

} // namespace odo::test
