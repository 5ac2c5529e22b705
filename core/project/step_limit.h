// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

struct sqlite3;

namespace odo {

struct ProjectConnection;

/// While it lives, the statements of a connection may take so many steps of SQLite's virtual machine in all; one that would take more
/// fails with InvalidInput, "the file is damaged". One at a time for a connection, on its thread.
class StepLimit
{
public:
    StepLimit(const ProjectConnection &connection, std::int64_t most);
    ~StepLimit();
    StepLimit(const StepLimit &) = delete;
    StepLimit &operator=(const StepLimit &) = delete;

private:
    static int onSteps(void *limit);

    sqlite3 *const m_handle;
    std::int64_t m_left;
};

} // namespace odo
