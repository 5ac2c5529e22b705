// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/blob_finder.h"

#include "core/tracking/internal/fetch_early.h"
#include "core/tracking/observation.h"

#include <algorithm>
#include <cmath>

namespace odo {

Eigen::Matrix2d Blob::covariance() const
{
    const Eigen::Vector2d mean = centre();
    const double own = step * step / 12.0;
    Eigen::Matrix2d cov;
    cov(0, 0) = sumXX / count - mean.x() * mean.x() + own;
    cov(1, 1) = sumYY / count - mean.y() * mean.y() + own;
    cov(0, 1) = cov(1, 0) = sumXY / count - mean.x() * mean.y();
    return cov;
}

void RegionMask::reset(const ChromaRect &newArea)
{
    area = newArea;
    bytes.assign(static_cast<std::size_t>(area.width()) * area.height(), 0);
}

void BlobFinder::find(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step)
{
    if (step == 1 && !area.isEmpty()) {
        const PixelRect samples{area.left, area.top, area.right, area.bottom};
        fetchEarly(grid.u, samples);
        fetchEarly(grid.v, samples);
    }
    m_runs.clear();
    m_parents.clear();
    m_blobs.clear();
    findRuns(grid, table, area, step);
    gatherBlobs(step);
}

int BlobFinder::rootOf(int label)
{
    while (m_parents[label] != label) {
        m_parents[label] = m_parents[m_parents[label]];
        label = m_parents[label];
    }
    return label;
}

int BlobFinder::joinWithRowAbove(const Run &run, std::size_t &above, std::size_t aboveEnd, int step)
{
    while (above < aboveEnd && m_runs[above].last < run.first - step)
        ++above;
    int label = -1;
    for (std::size_t i = above; i < aboveEnd && m_runs[i].first <= run.last + step; ++i) {
        const int root = rootOf(m_runs[i].label);
        if (label >= 0)
            m_parents[std::max(label, root)] = std::min(label, root);
        label = label < 0 ? root : std::min(label, root);
    }
    if (label < 0) {
        label = static_cast<int>(m_parents.size());
        m_parents.push_back(label);
    }
    return label;
}

/// The runs of one row. One sample missing because of noise does not break a run.
void BlobFinder::findRunsInRow(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area,
                               int y, int step)
{
    const std::uint8_t *u = grid.u.row(y), *v = grid.v.row(y);
    const int reach = 2 * step;
    // Blocks without the robot's colour are passed over, as long as that keeps to the lattice of the step.
    const int block = ChromaTable::blockSamples % step == 0 ? ChromaTable::blockSamples : area.width();
    for (int x = area.left; x < area.right;) {
        const int end = std::min(x + block, area.right);
        if (end - x == ChromaTable::blockSamples && !table.mayTakeBlock(u + x, v + x)) {
            x = end;
            continue;
        }
        while (x < end && table.weight(u[x], v[x]) < ChromaTable::threshold)
            x += step;
        if (x >= end)
            continue;
        Run run{y, x, x, 0, 0, 0, 0, 0};
        for (; x < area.right && x - run.last <= reach; x += step) {
            const std::uint8_t weight = table.weight(u[x], v[x]);
            if (weight < ChromaTable::threshold)
                continue;
            run.last = x;
            ++run.taken;
            run.weight += weight;
            run.sumU += u[x];
            run.sumV += v[x];
        }
        m_runs.push_back(run);
    }
}

/// Those of its parts that are searched, on the lattice of the step.
void BlobFinder::findSearchedRunsInRow(const ChromaGrid &grid, const ChromaTable &table,
                                       const ChromaRect &area, int y, int step)
{
    for (int x = m_searched->nextSet(area.left, y); x < area.right;) {
        const int end = std::min(m_searched->nextClear(x, y), area.right);
        ChromaRect part = area;
        part.left = area.left + (x - area.left + step - 1) / step * step;
        part.right = end;
        if (part.left < end)
            findRunsInRow(grid, table, part, y, step);
        x = end < area.right ? m_searched->nextSet(end, y) : end;
    }
}

void BlobFinder::findRuns(const ChromaGrid &grid, const ChromaTable &table, const ChromaRect &area, int step)
{
    std::size_t aboveBegin = 0;
    for (int y = area.top; y < area.bottom; y += step) {
        const std::size_t rowBegin = m_runs.size();
        if (m_searched)
            findSearchedRunsInRow(grid, table, area, y, step);
        else
            findRunsInRow(grid, table, area, y, step);
        const std::size_t rowEnd = m_runs.size();
        std::size_t above = aboveBegin;
        for (std::size_t i = rowBegin; i < rowEnd; ++i)
            m_runs[i].label = joinWithRowAbove(m_runs[i], above, rowBegin, step);
        aboveBegin = rowBegin;
    }
}

void BlobFinder::gatherBlobs(int step)
{
    m_blobOfLabel.assign(m_parents.size(), -1);
    for (const Run &run : m_runs) {
        const int root = rootOf(run.label);
        if (m_blobOfLabel[root] < 0) {
            m_blobOfLabel[root] = static_cast<int>(m_blobs.size());
            Blob blob;
            blob.label = root;
            blob.step = step;
            blob.box = {run.first, run.y, run.last + 1, run.y + 1};
            m_blobs.push_back(blob);
        }
        Blob &blob = m_blobs[m_blobOfLabel[root]];
        const int pixels = (run.last - run.first) / step + 1;
        const double n = pixels;
        const double mid = 0.5 * (run.first + run.last);
        blob.count += n;
        blob.sumX += n * mid;
        blob.sumY += n * run.y;
        blob.sumXX += n * mid * mid + step * step * n * (n * n - 1) / 12.0;
        blob.sumXY += n * mid * run.y;
        blob.sumYY += n * run.y * static_cast<double>(run.y);
        blob.visited += run.taken;
        blob.weight += run.weight;
        blob.sumU += run.sumU;
        blob.sumV += run.sumV;
        blob.box = {std::min(blob.box.left, run.first), blob.box.top, std::max(blob.box.right, run.last + 1),
                    run.y + 1};
    }
}

void BlobFinder::paint(const Blob &blob, int margin, RegionMask &mask) const
{
    mask.reset(blob.box.grownBy(margin));
    for (const Run &run : m_runs) {
        int label = run.label;
        while (m_parents[label] != label)
            label = m_parents[label];
        if (label == blob.label)
            std::fill_n(mask.row(run.y) + (run.first - mask.area.left), run.last - run.first + 1,
                        std::uint8_t{1});
    }
}

namespace {

constexpr std::uint8_t outsideClass = 0, edgeClass = 1, insideClass = 2;
constexpr double alphaLow = 0.1, alphaRange = 0.8;
constexpr int farthestReference = 6;        ///< samples from an edge sample to what is wholly in or out
constexpr double leastRegionContrast = 5.0; ///< code values between inside and outside, else the mask decides
constexpr double referenceNoise =
    1.35; ///< variance of alpha with that of its two references, each of two samples
constexpr double leastNoise = 0.35;                   ///< rounding to whole code values
constexpr double centreModelVariance = 0.015 * 0.015; ///< what the finite number of samples leaves there

} // namespace

/// Moments about the blob's centre, which keeps them well conditioned.
struct RegionMeasure::Sums
{
    double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    double noiseXX = 0, noiseXY = 0, noiseYY = 0; ///< of the variance of alpha

