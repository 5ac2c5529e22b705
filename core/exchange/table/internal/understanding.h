// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/exchange/table/track_reading.h"

#include <filesystem>
#include <vector>

namespace odo {

/// What the steps of reading a table share: the file and what a person said of it, and what they found.
struct Understanding
{
    const std::filesystem::path &file;
    const TrackReading &reading;
    std::vector<Message> facts;   ///< how the table was read: units, axes, what its times count from
    std::vector<Message> notices; ///< what was left out, with lines, and why

    /// The failure of reading it at a line; 0: of the whole file.
    tl::unexpected<Error> wrong(int line, Message why, Message advice) const;
};

} // namespace odo
