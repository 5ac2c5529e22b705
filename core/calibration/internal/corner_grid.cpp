// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/corner_grid.h"

#include "core/base/job_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <set>

namespace odo {

namespace {

using cv::Point2f;
using Cell = std::array<int, 2>;

constexpr float nearestNeighbour = 8;   // pixels
constexpr float coneCosine = 0.94F;     // 20° about an edge
constexpr float snapping = 0.3F;        // of a step: how far a corner may lie from where it is expected
constexpr float intoField = 0.3F;       // of a step: where the fields around a corner are sampled
constexpr float leastFieldContrast = 8; // grey levels
constexpr int mostSeeds = 60;
constexpr int largestSide = 60;
constexpr int mostWithoutSaddle = 3000; // brickwork and tiles are full of places that are nearly corners

float norm(Point2f v)
{
    return std::hypot(v.x, v.y);
}

/// Saddle points by where they are, to find the nearest ones without a look at all of them.
class PointMap
{
public:
    PointMap(const std::vector<SaddlePoint> &points, cv::Size size)
        : m_points(points), m_columns(size.width / fieldPx + 1), m_rows(size.height / fieldPx + 1),
          m_fields(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows))
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            m_fields[fieldAt(columnOf(points[i].position), rowOf(points[i].position))].push_back(i);
    }

    /// The nearest point that is accepted and nearer than this; among equally near ones the first. Null if
    /// there is none.
    template <class Accepted>
    const SaddlePoint *nearest(Point2f to, float least, Accepted accepted) const
    {
        const int column = columnOf(to), row = rowOf(to);
        std::size_t best = m_points.size();
        for (int ring = 0; ring <= std::max(m_columns, m_rows); ++ring) {
            if (static_cast<float>((ring - 1) * fieldPx) > least)
                break;
            visitRing(column, row, ring, [&](std::size_t i) {
                const float distance = norm(m_points[i].position - to);
                const bool isNearer = distance < least || (distance == least && i < best);
                if (isNearer && accepted(m_points[i].position - to, distance)) {
                    least = distance;
                    best = i;
                }
            });
        }
        return best < m_points.size() ? &m_points[best] : nullptr;
    }

private:
    static constexpr int fieldPx = 24;

    int columnOf(Point2f position) const
    {
        return std::clamp(static_cast<int>(position.x) / fieldPx, 0, m_columns - 1);
    }
    int rowOf(Point2f position) const
    {
        return std::clamp(static_cast<int>(position.y) / fieldPx, 0, m_rows - 1);
    }
    std::size_t fieldAt(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(column);
    }
    template <class Visit>
    void visitRing(int column, int row, int ring, Visit visit) const
    {
        for (int y = std::max(row - ring, 0); y <= std::min(row + ring, m_rows - 1); ++y) {
            const bool isWholeLine = std::abs(y - row) == ring;
            for (int x = column - ring; x <= column + ring; x += isWholeLine || ring == 0 ? 1 : 2 * ring) {
                if (x < 0 || x >= m_columns)
                    continue;
                for (const std::size_t i : m_fields[fieldAt(x, y)])
                    visit(i);
            }
        }
    }

    const std::vector<SaddlePoint> &m_points;
    int m_columns, m_rows;
    std::vector<std::vector<std::size_t>> m_fields;
};

/// Grows one grid from one corner.
class Grower
{
public:
    Grower(const cv::Mat &smoothed, const std::vector<SaddlePoint> &points)
        : m_smoothed(smoothed), m_points(points, smoothed.size())
    {
    }

    /// False when the point has no neighbours that make a corner of a board.
    bool seed(const SaddlePoint &start)
    {
        m_cells.clear();
        for (float sideA : {1.0F, -1.0F}) {
            for (float sideB : {1.0F, -1.0F}) {
                const auto along = neighbour(start, sideA * start.edges[0]);
                const auto across = neighbour(start, sideB * start.edges[1]);
                if (!along || !across)
                    continue;
                const Point2f u = *along - start.position, v = *across - start.position;
                if (norm(u) > 4 * norm(v) || norm(v) > 4 * norm(u))
                    continue;
                m_brightSign = 1;
                if (!areFieldsRight(start.position, u, v, {0, 0}))
                    m_brightSign = -1;
                if (!areFieldsRight(start.position, u, v, {0, 0}) || !areFieldsRight(*along, u, v, {1, 0}) ||
                    !areFieldsRight(*across, u, v, {0, 1}))
                    continue;
                m_cells = {{{0, 0}, start.position}, {{1, 0}, *along}, {{0, 1}, *across}};
                return true;
            }
        }
        return false;
    }

