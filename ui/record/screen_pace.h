// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <optional>

namespace odo {

/// Which of a view's pictures the screen gets: of a camera of up to 40 a second all, of a faster one every
/// second, third, ... so that the steps between them stay even. (Each is recorded and tracked.) Not thread-safe.
class ScreenPace
{
public:
    /// taken: by this machine's steady clock; increasing.
    bool takes(Nanoseconds taken)
    {
        if (m_last && taken - *m_last < shortestStep)
            return false;
        m_last = taken;
        return true;
    }

private:
    static constexpr Nanoseconds shortestStep = std::chrono::milliseconds(24); // every second at 60 a second
    std::optional<Nanoseconds> m_last;
};

} // namespace odo
