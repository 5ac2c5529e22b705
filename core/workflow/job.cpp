// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/job.h"

#include "core/base/job_control.h"
#include "core/base/shortage.h"

namespace odo {

Result<void> runToEnd(Job &job, Project &project, const JobControl &control)
{
    return orShortage(cannotDoThis(), [&]() -> Result<void> {
        if (auto prepared = job.prepare(project); !prepared)
            return prepared;
        {
            const CancelScope scope(&control.cancel);
            if (auto done = job.run(control); !done)
                return done;
        }
        return job.commit(project);
    });
}

} // namespace odo
