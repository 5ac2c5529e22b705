// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_kind.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace odo {

namespace {

constexpr std::string_view sqliteMagic("SQLite format 3\0", 16), projectId("Odog");
constexpr std::size_t sqliteIdOffset = 68; // https://www.sqlite.org/fileformat.html, section 1.3

struct Signature
{
    std::size_t offset;
    std::string_view bytes;
    FileKind kind;
};
constexpr Signature signatures[] = {{0, "%PDF-", FileKind::Pdf},
                                    {0, "\x89PNG\r\n\x1a\n", FileKind::Png},
                                    {0, "\xff\xd8\xff", FileKind::Jpeg},
                                    {4, "ftyp", FileKind::Mp4},
                                    {0, "\x1a\x45\xdf\xa3", FileKind::Matroska},
                                    {0, "PK\x03\x04", FileKind::Zip}};

/// Whether one of the first files in a ZIP is a workbook's.
bool isWorkbook(std::string_view zip)
{
    return zip.find("xl/workbook") != std::string_view::npos ||
           zip.find("xl/worksheets/") != std::string_view::npos;
}

/// The text up to the end of its line, and the rest.
std::pair<std::string_view, std::string_view> firstLine(std::string_view text)
{
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return {line, end == std::string_view::npos ? std::string_view() : text.substr(end + 1)};
}

std::size_t cellCount(std::string_view line, char delimiter)
{
    std::size_t count = 1;
    bool isQuoted = false;
    for (const char c : line) {
        isQuoted = isQuoted != (c == '"');
        count += c == delimiter && !isQuoted;
    }
    return count;
}

/// Whether the text begins with a row of names without blanks, and a second row of as many cells if there is
/// one.
bool isCsv(std::string_view text)
{
    const auto [header, rest] = firstLine(text);
    const char delimiter = header.find(';') != std::string_view::npos ? ';' : ',';
    const std::size_t cells = cellCount(header, delimiter);
    if (cells < 2 || header.find(' ') != std::string_view::npos)
        return false;
    const bool hasSecond = rest.find('\n') != std::string_view::npos; // a whole one
    return !hasSecond || cellCount(firstLine(rest).first, delimiter) == cells;
}

/// Whether the first line that is no remark has eight numbers.
bool isTum(std::string_view text)
{
    constexpr int columns = 8;
    auto [line, rest] = firstLine(text);
    while (line.starts_with('#'))
        std::tie(line, rest) = firstLine(rest);
    int numbers = 0;
    while (!line.empty()) {
        const std::size_t end = line.find(' ');
        const std::string_view number = line.substr(0, end);
        if (number.empty() || number.find_first_not_of("+-.0123456789eE") != std::string_view::npos)
            return false;
        ++numbers;
        line = end == std::string_view::npos ? std::string_view() : line.substr(end + 1);
    }
    return numbers == columns;
}

bool isTracker(std::string_view text)
{
    const auto [name, rest] = firstLine(text);
    return firstLine(rest).first.starts_with("t\tx\ty");
}

bool startsAsPage(std::string_view text)
{
    constexpr std::string_view doctype = "<!doctype html", element = "<html";
    const auto startsWith = [&text](std::string_view lower) {
        return text.size() >= lower.size() &&
               std::equal(lower.begin(), lower.end(), text.begin(), [](char expected, char c) {
                   return expected == (c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c);
               });
    };
    return startsWith(doctype) || startsWith(element);
}

FileKind textKind(std::string_view text)
{
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    const char first = start == std::string_view::npos ? ' ' : text[start];
    if (first == '{' || first == '[')
        return FileKind::Json;
    if (startsAsPage(text.substr(std::min(start, text.size()))))
        return FileKind::Html;
    if (first == '<' && text.find("<svg") != std::string_view::npos)
        return FileKind::Svg;
    if (text.starts_with("%YAML") || text.starts_with("image_width:"))
        return FileKind::Yaml;
    if (isTracker(text))
        return FileKind::Tracker;
    if (isTum(text))
        return FileKind::Tum;
    return isCsv(text) ? FileKind::Csv : FileKind::Text;
}

} // namespace

FileKind kindOf(std::string_view start)
{
    start = start.substr(0, kindBytes);
    if (start.empty())
        return FileKind::Empty;
    if (start.starts_with(sqliteMagic))
        return start.size() > sqliteIdOffset && start.substr(sqliteIdOffset).starts_with(projectId)
                   ? FileKind::Project
                   : FileKind::Database;
    for (const Signature &signature : signatures)
        if (start.size() > signature.offset && start.substr(signature.offset).starts_with(signature.bytes))
            return signature.kind == FileKind::Zip && isWorkbook(start) ? FileKind::Xlsx : signature.kind;
    return start.find('\0') == std::string_view::npos ? textKind(start) : FileKind::Other;
}

bool isSameKind(FileKind a, FileKind b)
{
    const auto isTable = [](FileKind kind) {
        return kind == FileKind::Csv || kind == FileKind::Tum || kind == FileKind::Tracker;
    };
    return a == b || (isTable(a) && isTable(b));
}

SystemResult<FileKind> kindOfFile(const FileHandle &file)
{
    std::array<char, kindBytes> start{};
    return file.readStart(start).map([&](std::size_t length) { return kindOf({start.data(), length}); });
}

} // namespace odo
