// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/fused_track.h"

#include "core/base/percentile.h"
#include "core/trajectory/internal/kalman_smoother.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>

namespace odo {

namespace {

// What stays of the silhouette's form and the clocks after the correction of the height.
constexpr double modelSigmaM = 0.003;
// However badly the views agree on the whole, half a robot apart is never the same position.
constexpr double largestSigmaM = 0.03;
// Enough for any floor; groups are enumerated.
constexpr std::size_t mostViews = 12;

Eigen::Matrix2d differenceCovariance(const FloorPosition &a, const FloorPosition &b)
{
    return totalCovariance(a) + totalCovariance(b) +
           Eigen::Matrix2d::Identity() * (2 * modelSigmaM * modelSigmaM);
}

double distanceSquared(const FloorPosition &a, const FloorPosition &b)
{
    const Eigen::Vector2d d = a.pointInWorld - b.pointInWorld;
    return d.dot(differenceCovariance(a, b).inverse() * d);
}

} // namespace

Eigen::Matrix2d totalCovariance(const FloorPosition &position)
{
    return position.pixelCovariance + position.calibrationCovariance;
}

FusedPosition fuse(std::span<const ViewPosition> positions)
{
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    for (const ViewPosition &one : positions)
        information += totalCovariance(one.position).inverse();
    const Eigen::Matrix2d covariance = information.inverse();

    FusedPosition fused;
    for (const ViewPosition &one : positions) {
        const Eigen::Matrix2d weight = covariance * totalCovariance(one.position).inverse();
        fused.position += weight * one.position.pointInWorld;
        fused.covariance += weight * one.position.pixelCovariance * weight.transpose();
        fused.commonCovariance +=
            weight * (one.position.calibrationCovariance + one.lastingCovariance) * weight.transpose();
        fused.displacementPerMetreHeight += weight * one.position.displacementPerMetreHeight;
        fused.views |= 1u << one.view;
    }
    return fused;
}

double largestDistance(std::span<const ViewPosition> positions)
{
    double largest = 0;
    for (std::size_t a = 0; a < positions.size(); ++a) {
        for (std::size_t b = a + 1; b < positions.size(); ++b)
            largest = std::max(
                largest, (positions[a].position.pointInWorld - positions[b].position.pointInWorld).norm());
    }
    return largest;
}

AgreementGate::AgreementGate(const std::vector<std::vector<Sighting>> &views)
{
    std::vector<double> distances, variances;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            for (std::size_t i = 0; i < std::min(views[a].size(), views[b].size()); ++i) {
                if (!views[a][i].seen || !views[b][i].seen)
                    continue;
                distances.push_back(distanceSquared(views[a][i].position, views[b][i].position));
                variances.push_back(differenceCovariance(views[a][i].position, views[b][i].position).trace() /
                                    2);
            }
        }
    }
    if (distances.empty())
        return;
    constexpr double medianOfChiSquared2 = 1.3863;
    m_scale = std::max(1.0, upperMedian(std::move(distances)) / medianOfChiSquared2);
    const double variance = upperMedian(std::move(variances));
    m_scale = std::max(1.0, std::min(m_scale, largestSigmaM * largestSigmaM / variance));
}

bool AgreementGate::agree(const ViewPosition &a, const ViewPosition &b) const
{
    return distanceSquared(a.position, b.position) <= refusalGate * m_scale;
}

