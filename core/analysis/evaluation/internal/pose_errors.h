// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/evaluation/internal/measured_course.h"
#include "core/analysis/evaluation/log_evaluation.h"

#include <vector>

namespace odo {

/// A pose of the log and the measured one of the same time.
struct PosePair
{
    double timeS = 0; ///< of the trial
    LogPose log;
    CoursePose measured;

    bool haveHeadings() const { return log.headingRad && measured.headingRad; }
};

/// Turned and shifted, and scaled if asked, for the least squared distances of the log's positions from the
/// measured ones: the closed form of Umeyama 1991 ("Least-squares estimation of transformation parameters
/// between two point patterns") in the plane, which never mirrors. Positions that are all the same are
/// shifted alone.
PlaneSimilarity leastSquaresAlignment(const std::vector<PosePair> &pairs, bool withScale);

/// Whether the log mirrored lies far nearer to the run than the log itself.
bool isMirrored(const std::vector<PosePair> &pairs);

/// The first pose of the log onto the measured one. Its direction is that of the two headings where the
/// measured one is more certain than the direction of the first stretch of the path (half a metre, at most a
/// quarter of it), else the least-squares direction of that stretch about the first pose.
struct OriginAlignment
{
    PlaneSimilarity transform;
    bool isTurnedByHeading = false;
    double sigmaHeadingRad = 0;
};
OriginAlignment originAlignment(const std::vector<PosePair> &pairs);

/// Of all pairs, m. origin: by which they were aligned, whose uncertainty the errors share: that of the first
/// position, and of the direction with the distance from it; null where they were aligned otherwise.
ErrorStatistics absoluteErrors(const std::vector<PosePair> &pairs, const PlaneSimilarity &transform,
                               double sigmaOffsetS, const OriginAlignment *origin = nullptr);

/// Two poses a distance apart along the measured path.
struct PathStep
{
    std::size_t from = 0, to = 0;
};
/// From each pose the one whose distance along the polyline of measured positions is nearest to deltaM, if
/// within 10 % of it; not across gaps.
std::vector<PathStep> stepsOf(const std::vector<PosePair> &pairs, double deltaM);

/// Of all steps, m; byHeadings: those whose first pair has both are taken. scaleSigma: the calibration's.
std::optional<ErrorStatistics> relativeErrors(const std::vector<PosePair> &pairs,
                                              const std::vector<PathStep> &steps,
                                              const PlaneSimilarity &transform, bool byHeadings,
                                              double scaleSigma, double sigmaOffsetS);

/// Of the pairs that have both headings, rad; the amounts. origin: as of absoluteErrors.
std::optional<ErrorStatistics> headingErrors(const std::vector<PosePair> &pairs,
                                             const PlaneSimilarity &transform,
                                             const OriginAlignment *origin = nullptr);
/// The mean of the signed differences of the headings; nullopt where it is within what they scatter.
std::optional<double> lastingHeadingError(const std::vector<PosePair> &pairs,
                                          const PlaneSimilarity &transform);

} // namespace odo
