// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/live_gates.h"

#include "core/trajectory/gate_passages.h"

#include <algorithm>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds window = 5s; // a robot that stands before a gate for longer has not passed it yet
constexpr Nanoseconds samePassage = 50ms;

} // namespace

std::vector<GatePassage> LiveGates::add(const LivePosition &position)
{
    if (m_gates.empty())
        return {};
    m_samples.push_back(position.sample);
    m_points.push_back(position.point);
    const auto old = std::ranges::find_if(
        m_samples, [&](const Sample &sample) { return sample.time >= position.sample.time - window; });
    m_points.erase(m_points.begin(), m_points.begin() + (old - m_samples.begin()));
    m_samples.erase(m_samples.begin(), old);
    std::vector<GatePassage> found = findPassages(m_gates, m_samples, m_points);
    std::erase_if(found, [this](const GatePassage &passage) { return isKnown(passage); });
    m_passages.insert(m_passages.end(), found.begin(), found.end());
    return found;
}

bool LiveGates::isKnown(const GatePassage &passage) const
{
    return std::ranges::any_of(m_passages, [&](const GatePassage &known) {
        return known.gate == passage.gate && std::chrono::abs(known.time - passage.time) < samePassage;
    });
}

void LiveGates::forget()
{
    m_samples.clear();
    m_points.clear();
    m_passages.clear();
}

} // namespace odo