    void grow()
    {
        std::vector<Cell> edge;
        for (const auto &[cell, position] : m_cells)
            edge.push_back(cell);
        for (std::size_t i = 0; i < edge.size(); ++i) {
            const Cell from = edge[i];
            for (const Cell &step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
                const Cell cell{from[0] + step[0], from[1] + step[1]};
                if (place(cell, from))
                    edge.push_back(cell);
            }
        }
    }

    const std::map<Cell, Point2f> &cells() const { return m_cells; }

private:
    std::optional<Point2f> neighbour(const SaddlePoint &start, Point2f direction) const
    {
        const auto *nearest = m_points.nearest(start.position, 1e9F, [&](Point2f away, float distance) {
            return distance >= nearestNeighbour && away.dot(direction) >= coneCosine * distance;
        });
        return nearest ? std::optional(nearest->position) : std::nullopt;
    }

    std::optional<Point2f> corner(const Cell &cell) const
    {
        const auto found = m_cells.find(cell);
        return found == m_cells.end() ? std::nullopt : std::optional(found->second);
    }

    /// The step from one corner to the next along an axis, as seen at a cell or else beside it.
    std::optional<Point2f> stepAt(const Cell &cell, std::size_t axis) const
    {
        for (int beside : {0, 1, -1}) {
            Cell middle = cell;
            middle[1 - axis] += beside;
            Cell before = middle, after = middle;
            --before[axis];
            ++after[axis];
            const auto here = corner(middle), last = corner(before), next = corner(after);
            if (here && last && next)
                return 0.5F * (*next - *last);
            if (here && next)
                return *next - *here;
            if (here && last)
                return *here - *last;
        }
        return std::nullopt;
    }

    bool place(const Cell &cell, const Cell &from)
    {
        const int across = std::max(std::abs(cell[0]), std::abs(cell[1]));
        if (m_cells.contains(cell) || across > largestSide)
            return false;
        const auto u = stepAt(from, 0), v = stepAt(from, 1);
        if (!u || !v)
            return false;
        const Point2f step =
            static_cast<float>(cell[0] - from[0]) * *u + static_cast<float>(cell[1] - from[1]) * *v;
        const Point2f expected = m_cells.at(from) + step;
        const auto position = snapped(expected, snapping * std::min(norm(*u), norm(*v)));
        if (!position || !areFieldsRight(*position, *u, *v, cell))
            return false;
        m_cells[cell] = *position;
        return true;
    }

    /// The saddle point nearest to where a corner is expected, or the corner that gradients point to there.
    std::optional<Point2f> snapped(Point2f expected, float tolerance) const
    {
        if (expected.x < 1 || expected.y < 1 || expected.x > static_cast<float>(m_smoothed.cols - 2) ||
            expected.y > static_cast<float>(m_smoothed.rows - 2))
            return std::nullopt;
        if (const auto *nearest = m_points.nearest(expected, std::nextafter(tolerance, HUGE_VALF),
                                                   [](Point2f, float) { return true; }))
            return nearest->position;
        if (++m_withoutSaddle > mostWithoutSaddle)
            return std::nullopt;
        std::vector<Point2f> corner{expected};
        const int half = std::clamp(static_cast<int>(tolerance), 2, 11);
        cv::cornerSubPix(m_smoothed, corner, {half, half}, {-1, -1},
                         {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.05});
        if (norm(corner.front() - expected) > tolerance)
            return std::nullopt;
        return corner.front();
    }

    /// Whether two opposite fields are brighter than the two others, in the turn that the cell's parity asks
    /// for.
    bool areFieldsRight(Point2f position, Point2f u, Point2f v, const Cell &cell) const
    {
        const Point2f sum = intoField * (u + v), difference = intoField * (u - v);
        const auto [darkA, brightA] =
            std::minmax({greyAt(m_smoothed, position + sum), greyAt(m_smoothed, position - sum)});
        const auto [darkB, brightB] = std::minmax(
            {greyAt(m_smoothed, position + difference), greyAt(m_smoothed, position - difference)});
        const bool even = (cell[0] + cell[1]) % 2 == 0;
        const bool isABright = even == (m_brightSign > 0);
        const float gap = isABright ? darkA - brightB : darkB - brightA;
        const float range = std::max(brightA, brightB) - std::min(darkA, darkB);
        return gap > leastFieldContrast && gap > 0.25F * range;
    }

    const cv::Mat &m_smoothed;
    const PointMap m_points;
    std::map<Cell, Point2f> m_cells;
    mutable int m_withoutSaddle = 0; ///< corners sought where there is no saddle point, of all grids

    int m_brightSign = 1;
};

struct Rectangle
{
    int left = 0, top = 0, columns = 0, rows = 0;
};

