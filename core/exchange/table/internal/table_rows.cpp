// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/table_rows.h"

#include "core/exchange/table/internal/table_reader.h"
#include "core/exchange/text_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr std::size_t mostPositions = 1'500'000; // with what is computed of them they take half a gigabyte
constexpr std::size_t mostTracks = 1000;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string shown(std::string_view cell)
{
    return std::string(cell.substr(0, 40));
}

/// The yaw of a quaternion. NaN: it is none, or not that of a robot whose Z axis points up.
double yawOf(const Eigen::Vector4d &q)
{
    constexpr double leastUpright = 0.7, mostOffUnit = 0.1;
    if (!(std::abs(q.norm() - 1) < mostOffUnit))
        return none;
    const Eigen::Matrix3d axes = Eigen::Quaterniond(Eigen::Vector4d(q.normalized())).toRotationMatrix();
    return axes(2, 2) < leastUpright ? none : std::atan2(axes(1, 0), axes(0, 0));
}

} // namespace

TableRows::TableRows(RawTable table, NumberStyle style, char delimiter, const TrackReading &reading,
                     const std::filesystem::path &file)
    : m_table(std::move(table)), m_style(style), m_endsWithDelimiter(delimiter != ' '), m_reading(reading),
      m_file(file)
{
    if (m_table.columns.id)
        return; // each row says its track
    for (const TrackColumns &columns : m_table.columns.tracks) {
        RawTrack &track = m_table.tracks.emplace_back();
        track.name = columns.name;
        track.columns = columns;
    }
}

tl::unexpected<Error> TableRows::wrong(Message why, Message advice) const
{
    return fail(ErrorCode::InvalidInput, atLineOf(m_file, m_reading, std::max(1, m_line)), std::move(why),
                std::move(advice));
}

Result<void> TableRows::checkCount(const std::vector<std::string_view> &cells) const
{
    const std::size_t wanted = m_table.columns.columns;
    const bool hasMore = cells.size() == wanted + 1 &&
                         (m_table.columns.mayHaveUnnamed || (m_endsWithDelimiter && cells.back().empty()));
    if (cells.size() == wanted || hasMore)
        return {};
    if (m_table.columns.format == TrackFormat::Tum)
        return wrong(
            cells.size() == 1
                ? ODO_TEXT("exchange.tum_entry", "it has %1 entry instead of the 8 of TUM")(cells.size())
                : ODO_TEXT("exchange.tum_entries", "it has %1 entries instead of the 8 of TUM")(cells.size()),
            ODO_TEXT("exchange.write_tum_or_header", "write %1, or begin the file with the line %2")(
                std::string("timestamp tx ty tz qx qy qz qw"), std::string("t_s,x_mm,y_mm")));
    return wrong(cells.size() == 1
                     ? ODO_TEXT("exchange.cell_of_columns",
                                "it has %1 cell where the header has %2")(cells.size(), wanted)
                     : ODO_TEXT("exchange.cells_of_columns",
                                "it has %1 cells where the header has %2")(cells.size(), wanted),
                 ODO_TEXT("exchange.fill_in_all_cells", "give each line as many cells as the header"));
}

bool TableRows::isCut(const std::vector<std::string_view> &cells) const
{
    return cells.size() < m_table.columns.columns;
}

/// nullopt in the value: the row is passed over.
Result<std::optional<Stamp>> TableRows::stampOfRow(const std::vector<std::string_view> &cells)
{
    if (!m_table.columns.time)
        return Stamp{Stamp::Kind::Number, static_cast<long double>(m_rows)};
    const auto &time = *m_table.columns.time;
    auto stamp = stampOf(cells[time.index], m_style);
    if (stamp && time.nanoseconds) {
        const auto nanoseconds = styledLongNumber(cells[*time.nanoseconds], m_style);
        stamp->value += nanoseconds.value_or(0) * 1e-9L;
    }
    if (stamp)
        return stamp;
    if (m_table.unreadable++ == 0) {
        m_table.firstUnreadable = m_line;
        m_firstUnreadable =
            wrong(ODO_TEXT("exchange.not_a_time", "'%1' is not a time")(shown(cells[time.index])),
                  ODO_TEXT("exchange.write_digits", "write it with digits, like 12.5"))
                .value();
    }
    return std::nullopt;
}

RawTrack &TableRows::trackNamed(std::string_view id)
{
    const auto known = m_byId.find(id);
    if (known != m_byId.end())
        return m_table.tracks[known->second];
    m_byId.emplace(std::string(id), m_table.tracks.size());
    RawTrack &track = m_table.tracks.emplace_back();
    track.name = std::string(id.substr(0, 200));
    track.columns = m_table.columns.tracks.front();
    return track;
}

/// What looked like the names of tracks only counts the lines.
void TableRows::mergeTracks()
{
    std::vector<std::array<std::size_t, 3>> rows; // line, track, row
    for (std::size_t k = 0; k < m_table.tracks.size(); ++k) {
        for (std::size_t i = 0; i < m_table.tracks[k].size(); ++i)
            rows.push_back({static_cast<std::size_t>(m_table.tracks[k].lines[i]), k, i});
    }
    std::ranges::sort(rows);
    RawTrack whole;
    whole.columns = m_table.columns.tracks.front();
    for (const auto &[line, k, i] : rows)
        whole.addRow(m_table.tracks[k], i);
    m_table.tracks.assign(1, std::move(whole));
    m_table.columns.id.reset();
    m_byId.clear();
}

Result<double> TableRows::numberAt(const std::vector<std::string_view> &cells, std::size_t column) const
{
    const auto number = styledNumber(cells[column], m_style);
    if (!number)
        return wrong(notAFiniteNumber(shown(cells[column])),
                     ODO_TEXT("exchange.write_digits_or_blank",
                              "write it with digits, like 12.5, or leave the cell blank"));
    return *number;
}

