// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/table_columns.h"

#include "core/base/plain_text.h"
#include "core/exchange/table/internal/column_name.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <map>
#include <span>

namespace odo {

namespace {

constexpr auto timeNames = std::to_array<std::string_view>({"t",
                                                            "time",
                                                            "timestamp",
                                                            "stamp",
                                                            "timestamps",
                                                            "header_stamp",
                                                            "field_header_stamp",
                                                            "datetime",
                                                            "date_time",
                                                            "clock",
                                                            "elapsed",
                                                            "elapsed_time",
                                                            "time_stamp",
                                                            "recording_time",
                                                            "latest_time",
                                                            "timecode",
                                                            "zeit",
                                                            "zeitstempel",
                                                            "uhrzeit",
                                                            "temps",
                                                            "horodatage",
                                                            "tiempo",
                                                            "tempo",
                                                            "시간",
                                                            "时间",
                                                            "時間",
                                                            "时刻"});
/// A column that is called as a unit holds times in it.
constexpr auto unitNames = std::to_array<std::string_view>(
    {"sec", "secs", "seconds", "sekunden", "secondes", "segundos", "ms", "msec", "millis", "milliseconds",
     "millisekunden", "us", "usec", "micros", "microseconds", "ns", "nsec", "nanoseconds"});
constexpr auto frameNames = std::to_array<std::string_view>(
    {"frame",       "frames",    "frame_idx",  "frame_index", "frame_number", "frame_no",    "frame_nr",
     "framenumber", "frame_num", "frameindex", "frameidx",    "coords",       "frame_count", "image",
     "bild",        "bild_nr",   "bildnummer", "fotograma",   "프레임",       "帧",          "帧号"});
constexpr std::array<std::string_view, 12> idNames{"id",       "track",    "track_id",  "robot",
                                                   "robot_id", "object",   "object_id", "marker",
                                                   "name",     "identity", "particle",  "individual"};
constexpr std::array<std::string_view, 8> confidenceWords{
    "likelihood", "confidence", "conf", "score", "prob", "probability", "visibility", "certainty"};
constexpr std::size_t mostNames = 10'000; // columns behind them are not looked at
constexpr std::array<std::string_view, 3> headingWords{"heading", "yaw", "theta"};

/// Reads one header; the parts of a track are searched from its first column to that of the next track.
class HeaderSearch
{
public:
    HeaderSearch(const std::vector<std::string_view> &cells, const std::vector<std::string_view> &above)
        : m_cells(cells), m_above(above)
    {
        m_names.reserve(std::min(cells.size(), mostNames));
        for (const std::string_view cell :
             cells.size() > mostNames ? std::span(cells).first(mostNames) : std::span(cells))
            m_names.emplace_back(cell);
    }

    std::optional<Result<TableColumns>> read()
    {
        m_table.columns = m_cells.size();
        findTime();
        findTracks();
        if (m_table.tracks.empty() || !m_table.time)
            return std::nullopt;
        if (m_unknownUnit)
            return Result<TableColumns>(tl::unexpected(*m_unknownUnit));
        findFlags();
        m_table.format = formatOf();
        return Result<TableColumns>(std::move(m_table));
    }

    std::optional<Result<TableColumns::Time>> readTime()
    {
        findTime();
        if (!m_table.time)
            return std::nullopt;
        return m_unknownUnit ? Result<TableColumns::Time>(tl::unexpected(*m_unknownUnit))
                             : Result<TableColumns::Time>(*m_table.time);
    }

private:
    void findTime();
    bool findRosTime();
    void findTracks();
    void addTrack(std::size_t x, std::size_t y, std::optional<std::size_t> z, std::string name);
    void findParts(TrackColumns &track, std::size_t from, std::size_t to) const;
    std::vector<TrackColumns> namedPairs() const;
    void findFlags();
    TrackFormat formatOf() const;
    LengthColumn lengthAt(std::size_t index);
    std::string nameAbove(std::size_t from, std::size_t to) const;

