// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/guidance_repository.h"

#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"

#include <algorithm>

namespace odo {

namespace {

constexpr std::size_t fewestAreaCorners = 3;
constexpr double mostPixel = 1e6;

constexpr StoredWords<GuidanceItem::Kind, 4> guidanceKindWords{{{GuidanceItem::Kind::Ignore, "ignore"},
                                                                {GuidanceItem::Kind::Search, "search"},
                                                                {GuidanceItem::Kind::Point, "point"},
                                                                {GuidanceItem::Kind::Hidden, "hidden"}}};

Message guidanceSubject(const GuidanceItem &item)
{
    switch (item.kind) {
    case GuidanceItem::Kind::Ignore:
        return ODO_TEXT("project.ignored_area", "ignored area");
    case GuidanceItem::Kind::Search:
        return ODO_TEXT("project.search_area", "search area");
    case GuidanceItem::Kind::Point:
        return ODO_TEXT("project.point_by_hand", "point set by hand");
    case GuidanceItem::Kind::Hidden:
        break;
    }
    return ODO_TEXT("project.not_visible_span", "time in which a robot is not visible");
}

bool isArea(const GuidanceItem &item)
{
    return item.kind == GuidanceItem::Kind::Ignore || item.kind == GuidanceItem::Kind::Search;
}

Result<void> checkGuidance(const GuidanceItem &item)
{
    const auto refuse = [&](const Message &why, const Message &advice) {
        return fail(ErrorCode::InvalidInput, guidanceSubject(item), why, advice);
    };
    const std::size_t count = item.pointsPx.size();
    if (isArea(item) && count < fewestAreaCorners)
        return refuse(
            ODO_TEXT("project.area_few_corners", "an area needs at least %1 corners")(fewestAreaCorners),
            ODO_TEXT("project.give_more_corners", "give more corners"));
    if (isArea(item) && count > mostAreaCorners)
        return refuse(
            ODO_TEXT("project.area_many_corners", "an area has at most %1 corners")(mostAreaCorners),
            ODO_TEXT("project.give_fewer_corners", "give fewer corners, or two areas"));
    const bool isInFrame = std::ranges::all_of(item.pointsPx, [](const Eigen::Vector2d &point) {
        return point.allFinite() && point.cwiseAbs().maxCoeff() <= mostPixel;
    });
    if (!isInFrame)
        return refuse(ODO_TEXT("project.area_off_frame", "a position is not in the frame"),
                      ODO_TEXT("project.give_frame_pixels", "give positions in pixels of the frame"));
    if (item.kind == GuidanceItem::Kind::Point &&
        !(count == 1 && item.sigmaPx > 0 && item.sigmaPx <= mostPixel))
        return refuse(ODO_TEXT("project.point_without_sigma", "it needs one position and a σ above 0 px"),
                      ODO_TEXT("project.give_sigma_px", "give σ in pixels"));
    if (item.fromFrame < 0 || item.toFrame < item.fromFrame)
        return refuse(ODO_TEXT("project.frames_in_wrong_order", "it ends before it starts"),
                      ODO_TEXT("project.give_frames_in_order", "give the start before the end"));
    return {};
}

} // namespace

GuidanceRepository::GuidanceRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<GuidanceItem> GuidanceRepository::add(const GuidanceItem &item)
{
    ODO_TRY(checkGuidance(item));
    return transact(m_connection, [&]() -> Result<GuidanceItem> {
        Statement count(m_connection, QStringLiteral("SELECT COUNT(*) FROM guidance WHERE recording_id=?"));
        ODO_TRY(count.bind(item.recording).firstRow());
        if (count.integer(0) >= std::int64_t(mostGuidanceItems))
            return fail(
                ErrorCode::InvalidInput, guidanceSubject(item),
                ODO_TEXT("project.guidance_too_many", "the view already has %1 of them")(mostGuidanceItems),
                ODO_TEXT("project.remove_guidance", "remove some first"));
        std::vector<double> numbers;
        for (const Eigen::Vector2d &point : item.pointsPx)
            numbers.insert(numbers.end(), {point.x(), point.y()});
        Statement insert(m_connection, QStringLiteral("INSERT INTO guidance (recording_id, robot_id, kind, "
                                                      "from_frame, to_frame, points, sigma_px) VALUES "
                                                      "(?,NULLIF(?,0),?,?,?,?,?)"));
        insert.bind(item.recording).bind(item.robot).bind(storedWord(guidanceKindWords, item.kind));
        insert.bind(item.fromFrame).bind(item.toFrame).bind(packNumbers(numbers));
        ODO_TRY(insert.bind(item.sigmaPx).run());
        GuidanceItem stored = item;
        stored.id = insert.insertedId();
        return stored;
    });
}

Result<void> GuidanceRepository::remove(RecordId item)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement known(m_connection, QStringLiteral("SELECT 1 FROM guidance WHERE id=?"));
        if (!ODO_TRY(known.bind(item).firstRow()))
            return fail(ErrorCode::NotFound, ODO_TEXT("project.guidance", "guidance of the tracker"),
                        ODO_TEXT("project.guidance_is_gone", "it was removed meanwhile"),
                        ODO_TEXT("project.choose_from_list", "choose one from the list"));
        return runFor(m_connection, "DELETE FROM guidance WHERE id=?", item);
    });
}

Result<std::vector<GuidanceItem>> GuidanceRepository::of(RecordId trial) const
{
    std::vector<GuidanceItem> items;
    const Message what = ODO_TEXT("project.guidance", "guidance of the tracker");
    Statement select(m_connection,
                     QStringLiteral("SELECT guidance.id, recording_id, COALESCE(robot_id, 0), kind, "
                                    "from_frame, to_frame, points, sigma_px FROM guidance JOIN recording ON "
                                    "recording.id=recording_id WHERE trial_id=? ORDER BY guidance.id"));
    auto read = select.bind(trial).eachRow([&](const Statement &row) -> Result<void> {
        GuidanceItem item;
        item.kind = ODO_TRY(fromStoredWord(guidanceKindWords, row.text(3), what));
        item.id = row.integer(0);
        item.recording = row.integer(1);
        item.robot = row.integer(2);
        item.fromFrame = row.integer(4);
        item.toFrame = row.integer(5);
        const auto numbers = ODO_TRY(unpackNumbers(row.blob(6), what));
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            item.pointsPx.emplace_back(numbers[i], numbers[i + 1]);
        item.sigmaPx = row.real(7);
        if (checkGuidance(item)) // what another program wrote may be anything
            items.push_back(std::move(item));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return items;
}

} // namespace odo
