// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/trial_table.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// By what the runs of a table are put together.
struct ResultGrouping
{
    enum class By { Nothing, Team, Class, Task, Robot, Variable };

    By by = By::Nothing;
    std::string variable; ///< its name, where it is by one
};

/// Whether a run's value is used: not where the run's verdict is bad, the value is a lower bound, or it
/// belongs to the task and was measured by another course than the task has now. False where there is none.
bool isUsed(const ResultTable &table, std::size_t row, std::size_t column);

/// Of some columns over some rows: column by column, the groups in the order of their names; a group without
/// values is left out. Any thread.
std::vector<ResultStatistics> resultStatistics(const ResultTable &table, std::span<const std::size_t> rows,
                                               std::span<const std::size_t> columns,
                                               const ResultGrouping &grouping);

} // namespace odo
