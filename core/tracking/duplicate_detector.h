// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"
#include "core/video/frame.h"

#include <optional>
#include <vector>

namespace odo {

/// Recognises a picture that is the one before it again, byte for byte: what a camera or a recorder delivers
/// that was late. Looks at every 16th row first, so that a new picture costs next to nothing. Of frames that
/// hold a part of their picture, the common part is compared first and, if that is equal, the whole pictures.
/// Keeps a share in the last frame.
class DuplicateDetector
{
public:
    bool repeatsTheLast(const Frame &frame);

private:
    std::optional<Frame> m_last;
};

/// Observations as those of a frame, which repeats the one before it or does not.
void stamp(std::vector<Observation> &observations, const Frame &frame, bool repeats);

} // namespace odo
