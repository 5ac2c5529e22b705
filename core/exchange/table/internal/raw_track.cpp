// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/raw_track.h"

#include <limits>

namespace odo {

namespace {

template <class Value>
void removeFrom(std::vector<Value> &values, const std::vector<bool> &marked)
{
    if (values.empty())
        return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!marked[i])
            values[kept++] = values[i];
    }
    values.resize(kept);
}

template <class Value>
void addFrom(const std::vector<Value> &from, std::size_t row, std::vector<Value> &to)
{
    if (!from.empty())
        to.push_back(from[row]);
}

} // namespace

void RawTrack::addRow(const RawTrack &from, std::size_t row)
{
    stampKind = from.stampKind;
    addFrom(from.lines, row, lines);
    addFrom(from.stamps, row, stamps);
    addFrom(from.x, row, x);
    addFrom(from.y, row, y);
    addFrom(from.z, row, z);
    addFrom(from.confidence, row, confidence);
    addFrom(from.sigmas, row, sigmas);
    addFrom(from.headings, row, headings);
}

void RawTrack::remove(const std::vector<bool> &marked)
{
    removeFrom(lines, marked);
    removeFrom(stamps, marked);
    removeFrom(x, marked);
    removeFrom(y, marked);
    removeFrom(z, marked);
    removeFrom(confidence, marked);
    removeFrom(sigmas, marked);
    removeFrom(headings, marked);
}

void RawTrack::forget(std::size_t row)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    x[row] = y[row] = none;
    if (!z.empty())
        z[row] = none;
    if (!sigmas.empty())
        sigmas[row] = {none, none};
    if (!headings.empty())
        headings[row] = none;
}

} // namespace odo