/// The largest rectangle of which no corner is missing.
Rectangle fullRectangle(const std::map<Cell, Point2f> &cells)
{
    Cell low{0, 0}, high{0, 0};
    for (const auto &[cell, position] : cells) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], cell[axis]);
            high[axis] = std::max(high[axis], cell[axis]);
        }
    }
    const int columns = high[0] - low[0] + 1, rows = high[1] - low[1] + 1;
    std::vector<bool> there(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y - low[1]) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(x - low[0]);
    };
    for (const auto &[cell, position] : cells)
        there[index(cell[0], cell[1])] = true;
    Rectangle best;
    for (int top = low[1]; top <= high[1]; ++top) {
        std::vector<bool> full(static_cast<std::size_t>(columns), true); // from the top row down to this one
        for (int bottom = top; bottom <= high[1]; ++bottom) {
            int run = 0;
            for (int x = low[0]; x <= high[0]; ++x) {
                const auto column = static_cast<std::size_t>(x - low[0]);
                full[column] = full[column] && there[index(x, bottom)];
                run = full[column] ? run + 1 : 0;
                const int height = bottom - top + 1;
                if (run * height > best.columns * best.rows)
                    best = {x - run + 1, top, run, height};
            }
        }
    }
    return best;
}

CornerGrid gridOf(const std::map<Cell, Point2f> &cells)
{
    const Rectangle rectangle = fullRectangle(cells);
    CornerGrid grid{rectangle.columns, rectangle.rows, {}};
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns; ++x)
            grid.corners.push_back(cells.at({rectangle.left + x, rectangle.top + y}));
    }
    if (grid.columns < 3 || grid.rows < 3)
        return {};
    const Point2f u = grid.at(1, 0) - grid.at(0, 0), v = grid.at(0, 1) - grid.at(0, 0);
    if (u.x * v.y - u.y * v.x < 0) { // left-handed: read each row backwards
        for (int y = 0; y < grid.rows; ++y)
            std::reverse(grid.corners.begin() + y * grid.columns,
                         grid.corners.begin() + (y + 1) * grid.columns);
    }
    return grid;
}

} // namespace

float CornerGrid::spacing() const
{
    std::vector<float> steps;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            if (x > 0)
                steps.push_back(norm(at(x, y) - at(x - 1, y)));
            if (y > 0)
                steps.push_back(norm(at(x, y) - at(x, y - 1)));
        }
    }
    if (steps.empty())
        return 0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

CornerGrid findCornerGrid(const cv::Mat &grey)
{
    cv::Mat smoothed;
    cv::GaussianBlur(grey, smoothed, {0, 0}, 1.2);
    const std::vector<SaddlePoint> points = findSaddlePoints(smoothed);
    Grower grower(smoothed, points);
    CornerGrid best;
    std::set<std::array<float, 2>> grown; // corners that belong to a grid already
    int seeds = 0;
    for (const SaddlePoint &start : points) {
        if (seeds >= mostSeeds)
            break;
        if (grown.contains({start.position.x, start.position.y}))
            continue;
        if (!grower.seed(start))
            continue;
        ++seeds;
        grower.grow();
        for (const auto &[cell, position] : grower.cells())
            grown.insert({position.x, position.y});
        CornerGrid grid = gridOf(grower.cells());
        if (grid.corners.size() > best.corners.size())
            best = std::move(grid);
        if (2 * best.corners.size() > points.size()) // no larger one can be left
            break;
    }
    return best;
}

