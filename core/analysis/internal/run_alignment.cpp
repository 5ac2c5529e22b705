// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/internal/run_alignment.h"

#include "core/analysis/gate_passages.h"
#include "core/analysis/motion_stretches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace odo {

std::string_view alignByWord(AlignBy by)
{
    switch (by) {
    case AlignBy::StartGate:
        return "start_gate";
    case AlignBy::MotionOnset:
        return "motion_onset";
    case AlignBy::Distance:
        return "distance";
    case AlignBy::ByHand:
        break;
    }
    return "hand";
}

std::optional<AlignedMoment> startGateMoment(const Task &task, const std::vector<Sample> &samples,
                                             const std::vector<ProfilePoint> &points)
{
    const auto start = std::find_if(task.gates.begin(), task.gates.end(), [](const Gate &gate) {
        return gate.role == GateRole::Start || gate.role == GateRole::StartFinish;
    });
    if (start == task.gates.end())
        return std::nullopt;
    const std::vector<GatePassage> passages = findPassages({*start}, samples, points);
    if (passages.empty())
        return std::nullopt;
    const GatePassage &first = passages.front();
    const double own = std::sqrt(std::max(0.0, std::pow(first.sigmaS, 2) - std::pow(first.commonSigmaS, 2)));
    return AlignedMoment{toSeconds(first.time), own, first.commonSigmaS};
}

std::optional<AlignedMoment> onsetMoment(const std::vector<Sample> &samples,
                                         const std::vector<ProfilePoint> &points)
{
    const std::vector<RunInstant> instants = validInstants(samples, points);
    const std::vector<MotionStretch> motions = findMotions(instants);
    if (motions.empty() || motions.front().first == 0)
        return std::nullopt;
    return AlignedMoment{motions.front().startS, sigmaOfMoment(instants, motions.front().first), 0};
}

AlignedMoment handMoment(double timeS, const std::vector<Sample> &samples)
{
    if (samples.size() < 2)
        return {timeS, 0, 0};
    const double wholeS = toSeconds(samples.back().time - samples.front().time);
    return {timeS, wholeS / static_cast<double>(samples.size() - 1) / std::sqrt(12.0), 0};
}

std::optional<double> firstMotionS(const std::vector<Sample> &samples,
                                   const std::vector<ProfilePoint> &points)
{
    const std::vector<MotionStretch> motions = findMotions(validInstants(samples, points));
    if (motions.empty())
        return std::nullopt;
    return motions.front().startS;
}

namespace {

constexpr double leastStepM = 0.005;
constexpr double closingShare = 0.05, leastClosingM = 0.03; // of the extent: how near to its start a lap ends
constexpr double sameDirection = 0.707;                     // cosine of 45°

/// Where the first lap ends: nearest to the start after having been far from it; 0: it never comes back.
std::size_t endOfLap(const std::vector<Eigen::Vector2d> &points, double extentM)
{
    const auto away = [&](std::size_t i) { return (points[i] - points.front()).norm(); };
    const auto direction = [&](std::size_t i) { return (points[i + 1] - points[i]).normalized(); };
    bool wasFar = false;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        wasFar = wasFar || away(i) > extentM / 2;
        const bool isBack = wasFar && away(i) < std::max(leastClosingM, closingShare * extentM);
        if (isBack && away(i) <= away(i + 1) && direction(i).dot(direction(0)) > sameDirection)
            return i;
    }
    return 0;
}

} // namespace

double extentOf(const ReferencePath &path)
{
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d &point : path.points)
        box.extend(point);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

ReferencePath pathOfRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    const std::vector<RunInstant> instants = validInstants(samples, points);
    const std::vector<MotionStretch> motions = findMotions(instants);
    ReferencePath path;
    if (motions.empty())
        return path;
    for (std::size_t i = motions.front().first; i <= motions.back().last; ++i) {
        const Eigen::Vector2d &place = instants[i].point->position;
        if (path.points.empty() || (place - path.points.back()).norm() >= leastStepM)
            path.points.push_back(place);
    }
    if (path.points.size() < 2)
        return {};
    if (const std::size_t end = endOfLap(path.points, extentOf(path)); end > 0) {
        path.points.resize(end); // the straight piece back to the start takes the place of the last step
        path.closed = true;
    }
    return path;
}

ReferencePath reversed(ReferencePath path)
{
    std::reverse(path.points.begin() + (path.closed ? 1 : 0), path.points.end());
    return path;
}

} // namespace odo
