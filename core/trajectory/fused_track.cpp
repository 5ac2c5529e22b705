// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/fused_track.h"

#include "core/trajectory/kalman_smoother.h"
#include "core/trajectory/track_segments.h"

#include <Eigen/LU>

namespace odo {

namespace {

// Calibration and form put a single view a little beside the fused track.
constexpr double singleViewSigmaM = 0.005;
// Each pass decides what lies next to decided samples; a stretch longer than twice this is given up.
constexpr int mostFusionPasses = 30;

void take(Sample &sample, const std::vector<ViewPosition> &group, double planeSigmaM)
{
    const FusedPosition fused = fuse(group);
    sample.position = fused.position;
    sample.covariance = fused.covariance;
    const Eigen::Vector2d shift = planeSigmaM * fused.displacementPerMetreHeight;
    sample.commonCovariance = fused.commonCovariance + shift * shift.transpose();
    sample.views = fused.views;
}

/// The views that found the robot: the sure ones, or all when none is sure.
struct Found
{
    std::vector<ViewPosition> positions;
    bool sure = true;
    bool duplicate = false;
};

Found collect(const std::vector<std::vector<Sighting>> &views, std::size_t i, double leastScore,
              SampleEvidence &evidence)
{
    Found found;
    std::vector<ViewPosition> doubtful;
    bool allCut = true, areOutlines = true;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const Sighting &sighting = views[v][i];
        found.duplicate |= sighting.duplicate;
        if (!sighting.seen)
            continue;
        evidence.bestScore = std::max(evidence.bestScore, sighting.score);
        allCut &= sighting.cut;
        areOutlines &= sighting.ofOutline;
        const ViewPosition position{static_cast<std::uint32_t>(v), sighting.place};
        if (sighting.cut || sighting.score < leastScore)
            doubtful.push_back(position);
        else
            found.positions.push_back(position);
    }
    if (found.positions.empty() && !doubtful.empty()) {
        found.positions = std::move(doubtful);
        found.sure = false;
        evidence.cut = allCut;
        evidence.partlySeen = areOutlines;
    }
    return found;
}

} // namespace

FusedTrack fuseViews(const std::vector<Nanoseconds> &times, const std::vector<std::int64_t> &frames,
                     const std::vector<std::vector<Sighting>> &views, const FusionSettings &settings)
{
    const AgreementGate gate(views);
    FusedTrack track;
    track.samples.resize(times.size());
    track.evidence.resize(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        Sample &sample = track.samples[i];
        SampleEvidence &evidence = track.evidence[i];
        sample.time = times[i];
        sample.frame = frames[i];
        const Found found = collect(views, i, settings.leastScore, evidence);
        if (found.positions.empty()) {
            sample.flags = flagBit(found.duplicate ? SampleFlag::DuplicateFrame : SampleFlag::Lost);
            continue;
        }
        if (!found.sure)
            sample.flags |= flagBit(SampleFlag::LowScore);
        if (found.positions.size() > 1)
            sample.viewDisagreementM = largestDistance(found.positions);
        const auto group = gate.largestAgreeingGroup(found.positions);
        take(sample, group, settings.planeSigmaM);
        if (group.size() == found.positions.size())
            continue;
        sample.flags |= flagBit(SampleFlag::ViewsDisagree);
        if (2 * group.size() <= found.positions.size()) {
            sample.flags |= flagBit(SampleFlag::Jump);
            evidence.contenders = found.positions;
        }
    }
    return track;
}

namespace {

/// Index of the one contender that fits the estimate, if there is exactly one.
std::optional<std::size_t> onlyFit(const std::vector<ViewPosition> &contenders,
                                   const MotionEstimate &estimate)
{
    std::optional<std::size_t> fit;
    for (std::size_t c = 0; c < contenders.size(); ++c) {
        const Eigen::Matrix2d s = estimate.covariance.topLeftCorner<2, 2>() +
                                  totalCovariance(contenders[c].place) +
                                  Eigen::Matrix2d::Identity() * singleViewSigmaM * singleViewSigmaM;
        const Eigen::Vector2d d = contenders[c].place.pointInWorld - estimate.position();
        if (d.dot(s.inverse() * d) > refusalGate)
            continue;
        if (fit)
            return std::nullopt;
        fit = c;
    }
    return fit;
}

bool decideOnce(FusedTrack &track, const FusionSettings &settings, const std::vector<TrackSegment> &segments,
                MotionNoise noise)
{
    bool decided = false;
    for (const TrackSegment &segment : segments) {
        if (segment.measured < 3)
            continue;
        smoothMotion(segment.nodes, noise, [&](std::size_t i, const MotionEstimate &estimate) {
            auto &contenders = track.evidence[segment.first + i].contenders;
            if (contenders.empty())
                return;
            const auto fit = onlyFit(contenders, estimate);
            if (!fit)
                return;
            Sample &sample = track.samples[segment.first + i];
            take(sample, {contenders[*fit]}, settings.planeSigmaM);
            sample.flags &= ~flagBit(SampleFlag::Jump);
            contenders.clear();
            decided = true;
        });
    }
    return decided;
}

bool hasContenders(const FusedTrack &track)
{
    return std::any_of(track.evidence.begin(), track.evidence.end(),
                       [](const SampleEvidence &evidence) { return !evidence.contenders.empty(); });
}

} // namespace

void chooseByMotion(FusedTrack &track, const FusionSettings &settings, Nanoseconds longestGap)
{
    if (!hasContenders(track))
        return;
    auto segments = cutIntoSegments(track.samples, longestGap);
    const MotionNoise noise = estimateMotionNoise(nodesOf(segments), true, settings.measurement);
    for (int pass = 0; pass < mostFusionPasses && hasContenders(track); ++pass) {
        if (!decideOnce(track, settings, segments, noise))
            break;
        segments = cutIntoSegments(track.samples, longestGap);
    }
}

} // namespace odo
