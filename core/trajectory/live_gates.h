// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/live_track.h"

#include <vector>

namespace odo {

/// Tells while a robot drives when it passes the gates of its task, by the same rule as the analysis
/// (findPassages), with what is known a moment later. Not thread-safe.
class LiveGates
{
public:
    explicit LiveGates(std::vector<Gate> gates) : m_gates(std::move(gates)) {}

    /// The passages that this position makes certain; positions come in order of time.
    std::vector<GatePassage> add(const LivePosition &position);
    /// All since the beginning, in order of time.
    const std::vector<GatePassage> &passages() const { return m_passages; }
    void forget();

private:
    bool isKnown(const GatePassage &passage) const;

    std::vector<Gate> m_gates;
    std::vector<Sample> m_samples;      ///< of the last seconds
    std::vector<ProfilePoint> m_points; ///< the same
    std::vector<GatePassage> m_passages;
};

} // namespace odo
