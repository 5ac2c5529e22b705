// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/track_file.h"

#include "core/exchange/delimited_text.h"
#include "core/exchange/text_file.h"
#include "core/exchange/track_columns.h"

#include <algorithm>
#include <chrono>

namespace odo {

namespace {

constexpr std::size_t mostTrackBytes = std::size_t(256) << 20;
constexpr std::size_t mostPlaces = 4'000'000; // a blank one takes thirty times its bytes in the file
constexpr double mostM = 100e3;
constexpr auto longest = std::chrono::hours(24 * 7);
constexpr std::size_t leastPositions = 3, tumEntries = 8;
constexpr int linesAboveHeader = 4;
constexpr int linesBetweenQuestions = 4096; // about cancellation

constexpr std::string_view tumMark = "timestamp tx ty tz qx qy qz qw", csvMark = "t_s,x_mm,y_mm";

/// What all ways of reading share: the file for messages, and what is asked of each position.
class TrackReader
{
public:
    TrackReader(const std::filesystem::path &file, std::string_view text, const JobControl &control)
        : m_file(file), m_size(text.size()), m_lines(text), m_control(control)
    {
    }

    Result<TrackFile> read();

private:
    Result<TrackFile> readTum(std::string_view first);
    Result<TrackFile> readTable(const TrackHeader &header, bool isTracker);
    Result<std::optional<TrackHeader>> headerOf(std::string_view line);
    Result<void> addRow(const TrackHeader &header, std::vector<FileTrack> &tracks);
    Result<std::optional<Eigen::Vector2d>> pairOf(const UnitColumn &x, const UnitColumn &y, const char *what);
    Result<void> add(FileTrack &track, const ImportedPosition &position);
    Result<TrackFile> checked(TrackFile file) const;
    Result<double> numberOf(std::size_t cell) const;
    tl::unexpected<Error> wrong(const std::string &why, const std::string &advice) const
    {
        return fail(ErrorCode::InvalidInput, atLine(m_file, std::max(1, m_lines.number())), why, advice);
    }
    std::string shown(std::size_t cell) const { return '\'' + std::string(m_cells[cell].substr(0, 40)) + '\''; }
    Result<void> askControl(std::size_t bytesPerLine) const;

