// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/profile.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace odo {

/// Samples of a series that may be too long to be held at once: so many of them, made or read in chunks from `first` on. An
/// error that a chunk gives ends whatever asked for it.
struct SampleSource
{
    std::size_t count = 0;
    std::function<Result<std::vector<Sample>>(std::size_t first, std::size_t count)> chunk;
};

/// Those of a vector, which must outlive it.
inline SampleSource sourceOf(const std::vector<Sample> &samples)
{
    return {samples.size(), [&samples](std::size_t first, std::size_t count) -> Result<std::vector<Sample>> {
                const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(first);
                return std::vector<Sample>(begin, begin + static_cast<std::ptrdiff_t>(count));
            }};
}

} // namespace odo
