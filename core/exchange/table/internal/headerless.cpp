// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/headerless.h"

#include "core/exchange/table/internal/number_style.h"
#include "core/exchange/table/internal/stamps.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace odo {

namespace {

constexpr std::size_t kittiCells = 12, plainCells = 3;

/// A message that begins with a header and, of some, the name of a second frame; the numbers that follow.
struct EchoedMessage
{
    std::size_t names, numbers;
};
constexpr std::array<EchoedMessage, 5> echoedMessages{{
    {1, 3},              // PointStamped
    {1, 7},              // PoseStamped
    {1, 7 + 36},         // PoseWithCovarianceStamped
    {2, 7},              // TransformStamped
    {2, 7 + 36 + 6 + 36} // Odometry
}};

bool isWhole(std::string_view cell)
{
    return !cell.empty() && std::ranges::all_of(cell, [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<TableColumns> echoedColumns(const std::vector<std::string_view> &cells)
{
    constexpr std::size_t stampCells = 2, nanosecondDigits = 9;
    if (cells.size() < 6 || !isWhole(cells[0]) || !isWhole(cells[1]) || cells[1].size() > nanosecondDigits)
        return std::nullopt;
    const auto isName = [&](std::size_t i) { return !cellNumber(cells[i], ','); };
    const auto isNumber = [](std::string_view cell) { return cellNumber(cell, ',') || isMissingMark(cell); };
    for (const auto &[names, numbers] : echoedMessages) {
        const std::size_t x = stampCells + names;
        if (cells.size() != x + numbers || !isName(stampCells) || !isName(x - 1) ||
            !std::all_of(cells.begin() + std::ptrdiff_t(x), cells.end(), isNumber))
            continue;
        TableColumns table;
        table.format = TrackFormat::RosBag;
        table.time = TableColumns::Time{0, TimeUnit::Second, 1};
        TrackColumns track{
            {}, {x, LengthUnit::Metre}, {x + 1, LengthUnit::Metre}, LengthColumn{x + 2, LengthUnit::Metre}};
        if (numbers > 3)
            track.quaternion = {x + 3, x + 4, x + 5, x + 6};
        table.tracks.push_back(std::move(track));
        table.columns = cells.size();
        return table;
    }
    return std::nullopt;
}

std::optional<TableColumns> plainColumns(const std::vector<std::string_view> &cells, char delimiter)
{
    const auto isNumber = [&](std::string_view cell) {
        return cellNumber(cell, delimiter) || isMissingMark(cell);
    };
    const bool isTime =
        cells.size() == plainCells && (cellNumber(cells[0], delimiter) || stampOf(cells[0], {}));
    if (!isTime || !isNumber(cells[1]) || !isNumber(cells[2]))
        return std::nullopt;
    TableColumns table;
    table.time = TableColumns::Time{0, {}, {}};
    table.tracks.push_back({{}, {1, {}}, {2, {}}});
    table.columns = plainCells;
    table.areAssumed = true;
    return table;
}

} // namespace

std::optional<TableColumns> headerlessColumns(const std::vector<std::string_view> &cells, char delimiter)
{
    if (auto plain = plainColumns(cells, delimiter))
        return plain;
    if (delimiter == ' ')
        return cells.size() == kittiCells ? kittiColumns() : tumColumns();
    return delimiter == ',' ? echoedColumns(cells) : std::nullopt;
}

bool mayBeTimes(const std::vector<long double> &stamps)
{
    constexpr double mostBackward = 0.02, leastEven = 0.8, since1970 = 9e8, finest = 1e-3;
    std::vector<double> steps;
    for (std::size_t i = 1; i < stamps.size(); ++i)
        steps.push_back(static_cast<double>(stamps[i] - stamps[i - 1]));
    const auto count = static_cast<double>(steps.size());
    if (steps.size() < 2 || static_cast<double>(std::ranges::count_if(
                                steps, [](double step) { return step <= 0; })) > mostBackward * count)
        return false;
    if (stamps.front() > since1970)
        return true;
    // rounded ones have two lengths: 0.03, 0.03, 0.04
    const double most = *std::ranges::max_element(steps);
    std::map<long long, std::size_t> lengths;
    for (const double step : steps)
        ++lengths[std::llround(step / (finest * most))];
    std::vector<std::size_t> counts;
    for (const auto &[length, rows] : lengths)
        counts.push_back(rows);
    std::ranges::sort(counts, std::greater<>());
    return static_cast<double>(counts.front() + (counts.size() > 1 ? counts[1] : 0)) >= leastEven * count;
}

} // namespace odo