namespace {

constexpr int ringSamples = 32;
constexpr float ringRadius = 5;
constexpr float leastSaddleContrast = 12; // grey levels between the fields
constexpr std::size_t mostPoints = 3000;  // an image of gravel is full of them
constexpr float twoPi = 2 * std::numbers::pi_v<float>;

/// Angles where the ring crosses its middle grey, if there are exactly four that lie opposite one another.
std::optional<std::array<float, 4>> crossings(const std::array<float, ringSamples> &ring)
{
    const auto [low, high] = std::ranges::minmax(ring);
    if (high - low < leastSaddleContrast)
        return std::nullopt;
    const float middle = 0.5F * (low + high);
    std::array<float, 4> angles{};
    std::size_t count = 0;
    for (int i = 0; i < ringSamples; ++i) {
        const float here = ring[static_cast<std::size_t>(i)] - middle;
        const float next = ring[static_cast<std::size_t>((i + 1) % ringSamples)] - middle;
        if ((here > 0) == (next > 0))
            continue;
        if (count == 4)
            return std::nullopt;
        angles[count++] = (static_cast<float>(i) + here / (here - next)) * twoPi / ringSamples;
    }
    if (count != 4)
        return std::nullopt;
    constexpr float mostBend = 0.7F, leastField = 0.35F; // radians
    for (std::size_t i = 0; i < 2; ++i) {
        if (std::abs(angles[i + 2] - angles[i] - twoPi / 2) > mostBend)
            return std::nullopt;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const float field = i < 3 ? angles[i + 1] - angles[i] : angles[0] + twoPi - angles[3];
        if (field < leastField)
            return std::nullopt;
    }
    return angles;
}

std::optional<SaddlePoint> describe(const cv::Mat &smoothed, cv::Point2f position)
{
    std::array<float, ringSamples> ring{};
    for (int i = 0; i < ringSamples; ++i) {
        const float angle = static_cast<float>(i) * twoPi / ringSamples;
        ring[static_cast<std::size_t>(i)] =
            greyAt(smoothed, position + ringRadius * cv::Point2f(std::cos(angle), std::sin(angle)));
    }
    const auto angles = crossings(ring);
    if (!angles)
        return std::nullopt;
    SaddlePoint point{position, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        const float angle = 0.5F * ((*angles)[i] + (*angles)[i + 2] - twoPi / 2);
        point.edges[i] = {std::cos(angle), std::sin(angle)};
    }
    return point;
}

constexpr float leastStrength = 100;
constexpr int peakReach = 3; // pixels either side in which a peak is the highest

using Peak = std::pair<float, cv::Point2f>;

/// The negative determinant of the Hessian: large where the grey surface is a saddle.
cv::Mat saddleStrength(const cv::Mat &smoothed)
{
    cv::Mat xx, yy, xy, strength;
    cv::Sobel(smoothed, xx, CV_32F, 2, 0);
    cv::Sobel(smoothed, yy, CV_32F, 0, 2);
    cv::Sobel(smoothed, xy, CV_32F, 1, 1);
    strength = xy.mul(xy) - xx.mul(yy);
    return strength;
}

/// Peaks of the strength in some rows of the image; `strongest` is raised to the strength there.
void addPeaks(const cv::Mat &smoothed, cv::Range rows, std::vector<Peak> &peaks, double &strongest)
{
    const cv::Range wider(std::max(rows.start - peakReach, 0), std::min(rows.end + peakReach, smoothed.rows));
    const cv::Mat strength = saddleStrength(smoothed.rowRange(wider));
    cv::Mat highest;
    cv::dilate(strength, highest, cv::Mat::ones(2 * peakReach + 1, 2 * peakReach + 1, CV_8U));
    double most = 0;
    cv::minMaxLoc(strength, nullptr, &most);
    strongest = std::max(strongest, most);
    for (int y = std::max(rows.start, 2); y < std::min(rows.end, smoothed.rows - 2); ++y) {
        const auto *row = strength.ptr<float>(y - wider.start);
        const auto *top = highest.ptr<float>(y - wider.start);
        for (int x = 2; x < strength.cols - 2; ++x) {
            if (row[x] >= leastStrength && row[x] == top[x])
                peaks.emplace_back(row[x], cv::Point2f(static_cast<float>(x), static_cast<float>(y)));
        }
    }
}

} // namespace

float greyAt(const cv::Mat &image, cv::Point2f position)
{
    const float x = std::clamp(position.x, 0.0F, static_cast<float>(image.cols - 1));
    const float y = std::clamp(position.y, 0.0F, static_cast<float>(image.rows - 1));
    const int column = std::min(static_cast<int>(x), image.cols - 2);
    const int row = std::min(static_cast<int>(y), image.rows - 2);
    const float right = x - static_cast<float>(column), down = y - static_cast<float>(row);
    const auto *upper = image.ptr<std::uint8_t>(row) + column;
    const auto *lower = image.ptr<std::uint8_t>(row + 1) + column;
    const float above = upper[0] + right * static_cast<float>(upper[1] - upper[0]);
    const float below = lower[0] + right * static_cast<float>(lower[1] - lower[0]);
    return above + down * (below - above);
}

std::vector<SaddlePoint> findSaddlePoints(const cv::Mat &smoothed)
{
    // rows at a time: their numbers of 32 bits take many times the memory of the image
    constexpr int band = 256;
    double strongest = 0;
    std::vector<Peak> peaks;
    for (int y = 0; y < smoothed.rows; y += band) {
        endIfCancelled();
        addPeaks(smoothed, {y, std::min(y + band, smoothed.rows)}, peaks, strongest);
    }
    const auto least = static_cast<float>(0.005 * strongest);
    std::erase_if(peaks, [&](const Peak &peak) { return peak.first < least; });
    std::ranges::sort(peaks, std::greater<>(), &Peak::first);
    if (peaks.size() > mostPoints)
        peaks.resize(mostPoints);
    std::vector<SaddlePoint> points;
    for (const auto &peak : peaks) {
        if (const auto point = describe(smoothed, peak.second))
            points.push_back(*point);
    }
    return points;
}

} // namespace odo
