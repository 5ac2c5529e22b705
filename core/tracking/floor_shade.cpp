// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/floor_shade.h"

#include "core/tracking/difference_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace odo {

namespace {

constexpr int patchReach = 3;                           // of the patches whose texture is compared, pixels to each side
constexpr int patchRows = 2 * patchReach + 1;
constexpr int leastPatch = 16;                     // pixels
constexpr double flatness = 0.25;                  // of the texture's variance
constexpr double clearTexture = 6;                 // its variance against the noise's
constexpr float otherHue = 2.2F;                   // code values, of a patch's mean chroma against that of the floor in shadow
constexpr float logUnit = 1024, hueUnit = 256;  // of the fixed-point sums: finer than the steps of code values

enum ShadeSum { pixelsSum, seenSum, seen2Sum, behindSum, behind2Sum, offUSum, offVSum };

/// Logarithms of luma above black in units of 1 / logUnit.
std::array<std::int32_t, 256> makeLogs()
{
    std::array<std::int32_t, 256> logs{};
    for (std::size_t i = 1; i < logs.size(); ++i)
        logs[i] = std::int32_t(std::lround(logUnit * std::log(float(i))));
    return logs;
}

/// n² times the variance of n values, from their sum and the sum of their squares.
double scaledVariance(double n, double sum, double squares)
{
    return n * squares - sum * sum;
}

} // namespace

void FloorShade::find(const ComparedWindow &window)
{
    m_shade = window.darkened();
    m_byHue.reset(m_shade.width(), m_shade.height());
    m_box = m_shade.bounds();
    const std::vector<Sums> none(std::size_t(m_box.width() + 2 * patchReach));
    m_rows.assign(patchRows + 1, none);
    m_columns = none;
    for (int y = m_box.y0; y < m_box.y1 + patchReach; ++y) {
        takeRow(window, y);
        exchangeRows(slot(y), slot(y + 1)); // the latter lies above the patch of the row judged now
        if (y - patchReach >= m_box.y0)
            judgeRow(window, y - patchReach);
    }
}

std::vector<FloorShade::Sums> &FloorShade::slot(int y)
{
    return m_rows[std::size_t(y) % m_rows.size()];
}

void FloorShade::takeRow(const ComparedWindow &window, int y)
{
    static const auto logs = makeLogs();
    std::vector<Sums> &row = slot(y);
    std::ranges::fill(row, Sums{});
    if (y >= m_box.y1)
        return;
    const float perGain = 1 / window.gain().factor; // a factor adds to all logarithms, and to no variance
    Sums *sums = row.data() + patchReach;
    window.darkened().forEachInRow(y, [&](int x) {
        const PixelColour seen = window.seen(x, y), behind = window.behind(x, y);
        const float ratio = seen.luma / behind.luma;
        const std::int32_t now = logs[std::size_t(std::int32_t(seen.luma))], before = logs[std::size_t(std::int32_t(behind.luma * perGain + 0.5F))];
        const auto offU = std::int32_t(hueUnit * (seen.u - ratio * behind.u)), offV = std::int32_t(hueUnit * (seen.v - ratio * behind.v));
        sums[x - m_box.x0] = {1, now, now * now, before, before * before, offU, offV, 0};
    });
}

/// Takes a row into the patches' sums, and another out of them.
void FloorShade::exchangeRows(const std::vector<Sums> &added, const std::vector<Sums> &removed)
{
    const std::int32_t *more = added.front().data(), *less = removed.front().data();
    std::int32_t *__restrict into = m_columns.front().data();
    const int count = int(added.size() * Sums().size());
    for (int i = 0; i < count; ++i)
        into[i] += more[i] - less[i];
}

/// Takes from the shade what the patch around it shows to be none.
void FloorShade::judgeRow(const ComparedWindow &window, int y)
{
    const BitMask &candidates = window.darkened();
    Sums sums{};
    const auto add = [&sums](const Sums &column) {
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += column[k];
    };
    const auto remove = [&sums](const Sums &column) {
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] -= column[k];
    };
    std::size_t begin = 0, end = 0; // of the columns that are in the sums
    candidates.forEachInRow(y, [&](int x) {
        const auto first = std::size_t(x - m_box.x0), last = first + patchRows;
        if (first >= end) {
            sums = Sums{};
            begin = end = first;
        }
        for (; begin < first; ++begin)
            remove(m_columns[begin]);
        for (; end < last; ++end)
            add(m_columns[end]);
        judge(window, sums, x, y);
    });
}

void FloorShade::judge(const ComparedWindow &window, const Sums &sums, int x, int y)
{
    if (sums[pixelsSum] < leastPatch)
        return;
    const auto n = double(sums[pixelsSum]);
    if (std::max(std::abs(sums[offUSum]), std::abs(sums[offVSum])) > otherHue * hueUnit * float(n)) {
        m_byHue.set(x, y);
        m_shade.clear(x, y);
        return;
    }
    const double variance = scaledVariance(n, sums[seenSum], sums[seen2Sum]), varianceBehind = scaledVariance(n, sums[behindSum], sums[behind2Sum]);
    if (variance >= flatness * varianceBehind)
        return;
    const float luma = std::max(1.0F, window.seen(x, y).luma);
    if (varianceBehind * double(squared(luma)) > clearTexture * n * n * double(squared(logUnit) * window.lumaNoise2(x, y)))
        m_shade.clear(x, y);
}

} // namespace odo
