// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/run_alignment.h"

#include "core/trajectory/gate_passages.h"
#include "core/trajectory/motion_stretches.h"

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

} // namespace odo
