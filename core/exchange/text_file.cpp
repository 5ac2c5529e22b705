// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/text_file.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/exchange/internal/spreadsheet_coding.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"

#include <QFile>
#include <QStringDecoder>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace odo {

struct TextFile::Impl
{
    Message what; ///< for messages
    std::size_t maxBytes = 0, count = 0;
    TextCoding coding = TextCoding::Utf8;
    QFile input;
    QStringDecoder decoder{QStringDecoder::Utf8};
    SpreadsheetCoding spreadsheets; ///< in place of the one above

    tl::unexpected<Error> tooLarge() const
    {
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("exchange.file_too_large", "it is larger than %1")(
                        quantity(static_cast<double>(maxBytes / 1024), 0, "KiB")),
                    checkRightFile());
    }

    Result<void> isNoText() const
    {
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("exchange.is_no_utf8", "it is not a UTF-8 text file"),
                    ODO_TEXT("exchange.save_as_utf8", "save it again as UTF-8 text"));
    }

    /// A character may begin in one block and end in the next.
    Result<void> checkEncoding(QByteArray &block, bool isLast)
    {
        if (coding == TextCoding::OfSpreadsheets) {
            spreadsheets.makeUtf8(block);
            return block.contains('\0') ? isNoText() : Result<void>();
        }
        if (count == 0 && (block.startsWith("\xff\xfe") || block.startsWith("\xfe\xff")))
            return fail(
                ErrorCode::InvalidInput, what, ODO_TEXT("exchange.is_utf16", "it is written in UTF-16"),
                ODO_TEXT("exchange.save_as_csv_utf8", "save it again as \"CSV UTF-8\" or as a UTF-8 text"));
        // the sequence before must be complete
        static_cast<void>(QString(decoder(isLast ? QByteArrayLiteral("\n") : block)));
        return decoder.hasError() || block.contains('\0') ? isNoText() : Result<void>();
    }
};

