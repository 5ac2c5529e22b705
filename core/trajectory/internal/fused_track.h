// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/geometry/floor_view.h"
#include "core/trajectory/internal/floor_positions.h"
#include "core/trajectory/internal/kalman_smoother.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace odo {

/// One view's word on where the robot is.
struct ViewPosition
{
    std::uint32_t view = 0; ///< index of the view
    FloorPosition position;
    Eigen::Matrix2d lastingCovariance = Eigen::Matrix2d::Zero(); ///< Sighting's
};

/// The part of single frames and the part of the calibration together, m².
Eigen::Matrix2d totalCovariance(const FloorPosition &position);

/// Several views' word, joined.
struct FusedPosition
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();       ///< frame to frame, m²
    Eigen::Matrix2d commonCovariance = Eigen::Matrix2d::Zero(); ///< of the views' calibrations, m²
    Eigen::Vector2d displacementPerMetreHeight = Eigen::Vector2d::Zero();
    std::uint32_t views = 0; ///< bit i: view i
};

/// Minimum-variance fusion on the plane (Sankaranarayanan and Chellappa 2008, eq. 9): x = (ΣΣᵢ⁻¹)⁻¹ ΣΣᵢ⁻¹xᵢ
/// with Σᵢ the pixel and calibration parts together; the two parts are then carried through the same weights
/// apart, because only the pixel part averages out over frames. The calibrations of different views count as
/// independent. positions must not be empty.
FusedPosition fuse(std::span<const ViewPosition> positions);

/// Largest distance between two of the positions, metres; 0 for one.
double largestDistance(std::span<const ViewPosition> positions);

/// Decides whether views contradict one another, measured against how well they agree in the whole run: a
/// steady disagreement is the calibration's, a sudden one a false sighting.
class AgreementGate
{
public:
    /// views: sightings of each view at the same times, on the plane used.
    explicit AgreementGate(const std::vector<std::vector<Sighting>> &views);

    /// χ²(2) 99.9 % of the difference.
    bool agree(const ViewPosition &a, const ViewPosition &b) const;
    /// The largest group of views that all agree with one another; of equal groups the one with the smaller
    /// variance. One position: itself.
    std::vector<ViewPosition> largestAgreeingGroup(std::span<const ViewPosition> positions) const;

private:
    double m_scale = 1; ///< on the variance
};

/// What a sample was made of, for decisions and for words.
struct SampleEvidence
{
    std::vector<ViewPosition>
        contenders;       ///< positions of views that contradict each other; empty when decided
    double bestScore = 0; ///< of the views that found the robot
    bool cut = false;     ///< every view that found it has it at the frame's edge
    /// in no view is its outline what it usually is: something hides a part of it, or touches it in the frame
    bool partlySeen = false;
    /// the views contradict one another here as they do near by, and their covariances hold it
    /// (core/trajectory/view_disagreement.h)
    bool isContradicted = false;
};

/// The samples of one robot before the search for spikes; samples and evidence have equal length.
struct FusedTrack
{
    std::vector<Sample> samples;
    std::vector<SampleEvidence> evidence;
};

struct FusionSettings
{
    double planeSigmaM = 0;  ///< uncertainty of the height of the plane used; goes into the common part
    double leastScore = 0.2; ///< views below are left out, or the sample is flagged where there is no better
    MeasurementNoise measurement = {}; ///< for the decisions by motion
};

/// Joins the views at each time. Flags set: Lost, DuplicateFrame, LowScore, ViewsDisagree, and Jump with it
/// where no group of views has a majority (chooseByMotion may decide these).
FusedTrack fuseViews(const std::vector<Nanoseconds> &times, const std::vector<std::int64_t> &frames,
                     const std::vector<std::vector<Sighting>> &views, const FusionSettings &settings);

/// Where views contradict each other without a majority, takes the one view that fits the motion before and
/// after: its squared Mahalanobis distance from the smoothed track without the sample is inside χ²(2) 99.9 %
/// and every other one's outside. From the edges of such a stretch inwards. Decided samples keep
/// ViewsDisagree and lose Jump.
void chooseByMotion(FusedTrack &track, const FusionSettings &settings, Nanoseconds longestGap);

/// A stretch of samples without a long gap, from one that is used to another that is used.
struct TrackSegment
{
    std::size_t first = 0;        ///< index of the first sample
    std::vector<TrackNode> nodes; ///< one for each sample
    std::size_t measured = 0;     ///< nodes that carry a measurement
};

/// Cuts the samples where nothing is used for longer than longestGap, and at breaks. A sample is used when it
/// has a position and `isUsed` says so (by default: when its flags do not reject it). Used samples whose time
/// does not come after the last used one's are left out.
std::vector<TrackSegment> cutIntoSegments(const std::vector<Sample> &samples, Nanoseconds longestGap,
                                          const std::function<bool(const Sample &)> &isUsed = {});

/// How the motion changed on the way to a sample: as TrackNode says it.
struct MotionChange
{
    bool struck = false;
    double liveliness = 1;
};

/// Tells the nodes how the motion changed: one value for each of the samples that were cut, or none at all.
/// In a gap before a node that was struck the blow may have come anywhere.
void markChanges(std::vector<TrackSegment> &segments, const std::vector<MotionChange> &changes);

/// The segments' nodes, as estimateMotionNoise wants them.
std::vector<std::span<const TrackNode>> nodesOf(const std::vector<TrackSegment> &segments);

} // namespace odo