    const std::vector<std::string_view> &m_cells, &m_above;
    std::vector<ColumnName> m_names;
    TableColumns m_table;
    std::optional<Error> m_unknownUnit;
};

tl::unexpected<Error> unitNotKnown(std::string_view cell)
{
    return fail(ErrorCode::InvalidInput, {},
                ODO_TEXT("exchange.unit_not_known",
                         "its column '%1' is in a unit that is not known")(std::string(cell.substr(0, 40))),
                ODO_TEXT("exchange.give_known_units", "give times in s or ms and positions in m, cm or mm"));
}

/// The stamp of the measurement goes before the time at which it was written to the bag.
bool HeaderSearch::findRosTime()
{
    std::optional<std::size_t> seconds, nanoseconds;
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const std::string &lower = m_names[i].lower();
        if (lower.ends_with("stamp.secs") || lower.ends_with("stamp.sec") || lower.ends_with("stamp/sec"))
            seconds = i;
        else if (lower.ends_with("stamp.nsecs") || lower.ends_with("stamp.nanosec") ||
                 lower.ends_with("stamp/nanosec"))
            nanoseconds = i;
        else if (lower == "field.header.stamp")
            m_table.time = TableColumns::Time{i, TimeUnit::Nanosecond, {}};
    }
    if (seconds && nanoseconds)
        m_table.time = TableColumns::Time{*seconds, TimeUnit::Second, nanoseconds};
    return m_table.time.has_value();
}

void HeaderSearch::findTime()
{
    if (findRosTime())
        return;
    enum class By { Name, Unit, Frame };
    for (const By by : {By::Name, By::Unit, By::Frame}) {
        const bool isFrame = by == By::Frame;
        for (std::size_t i = 0; i < m_names.size() && !m_table.time; ++i) {
            const ColumnName &name = m_names[i];
            const std::string words = name.joinedWords();
            const bool isNamed = isFrame          ? isAmong(frameNames, words)
                                 : by == By::Unit ? isAmong(unitNames, words)
                                                  : isAmong(timeNames, words);
            if (!isNamed || name.lengthUnit())
                continue;
            auto unit = isFrame                             ? TimeUnit::Frame
                        : by == By::Unit && !name.hasUnit() ? timeUnitNamed(words)
                                                            : name.timeUnit();
            if (!unit && name.isBracketed()) {
                if (!m_unknownUnit)
                    m_unknownUnit = unitNotKnown(m_cells[i]).value();
            }
            m_table.time = TableColumns::Time{i, unit, {}};
            m_table.hasUnits = m_table.hasUnits || (!isFrame && name.hasUnit());
        }
    }
}

LengthColumn HeaderSearch::lengthAt(std::size_t index)
{
    const ColumnName &name = m_names[index];
    if (name.isBracketed() && !name.lengthUnit() && !m_unknownUnit)
        m_unknownUnit = unitNotKnown(m_cells[index]).value();
    m_table.hasUnits = m_table.hasUnits || name.hasUnit();
    return {index, name.lengthUnit()};
}

std::string HeaderSearch::nameAbove(std::size_t from, std::size_t to) const
{
    for (std::size_t i = to + 1; i-- > from;) {
        if (i < m_above.size() && !m_above[i].empty())
            return std::string(m_above[i]);
    }
    return {};
}

/// Positions without further words go before those with words for a position, and both before those of
/// somebody; pixels come last.
void HeaderSearch::findTracks()
{
    struct Axes
    {
        std::vector<std::size_t> x, y, z;
    };
    std::map<int, std::vector<std::pair<std::string, Axes>>> byRank;
    std::map<std::pair<int, std::string>, std::size_t> places;
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const ColumnName &name = m_names[i];
        if (!name.isPosition() || (m_table.time && m_table.time->index == i))
            continue;
        if (i < m_above.size() && lowerCaseAscii(m_above[i]) == "rotation")
            continue; // of motion capture, beside the positions
        if (name.hasUnit() && !name.isBracketed() && !name.lengthUnit())
            continue; // x_s
        const int isPixel = name.lengthUnit() == LengthUnit::Pixel ? 3 : 0;
        const int rank = isPixel + (name.isPlainAxis() ? 0 : name.owner().empty() ? 1 : 2);
        auto &groups = byRank[rank];
        const auto [place, isNew] = places.try_emplace({rank, name.owner()}, groups.size());
        if (isNew)
            groups.emplace_back(name.owner(), Axes());
        Axes &axes = groups[place->second].second;
        (name.axis() == 'x' ? axes.x : name.axis() == 'y' ? axes.y : axes.z).push_back(i);
    }
    for (const auto &[rank, groups] : byRank) {
        for (const auto &[owner, axes] : groups) {
            const std::size_t count = std::min(axes.x.size(), axes.y.size());
            for (std::size_t k = 0; k < count; ++k)
                addTrack(axes.x[k], axes.y[k],
                         axes.z.size() == count ? std::optional(axes.z[k]) : std::nullopt, owner);
        }
        if (!m_table.tracks.empty())
            break;
    }
    if (m_table.tracks.empty())
        m_table.tracks = namedPairs();
    for (std::size_t k = 0; k < m_table.tracks.size(); ++k) {
        TrackColumns &track = m_table.tracks[k];
        const auto begin = [&](std::size_t of) {
            return std::min(m_table.tracks[of].x.index, m_table.tracks[of].y.index);
        };
        const std::size_t from = k == 0 ? 0 : begin(k);
        const std::size_t to = k + 1 < m_table.tracks.size() ? begin(k + 1) : m_names.size();
        if (track.name.empty())
            track.name = nameAbove(from, track.x.index);
        findParts(track, from, std::max(from, to));
    }
}