TextFile::TextFile(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
TextFile::~TextFile() = default;
TextFile::TextFile(TextFile &&) noexcept = default;

Message atLine(const std::filesystem::path &file, int line)
{
    return ODO_TEXT("exchange.at_line", "%1:%2")(Named::file(file), line);
}

Result<TextFile> TextFile::open(const std::filesystem::path &file, std::size_t maxBytes, TextCoding coding)
{
    auto impl = std::make_unique<Impl>();
    impl->coding = coding;
    impl->what = quotedFileSubject(file);
    impl->maxBytes = maxBytes;
    ODO_TRY(checkMayBeRead(file, impl->what));
    impl->input.setFileName(QString::fromStdString(file.string()));
    if (!impl->input.open(QIODevice::ReadOnly))
        return fail(ErrorCode::Io, impl->what, cannotBeRead(impl->input.errorString().toStdString()),
                    checkFileMayBeRead());
    if (static_cast<std::size_t>(impl->input.size()) > maxBytes)
        return impl->tooLarge();
    return TextFile(std::move(impl));
}

Result<std::string> TextFile::read()
{
    constexpr qint64 blockBytes = 1 << 16;
    QByteArray block = m_impl->input.read(blockBytes);
    const bool isFirst = m_impl->count == 0;
    const auto count = static_cast<std::size_t>(block.size());
    ODO_TRY(m_impl->checkEncoding(block, block.isEmpty()));
    m_impl->count += count;
    if (m_impl->count > m_impl->maxBytes) // it has grown, or its size is not known (/proc)
        return m_impl->tooLarge();
    if (isFirst && block.startsWith("\xef\xbb\xbf"))
        block.remove(0, 3);
    return block.toStdString();
}

Message TextFile::lineName(int line) const
{
    return atLine(m_impl->input.fileName().toStdString(), line);
}

std::size_t TextFile::size() const
{
    return static_cast<std::size_t>(m_impl->input.size());
}

Result<std::string> readTextFile(const std::filesystem::path &file, std::size_t maxBytes)
{
    auto input = ODO_TRY(TextFile::open(file, maxBytes));
    std::string text;
    for (;;) {
        const auto block = ODO_TRY(input.read());
        if (block.empty())
            return text;
        text += block;
    }
}

std::string numberText(double value)
{
    char text[400]; // the longest double without exponent has 309 digits before the point
    const auto [end, problem] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
    if (problem != std::errc())
        return "0"; // below 1e-307: nothing that anybody measures
    return std::string(text, end);
}

Message separatedBySemicolons()
{
    return ODO_TEXT("exchange.separated_by_semicolons", "its columns are separated by semicolons");
}

Message notAFiniteNumber(std::string what)
{
    return ODO_TEXT("exchange.not_a_finite_number", "'%1' is not a finite number")(std::move(what));
}

Message entryIsMissing(std::string key)
{
    return ODO_TEXT("exchange.entry_is_missing", "the entry '%1' is missing")(std::move(key));
}

Message checkRightFile()
{
    return ODO_TEXT("exchange.check_right_file", "check that it is the right file");
}

Message beginWithLine(const std::string &line)
{
    return ODO_TEXT("exchange.begin_with_line", "begin the file with the line %1")(line);
}

namespace {

// a million columns; of blank cells each takes eight times its bytes
constexpr std::size_t mostLineBytes = std::size_t(8) << 20;
// the year 2096; nanoseconds of 64 bits hold what lies between any two
constexpr long double mostSeconds = 4e9L;

/// A whole cell as a number of any kind of floating point.
template <class Number>
std::optional<Number> numberOf(std::string_view cell, char delimiter)
{
    std::array<char, 65> copy{}; // ends with a zero: libstdc++ reads one character beyond the given end
    if (cell.starts_with('+'))
        cell.remove_prefix(1); // from_chars knows none
    if (cell.empty() || cell.size() >= copy.size())
        return std::nullopt;
    std::copy(cell.begin(), cell.end(), copy.begin());
    if (delimiter != ',')
        std::replace(copy.data(), copy.data() + cell.size(), ',', '.');
    Number value = 0;
    const auto [end, problem] = std::from_chars(copy.data(), copy.data() + cell.size(), value);
    if (problem != std::errc() || end != copy.data() + cell.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace

Result<std::optional<std::string_view>> FileLines::next()
{
    std::size_t searched = m_position, end = 0;
    while ((end = m_text.find('\n', searched)) == std::string::npos && !m_atEnd) {
        m_text.erase(0, m_position);
        m_position = 0;
        searched = m_text.size();
        if (searched > mostLineBytes)
            return fail(ErrorCode::InvalidInput, m_file.lineName(m_number + 1),
                        ODO_TEXT("exchange.line_too_long", "it is longer than 8 MiB"), checkRightFile());
        const auto block = ODO_TRY(m_file.read());
        m_atEnd = block.empty();
        m_text += block;
    }
    if (m_position >= m_text.size())
        return std::nullopt;
    end = std::min(end, m_text.size());
    std::string_view line = std::string_view(m_text).substr(m_position, end - m_position);
    m_given += line.size() + 1;
    m_position = end + 1;
    ++m_number;
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

double FileLines::doneShare() const
{
    return std::min(1.0, double(m_given) / double(std::max<std::size_t>(m_file.size(), 1)));
}

std::string_view withoutBlanks(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

char delimiterOf(std::string_view header)
{
    for (const char delimiter : {'\t', ';', ','}) {
        if (header.find(delimiter) != std::string_view::npos)
            return delimiter;
    }
    return ' ';
}

void splitCells(std::string_view line, char delimiter, std::vector<std::string_view> &cells)
{
    cells.clear();
    if (delimiter == ' ')
        line = withoutBlanks(line);
    for (std::size_t at = 0; at <= line.size();) {
        if (delimiter == ' ')
            at = std::min(line.find_first_not_of(" \t", at), line.size());
        std::size_t end = at;
        const auto parts = [delimiter](char c) { return c == delimiter || (delimiter == ' ' && c == '\t'); };
        for (bool isQuoted = false; end < line.size() && (isQuoted || !parts(line[end])); ++end)
            isQuoted ^= line[end] == '"';
        std::string_view cell = withoutBlanks(line.substr(at, end - at));
        if (cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"'))
            cell = withoutBlanks(cell.substr(1, cell.size() - 2));
        cells.push_back(cell);
        at = end + 1;
    }
}

std::optional<double> cellNumber(std::string_view cell, char delimiter)
{
    return numberOf<double>(cell, delimiter);
}

std::optional<Nanoseconds> cellTime(std::string_view cell, char delimiter, double secondsPerUnit)
{
    const auto value = numberOf<long double>(cell, delimiter);
    if (!value)
        return std::nullopt;
    // 1e-9 is no double
    const long double unitsPerSecond = std::roundl(1 / static_cast<long double>(secondsPerUnit));
    const long double seconds = *value / unitsPerSecond;
    if (std::abs(seconds) > mostSeconds)
        return std::nullopt;
    return Nanoseconds(std::llroundl(*value * (1e9L / unitsPerSecond)));
}

namespace {

/// Cuts a text into rows of cells.
class CsvParser
{
public:
    CsvParser(const std::filesystem::path &file, const std::string &text) : m_file(file), m_text(text) {}

    Result<std::vector<CsvRow>> parse()
    {
        std::vector<CsvRow> rows;
        while (m_position < m_text.size()) {
            CsvRow row{m_line, {}};
            for (bool more = true; more;) {
                row.cells.push_back(ODO_TRY(parseCell()));
                more = m_position < m_text.size() && m_text[m_position] == ',';
                if (more)
                    ++m_position;
            }
            endLine();
            if (row.cells.size() > 1 || !row.cells.front().empty())
                rows.push_back(std::move(row));
        }
        return rows;
    }

private:
    bool atLineEnd() const
    {
        if (m_position >= m_text.size() || m_text[m_position] == '\n')
            return true;
        return m_text[m_position] == '\r' &&
               (m_position + 1 >= m_text.size() || m_text[m_position + 1] == '\n');
    }

    void endLine()
    {
        while (m_position < m_text.size() && m_text[m_position] == '\r')
            ++m_position;
        if (m_position < m_text.size())
            ++m_position;
        ++m_line;
    }

    Result<std::string> parseCell()
    {
        if (m_position < m_text.size() && m_text[m_position] == '"')
            return parseQuoted();
        const std::size_t start = m_position;
        while (!atLineEnd() && m_text[m_position] != ',')
            ++m_position;
        std::string cell = m_text.substr(start, m_position - start);
        cell.erase(0, cell.find_first_not_of(" \t"));
        cell.erase(cell.find_last_not_of(" \t") + 1);
        return cell;
    }

    Result<std::string> parseQuoted()
    {
        const int startLine = m_line;
        std::string cell;
        for (++m_position; m_position < m_text.size(); ++m_position) {
            const char c = m_text[m_position];
            if (c == '"') {
                const bool doubled = m_position + 1 < m_text.size() && m_text[m_position + 1] == '"';
                ++m_position;
                if (!doubled)
                    break;
            }
            if (c == '\n')
                ++m_line;
            cell += c;
        }
        if (m_text[m_position - 1] != '"' || (!atLineEnd() && m_text[m_position] != ','))
            return fail(ErrorCode::InvalidInput, atLine(m_file, startLine),
                        ODO_TEXT("exchange.quoted_cell_does_not_end", "a quoted cell does not end"),
                        ODO_TEXT("exchange.close_quotes", "close the quotes"));
        return cell;
    }

    const std::filesystem::path &m_file;
    const std::string &m_text;
    std::size_t m_position = 0;
    int m_line = 1;
};

std::string headerLine(const std::vector<std::string> &columns)
{
    std::string line;
    for (const std::string &column : columns)
        line += (line.empty() ? "" : ",") + column;
    return line;
}

/// Whether a text is to be marked by an apostrophe; one that looks as if it had been marked is too.
bool isToBeMarked(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
    return !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos &&
           !parseNumber(text);
}

} // namespace

Result<std::vector<CsvRow>> readCsvRows(const std::filesystem::path &file)
{
    const auto text = ODO_TRY(readTextFile(file));
    return CsvParser(file, text).parse();
}

Result<std::vector<CsvRow>> readCsvTable(const std::filesystem::path &file,
                                         const std::vector<std::string> &columns)
{
    auto rows = ODO_TRY(readCsvRows(file));
    if (rows.empty())
        return fail(ErrorCode::InvalidInput, atLine(file, 1), fileIsEmpty(),
                    beginWithLine(headerLine(columns)));
    if (rows.front().cells != columns) {
        const bool semicolons =
            rows.front().cells.size() == 1 && rows.front().cells.front().find(';') != std::string::npos;
        return semicolons
                   ? fail(ErrorCode::InvalidInput, atLine(file, rows.front().line), separatedBySemicolons(),
                          ODO_TEXT("exchange.save_with_commas_and_points",
                                   "save it with commas, and with a point in its numbers"))
                   : fail(ErrorCode::InvalidInput, atLine(file, rows.front().line),
                          ODO_TEXT("exchange.lacks_header", "it lacks the expected header line"),
                          beginWithLine(headerLine(columns)));
    }
    rows.erase(rows.begin());
    for (const CsvRow &row : rows) {
        if (row.cells.size() != columns.size())
            return fail(ErrorCode::InvalidInput, atLine(file, row.line),
                        ODO_TEXT("exchange.wrong_number_of_cells",
                                 "it has %1 cells instead of %2")(row.cells.size(), columns.size()),
                        ODO_TEXT("exchange.write_value_for_each",
                                 "write one value for each of %1")(headerLine(columns)));
    }
    return rows;
}

Result<double> csvNumber(const std::filesystem::path &file, const CsvRow &row, std::size_t column,
                         const std::string &name)
{
    const auto number = parseNumber(row.cells[column]);
    if (!number)
        return fail(ErrorCode::InvalidInput, atLine(file, row.line),
                    ODO_TEXT("exchange.cell_not_a_number",
                             "%1 '%2' is not a finite number")(name, row.cells[column].substr(0, 40)),
                    number.error().advice);
    return *number;
}

std::string csvText(const std::string &text, char delimiter)
{
    std::string safe = isToBeMarked(text) ? "'" + text : text;
    const bool plain = safe.find_first_of(std::string("\"\r\n") + delimiter) == std::string::npos;
    if (plain)
        return safe;
    std::string quoted = "\"";
    for (const char c : safe) {
        quoted += c;
        if (c == '"')
            quoted += '"';
    }
    return quoted + '"';
}

std::string csvTextOf(const std::string &cell)
{
    return cell.starts_with('\'') && isToBeMarked(std::string_view(cell).substr(1)) ? cell.substr(1) : cell;
}

} // namespace odo
