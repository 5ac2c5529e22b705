// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"

namespace odo {

/// The background of a camera that is running: learned anew whenever about half as much again has moved before it. One thread at a time.
class LiveBackground
{
public:
    /// Every frame in order. A background where a newer one was learned.
    std::optional<Background> add(const Frame &frame);

private:
    BackgroundLearner m_learner;
    std::int64_t m_next = 20; ///< moving frames at which it is learned: after fewer the robot's first place is a part of it
    Nanoseconds m_lastLook{Nanoseconds::min()};
};

} // namespace odo
