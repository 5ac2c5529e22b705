// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/quick_check.h"

#include "core/project/connection.h"

namespace odo {

Result<bool> passesQuickCheck(const ProjectConnection &connection)
{
    Statement check(connection, QStringLiteral("PRAGMA quick_check(1)"));
    const auto row = check.firstRow();
    if (!row)
        return tl::unexpected(row.error());
    return *row && check.text(0) == "ok";
}

} // namespace odo