    void add(double alpha, double dx, double dy)
    {
        area += alpha;
        x += alpha * dx;
        y += alpha * dy;
        xx += alpha * dx * dx;
        xy += alpha * dx * dy;
        yy += alpha * dy * dy;
    }
    void addNoise(double variance, double dx, double dy)
    {
        noiseXX += variance * dx * dx;
        noiseXY += variance * dx * dy;
        noiseYY += variance * dy * dy;
    }
};

void RegionMeasure::classify(const RegionMask &mask)
{
    m_area = mask.area;
    m_classes.assign(mask.bytes.size(), outsideClass);
    const int w = m_area.width();
    for (int y = 2; y < m_area.height() - 2; ++y) {
        const std::uint8_t *m = mask.bytes.data() + static_cast<std::ptrdiff_t>(y) * w;
        std::uint8_t *c = m_classes.data() + static_cast<std::ptrdiff_t>(y) * w;
        for (int x = 2; x < w - 2; ++x) {
            const int any = m[x] | m[x - 1] | m[x + 1] | m[x - w] | m[x + w] | m[x - 2] | m[x + 2] |
                            m[x - 2 * w] | m[x + 2 * w] | m[x - w - 1] | m[x - w + 1] | m[x + w - 1] |
                            m[x + w + 1];
            const int all = m[x] & m[x - 1] & m[x + 1] & m[x - w] & m[x + w] & m[x - 2] & m[x + 2] &
                            m[x - 2 * w] & m[x + 2 * w] & m[x - w - 1] & m[x - w + 1] & m[x + w - 1] &
                            m[x + w + 1];
            c[x] = static_cast<std::uint8_t>(any + all);
        }
    }
}

/// Mean chroma of the samples inside, and their noise from the differences of neighbours, which shading
/// leaves alone.
void RegionMeasure::readColour(const ChromaGrid &grid, const Blob &blob, const Chroma &expected,
                               RegionShape &shape) const
{
    // Every other row will do for a large region.
    const int step = blob.box.height() > 24 ? 2 : 1;
    std::int64_t n = 0, sumU = 0, sumV = 0, pairs = 0, squares = 0;
    for (int y = blob.box.top; y < blob.box.bottom; y += step) {
        const std::uint8_t *c = rowOfClasses(y);
        const std::uint8_t *u = grid.u.row(y), *v = grid.v.row(y);
        int rowN = 0, rowU = 0, rowV = 0, rowPairs = 0, rowSquares = 0;
        for (int x = blob.box.left; x < blob.box.right - 1; ++x) {
            const int inside = c[x] >> 1, both = inside & (c[x + 1] >> 1);
            const int du = u[x + 1] - u[x], dv = v[x + 1] - v[x];
            rowN += inside;
            rowU += inside * u[x];
            rowV += inside * v[x];
            rowPairs += both;
            rowSquares += both * (du * du + dv * dv);
        }
        n += rowN, sumU += rowU, sumV += rowV, pairs += rowPairs, squares += rowSquares;
    }
    const auto count = static_cast<double>(n);
    shape.colour =
        n > 0 ? Chroma(static_cast<double>(sumU) / count - 128.0, static_cast<double>(sumV) / count - 128.0)
              : expected;
    const double variance =
        pairs > 0 ? static_cast<double>(squares) / (4.0 * static_cast<double>(pairs)) : 4.0;
    shape.noise = std::max(leastNoise, std::sqrt(variance));
}

void RegionMeasure::addInside(const ChromaGrid &grid, const Blob &blob, Sums &sums) const
{
    const Eigen::Vector2d centre = blob.centre();
    const ChromaRect area = m_area.clippedTo(grid.bounds());
    for (int y = area.top; y < area.bottom; ++y) {
        const std::uint8_t *c =
            m_classes.data() + static_cast<std::ptrdiff_t>(y - m_area.top) * m_area.width();
        int n = 0;
        std::int64_t sum = 0, squares = 0;
        for (int x = area.left - m_area.left; x < area.right - m_area.left; ++x) {
            const int inside = c[x] >> 1;
            n += inside;
            sum += inside * x;
            squares += static_cast<std::int64_t>(inside * x) * x;
        }
        const double shift = m_area.left - centre.x(), dy = y - centre.y();
        sums.area += n;
        sums.x += static_cast<double>(sum) + n * shift;
        sums.xx += static_cast<double>(squares) + 2 * shift * static_cast<double>(sum) + n * shift * shift;
        sums.y += n * dy;
        sums.xy += (static_cast<double>(sum) + n * shift) * dy;
        sums.yy += n * dy * dy;
    }
}

/// Walks from sample (x, y) along a direction (in 1/256 samples a step) and gives the sum of the first two
/// samples of the wanted class; false when there are none near. Whole numbers only: this is the innermost
/// loop.
bool RegionMeasure::findReference(const ChromaGrid &grid, int x, int y, int stepX, int stepY, int wanted,
                                  EdgeReference &reference) const
{
    const auto inImage = [&grid](int px, int py) {
        return static_cast<unsigned>(px) < static_cast<unsigned>(grid.u.width) &&
               static_cast<unsigned>(py) < static_cast<unsigned>(grid.u.height);
    };
    int fineX = (x << 8) + 128, fineY = (y << 8) + 128;
    for (int r = 1; r <= farthestReference; ++r) {
        fineX += stepX, fineY += stepY;
        const int px = fineX >> 8, py = fineY >> 8;
        if (!inImage(px, py))
            return false;
        if (classAt(px, py) != wanted)
            continue;
        int qx = (fineX + stepX) >> 8, qy = (fineY + stepY) >> 8;
        if (!inImage(qx, qy) || classAt(qx, qy) != wanted)
            qx = px, qy = py;
        reference.u = 0.5f * static_cast<float>(grid.u.at(px, py) + grid.u.at(qx, qy));
        reference.v = 0.5f * static_cast<float>(grid.v.at(px, py) + grid.v.at(qx, qy));
        return true;
    }
    return false;
}

bool RegionMeasure::isBackground(float du, float dv, const EdgeReference &in, const EdgeReference &out)
{
    const float cu = in.u - out.u, cv = in.v - out.v;
    return du * cu + dv * cv < static_cast<float>(0.5 * alphaLow) * (cu * cu + cv * cv);
}

void RegionMeasure::addEdge(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
                            const RegionShape &shape, Sums &sums) const
{
    const Eigen::Vector2d centre = blob.centre();
    const Eigen::Matrix2f inverse = blob.covariance().inverse().cast<float>();
    const EdgeReference wholeInside{static_cast<float>(shape.colour.x() + 128),
                                    static_cast<float>(shape.colour.y() + 128)};
    const double noiseOfAlpha = referenceNoise * shape.noise * shape.noise / (alphaRange * alphaRange);
    const ChromaRect area = m_area.clippedTo(grid.bounds());
    for (int y = area.top; y < area.bottom; ++y) {
        const std::uint8_t *c = rowOfClasses(y);
        const std::uint8_t *m = mask.row(y) - mask.area.left;
        for (int x = area.left; x < area.right; ++x) {
            if (c[x] != edgeClass)
                continue;
            const double dx = x - centre.x(), dy = y - centre.y();
            const auto fx = static_cast<float>(dx), fy = static_cast<float>(dy);
            const float nx = inverse(0, 0) * fx + inverse(0, 1) * fy,
                        ny = inverse(1, 0) * fx + inverse(1, 1) * fy;
            const float unit = 256.0f / std::sqrt(std::max(nx * nx + ny * ny, 1e-20f));
            const int stepX = static_cast<int>(nx * unit), stepY = static_cast<int>(ny * unit);
            EdgeReference in, out;
            double alpha = m[x];
            if (findReference(grid, x, y, stepX, stepY, outsideClass, out)) {
                // So like the background that not even a side of half the robot's chroma would show: most
                // outer samples.
                if (isBackground(grid.u.at(x, y) - out.u, grid.v.at(x, y) - out.v, wholeInside, out))
                    continue;
                if (!findReference(grid, x, y, -stepX, -stepY, insideClass, in))
                    in = wholeInside;
                const float du = in.u - out.u, dv = in.v - out.v;
                const float squared = du * du + dv * dv;
                if (squared >= leastRegionContrast * leastRegionContrast) {
                    const float along = (grid.u.at(x, y) - out.u) * du + (grid.v.at(x, y) - out.v) * dv;
                    alpha = std::clamp((along / squared - alphaLow) / alphaRange, 0.0, 1.0);
                    if (alpha > 0 && alpha < 1)
                        sums.addNoise(noiseOfAlpha / squared, dx, dy);
                }
            }
            sums.add(alpha, dx, dy);
        }
    }
}

RegionShape RegionMeasure::examine(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
                                   const Chroma &expected)
{
    classify(mask);
    RegionShape shape;
    readColour(grid, blob, expected, shape);
    shape.area = blob.area();
    shape.centre = blob.centre();
    shape.covariance = blob.covariance();
    shape.centreCovariance = Eigen::Matrix2d::Identity() * 0.25;
    return shape;
}

RegionShape RegionMeasure::measure(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
                                   const Chroma &expected)
{
    RegionShape shape = examine(grid, blob, mask, expected);
    Sums sums;
    addInside(grid, blob, sums);
    addEdge(grid, blob, mask, shape, sums);
    if (sums.area < 1)
        return shape;
    const double a = sums.area, mx = sums.x / a, my = sums.y / a;
    shape.area = a;
    shape.centre = blob.centre() + Eigen::Vector2d(mx, my);
    shape.covariance << sums.xx / a - mx * mx + 1.0 / 12, sums.xy / a - mx * my, sums.xy / a - mx * my,
        sums.yy / a - my * my + 1.0 / 12;
    shape.centreCovariance << sums.noiseXX, sums.noiseXY, sums.noiseXY, sums.noiseYY;
    shape.centreCovariance /= a * a;
    shape.centreCovariance.diagonal().array() += centreModelVariance;
    return shape;
}

Ellipse ellipseOf(const RegionShape &shape, const ChromaGrid &grid)
{
    return ellipseOf(grid.toLuma(shape.centre),
                     grid.scale.asDiagonal() * shape.covariance * grid.scale.asDiagonal());
}

} // namespace odo
