// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/job.h"

#include "core/base/job_control.h"
#include "core/base/shortage.h"

namespace odo {

Result<void> runToEnd(Job &job, Project &project, const JobControl &control)
{
    return orShortage(cannotDoThis(), [&]() -> Result<void> {
        ODO_TRY(job.prepare(project));
        {
            const CancelScope scope(&control.cancel);
            ODO_TRY(job.run(control));
        }
        return job.commit(project);
    });
}

} // namespace odo
