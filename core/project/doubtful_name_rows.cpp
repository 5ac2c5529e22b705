// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/doubtful_name_rows.h"

#include "core/project/connection.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace odo {

Result<void> addDoubtfulNames(ProjectConnection &connection, RecordId analysis, const std::vector<DoubtfulName> &doubts)
{
    for (std::size_t i = 0; i < doubts.size(); ++i) {
        const DoubtfulName &doubt = doubts[i];
        const auto position = static_cast<std::int64_t>(i);
        Statement insert(connection, QStringLiteral("INSERT INTO doubtful_name VALUES (?,?,?,?)"));
        insert.bind(analysis).bind(position).bind(static_cast<std::int64_t>(doubt.from.count()));
        if (auto done = insert.bind(static_cast<std::int64_t>(doubt.to.count())).run(); !done)
            return done;
        for (const RecordId other : doubt.others) {
            Statement insertOther(connection, QStringLiteral("INSERT INTO doubtful_name_robot VALUES (?,?,?)"));
            if (auto done = insertOther.bind(analysis).bind(position).bind(other).run(); !done)
                return done;
        }
    }
    return {};
}

Result<std::vector<DoubtfulName>> readDoubtfulNames(const ProjectConnection &connection, RecordId analysis)
{
    std::vector<DoubtfulName> doubts;
    std::optional<std::int64_t> last;
    Statement select(connection, QStringLiteral("SELECT doubtful_name.position, from_ns, to_ns, robot_id, robot.name FROM doubtful_name "
                                                  "LEFT JOIN doubtful_name_robot USING (analysis_id, position) "
                                                  "LEFT JOIN robot ON robot.id=robot_id WHERE analysis_id=? "
                                                  "ORDER BY doubtful_name.position, robot_id"));
    auto read = select.bind(analysis).eachRow([&](const Statement &row) -> Result<void> {
        if (last != row.integer(0)) {
            constexpr std::int64_t latest = std::numeric_limits<std::int64_t>::max() / 2; // so that times can be subtracted
            const Nanoseconds from(std::clamp<std::int64_t>(row.integer(1), 0, latest)), to(std::clamp<std::int64_t>(row.integer(2), 0, latest));
            doubts.push_back({std::min(from, to), std::max(from, to), {}, {}});
        }
        last = row.integer(0);
        if (row.integer(3) != 0) {
            doubts.back().others.push_back(row.integer(3));
            doubts.back().otherNames.push_back(row.name(4));
        }
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return doubts;
}

} // namespace odo
