// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/camera_watch.h"

#include "core/base/percentile.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int side = 24;                 // of a patch, px
constexpr int columns = 8, rows = 5;     // of the grid that has one patch a cell
constexpr double leastTexture = 8;       // code values² a px², of the weaker direction
constexpr std::size_t fewestPatches = 8; // for a result
constexpr double fewestFound = 0.6;      // of the patches
constexpr double alikeAgain = 0.85;      // correlation of a patch that was found again
constexpr double movedPx = 0.7, movedShare = 2.0 / 3;
constexpr Nanoseconds lookInterval = std::chrono::milliseconds(250), ofParts = std::chrono::seconds(1);
constexpr Nanoseconds lasting = std::chrono::seconds(1);
constexpr int iterations = 8;
constexpr double settledPx = 0.02;
constexpr int searchPx = 48, searchStep = 2, searchGrid = 4; // after a jump

/// Samples of a patch at a place between pixels; false: outside of the image.
bool sample(const PlaneView &luma, double x0, double y0, std::vector<float> &values)
{
    const int left = int(std::floor(x0)), top = int(std::floor(y0));
    if (left < 0 || top < 0 || left + side + 1 >= luma.width || top + side + 1 >= luma.height)
        return false;
    const auto fx = float(x0 - left), fy = float(y0 - top);
    values.resize(std::size_t(side) * side);
    for (int y = 0; y < side; ++y) {
        const std::uint8_t *upper = luma.row(top + y) + left, *lower = luma.row(top + y + 1) + left;
        for (int x = 0; x < side; ++x)
            values[std::size_t(y * side + x)] =
                (1 - fy) * ((1 - fx) * float(upper[x]) + fx * float(upper[x + 1])) +
                fy * ((1 - fx) * float(lower[x]) + fx * float(lower[x + 1]));
    }
    return true;
}

struct Statistics
{
    double mean = 0, deviation = 0;
};

Statistics statisticsOf(const std::vector<float> &values)
{
    double sum = 0, squares = 0;
    for (const float value : values) {
        sum += double(value);
        squares += double(value) * double(value);
    }
    const auto count = double(values.size());
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(1e-6, squares / count - mean * mean))};
}

/// Second moments of the slopes of a square of the image, per pixel.
Eigen::Matrix2d textureAt(const PlaneView &luma, int x0, int y0, int step)
{
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    double count = 0;
    for (int y = y0; y < y0 + side; y += step) {
        for (int x = x0; x < x0 + side; x += step) {
            const double dx = (luma.at(x + 1, y) - luma.at(x - 1, y)) / 2.0,
                         dy = (luma.at(x, y + 1) - luma.at(x, y - 1)) / 2.0;
            moments(0, 0) += dx * dx;
            moments(0, 1) += dx * dy;
            moments(1, 1) += dy * dy;
            count += 1;
        }
    }
    moments(1, 0) = moments(0, 1);
    return moments / count;
}

double weakerDirection(const Eigen::Matrix2d &moments)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(moments).eigenvalues()[0];
}

} // namespace

void CameraWatch::choosePatches(const PlaneView &luma)
{
    constexpr int margin = 2, apart = side / 2;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int x1 = std::max(margin, column * luma.width / columns),
                      y1 = std::max(margin, row * luma.height / rows);
            const int x2 = std::min(luma.width - side - margin, (column + 1) * luma.width / columns - side),
                      y2 = std::min(luma.height - side - margin, (row + 1) * luma.height / rows - side);
            Patch best;
            double texture = leastTexture;
            for (int y = y1; y <= y2; y += apart) {
                for (int x = x1; x <= x2; x += apart) {
                    const double here = weakerDirection(textureAt(luma, x, y, 2));
                    if (here <= texture)
                        continue;
                    texture = here;
                    best.x = x;
                    best.y = y;
                }
            }
            if (texture <= leastTexture)
                continue;
            sample(luma, best.x, best.y, best.values);
            const auto [mean, deviation] = statisticsOf(best.values);
            best.mean = mean;
            best.deviation = deviation;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const int px = best.x + x, py = best.y + y;
                    best.slopesX.push_back(float(luma.at(px + 1, py) - luma.at(px - 1, py)) / 2);
                    best.slopesY.push_back(float(luma.at(px, py + 1) - luma.at(px, py - 1)) / 2);
                }
            }
            best.inverse = (textureAt(luma, best.x, best.y, 1) * double(side * side)).inverse();
            m_patches.push_back(std::move(best));
        }
    }
}