std::vector<ViewPosition> AgreementGate::largestAgreeingGroup(std::span<const ViewPosition> positions) const
{
    const std::size_t count = std::min(positions.size(), mostViews);
    std::vector<ViewPosition> best;
    double bestVariance = 0;
    for (unsigned members = 1; members < (1u << count); ++members) {
        if (static_cast<std::size_t>(std::popcount(members)) < best.size())
            continue;
        std::vector<ViewPosition> group;
        for (std::size_t i = 0; i < count; ++i) {
            if (members & (1u << i))
                group.push_back(positions[i]);
        }
        bool allAgree = true;
        for (std::size_t i = 0; allAgree && i < group.size(); ++i) {
            for (std::size_t j = i + 1; allAgree && j < group.size(); ++j)
                allAgree = agree(group[i], group[j]);
        }
        if (!allAgree)
            continue;
        const FusedPosition fused = fuse(group);
        const double variance = (fused.covariance + fused.commonCovariance).trace();
        if (group.size() > best.size() || variance < bestVariance) {
            best = group;
            bestVariance = variance;
        }
    }
    return best;
}

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
    std::vector<ViewPosition> uncertain;
    bool allCut = true, areOutlines = true;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const Sighting &sighting = views[v][i];
        found.duplicate |= sighting.duplicate;
        if (!sighting.seen)
            continue;
        evidence.bestScore = std::max(evidence.bestScore, sighting.score);
        allCut &= sighting.cut;
        areOutlines &= sighting.ofOutline;
        const ViewPosition position{static_cast<std::uint32_t>(v), sighting.position,
                                    sighting.lastingCovariance};
        if (sighting.cut || sighting.score < leastScore)
            uncertain.push_back(position);
        else
            found.positions.push_back(position);
    }
    if (found.positions.empty() && !uncertain.empty()) {
        found.positions = std::move(uncertain);
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
                                  totalCovariance(contenders[c].position) +
                                  Eigen::Matrix2d::Identity() * singleViewSigmaM * singleViewSigmaM;
        const Eigen::Vector2d d = contenders[c].position.pointInWorld - estimate.position();
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

namespace {

constexpr std::size_t nodesAround =
    2; // measured nodes to either side that a step of the way is measured over

/// Fills the way up to each node: over five measured nodes each, so that pixel noise is no way.
void measureTravel(std::vector<TrackNode> &nodes)
{
    std::vector<std::size_t> measured;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].measured)
            measured.push_back(i);
    }
    double travelM = 0;
    for (std::size_t m = 1; m < measured.size(); ++m) {
        const TrackNode &before = nodes[measured[m - std::min(m, nodesAround)]];
        const TrackNode &behind = nodes[measured[std::min(measured.size() - 1, m + nodesAround)]];
        const double speed = (behind.position - before.position).norm() / (behind.timeS - before.timeS);
        const std::size_t from = measured[m - 1], to = measured[m];
        for (std::size_t i = from + 1; i <= to; ++i)
            nodes[i].travelM = travelM + (speed + restDriftMps) * (nodes[i].timeS - nodes[from].timeS);
        travelM = nodes[to].travelM;
    }
}

} // namespace

std::vector<TrackSegment> cutIntoSegments(const std::vector<Sample> &samples, Nanoseconds longestGap,
                                          const std::function<bool(const Sample &)> &isUsed)
{
    const auto used = [&](const Sample &sample) {
        return sample.position && (isUsed ? isUsed(sample) : !isRejected(sample.flags));
    };
    std::vector<bool> taken(samples.size());
    std::vector<std::pair<std::size_t, std::size_t>> stretches; // indices of the first and the last taken
    bool isBroken = false;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        isBroken = isBroken || samples[i].isAfterBreak;
        if (!used(samples[i]))
            continue;
        const bool first = stretches.empty();
        const Nanoseconds since =
            first ? Nanoseconds(0) : samples[i].time - samples[stretches.back().second].time;
        if (!first && since <= Nanoseconds(0))
            continue;
        const bool isAfterBreak = std::exchange(isBroken, false);
        if (first || since > longestGap || isAfterBreak)
            stretches.emplace_back(i, i);
        stretches.back().second = i;
        taken[i] = true;
    }
    std::vector<TrackSegment> segments;
    for (const auto &[first, last] : stretches) {
        TrackSegment &segment = segments.emplace_back(TrackSegment{first, {}, 0});
        segment.nodes.reserve(last - first + 1);
        for (std::size_t i = first; i <= last; ++i) {
            TrackNode node{toSeconds(samples[i].time)};
            if (taken[i]) {
                node.measured = true;
                node.position = *samples[i].position;
                node.covariance = samples[i].covariance;
                ++segment.measured;
            }
            segment.nodes.push_back(node);
        }
        measureTravel(segment.nodes);
    }
    return segments;
}

void markChanges(std::vector<TrackSegment> &segments, const std::vector<MotionChange> &changes)
{
    if (changes.empty())
        return;
    for (TrackSegment &segment : segments) {
        std::vector<TrackNode> &nodes = segment.nodes;
        for (std::size_t i = nodes.size(); i-- > 1;) {
            nodes[i].struck = changes[segment.first + i].struck ||
                              (i + 1 < nodes.size() && !nodes[i].measured && nodes[i + 1].struck);
            nodes[i].liveliness = changes[segment.first + i].liveliness;
        }
    }
}

std::vector<std::span<const TrackNode>> nodesOf(const std::vector<TrackSegment> &segments)
{
    std::vector<std::span<const TrackNode>> nodes;
    for (const TrackSegment &segment : segments)
        nodes.emplace_back(segment.nodes);
    return nodes;
}

} // namespace odo
