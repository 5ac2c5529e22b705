// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

namespace odo {

class Project;

/// A use case in three steps, so that long work never touches the project and the project never waits for
/// long work: prepare reads what is needed, run works on values alone, commit stores the outcome in one
/// transaction. A failed or cancelled job leaves the project as it was.
class Job
{
public:
    virtual ~Job() = default;
    /// On the project's thread; quick.
    virtual Result<void> prepare(Project &project) = 0;
    /// On any thread; long; asks control for cancellation at least ten times a second.
    virtual Result<void> run(const JobControl &control) = 0;
    /// On the project's thread; quick; one transaction.
    virtual Result<void> commit(Project &project) = 0;
};

/// All three steps on the calling thread: what the command line does.
Result<void> runToEnd(Job &job, Project &project, const JobControl &control);

} // namespace odo