void HeaderSearch::addTrack(std::size_t x, std::size_t y, std::optional<std::size_t> z, std::string name)
{
    TrackColumns track{std::move(name), lengthAt(x), lengthAt(y)};
    if (z)
        track.z = lengthAt(*z);
    m_table.tracks.push_back(std::move(track));
}

/// Uncertainties, heading, orientation and confidence between two columns.
void HeaderSearch::findParts(TrackColumns &track, std::size_t from, std::size_t to) const
{
    std::array<std::optional<std::size_t>, 4> quaternion;
    for (std::size_t i = from; i < to; ++i) {
        const ColumnName &name = m_names[i];
        const std::string words = name.joinedWords();
        if (words == "sigma_x" && !track.sigmaX)
            track.sigmaX = LengthColumn{i, name.lengthUnit()};
        else if (words == "sigma_y" && !track.sigmaY)
            track.sigmaY = LengthColumn{i, name.lengthUnit()};
        else if (isAmong(headingWords, words) && name.radiansPerUnit() && !track.heading)
            track.heading = TrackColumns::Angle{i, *name.radiansPerUnit()};
        else if (!name.words().empty() && isAmong(confidenceWords, name.words().back()) &&
                 (!track.confidence || *track.confidence < track.x.index))
            track.confidence = i;
        else if (name.isQuaternion())
            quaternion[name.axis() == 'w' ? 3 : static_cast<std::size_t>(name.axis() - 'x')] = i;
    }
    if (std::ranges::all_of(quaternion, [](const auto &part) { return part.has_value(); }))
        track.quaternion = {*quaternion[0], *quaternion[1], *quaternion[2], *quaternion[3]};
}

/// Tracker's other way: "xball", "yball".
std::vector<TrackColumns> HeaderSearch::namedPairs() const
{
    std::vector<TrackColumns> tracks;
    for (std::size_t i = 0; i + 1 < m_names.size(); ++i) {
        const std::string_view x = m_cells[i].substr(0, m_cells[i].find(' ')),
                               y = m_cells[i + 1].substr(0, m_cells[i + 1].find(' '));
        if (x.size() > 1 && y.size() == x.size() && x[0] == 'x' && y[0] == 'y' &&
            x.substr(1) == y.substr(1) && x[1] != '_')
            tracks.push_back({std::string(x.substr(1)),
                              {i, m_names[i].lengthUnit()},
                              {i + 1, m_names[i + 1].lengthUnit()}});
    }
    return tracks;
}