/// NaN where both are missing.
Result<std::array<double, 2>> TableRows::pairAt(const std::vector<std::string_view> &cells, std::size_t x,
                                                std::size_t y, const MessageText &oneIsBlank) const
{
    const bool noX = isMissingMark(cells[x]), noY = isMissingMark(cells[y]);
    if (noX && noY)
        return std::array{none, none};
    if (noX || noY)
        return wrong(oneIsBlank, ODO_TEXT("exchange.fill_in_both", "fill in both or none"));
    const double first = ODO_TRY(numberAt(cells, x));
    const double second = ODO_TRY(numberAt(cells, y));
    return std::array{first, second};
}

Result<void> TableRows::addSigmas(RawTrack &track, const std::vector<std::string_view> &cells) const
{
    const TrackColumns &columns = track.columns;
    if (!columns.sigmaX || !columns.sigmaY)
        return {};
    track.sigmas.push_back({none, none});
    if (!track.isMeasured(track.sigmas.size() - 1))
        return {};
    const auto sigmas =
        ODO_TRY(pairAt(cells, columns.sigmaX->index, columns.sigmaY->index,
                       ODO_TEXT("exchange.one_error_blank", "one of its two uncertainties is blank")));
    if (sigmas[0] <= 0 || sigmas[1] <= 0)
        return wrong(ODO_TEXT("exchange.sigma_not_above_zero", "its uncertainty '%1' is not above zero")(
                         shown(cells[(sigmas[0] <= 0 ? columns.sigmaX : columns.sigmaY)->index])),
                     ODO_TEXT("exchange.sigma_or_blank",
                              "give the standard deviation of each position, or leave these cells blank"));
    track.sigmas.back() = sigmas;
    return {};
}

double TableRows::headingAt(const TrackColumns &columns, const std::vector<std::string_view> &cells) const
{
    if (columns.heading)
        return styledNumber(cells[columns.heading->index], m_style).value_or(none) *
               columns.heading->radPerUnit;
    Eigen::Vector4d q;
    for (std::size_t i = 0; i < 4; ++i)
        q[Eigen::Index(i)] = styledNumber(cells[(*columns.quaternion)[i]], m_style).value_or(none);
    return yawOf(q);
}

bool TableRows::isMarkedLost(const std::vector<std::string_view> &cells) const
{
    if (!m_table.columns.lost)
        return false;
    const std::string_view cell = cells[m_table.columns.lost->index];
    const bool isTrue = cell == "1" || cell == "true" || cell == "True" || cell == "TRUE";
    const bool isFalse = cell == "0" || cell == "false" || cell == "False" || cell == "FALSE";
    return m_table.columns.lost->isLostIfTrue ? isTrue : isFalse;
}

Result<void> TableRows::addTo(RawTrack &track, const Stamp &stamp, const std::vector<std::string_view> &cells)
{
    if (++m_places > mostPositions)
        return wrong(ODO_TEXT("exchange.too_many_places", "the file has more than 1.5 million positions"),
                     ODO_TEXT("exchange.check_one_run", "check that all lines are of one run"));
    const TrackColumns &columns = track.columns;
    const auto position =
        ODO_TRY(pairAt(cells, columns.x.index, columns.y.index,
                       ODO_TEXT("exchange.one_place_blank", "one of its two coordinates is blank")));
    track.lines.push_back(m_line);
    track.stamps.push_back(stamp.value);
    track.stampKind = stamp.kind;
    const bool isLost = isMarkedLost(cells);
    track.x.push_back(isLost ? none : position[0]);
    track.y.push_back(isLost ? none : position[1]);
    if (columns.z)
        track.z.push_back(styledNumber(cells[columns.z->index], m_style).value_or(none));
    if (columns.confidence)
        track.confidence.push_back(
            static_cast<float>(styledNumber(cells[*columns.confidence], m_style).value_or(none)));
    ODO_TRY(addSigmas(track, cells));
    if (columns.heading || columns.quaternion)
        track.headings.push_back(headingAt(columns, cells));
    return {};
}

Result<void> TableRows::add(const std::vector<std::string_view> &cells, int line)
{
    m_line = line;
    ODO_TRY(checkCount(cells));
    const auto stamp = ODO_TRY(stampOfRow(cells));
    ++m_rows;
    if (!stamp)
        return {};
    if (m_byId.size() == mostTracks && 2 * m_byId.size() > m_rows)
        mergeTracks();
    if (m_table.columns.id) {
        const std::string_view id = cells[*m_table.columns.id];
        if (m_byId.size() == mostTracks && !m_byId.contains(id))
            return wrong(
                ODO_TEXT("exchange.too_many_tracks", "the file has more than 1000 tracks"),
                ODO_TEXT("exchange.check_track_column", "check which column says the track of a line"));
        return addTo(trackNamed(id), *stamp, cells);
    }
    for (RawTrack &track : m_table.tracks)
        ODO_TRY(addTo(track, *stamp, cells));
    return {};
}

Result<RawTable> TableRows::finish(int lastLine)
{
    m_line = m_table.lastLine = lastLine;
    if (m_table.unreadable > mostBadRows(m_rows))
        return tl::unexpected(*m_firstUnreadable);
    if (m_byId.size() > 1 && 2 * m_byId.size() > m_rows)
        mergeTracks();
    if (m_table.tracks.empty()) {
        RawTrack &track = m_table.tracks.emplace_back();
        track.columns = m_table.columns.tracks.front();
    }
    return std::move(m_table);
}

} // namespace odo
