// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/error.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace odo {

/// Where a robot itself believes to be: a line of its own log, by its own clock and in its own axes.
struct LogPose
{
    double timeS = 0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    std::optional<double> headingRad = {}; ///< anticlockwise from the log's X
};

/// How a log is put into the world's axes before its errors are taken.
enum class LogAlignment {
    None,   ///< not at all
    Origin, ///< its first common pose onto the measured one
    Se2,    ///< turned and shifted for the least squared distances (Umeyama 1991)
    Sim2,   ///< and scaled
};
/// "none", "origin", "se2", "sim2".
std::string_view wordOf(LogAlignment alignment);
std::optional<LogAlignment> logAlignmentOf(std::string_view word);

/// From the log's axes to the world's: scaled, turned, shifted.
struct PlaneSimilarity
{
    Eigen::Vector2d shiftM = Eigen::Vector2d::Zero();
    double headingRad = 0, scale = 1;

    Eigen::Vector2d operator()(const Eigen::Vector2d &point) const;
};

/// The log's clock against the trial's: what the log stamps t was measured at the trial's time
/// t + offset + rate · (t − middle).
struct LogClock
{
    double offsetS = 0; ///< at middleS
    double sigmaOffsetS =
        0; ///< with what the calibration's part of the positions' uncertainty puts along the motion
    double rate = 0, sigmaRate = 0; ///< by how much it is too slow; 0 where that is not significant
    double middleS = 0;             ///< of what was compared, by the log's clock
    bool isGiven = false;           ///< by a person, without a σ

    double trialTimeS(double logTimeS) const { return logTimeS + offsetS + rate * (logTimeS - middleS); }
};

/// Errors in numbers. The standard deviation is that of the errors about their mean, divided by their number.
struct ErrorStatistics
{
    std::size_t count = 0;
    double rmse = 0, mean = 0, median = 0, std = 0, least = 0, most = 0;
    /// Root mean square of what the uncertainty of the measurement alone makes of such an error.
    double measurementSigma = 0;

    /// The measurement alone may be the reason: the root mean square is not beyond what chance gives in 95 of
    /// 100 cases where the log is right. The calibration's part is one draw for all of a run, so that is the
    /// distribution of one error of two coordinates (Rayleigh: √(ln 20) of its root mean square).
    bool isWithinUncertainty() const;
};
ErrorStatistics statisticsOf(std::vector<double> errors);

struct EvaluationOptions
{
    LogAlignment alignment = LogAlignment::Se2;
    double deltaM = 1;             ///< distance travelled over which the relative error is taken
    std::optional<double> offsetS; ///< LogClock::offsetS where a person knows it; empty: it is estimated
};

/// A log held against a measured run. SI.
struct LogEvaluation
{
    LogClock clock;
    LogAlignment alignment = LogAlignment::Se2;
    PlaneSimilarity transform;
    /// Of Origin: it was turned by the two headings of the first common pose; else by the first stretch.
    bool isTurnedByHeading = false;
    std::size_t inGaps = 0, outside = 0; ///< poses left out: nothing was measured then
    ErrorStatistics ape;                 ///< m; count: the common poses
    std::optional<ErrorStatistics> rpe;  ///< m; empty: no stretch of that length
    bool isRpeOfPoses = false; ///< false: of displacements in the world's axes, for want of headings
    std::optional<ErrorStatistics> heading; ///< rad, of their amounts; empty: one of both has none
    double pathM = 0;                       ///< as measured, over the common time
    double driftPercent = 0, sigmaDriftPercent = 0;
    std::vector<Message> remarks; ///< whole sentences on what the user should know
};

/// Holds a robot's own log against its measured run. Each pose of the log is compared with the measured one
/// at the same time: the cubic through the two smoothed points round it; none in a gap or where positions
/// were bridged. The time offset comes from the profiles of speed and turning, then from the positions
/// (internal/clock_fit.h).
///
/// Absolute pose error (APE): distance of the aligned log from the measured position (Sturm et al. 2012, "A
/// benchmark for the evaluation of RGB-D SLAM systems"). Relative pose error (RPE): over each stretch of
/// deltaM of the measured path (to 10 %, from every pose, not across gaps), the length of the translation of
/// (Qᵢ⁻¹Qⱼ)⁻¹(Pᵢ⁻¹Pⱼ) with measured poses Q and the log's P; where one of both has no headings, all are
/// taken as turned alike (Zhang & Scaramuzza 2018, "A tutorial on quantitative trajectory evaluation").
/// These are the figures of evo (Grupp 2017) for the same pairs of poses: evo_ape, and evo_rpe --delta_unit m
/// --all_pairs --pairs_from_reference. Alignment is not weighted by σ, as there: the log's own errors, whose
/// size nobody states, outweigh those of the measurement. Drift: distance of the ends in % of the measured
/// path, aligned at the origin.
///
/// Pure; any thread. Undetermined: no common time, a run whose motion determines no offset, a log of other
/// motion. subject: what errors are about.
Result<LogEvaluation> evaluateLog(const Profile &measured, const std::vector<LogPose> &log,
                                  const EvaluationOptions &options, const Message &subject);

} // namespace odo
