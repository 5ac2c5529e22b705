// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/duplicate_detector.h"

#include <cstring>

namespace odo {

namespace {

bool rowsEqual(const PlaneView &a, const PlaneView &b, int step)
{
    if (a.width != b.width || a.height != b.height)
        return false;
    for (int y = 0; y < a.height; y += step) {
        if (std::memcmp(a.row(y), b.row(y), static_cast<std::size_t>(a.width)) != 0)
            return false;
    }
    return true;
}

bool framesEqual(const Frame &a, const Frame &b, int step)
{
    return rowsEqual(a.u, b.u, step) && rowsEqual(a.v, b.v, step) && rowsEqual(a.y, b.y, step);
}

} // namespace

bool DuplicateDetector::repeatsTheLast(const Frame &frame)
{
    const bool repeats = m_last && framesEqual(*m_last, frame, 16) && framesEqual(*m_last, frame, 1);
    m_last = frame;
    return repeats;
}

} // namespace odo
