// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <cstdint>
#include <optional>

namespace odo {

/// Whether the lines of whole frames are of two moments, by what moves in them: where the odd lines were
/// taken later than the even ones, what moves is nearer in them to the next even lines than to those before.
/// Independent of what the file says. Not thread-safe.
class FieldMotion
{
public:
    enum class Kind {
        Unknown,     ///< too little moved, or it is neither
        Progressive, ///< all lines are of one moment
        TopFirst,
        BottomFirst
    };

    /// One frame more. Those that follow one another directly are compared where they differ within the
    /// region, in luma pixels; in all of them without one.
    void add(const Frame &frame, const std::optional<PixelRect> &region = {});
    Kind kind() const;
    /// Nothing more needs to be added.
    bool isClear() const { return m_pixels > plenty && kind() != Kind::Unknown; }

private:
    static constexpr std::int64_t plenty = 8000;

    void compare(const Frame &before, const Frame &frame, const PixelRect &region);

    std::optional<Frame> m_before;
    std::int64_t m_pixels = 0; ///< that differed
    double m_within = 0;       ///< of two frames, each field with its like, in steps of luma
    double m_forwards = 0;     ///< the top field with the bottom field of the next frame
    double m_backwards = 0;    ///< the bottom field with the top field of the next frame
};

} // namespace odo
