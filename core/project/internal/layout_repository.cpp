// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task.h"
#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <set>

namespace odo {

namespace {

/// A stored position, limited to the extent of a floor.
Eigen::Vector2d onFloor(const Eigen::Vector2d &point)
{
    constexpr double furthestM = 1000; // as isOnFloor has it
    return point.cwiseMax(-furthestM).cwiseMin(furthestM);
}

Result<void> checkMarkers(const MarkerLayout &layout)
{
    if (layout.markers.size() > mostMarkers)
        return fail(ErrorCode::InvalidInput, layoutSubject(layout.name),
                    ODO_TEXT("project.too_many_markers", "it has more than %1 markers")(mostMarkers),
                    ODO_TEXT("project.leave_out_unseen_markers", "remove those that no camera sees"));
    std::set<std::string> labels;
    for (const Marker &marker : layout.markers) {
        ODO_TRY(checkName(RecordKind::Marker, marker.label));
        if (!isOnFloor(marker.pointInWorld))
            return fail(ErrorCode::InvalidInput, layoutSubject(layout.name),
                        ODO_TEXT("project.marker_off_floor",
                                 "marker '%1' is not within a floor of 1 km")(Named::marker(marker.label)),
                        checkTheNumbers());
        if (!labels.insert(marker.label).second)
            return fail(
                ErrorCode::InvalidInput, layoutSubject(layout.name),
                ODO_TEXT("project.label_twice", "the label '%1' appears twice")(Named::marker(marker.label)),
                labelEachMarker());
    }
    return {};
}

Result<LayoutRecord> readLayout(const ProjectConnection &connection, RecordId id, const std::string &name)
{
    LayoutRecord record{id, {name, {}}};
    Statement select(
        connection,
        QStringLiteral("SELECT label, x_m, y_m FROM marker WHERE layout_id=? ORDER BY position LIMIT ?"));
    auto read = select.bind(id)
                    .bind(static_cast<std::int64_t>(mostMarkers))
                    .eachRow([&record](const Statement &row) -> Result<void> {
                        record.layout.markers.push_back({row.name(0), onFloor({row.real(1), row.real(2)})});
                        return {};
                    });
    if (!read)
        return tl::unexpected(read.error());
    return record;
}

} // namespace

LayoutRepository::LayoutRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<LayoutRecord> LayoutRepository::add(const MarkerLayout &given)
{
    MarkerLayout layout = given;
    layout.name = normalName(given.name);
    return transact(m_connection, [&]() -> Result<LayoutRecord> {
        ODO_TRY(checkName(RecordKind::Layout, layout.name));
        ODO_TRY(checkMarkers(layout));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Layout, layout.name));
        Statement insert(m_connection, QStringLiteral("INSERT INTO layout (name) VALUES (?)"));
        ODO_TRY(insert.bind(layout.name).run());
        const RecordId id = insert.insertedId();
        for (std::size_t i = 0; i < layout.markers.size(); ++i) {
            const Marker &marker = layout.markers[i];
            Statement row(m_connection, QStringLiteral("INSERT INTO marker VALUES (?,?,?,?,?)"));
            row.bind(id).bind(static_cast<std::int64_t>(i)).bind(marker.label);
            ODO_TRY(row.bind(marker.pointInWorld.x()).bind(marker.pointInWorld.y()).run());
        }
        return LayoutRecord{id, layout};
    });
}

Result<std::vector<LayoutRecord>> LayoutRepository::all() const
{
    std::vector<LayoutRecord> layouts;
    Statement select(m_connection, QStringLiteral("SELECT id, name FROM layout ORDER BY id"));
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        layouts.push_back(ODO_TRY(readLayout(m_connection, row.integer(0), row.name(1))));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return layouts;
}

Result<LayoutRecord> LayoutRepository::find(const std::string &name) const
{
    const auto id = ODO_TRY(idNamed(m_connection, RecordKind::Layout, name));
    if (id == 0)
        return noSuchName(m_connection, RecordKind::Layout, name);
    return get(id);
}

Result<LayoutRecord> LayoutRepository::get(RecordId id) const
{
    Statement select(m_connection, QStringLiteral("SELECT id, name FROM layout WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(m_connection, RecordKind::Layout, id);
    return readLayout(m_connection, select.integer(0), select.name(1));
}

Result<void> LayoutRepository::setPoints(const LayoutRecord &layout)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto stored = ODO_TRY(get(layout.id));
        if (!std::ranges::equal(stored.layout.markers, layout.layout.markers, {}, &Marker::label,
                                &Marker::label))
            return fail(ErrorCode::InvalidInput, layoutSubject(stored.layout.name),
                        ODO_TEXT("project.other_labels", "the labels differ from those of the layout"),
                        ODO_TEXT("project.add_another_layout", "add another layout for other markers"));
        ODO_TRY(checkMarkers({stored.layout.name, layout.layout.markers}));
        for (std::size_t i = 0; i < layout.layout.markers.size(); ++i) {
            const Marker &marker = layout.layout.markers[i];
            Statement update(
                m_connection,
                QStringLiteral("UPDATE marker SET x_m=?, y_m=? WHERE layout_id=? AND position=?"));
            update.bind(marker.pointInWorld.x()).bind(marker.pointInWorld.y()).bind(layout.id);
            ODO_TRY(update.bind(static_cast<std::int64_t>(i)).run());
        }
        return {};
    });
}

} // namespace odo
