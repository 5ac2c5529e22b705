// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/region_measure.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::uint8_t outsideClass = 0, edgeClass = 1, insideClass = 2;
constexpr double alphaLow = 0.1, alphaRange = 0.8;
constexpr int farthestReference = 6;  ///< samples from an edge sample to what is wholly in or out
constexpr double leastContrast = 5.0; ///< code values between inside and outside, else the mask decides
constexpr double referenceNoise =
    1.35; ///< variance of alpha with that of its two references, each of two samples
constexpr double leastNoise = 0.35;             ///< rounding to whole code values
constexpr double modelVariance = 0.015 * 0.015; ///< what the finite number of samples leaves in the centre

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

int RegionMeasure::classAt(int x, int y) const
{
    if (!m_area.contains(x, y))
        return outsideClass;
    return m_classes[static_cast<std::size_t>(y - m_area.top) * m_area.width() + (x - m_area.left)];
}

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

void RegionMeasure::addEdge(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
                            const Chroma &inside, double noise, Sums &sums) const
{
    const Eigen::Vector2d centre = blob.centre();
    const Eigen::Matrix2d inverse = blob.covariance().inverse();
    const ChromaRect bounds = grid.bounds();
    const ChromaRect area = m_area.clippedTo(bounds);
    const double noiseOfAlpha = referenceNoise * noise * noise / (alphaRange * alphaRange);

    // The mean of the first two samples along the normal that are wholly of the wanted class; false when
    // there are none near.
    const auto reference = [&](double x, double y, double nx, double ny, int wanted, Chroma &mean) {
        for (int r = 1; r <= farthestReference; ++r) {
            const int sx = static_cast<int>(std::lround(x + r * nx)),
                      sy = static_cast<int>(std::lround(y + r * ny));
            if (!bounds.contains(sx, sy))
                return false;
            if (classAt(sx, sy) != wanted)
                continue;
            const int tx = static_cast<int>(std::lround(x + (r + 1) * nx));
            const int ty = static_cast<int>(std::lround(y + (r + 1) * ny));
            const bool both = bounds.contains(tx, ty) && classAt(tx, ty) == wanted;
            mean = both ? Chroma((grid.at(sx, sy) + grid.at(tx, ty)) / 2) : grid.at(sx, sy);
            return true;
        }
        return false;
    };

    for (int y = area.top; y < area.bottom; ++y) {
        const std::uint8_t *c =
            m_classes.data() + static_cast<std::ptrdiff_t>(y - m_area.top) * m_area.width();
        for (int x = area.left; x < area.right; ++x) {
            if (c[x - m_area.left] != edgeClass)
                continue;
            const double dx = x - centre.x(), dy = y - centre.y();
            double nx = inverse(0, 0) * dx + inverse(0, 1) * dy, ny = inverse(1, 0) * dx + inverse(1, 1) * dy;
            const double length = std::hypot(nx, ny);
            nx /= length, ny /= length;
            Chroma in, out;
            double alpha = mask.at(x, y) ? 1.0 : 0.0;
            if (length > 0 && reference(x, y, nx, ny, outsideClass, out)) {
                if (!reference(x, y, -nx, -ny, insideClass, in))
                    in = inside;
                const Chroma contrast = in - out;
                const double squared = contrast.squaredNorm();
                if (squared >= leastContrast * leastContrast) {
                    const double linear = (grid.at(x, y) - out).dot(contrast) / squared;
                    alpha = std::clamp((linear - alphaLow) / alphaRange, 0.0, 1.0);
                    if (alpha > 0 && alpha < 1)
                        sums.addNoise(noiseOfAlpha / squared, dx, dy);
                }
            }
            sums.add(alpha, dx, dy);
        }
    }
}

RegionShape RegionMeasure::measure(const ChromaGrid &grid, const Blob &blob, const RegionMask &mask,
                                   const Chroma &expected)
{
    classify(mask);
    RegionShape shape;

    double n = 0, pairs = 0, squares = 0;
    Chroma sum = Chroma::Zero();
    for (int y = blob.box.top; y < blob.box.bottom; ++y) {
        int rowN = 0, rowU = 0, rowV = 0;
        for (int x = blob.box.left; x < blob.box.right; ++x) {
            if (classAt(x, y) != insideClass)
                continue;
            const int u = grid.u.at(x, y), v = grid.v.at(x, y);
            ++rowN;
            rowU += u;
            rowV += v;
            if (classAt(x + 1, y) == insideClass) {
                const int du = grid.u.at(x + 1, y) - u, dv = grid.v.at(x + 1, y) - v;
                squares += du * du + dv * dv;
                ++pairs;
            }
        }
        n += rowN;
        sum += Chroma(rowU - 128.0 * rowN, rowV - 128.0 * rowN);
    }
    shape.colour = n > 0 ? Chroma(sum / n) : expected;
    shape.noise = std::max(leastNoise, pairs > 0 ? std::sqrt(squares / (4 * pairs)) : 2.0);

    Sums sums;
    addInside(grid, blob, sums);
    addEdge(grid, blob, mask, shape.colour, shape.noise, sums);
    if (sums.area < 1) {
        shape.area = blob.area();
        shape.centre = blob.centre();
        shape.covariance = blob.covariance();
        shape.centreCovariance = Eigen::Matrix2d::Identity() * 0.25;
        return shape;
    }
    const double a = sums.area, mx = sums.x / a, my = sums.y / a;
    shape.area = a;
    shape.centre = blob.centre() + Eigen::Vector2d(mx, my);
    shape.covariance << sums.xx / a - mx * mx + 1.0 / 12, sums.xy / a - mx * my, sums.xy / a - mx * my,
        sums.yy / a - my * my + 1.0 / 12;
    shape.centreCovariance << sums.noiseXX, sums.noiseXY, sums.noiseXY, sums.noiseYY;
    shape.centreCovariance /= a * a;
    shape.centreCovariance.diagonal().array() += modelVariance;
    return shape;
}

Ellipse ellipseOf(const RegionShape &shape, const ChromaGrid &grid)
{
    const Eigen::Matrix2d cov = grid.scale.asDiagonal() * shape.covariance * grid.scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(cov);
    Ellipse ellipse;
    ellipse.centrePx = grid.toLuma(shape.centre);
    ellipse.semiMinorPx = 2 * std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
    ellipse.semiMajorPx = 2 * std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
    const Eigen::Vector2d axis = solver.eigenvectors().col(1);
    ellipse.angleRad = std::atan2(axis.y(), axis.x());
    return ellipse;
}

} // namespace odo
