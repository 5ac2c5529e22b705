// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "tests/fault/scarce.h"

#include <QString>
#include <functional>
#include <optional>

namespace odo::test {

/// What became of a process that was given no more of something.
struct ScarceAttempt
{
    int signal = 0;             ///< that ended it
    std::uint64_t requests = 0; ///< there were
    bool hasFailed = false;     ///< one of them was refused
    std::optional<Error> error;

    QString words() const;
};

/// Forks, and does the work in the child, whose n-th request is refused (0: none). A child that takes longer
/// than a minute is ended by SIGALRM.
ScarceAttempt attemptWithout(Scarce what, std::uint64_t n, const std::function<Result<void>()> &work);

/// Likewise in a child that may open so many files more.
ScarceAttempt attemptWithFiles(unsigned files, const std::function<Result<void>()> &work);

} // namespace odo::test
