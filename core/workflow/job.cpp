// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/job.h"

namespace odo {

Result<void> runToEnd(Job &job, Project &project, const JobControl &control)
{
    if (auto prepared = job.prepare(project); !prepared)
        return prepared;
    if (auto done = job.run(control); !done)
        return done;
    return job.commit(project);
}

} // namespace odo
