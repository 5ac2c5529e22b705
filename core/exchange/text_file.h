// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/message.h"
#include "core/base/units.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace odo {

/// Takes a text piece by piece, so that a long one need not be in memory; an error ends the writing.
using TextSink = std::function<Result<void>(std::string_view)>;

/// Gathers small pieces before it passes them on. Once something failed, it passes on nothing more.
class TextPieces
{
public:
    explicit TextPieces(const TextSink &sink) : m_sink(sink) {}
    void add(std::string_view piece)
    {
        constexpr std::size_t enough = 1 << 16;
        m_text += piece;
        if (m_text.size() >= enough)
            flush();
    }
    /// All that is left; what failed, if anything did.
    Result<void> finish()
    {
        flush();
        return m_outcome;
    }

private:
    void flush()
    {
        if (m_outcome && !m_text.empty())
            m_outcome = m_sink(m_text);
        m_text.clear();
    }

    const TextSink &m_sink;
    std::string m_text;
    Result<void> m_outcome;
};

/// The whole text that a function writes to a sink.
template <class Write>
std::string wholeText(const Write &write)
{
    std::string text;
    static_cast<void>(write([&text](std::string_view piece) -> Result<void> {
        text += piece;
        return {};
    }));
    return text;
}

/// "dir/a.csv:12": how messages point at a line of an input.
Message atLine(const std::filesystem::path &file, int line);

/// What a text may be written in: UTF-8 alone, or whatever spreadsheets save: UTF-16 with a byte order mark,
/// Windows-1252, and lines that end in CR alone.
enum class TextCoding { Utf8, OfSpreadsheets };

/// A text file that is read block by block, whatever its size, as UTF-8; a byte order mark is dropped. One
/// thread at a time.
class TextFile
{
public:
    /// Refuses, naming the file: what checkMayBeRead() refuses, and what is larger than the limit.
    static Result<TextFile> open(const std::filesystem::path &file, std::size_t maxBytes,
                                 TextCoding coding = TextCoding::Utf8);
    ~TextFile();
    TextFile(TextFile &&) noexcept;
    /// The next block, empty at the end. Refuses what is larger than the limit after all, bytes that are no
    /// text, and of TextCoding::Utf8 also UTF-16 (with the advice how to save it).
    Result<std::string> read();
    Message lineName(int line) const; ///< atLine
    std::size_t size() const;         ///< bytes, as far as known

private:
    struct Impl;
    explicit TextFile(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// Reads a whole text file as UTF-8; a byte order mark is dropped. Any thread. Refuses, naming the file:
/// no file, larger than the limit, UTF-16 (with the advice how to save it), bytes that are no text.
Result<std::string> readTextFile(const std::filesystem::path &file, std::size_t maxBytes = 1 << 20);

/// The shortest decimal text that reads back as the same number, with '.', without exponent, whatever the
/// locale.
std::string numberText(double value);

/// Messages about files from elsewhere, the same whatever they contain.
Message separatedBySemicolons();
Message notAFiniteNumber(std::string what); ///< the name of an entry, or its content
Message entryIsMissing(std::string key);

Message checkRightFile();                       ///< advice
Message beginWithLine(const std::string &line); ///< advice

/// Tables as other programs write them, line by line and without the whole text in memory; whatever the
/// locale.

/// Walks through the lines of a text file; LF or CRLF. One thread at a time.
class FileLines
{
public:
    explicit FileLines(TextFile file) : m_file(std::move(file)) {}
    /// The next line without its end, until the one after it is asked for; nullopt behind the last one.
    /// Errors: those of TextFile, and a line of more than 8 MiB.
    Result<std::optional<std::string_view>> next();
    int number() const { return m_number; } ///< of the line that next() gave last, from 1
    double doneShare() const;               ///< of the file

private:
    TextFile m_file;
    std::string m_text; ///< what was read of it and not given yet, and what next() gave last
    std::size_t m_position = 0, m_given = 0;
    int m_number = 0;
    bool m_atEnd = false;
};

std::string_view withoutBlanks(std::string_view text);

/// What parts the cells of a header line: a tab, or else ';', or else ',', or else blanks.
char delimiterOf(std::string_view header);

/// The cells of a line, without blanks and quotes around them; one that is quoted may hold the delimiter.
/// With a blank as delimiter several of them count as one.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view> &cells);

/// A whole cell as a finite number, with a point, or with a comma where that parts no cells.
std::optional<double> cellNumber(std::string_view cell, char delimiter);

/// A whole cell as a time in a unit of so many seconds, exact to the nanosecond (a double is not, for times
/// since 1970); nullopt also where it is beyond four thousand million seconds.
std::optional<Nanoseconds> cellTime(std::string_view cell, char delimiter, double secondsPerUnit);

/// A row of a CSV file below its header, with the line it began on.
struct CsvRow
{
    int line = 0;
    std::vector<std::string> cells;
};

/// Reads the rows of a CSV file as they are (RFC 4180: commas, quoted cells, LF or CRLF; a byte order mark is
/// allowed), with the header. Blank lines are skipped. At most 1 MiB.
Result<std::vector<CsvRow>> readCsvRows(const std::filesystem::path &file);

/// Reads a CSV file (RFC 4180: commas, quoted cells, LF or CRLF; a byte order mark is allowed) whose header
/// line holds exactly these columns, in this order. Blank lines are skipped. At most 1 MiB, each row as wide
/// as the header. Errors name file and line.
Result<std::vector<CsvRow>> readCsvTable(const std::filesystem::path &file,
                                         const std::vector<std::string> &columns);

/// A cell read as a finite number with a point, whatever the locale.
Result<double> csvNumber(const std::filesystem::path &file, const CsvRow &row, std::size_t column,
                         const std::string &name);

/// A text as a cell has to hold it: quoted where it has the delimiter, a quote or a line break, and with an
/// apostrophe in front where a spreadsheet would take it as a formula (it begins with = + - @, a tab or CR,
/// and is no number).
std::string csvText(const std::string &text, char delimiter);

/// The text of a cell that csvText has written, without such an apostrophe.
std::string csvTextOf(const std::string &cell);

} // namespace odo