    const std::filesystem::path &m_file;
    const std::size_t m_size;
    TextLines m_lines;
    const JobControl &m_control;
    char m_delimiter = ' ';
    std::size_t m_places = 0; ///< of all tracks
    std::vector<std::string_view> m_cells, m_above; ///< of the line that is read, and of the one above the header
};

Result<void> TrackReader::askControl(std::size_t bytesPerLine) const
{
    if (m_lines.number() % linesBetweenQuestions != 0)
        return {};
    if (m_control.isCancelled())
        return cancelled("file '" + m_file.string() + "'");
    const double done = double(m_lines.number()) * double(bytesPerLine) / double(std::max<std::size_t>(m_size, 1));
    m_control.report(std::min(0.5, 0.5 * done), "reading line " + std::to_string(m_lines.number()));
    return {};
}

Result<double> TrackReader::numberOf(std::size_t cell) const
{
    const auto number = cellNumber(m_cells[cell], m_delimiter);
    if (!number)
        return wrong(shown(cell) + " is not a finite number", "write it with digits, like 12.5, or leave the place blank");
    return *number;
}

/// Refuses what no robot's track has; keeps the rest as it is.
Result<void> TrackReader::add(FileTrack &track, const ImportedPosition &position)
{
    if (!track.positions.empty()) {
        const Nanoseconds before = track.positions.back().time;
        if (position.time <= before)
            return wrong(position.time == before ? "its time is that of the line before" : "its time is before that of the line before",
                         "put the lines in the order of time, each time once");
        if (position.time - track.positions.front().time > longest)
            return wrong("it is more than a week after the first line", "check the unit of the times, and that all lines are of one run");
    }
    if (position.position && position.position->cwiseAbs().maxCoeff() > mostM)
        return wrong("its place is more than 100 km away", "check the unit of the places: m, cm or mm");
    if (++m_places > mostPlaces)
        return wrong("the file has more than four million places", "check that all lines are of one run");
    track.positions.push_back(position);
    return {};
}

Result<TrackFile> TrackReader::checked(TrackFile file) const
{
    for (const FileTrack &track : file.tracks) {
        const auto count = static_cast<std::size_t>(
            std::ranges::count_if(track.positions, [](const ImportedPosition &one) { return one.position.has_value(); }));
        if (count < leastPositions && (file.tracks.size() == 1 || count > 0))
            return wrong((track.name.empty() ? "the track" : "track '" + track.name + "'") + " has " + std::to_string(count) +
                             (count == 1 ? " position" : " positions"),
                         "choose a file with three positions or more");
    }
    std::erase_if(file.tracks, [](const FileTrack &track) {
        return std::ranges::none_of(track.positions, [](const ImportedPosition &one) { return one.position.has_value(); });
    });
    if (file.tracks.empty())
        return wrong("none of its tracks has a position", "choose a file with three positions or more");
    return file;
}

Result<TrackFile> TrackReader::readTum(std::string_view first)
{
    TrackFile file{TrackFormat::Tum, std::vector<FileTrack>(1)};
    const std::size_t lineBytes = first.size() + 1;
    for (std::optional<std::string_view> line = first; line; line = m_lines.next()) {
        if (auto going = askControl(lineBytes); !going)
            return tl::unexpected(going.error());
        const std::string_view content = withoutBlanks(*line);
        if (content.empty() || content.starts_with('#'))
            continue;
        splitCells(content, ' ', m_cells);
        if (m_cells.size() != tumEntries)
            return wrong("it has " + std::to_string(m_cells.size()) + (m_cells.size() == 1 ? " entry" : " entries") + " instead of the 8 of TUM",
                         "write " + std::string(tumMark) + ", or begin the file with the line " + std::string(csvMark));
        for (std::size_t cell = 1; cell < tumEntries; ++cell) {
            if (auto number = numberOf(cell); !number)
                return tl::unexpected(number.error());
        }
        const auto time = cellTime(m_cells[0], m_delimiter, 1);
        if (!time)
            return wrong(shown(0) + " is not a time in seconds", "write it with digits, like 12.5");
        if (auto added = add(file.tracks[0], {*time, Eigen::Vector2d(*numberOf(1), *numberOf(2)), {}}); !added)
            return tl::unexpected(added.error());
    }
    return checked(std::move(file));
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
Result<std::optional<Eigen::Vector2d>> TrackReader::pairOf(const UnitColumn &x, const UnitColumn &y, const char *what)
{
    if (m_cells[x.index].empty() && m_cells[y.index].empty())
        return std::nullopt;
    if (m_cells[x.index].empty() || m_cells[y.index].empty())
        return wrong(std::string("one of its two ") + what + " is blank", "fill in both or none");
    const auto first = numberOf(x.index), second = numberOf(y.index);
    if (!first || !second)
        return tl::unexpected(first ? second.error() : first.error());
    // A quotient is rounded once: 0.1 is not 100 times 0.001.
    return Eigen::Vector2d(*first / std::round(1 / x.unit), *second / std::round(1 / y.unit));
}

Result<void> TrackReader::addRow(const TrackHeader &header, std::vector<FileTrack> &tracks)
{
    const bool hasMore = m_cells.size() == header.columns + 1 && m_cells.back().empty();
    if (m_cells.size() != header.columns && !hasMore)
        return wrong("it has " + std::to_string(m_cells.size()) + (m_cells.size() == 1 ? " cell" : " cells") + " where the header has " + std::to_string(header.columns),
                     "give each line as many cells as the header");
    const auto time = cellTime(m_cells[header.time.index], m_delimiter, header.time.unit);
    if (!time)
        return wrong(shown(header.time.index) + " is not a time", "write it with digits, like 12.5");
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        const TrackColumns &columns = header.tracks[i];
        const auto position = pairOf(columns.x, columns.y, "places");
        if (!position)
            return tl::unexpected(position.error());
        ImportedPosition row{*time, *position, {}};
        if (row.position && columns.sigmaX && columns.sigmaY) {
            auto sigma = pairOf(*columns.sigmaX, *columns.sigmaY, "errors");
            if (!sigma)
                return tl::unexpected(sigma.error());
            row.sigmaM = *sigma;
        }
        if (auto added = add(tracks[i], row); !added)
            return added;
    }
    return {};
}

Result<TrackFile> TrackReader::readTable(const TrackHeader &header, bool isTracker)
{
    TrackFile file{isTracker ? TrackFormat::Tracker : TrackFormat::Csv, {}};
    for (const TrackColumns &columns : header.tracks)
        file.tracks.push_back({columns.name, {}});
    while (const auto line = m_lines.next()) {
        if (auto going = askControl(line->size() + 1); !going)
            return tl::unexpected(going.error());
        splitCells(*line, m_delimiter, m_cells);
        if (std::ranges::all_of(m_cells, [](std::string_view cell) { return cell.empty(); }))
            continue;
        if (auto added = addRow(header, file.tracks); !added)
            return tl::unexpected(added.error());
    }
    return checked(std::move(file));
}

bool beginsAsNumber(std::string_view line)
{
    const std::string_view content = withoutBlanks(line);
    std::vector<std::string_view> cells;
    splitCells(content, delimiterOf(content), cells);
    return !cells.empty() && (cellNumber(cells[0], delimiterOf(content)) || cells[0] == "nan" || cells[0] == "NaN");
}

Result<TrackFile> TrackReader::read()
{
    int above = 0;
    bool isTracker = false;
    while (const auto line = m_lines.next()) {
        isTracker = isTracker || line->starts_with("#multi:");
        if (withoutBlanks(*line).empty() || line->starts_with('#') || line->starts_with("sep="))
            continue;
        if (above == 0 && delimiterOf(*line) != ',' && delimiterOf(*line) != ';' && beginsAsNumber(*line))
            return readTum(*line);
        if (beginsAsNumber(*line))
            break;
        auto header = headerOf(*line);
        if (!header)
            return tl::unexpected(header.error());
        if (*header) {
            const bool isBare = withoutBlanks(m_cells[0]) == "t" && !(*header)->hasUnits;
            return readTable(**header, isTracker || isBare || above > 0);
        }
        m_above = m_delimiter == ' ' ? std::vector{withoutBlanks(*line)} : m_cells; // a name may have blanks
        if (++above == linesAboveHeader)
            break;
    }
    const bool isEmpty = m_lines.number() == 0;
    return wrong(isEmpty ? "the file is empty" : "it has no header with a time, x and y, and is no TUM either",
                 "begin the file with the line " + std::string(csvMark) + ", or write lines of " + std::string(tumMark));
}

} // namespace

std::string_view trackFormatWord(TrackFormat format)
{
    return format == TrackFormat::Tum ? "tum" : format == TrackFormat::Csv ? "csv" : "tracker";
}

Result<TrackFile> readTrackFile(const std::filesystem::path &file, const JobControl &control)
{
    const auto text = readTextFile(file, mostTrackBytes);
    if (!text)
        return tl::unexpected(text.error());
    return TrackReader(file, *text, control).read();
}

} // namespace odo
