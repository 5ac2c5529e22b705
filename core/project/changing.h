// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <optional>

namespace odo {

/// Project::change of work that gives a Result with a value, which is passed on.
template <class Work>
auto changing(Project &project, const std::string &words, const Work &work) -> decltype(work())
{
    std::optional<decltype(work())> outcome;
    const Result<void> done = project.change(words, [&]() -> Result<void> {
        outcome = work();
        return *outcome ? Result<void>() : tl::unexpected(outcome->error());
    });
    if (!done)
        return tl::unexpected(done.error());
    return std::move(*outcome);
}

} // namespace odo
