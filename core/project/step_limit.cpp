// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/step_limit.h"

#include "core/project/connection.h"

#include <sqlite3.h>

namespace odo {

namespace {

constexpr int stepsBetweenCalls = 10'000;

} // namespace

StepLimit::StepLimit(const ProjectConnection &connection, std::int64_t most) : m_handle(connection.handle()), m_left(most)
{
    sqlite3_progress_handler(m_handle, stepsBetweenCalls, &StepLimit::onSteps, this);
}

StepLimit::~StepLimit()
{
    sqlite3_progress_handler(m_handle, 0, nullptr, nullptr);
}

int StepLimit::onSteps(void *limit)
{
    auto &self = *static_cast<StepLimit *>(limit);
    self.m_left -= stepsBetweenCalls;
    return self.m_left < 0 ? 1 : 0;
}

} // namespace odo