void HeaderSearch::findFlags()
{
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const std::string words = m_names[i].joinedWords();
        if (words == "missing" || words == "lost" || words == "is_lost")
            m_table.lost = TableColumns::LostFlag{i, true};
        else if (words == "valid" || words == "tracked" || words == "detected" || words == "visible")
            m_table.lost = TableColumns::LostFlag{i, false};
        else if (m_table.tracks.size() == 1 && !m_table.id && isAmong(idNames, words))
            m_table.id = i;
    }
}

TrackFormat HeaderSearch::formatOf() const
{
    if (m_names.front().lower() == "coords" && !m_above.empty() && m_above.front() == "bodyparts")
        return TrackFormat::DeepLabCut;
    for (const ColumnName &name : m_names) {
        const std::string &lower = name.lower();
        if (lower.starts_with("p_rs_") || lower.starts_with("q_rs_"))
            return TrackFormat::Euroc;
        if (lower == "%time" || lower.starts_with("field.") || lower.ends_with("pose.position.x") ||
            lower.ends_with("pose/position/x") || lower.ends_with("transform.translation.x"))
            return TrackFormat::RosBag;
        if (lower.starts_with("x#"))
            return TrackFormat::Trex;
        if (lower == "frame_idx")
            return TrackFormat::Sleap;
    }
    const std::string_view x = m_cells[m_table.tracks.front().x.index];
    if (m_names.front().lower().starts_with("time (") && x.find("/X") != std::string_view::npos)
        return TrackFormat::Kinovea;
    return TrackFormat::Csv;
}

} // namespace

std::optional<Result<TableColumns>> tableColumnsOf(const std::vector<std::string_view> &cells,
                                                   const std::vector<std::string_view> &namesAbove)
{
    if (cells.size() < 3)
        return std::nullopt;
    return HeaderSearch(cells, namesAbove).read();
}

std::optional<Result<TableColumns::Time>> timeColumnOf(const std::vector<std::string_view> &cells)
{
    const std::vector<std::string_view> noneAbove;
    return HeaderSearch(cells, noneAbove).readTime();
}

TableColumns tumColumns()
{
    TableColumns table;
    table.format = TrackFormat::Tum;
    table.time = TableColumns::Time{0, {}, {}};
    TrackColumns track{
        {}, {1, LengthUnit::Metre}, {2, LengthUnit::Metre}, LengthColumn{3, LengthUnit::Metre}};
    track.quaternion = {4, 5, 6, 7};
    table.tracks.push_back(std::move(track));
    table.columns = 8;
    return table;
}

TableColumns kittiColumns()
{
    TableColumns table;
    table.format = TrackFormat::Kitti;
    table.tracks.push_back(
        {{}, {3, LengthUnit::Metre}, {7, LengthUnit::Metre}, LengthColumn{11, LengthUnit::Metre}});
    table.columns = 12;
    return table;
}

std::optional<TableColumns> trcColumns(const std::vector<std::string_view> &markers, std::string_view unit)
{
    TableColumns table;
    table.format = TrackFormat::Trc;
    table.time = TableColumns::Time{1, TimeUnit::Second, {}};
    table.columns = 2;
    const auto known = lengthUnitNamed(lowerCaseAscii(unit));
    for (std::size_t i = 2; i < markers.size(); ++i) {
        if (markers[i].empty())
            continue;
        table.tracks.push_back(
            {std::string(markers[i]), {i, known}, {i + 1, known}, LengthColumn{i + 2, known}});
        table.columns = i + 3;
    }
    table.hasUnits = known.has_value();
    return table.tracks.empty() ? std::nullopt : std::optional(std::move(table));
}

} // namespace odo