/// Its shift, from one near it; nullopt: it is not found there.
std::optional<Eigen::Vector2d> CameraWatch::findNear(const Patch &patch, const PlaneView &luma,
                                                     Eigen::Vector2d shift) const
{
    std::vector<float> seen;
    const Eigen::Vector2d start = shift;
    double correlation = 0;
    for (int i = 0; i < iterations; ++i) {
        if (!sample(luma, patch.x + shift.x(), patch.y + shift.y(), seen))
            return std::nullopt;
        const auto [mean, deviation] = statisticsOf(seen);
        const double gain = patch.deviation / deviation;
        Eigen::Vector2d pull = Eigen::Vector2d::Zero();
        correlation = 0;
        for (std::size_t k = 0; k < seen.size(); ++k) {
            const double now = (double(seen[k]) - mean) * gain, before = double(patch.values[k]) - patch.mean;
            correlation += now * before;
            pull += (now - before) * Eigen::Vector2d(double(patch.slopesX[k]), double(patch.slopesY[k]));
        }
        correlation /= double(seen.size()) * patch.deviation * patch.deviation;
        const Eigen::Vector2d step = -(patch.inverse * pull);
        shift += step;
        if (!shift.allFinite() || (shift - start).norm() > side / 2.0)
            return std::nullopt;
        if (step.norm() < settledPx)
            break;
    }
    return correlation > alikeAgain ? std::optional(shift) : std::nullopt;
}

/// By which all patches together correlate best, on coarse samples; nullopt: hardly.
std::optional<Eigen::Vector2d> CameraWatch::searchCommonShift(const PlaneView &luma) const
{
    double best = 0;
    Eigen::Vector2d found = Eigen::Vector2d::Zero();
    for (int dy = -searchPx; dy <= searchPx; dy += searchStep) {
        for (int dx = -searchPx; dx <= searchPx; dx += searchStep) {
            double sum = 0, all = 0;
            for (const Patch &patch : m_patches) {
                const int x0 = patch.x + dx, y0 = patch.y + dy;
                if (x0 < 0 || y0 < 0 || x0 + side > luma.width || y0 + side > luma.height)
                    continue;
                double product = 0, now = 0, squares = 0, beforeSum = 0, beforeSquares = 0, count = 0;
                for (int y = 0; y < side; y += searchGrid) {
                    const std::uint8_t *line = luma.row(y0 + y) + x0;
                    for (int x = 0; x < side; x += searchGrid) {
                        const double value = line[x],
                                     before = double(patch.values[std::size_t(y * side + x)]) - patch.mean;
                        product += value * before;
                        now += value;
                        squares += value * value;
                        beforeSum += before;
                        beforeSquares += before * before;
                        count += 1;
                    }
                }
                const double variance =
                    (squares - now * now / count) * (beforeSquares - beforeSum * beforeSum / count);
                if (variance > 0)
                    sum += std::max(0.0, (product - now * beforeSum / count) / std::sqrt(variance));
                all += 1;
            }
            if (2 * all > double(m_patches.size()) && sum / all > best) {
                best = sum / all;
                found = {double(dx), double(dy)};
            }
        }
    }
    constexpr double leastAlike = 0.5;
    return best > leastAlike ? std::optional(found) : std::nullopt;
}

void CameraWatch::look(const PlaneView &luma, Nanoseconds time)
{
    const auto findAll = [&](const std::optional<Eigen::Vector2d> &from) {
        std::vector<double> shifts;
        for (Patch &patch : m_patches) {
            const auto shift = findNear(patch, luma, from.value_or(patch.shiftPx));
            if (!shift)
                continue;
            patch.shiftPx = *shift;
            shifts.push_back(shift->norm());
        }
        return shifts;
    };
    if (!m_isTried) { // what is not found a moment later is noise, or moves by itself
        m_isTried = true;
        std::erase_if(m_patches, [&](const Patch &one) { return !findNear(one, luma, one.shiftPx); });
    }
    const double enough = std::max(double(fewestPatches), fewestFound * double(m_patches.size()));
    std::vector<double> shifts = findAll(std::nullopt);
    if (double(shifts.size()) < enough) {
        if (const auto common = searchCommonShift(luma))
            shifts = findAll(common);
    }
    if (double(shifts.size()) < enough)
        return;
    const auto moved = double(std::ranges::count_if(shifts, [](double shift) { return shift > movedPx; }));
    const Look now{time, upperMedian(shifts), moved > movedShare * double(shifts.size())};
    const bool isDecided =
        !m_looks.empty() && m_looks.back().isMoved && m_looks.back().time - m_looks.front().time > lasting;
    if (!now.isMoved && !isDecided)
        m_looks.clear();
    if (!isDecided || now.isMoved)
        m_looks.push_back(now);
}

void CameraWatch::add(const Frame &frame)
{
    const Nanoseconds wanted = frame.validRegion ? ofParts : lookInterval;
    if (m_lastLook && frame.time - *m_lastLook < wanted)
        return;
    m_lastLook = frame.time;
    const auto whole = wholeFrame(frame);
    if (!whole)
        return;
    if (!m_isChosen) {
        m_isChosen = true;
        m_width = whole->y.width;
        m_height = whole->y.height;
        choosePatches(whole->y);
        return;
    }
    if (m_patches.size() >= fewestPatches && whole->y.width == m_width && whole->y.height == m_height)
        look(whole->y, whole->time);
}

std::optional<CameraMove> CameraWatch::move() const
{
    constexpr std::size_t leastLooks = 3;
    std::vector<double> shifts;
    for (const Look &one : m_looks)
        if (one.isMoved)
            shifts.push_back(one.shiftPx);
    if (shifts.size() < leastLooks)
        return std::nullopt;
    return CameraMove{m_looks.front().time, upperMedian(std::move(shifts))};
}

} // namespace odo
