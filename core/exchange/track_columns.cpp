// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/track_columns.h"

#include "core/exchange/delimited_text.h"

#include <algorithm>
#include <array>

namespace odo {

namespace {

struct Unit
{
    std::string_view name;
    double inSi;
};
constexpr std::array<Unit, 6> timeUnits{{{"s", 1}, {"sec", 1}, {"seconds", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
constexpr std::array<Unit, 3> lengthUnits{{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}}};

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
std::optional<Result<double>> unitOf(std::string_view cell, std::initializer_list<std::string_view> quantities,
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
    return fail(ErrorCode::InvalidInput, {}, "its column '" + std::string(cell.substr(0, 40)) + "' is in a unit that is not known",
                "give times in s or ms and places in m, cm or mm");
}

/// Finds columns in a row of cells; the first unknown unit stays as the error.
class ColumnSearch
{
public:
    explicit ColumnSearch(const std::vector<std::string_view> &cells) : m_cells(cells) {}

    template <std::size_t count>
    std::optional<UnitColumn> find(std::initializer_list<std::string_view> quantities, const std::array<Unit, count> &units,
                                   std::size_t from, std::size_t to)
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
        const std::string_view x = cells[i].substr(0, cells[i].find(' ')), y = cells[i + 1].substr(0, cells[i + 1].find(' '));
        if (x.size() > 1 && y.size() == x.size() && x[0] == 'x' && y[0] == 'y' && x.substr(1) == y.substr(1) && x[1] != '_')
            tracks.push_back({std::string(x.substr(1)), {i, 1}, {i + 1, 1}, {}, {}});
    }
    return tracks;
}

} // namespace

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
        header.tracks.push_back({nameAbove(namesAbove, from, x->index), *x, *y, search.find({"sigma_x"}, lengthUnits, from, end),
                                 search.find({"sigma_y"}, lengthUnits, from, end)});
        from = std::max(x->index, y->index) + 1;
    }
    const bool isNamed = header.tracks.empty(); // as only Tracker does it
    if (isNamed)
        header.tracks = namedPairs(cells);
    if (header.tracks.empty())
        return std::nullopt;
    if (search.error())
        return Result<TrackHeader>(tl::unexpected(*search.error()));
    const auto hasUnit = [&](const UnitColumn &column) { return lowerCase(withoutBlanks(cells[column.index])).find_first_of("_[(/") != std::string::npos; };
    header.hasUnits = !isNamed && (hasUnit(header.time) || hasUnit(header.tracks.front().x));
    return Result<TrackHeader>(std::move(header));
}

} // namespace odo
