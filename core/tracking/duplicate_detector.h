// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <optional>

namespace odo {

/// Recognises a picture that is the one before it again, byte for byte: what a camera or a recorder delivers
/// that was late. Looks at every 16th row first, so that a new picture costs next to nothing. Keeps a share
/// in the last frame.
class DuplicateDetector
{
public:
    bool repeatsTheLast(const Frame &frame);

private:
    std::optional<Frame> m_last;
};

} // namespace odo
