// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/track_file.h"

#include "core/base/error.h"
#include "core/exchange/text_file.h"
#include "core/files/file_words.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// A column of numbers with its unit.
struct UnitColumn
{
    std::size_t index = 0;
    double unit = 1; ///< in seconds, metres or radians
};

/// Where the columns of one track lie.
struct TrackColumns
{
    std::string name; ///< may be empty
    UnitColumn x, y;
    std::optional<UnitColumn> sigmaX, sigmaY, heading;
};

/// What the header of a table of tracks says.
struct TrackHeader
{
    UnitColumn time;
    std::vector<TrackColumns> tracks; ///< at least one
    std::size_t columns = 0;          ///< of them all
    bool hasUnits = false;            ///< of the time or a position, except for `xNAME`
};

namespace {

struct Unit
{
    std::string_view name;
    double inSi;
};
constexpr std::array<Unit, 6> timeUnits{
    {{"s", 1}, {"sec", 1}, {"seconds", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
constexpr std::array<Unit, 3> lengthUnits{{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}}};
constexpr std::array<Unit, 3> angleUnits{
    {{"rad", 1}, {"deg", std::numbers::pi / 180}, {"°", std::numbers::pi / 180}}};

/// A header cell: "x [m]" is the quantity x in the unit m.
struct ColumnName
{
    std::string quantity, unit;
    bool isBracketed = false; ///< its unit; then nothing else can be meant
};

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    for (char &c : lower) {
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

ColumnName nameOf(std::string_view cell)
{
    const std::string text = lowerCase(withoutBlanks(cell));
    const std::size_t open = text.find_first_of("[(/");
    if (open == std::string::npos || open == 0) {
        const std::size_t underscore = text.rfind('_');
        if (underscore == std::string::npos)
            return {text, {}, false};
        return {text.substr(0, underscore), text.substr(underscore + 1), false};
    }
    std::string unit = text.substr(open + 1);
    if (!unit.empty() && (unit.back() == ']' || unit.back() == ')'))
        unit.pop_back();
    return {std::string(withoutBlanks(text.substr(0, open))), std::string(withoutBlanks(unit)), true};
}

/// The unit of a cell that names one of the quantities; nullopt: it names none of them.
template <std::size_t count>
std::optional<Result<double>> unitOf(std::string_view cell,
                                     std::initializer_list<std::string_view> quantities,
                                     const std::array<Unit, count> &units)
{
    const std::string whole = lowerCase(withoutBlanks(cell));
    if (std::ranges::find(quantities, whole) != quantities.end())
        return 1.0;
    const ColumnName name = nameOf(cell);
    if (std::ranges::find(quantities, name.quantity) == quantities.end())
        return std::nullopt;
    for (const Unit &unit : units) {
        if (unit.name == name.unit)
            return unit.inSi;
    }
    if (!name.isBracketed)
        return std::nullopt;
    return fail(ErrorCode::InvalidInput, {},
                ODO_TEXT("exchange.unit_not_known",
                         "its column '%1' is in a unit that is not known")(std::string(cell.substr(0, 40))),
                ODO_TEXT("exchange.give_known_units", "give times in s or ms and positions in m, cm or mm"));
}

/// Finds columns in a row of cells; the first unknown unit stays as the error.
class ColumnSearch
{
public:
    explicit ColumnSearch(const std::vector<std::string_view> &cells) : m_cells(cells) {}

    template <std::size_t count>
    std::optional<UnitColumn> find(std::initializer_list<std::string_view> quantities,
                                   const std::array<Unit, count> &units, std::size_t from, std::size_t to)
    {
        for (std::size_t i = from; i < to; ++i) {
            const auto unit = unitOf(m_cells[i], quantities, units);
            if (!unit)
                continue;
            if (!*unit && !m_error)
                m_error = unit->error();
            return UnitColumn{i, unit->value_or(1)};
        }
        return std::nullopt;
    }
    /// A column that says its unit; others of its names are passed over.
    template <std::size_t count>
    std::optional<UnitColumn> findWithUnit(std::initializer_list<std::string_view> quantities,
                                           const std::array<Unit, count> &units, std::size_t from,
                                           std::size_t to) const
    {
        for (std::size_t i = from; i < to; ++i) {
            const ColumnName name = nameOf(m_cells[i]);
            const auto unit = std::ranges::find(units, std::string_view(name.unit), &Unit::name);
            if (unit != units.end() && std::ranges::find(quantities, name.quantity) != quantities.end())
                return UnitColumn{i, unit->inSi};
        }
        return std::nullopt;
    }
    const std::optional<Error> &error() const { return m_error; }

private:
    const std::vector<std::string_view> &m_cells;
    std::optional<Error> m_error;
};

std::string nameAbove(const std::vector<std::string_view> &names, std::size_t from, std::size_t to)
{
    for (std::size_t i = to + 1; i-- > from;) {
        if (i < names.size() && !names[i].empty())
            return std::string(names[i]);
    }
    return {};
}

/// Tracker's other way: "xball", "yball".
std::vector<TrackColumns> namedPairs(const std::vector<std::string_view> &cells)
{
    std::vector<TrackColumns> tracks;
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
        const std::string_view x = cells[i].substr(0, cells[i].find(' ')),
                               y = cells[i + 1].substr(0, cells[i + 1].find(' '));
        if (x.size() > 1 && y.size() == x.size() && x[0] == 'x' && y[0] == 'y' &&
            x.substr(1) == y.substr(1) && x[1] != '_')
            tracks.push_back({std::string(x.substr(1)), {i, 1}, {i + 1, 1}, {}, {}, {}});
    }
    return tracks;
}

} // namespace

/// Reads a header: a time (t, time, timestamp) and pairs of x and y, perhaps sigma_x and sigma_y; each with
/// its unit as `x_mm`, `x [m]`, `x (cm)`, `x/m`, or none (s, m); perhaps a heading, yaw or theta with the
/// unit rad or deg; of more tracks `xNAME` and `yNAME`, or the
/// names in the line above. Other columns are passed over. nullopt: it is no such header. The Error is the
/// reason alone, of a unit that is not known.
std::optional<Result<TrackHeader>> readTrackHeader(const std::vector<std::string_view> &cells,
                                                   const std::vector<std::string_view> &namesAbove)
{
    ColumnSearch search(cells);
    TrackHeader header;
    header.columns = cells.size();
    const auto time = search.find({"t", "time", "timestamp"}, timeUnits, 0, cells.size());
    if (!time)
        return std::nullopt;
    header.time = *time;
    for (std::size_t from = 0; from < cells.size();) {
        const auto x = search.find({"x"}, lengthUnits, from, cells.size());
        if (!x)
            break;
        const auto nextX = search.find({"x"}, lengthUnits, x->index + 1, cells.size());
        const std::size_t end = nextX ? nextX->index : cells.size();
        auto y = search.find({"y"}, lengthUnits, x->index + 1, end);
        if (!y)
            y = search.find({"y"}, lengthUnits, from, x->index);
        if (!y)
            break;
        header.tracks.push_back({nameAbove(namesAbove, from, x->index), *x, *y,
                                 search.find({"sigma_x"}, lengthUnits, from, end),
                                 search.find({"sigma_y"}, lengthUnits, from, end),
                                 search.findWithUnit({"heading", "yaw", "theta"}, angleUnits, from, end)});
        from = std::max(x->index, y->index) + 1;
    }
    const bool isNamed = header.tracks.empty(); // as only Tracker does it
    if (isNamed)
        header.tracks = namedPairs(cells);
    if (header.tracks.empty())
        return std::nullopt;
    if (search.error())
        return Result<TrackHeader>(tl::unexpected(*search.error()));
    const auto hasUnit = [&](const UnitColumn &column) {
        return lowerCase(withoutBlanks(cells[column.index])).find_first_of("_[(/") != std::string::npos;
    };
    header.hasUnits = !isNamed && (hasUnit(header.time) || hasUnit(header.tracks.front().x));
    return Result<TrackHeader>(std::move(header));
}

namespace {

constexpr std::size_t mostTrackBytes = std::size_t(256) << 20;
constexpr std::size_t mostPositions = 1'500'000; // with what is computed of them they take half a gigabyte
constexpr double mostM = 100e3;
constexpr auto longest = std::chrono::hours(24 * 7);
constexpr std::size_t leastPositions = 3, tumEntries = 8, tumRotation = 4; // its first cell
constexpr int linesAboveHeader = 4;
constexpr int linesBetweenQuestions = 4096; // about cancellation

constexpr std::string_view tumMark = "timestamp tx ty tz qx qy qz qw", csvMark = "t_s,x_mm,y_mm";

Message positionsOf(const std::string &track, std::size_t count)
{
    if (track.empty())
        return count == 1 ? ODO_TEXT("exchange.track_has_position", "the track has %1 position")(count)
                          : ODO_TEXT("exchange.track_has_positions", "the track has %1 positions")(count);
    return count == 1
               ? ODO_TEXT("exchange.named_track_has_position", "track '%1' has %2 position")(track, count)
               : ODO_TEXT("exchange.named_track_has_positions", "track '%1' has %2 positions")(track, count);
}

Message chooseLongerTrack()
{
    return ODO_TEXT("exchange.choose_longer_track", "choose a file with three positions or more");
}

/// As programs write an orientation that they do not know.
bool isNotANumber(std::string_view cell)
{
    return lowerCase(cell) == "nan" || lowerCase(cell) == "-nan";
}

Message writeDigits()
{
    return ODO_TEXT("exchange.write_digits", "write it with digits, like 12.5");
}

/// What all ways of reading share: the file for messages, and what is asked of each position.
class TrackReader
{
public:
    TrackReader(const std::filesystem::path &file, TextFile text, const JobControl &control)
        : m_file(file), m_lines(std::move(text)), m_control(control)
    {
    }

    Result<TrackFile> read();

private:
    Result<TrackFile> readTum();
    Result<TrackFile> readTable(const TrackHeader &header, bool isTracker);
    Result<std::optional<TrackHeader>> headerOf(std::string_view line);
    Result<void> addRow(const TrackHeader &header, std::vector<FileTrack> &tracks);
    Result<std::optional<ImportedPosition::Pair>> pairOf(const UnitColumn &x, const UnitColumn &y,
                                                         const MessageText &oneIsBlank);
    Result<void> add(FileTrack &track, const ImportedPosition &position);
    Result<TrackFile> checked(TrackFile file) const;
    Result<double> numberOf(std::size_t cell) const;
    std::optional<double> tumHeadingRad() const;
    tl::unexpected<Error> wrong(Message why, Message advice) const
    {
        return fail(ErrorCode::InvalidInput, atLine(m_file, std::max(1, m_lines.number())), std::move(why),
                    std::move(advice));
    }
    std::string shown(std::size_t cell) const { return std::string(m_cells[cell].substr(0, 40)); }
    Result<bool> nextLine();

    const std::filesystem::path &m_file;
    FileLines m_lines;
    std::string_view m_line; ///< that is read
    const JobControl &m_control;
    char m_delimiter = ' ';
    std::size_t m_places = 0;              ///< of all tracks
    std::vector<std::string_view> m_cells; ///< of the line
    std::string m_lineAbove;               ///< the one above the header
    std::vector<std::string_view> m_above; ///< its cells
};

/// False in the value: there is none; asks for cancellation.
Result<bool> TrackReader::nextLine()
{
    if (m_lines.number() % linesBetweenQuestions == 0) {
        if (m_control.isCancelled())
            return cancelled(quotedFileSubject(m_file));
        m_control.report(0.5 * m_lines.doneShare(),
                         ODO_TEXT("exchange.reading_line", "reading line %1")(m_lines.number()));
    }
    const auto line = ODO_TRY(m_lines.next());
    m_line = line.value_or(std::string_view());
    return line.has_value();
}

Result<double> TrackReader::numberOf(std::size_t cell) const
{
    const auto number = cellNumber(m_cells[cell], m_delimiter);
    if (!number)
        return wrong(notAFiniteNumber(shown(cell)),
                     ODO_TEXT("exchange.write_digits_or_blank",
                              "write it with digits, like 12.5, or leave the cell blank"));
    return *number;
}

/// Refuses what no robot's track has; keeps the rest as it is.
Result<void> TrackReader::add(FileTrack &track, const ImportedPosition &position)
{
    if (!track.positions.empty()) {
        const Nanoseconds before = track.positions.back().time;
        if (position.time <= before)
            return wrong(
                position.time == before
                    ? ODO_TEXT("exchange.time_repeated", "its time is the same as in the line before")
                    : ODO_TEXT("exchange.time_goes_back", "its time is earlier than in the line before"),
                ODO_TEXT("exchange.order_lines", "sort the lines by time, with each time only once"));
        if (position.time - track.positions.front().time > longest)
            return wrong(
                ODO_TEXT("exchange.longer_than_a_week", "it is more than a week after the first line"),
                ODO_TEXT("exchange.check_unit_of_times",
                         "check the unit of the times, and that all lines are of one run"));
    }
    if (position.position && position.position->cwiseAbs().maxCoeff() > mostM)
        return wrong(
            ODO_TEXT("exchange.place_too_far", "its position is more than 100 km away"),
            ODO_TEXT("exchange.check_unit_of_places", "check the unit of the positions: m, cm or mm"));
    if (++m_places > mostPositions)
        return wrong(ODO_TEXT("exchange.too_many_places", "the file has more than 1.5 million positions"),
                     ODO_TEXT("exchange.check_one_run", "check that all lines are of one run"));
    track.positions.push_back(position);
    return {};
}

Result<TrackFile> TrackReader::checked(TrackFile file) const
{
    for (const FileTrack &track : file.tracks) {
        const auto count = static_cast<std::size_t>(std::ranges::count_if(
            track.positions, [](const ImportedPosition &one) { return one.position.has_value(); }));
        if (count < leastPositions && (file.tracks.size() == 1 || count > 0))
            return wrong(positionsOf(track.name, count), chooseLongerTrack());
    }
    std::erase_if(file.tracks, [](const FileTrack &track) {
        return std::ranges::none_of(track.positions,
                                    [](const ImportedPosition &one) { return one.position.has_value(); });
    });
    if (file.tracks.empty())
        return wrong(ODO_TEXT("exchange.no_track_has_position", "none of its tracks has a position"),
                     chooseLongerTrack());
    return file;
}

/// From the line on that was read last.
Result<TrackFile> TrackReader::readTum()
{
    TrackFile file{TrackFormat::Tum, std::vector<FileTrack>(1)};
    for (Result<bool> isLine = true; !isLine || *isLine; isLine = nextLine()) {
        if (!isLine)
            return tl::unexpected(isLine.error());
        const std::string_view content = withoutBlanks(m_line);
        if (content.empty() || content.starts_with('#'))
            continue;
        splitCells(content, ' ', m_cells);
        if (m_cells.size() != tumEntries)
            return wrong(
                m_cells.size() == 1 ? ODO_TEXT("exchange.tum_entry",
                                               "it has %1 entry instead of the 8 of TUM")(m_cells.size())
                                    : ODO_TEXT("exchange.tum_entries",
                                               "it has %1 entries instead of the 8 of TUM")(m_cells.size()),
                ODO_TEXT("exchange.write_tum_or_header", "write %1, or begin the file with the line %2")(
                    std::string(tumMark), std::string(csvMark)));
        for (std::size_t cell = 1; cell < tumEntries; ++cell)
            if (cell < tumRotation || !isNotANumber(m_cells[cell]))
                ODO_TRY(numberOf(cell));
        const auto time = cellTime(m_cells[0], m_delimiter, 1);
        if (!time)
            return wrong(
                ODO_TEXT("exchange.not_a_time_in_seconds", "'%1' is not a time in seconds")(shown(0)),
                writeDigits());
        if (auto added = add(file.tracks[0],
                             {*time, Eigen::Vector2d(*numberOf(1), *numberOf(2)), {}, tumHeadingRad()});
            !added)
            return tl::unexpected(added.error());
    }
    return checked(std::move(file));
}

/// The yaw of the line's quaternion. nullopt: it is none, or not that of a robot whose Z axis points up.
std::optional<double> TrackReader::tumHeadingRad() const
{
    constexpr double leastUpright = 0.7, mostOffUnit = 0.1;
    Eigen::Vector4d q; // x, y, z, w, as Eigen keeps them
    for (std::size_t i = 0; i < 4; ++i) {
        if (isNotANumber(m_cells[tumRotation + i]))
            return std::nullopt;
        q[Eigen::Index(i)] = *cellNumber(m_cells[tumRotation + i], m_delimiter);
    }
    if (!(std::abs(q.norm() - 1) < mostOffUnit))
        return std::nullopt;
    const Eigen::Matrix3d axes = Eigen::Quaterniond(Eigen::Vector4d(q.normalized())).toRotationMatrix();
    if (axes(2, 2) < leastUpright)
        return std::nullopt;
    return std::atan2(axes(1, 0), axes(0, 0));
}

/// nullopt in the value: the line is no header, whatever parts its cells.
Result<std::optional<TrackHeader>> TrackReader::headerOf(std::string_view line)
{
    m_delimiter = delimiterOf(line);
    splitCells(line, m_delimiter, m_cells);
    auto header = readTrackHeader(m_cells, m_above);
    if (!header)
        return std::nullopt;
    if (!*header)
        return wrong(header->error().why, header->error().advice);
    if (m_cells.back().empty()) // Tracker ends its lines with a delimiter
        --(*header)->columns;
    return std::optional(std::move(**header));
}

/// A pair of cells in metres; nullopt where both are blank.
Result<std::optional<ImportedPosition::Pair>> TrackReader::pairOf(const UnitColumn &x, const UnitColumn &y,
                                                                  const MessageText &oneIsBlank)
{
    if (m_cells[x.index].empty() && m_cells[y.index].empty())
        return std::nullopt;
    if (m_cells[x.index].empty() || m_cells[y.index].empty())
        return wrong(oneIsBlank, ODO_TEXT("exchange.fill_in_both", "fill in both or none"));
    const auto first = numberOf(x.index), second = numberOf(y.index);
    if (!first || !second)
        return tl::unexpected(first ? second.error() : first.error());
    // A quotient is rounded once: 0.1 is not 100 times 0.001.
    return ImportedPosition::Pair(*first / std::round(1 / x.unit), *second / std::round(1 / y.unit));
}

Result<void> TrackReader::addRow(const TrackHeader &header, std::vector<FileTrack> &tracks)
{
    const bool hasMore = m_cells.size() == header.columns + 1 && m_cells.back().empty();
    if (m_cells.size() != header.columns && !hasMore)
        return wrong(m_cells.size() == 1
                         ? ODO_TEXT("exchange.cell_of_columns",
                                    "it has %1 cell where the header has %2")(m_cells.size(), header.columns)
                         : ODO_TEXT("exchange.cells_of_columns", "it has %1 cells where the header has %2")(
                               m_cells.size(), header.columns),
                     ODO_TEXT("exchange.fill_in_all_cells", "give each line as many cells as the header"));
    const auto time = cellTime(m_cells[header.time.index], m_delimiter, header.time.unit);
    if (!time)
        return wrong(ODO_TEXT("exchange.not_a_time", "'%1' is not a time")(shown(header.time.index)),
                     writeDigits());
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        const TrackColumns &columns = header.tracks[i];
        const auto position =
            ODO_TRY(pairOf(columns.x, columns.y,
                           ODO_TEXT("exchange.one_place_blank", "one of its two coordinates is blank")));
        ImportedPosition row{*time, position, {}, {}};
        if (row.position && columns.sigmaX && columns.sigmaY) {
            row.sigmaM = ODO_TRY(
                pairOf(*columns.sigmaX, *columns.sigmaY,
                       ODO_TEXT("exchange.one_error_blank", "one of its two uncertainties is blank")));
        }
        if (columns.heading && !m_cells[columns.heading->index].empty())
            row.headingRad = ODO_TRY(numberOf(columns.heading->index)) * columns.heading->unit;
        ODO_TRY(add(tracks[i], row));
    }
    return {};
}

Result<TrackFile> TrackReader::readTable(const TrackHeader &header, bool isTracker)
{
    TrackFile file{isTracker ? TrackFormat::Tracker : TrackFormat::Csv, {}};
    for (const TrackColumns &columns : header.tracks)
        file.tracks.push_back({columns.name, {}});
    for (;;) {
        const auto isLine = ODO_TRY(nextLine());
        if (!isLine)
            break;
        splitCells(m_line, m_delimiter, m_cells);
        if (std::ranges::all_of(m_cells, [](std::string_view cell) { return cell.empty(); }))
            continue;
        ODO_TRY(addRow(header, file.tracks));
    }
    return checked(std::move(file));
}

bool beginsAsNumber(std::string_view line)
{
    const std::string_view content = withoutBlanks(line);
    std::vector<std::string_view> cells;
    splitCells(content, delimiterOf(content), cells);
    return !cells.empty() &&
           (cellNumber(cells[0], delimiterOf(content)) || cells[0] == "nan" || cells[0] == "NaN");
}

Result<TrackFile> TrackReader::read()
{
    int above = 0;
    bool isTracker = false;
    for (;;) {
        const auto isLine = ODO_TRY(nextLine());
        if (!isLine)
            break;
        isTracker = isTracker || m_line.starts_with("#multi:");
        if (withoutBlanks(m_line).empty() || m_line.starts_with('#') || m_line.starts_with("sep="))
            continue;
        if (above == 0 && delimiterOf(m_line) != ',' && delimiterOf(m_line) != ';' && beginsAsNumber(m_line))
            return readTum();
        if (beginsAsNumber(m_line))
            break;
        auto header = ODO_TRY(headerOf(m_line));
        if (header) {
            const bool isBare = withoutBlanks(m_cells[0]) == "t" && !header->hasUnits;
            return readTable(*header, isTracker || isBare || above > 0);
        }
        m_lineAbove = m_line;
        m_above = {withoutBlanks(m_lineAbove)}; // a name may have blanks
        if (m_delimiter != ' ')
            splitCells(m_lineAbove, m_delimiter, m_above);
        if (++above == linesAboveHeader)
            break;
    }
    const bool isEmpty = m_lines.number() == 0;
    return wrong(isEmpty ? fileIsEmpty()
                         : ODO_TEXT("exchange.neither_header_nor_tum",
                                    "it has no header with a time, x and y, and it is not a TUM file"),
                 ODO_TEXT("exchange.begin_with_header_or_tum",
                          "begin the file with the line %1, or write lines of %2")(std::string(csvMark),
                                                                                   std::string(tumMark)));
}

} // namespace

std::string_view trackFormatWord(TrackFormat format)
{
    return format == TrackFormat::Tum ? "tum" : format == TrackFormat::Csv ? "csv" : "tracker";
}

Result<TrackFile> readTrackFile(const std::filesystem::path &file, const JobControl &control)
{
    auto text = ODO_TRY(TextFile::open(file, mostTrackBytes));
    return TrackReader(file, std::move(text), control).read();
}

} // namespace odo
