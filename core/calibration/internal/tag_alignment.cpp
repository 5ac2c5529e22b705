// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_alignment.h"

#include "core/base/percentile.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace odo {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double rimCells = 0.6;   // of the white rim that counts: beyond it the paper may end
constexpr int borderPx = 4;        // about that, for the blur
constexpr double smallSidePx = 60; // up to it a pixel is cut into 5 × 5 parts, above into 3 × 3
constexpr double leastTagSidePx = 5, mostImagePx = 30000;
constexpr int mostSidePx = 400;   // above it a tag is aligned in the image at half its size
constexpr int coarseSidePx = 120; // above it that is done first, and refined
constexpr double startVariance = 0.25, mostVariance = 6; // of the image's own blur, px²
constexpr double coarseOfCell = 0.3,
                 leastCoarsePx = 0.9; // blur of the image to catch a start that is far off
constexpr double leastSeen = 0.7;     // of it, in the image
constexpr int mostIterations = 25;
constexpr double stillPx = 0.002;
constexpr double mostMovedCells = 1.5;
constexpr double huber = 1.5;
constexpr double leastGreySigma = 0.5; // rounding alone leaves 0.3

constexpr int mapValues = 8, values = 13; // map, variance of the blur, black, white, its gradient

using Row = Eigen::Matrix<double, values, 1>;

/// How far from the middle a tag is compared, in its own units.
double withRim(const TagCells &cells)
{
    return cells.reach * (1 + 2 * rimCells / cells.side);
}

/// What a tag looks like under a map, and how that changes.
class TagImage
{
public:
    TagImage(const TagCells &cells, const cv::Rect &rect, int parts)
        : m_cells(cells), m_rect(rect), m_parts(parts),
          m_fine((rect.height + 2 * borderPx) * parts, (rect.width + 2 * borderPx) * parts, CV_32F)
    {
    }

    /// 0 black, 1 white, in m_fine's grid: each value the mean over a pixel about it.
    void draw(const Matrix3d &tagFromPixel, double variance)
    {
        const double step = 1.0 / m_parts;
        for (int row = 0; row < m_fine.rows; ++row) {
            auto *out = m_fine.ptr<float>(row);
            const double y = m_rect.y - borderPx + (row + 0.5) * step - 0.5;
            Vector3d at = tagFromPixel * Vector3d(m_rect.x - borderPx + 0.5 * step - 0.5, y, 1);
            const Vector3d along = tagFromPixel.col(0) * step;
            for (int column = 0; column < m_fine.cols; ++column, at += along)
                out[column] = whiteAt(at.x() / at.z(), at.y() / at.z());
        }
        cv::boxFilter(m_fine, m_fine, CV_32F, {m_parts, m_parts}, {-1, -1}, true, cv::BORDER_REPLICATE);
        if (variance > 1e-3)
            cv::GaussianBlur(m_fine, m_fine, {0, 0}, std::sqrt(variance) * m_parts, 0, cv::BORDER_REPLICATE);
    }

    struct Look
    {
        double white;
        Vector2d slope; ///< by pixel
        double byVariance;
    };

    Look at(int x, int y) const
    {
        const int column = (x - m_rect.x + borderPx) * m_parts + m_parts / 2,
                  row = (y - m_rect.y + borderPx) * m_parts + m_parts / 2;
        const auto value = [&](int dx, int dy) {
            return static_cast<double>(m_fine.at<float>(row + dy, column + dx));
        };
        const double here = value(0, 0), right = value(m_parts, 0), left = value(-m_parts, 0),
                     below = value(0, m_parts), above = value(0, -m_parts);
        // Half a pixel to either side for the slope, a whole one for the curvature (∂/∂σ² of a Gaussian is
        // half its Laplacian).
        const int half = m_parts / 2;
        const double reach = 2.0 * half / m_parts;
        return {here, Vector2d(value(half, 0) - value(-half, 0), value(0, half) - value(0, -half)) / reach,
                0.5 * (right + left + below + above - 4 * here)};
    }

private:
    float whiteAt(double u, double v) const
    {
        const double reach = m_cells.reach;
        if (!(std::abs(u) < reach && std::abs(v) < reach))
            return 1;
        const int column = std::min(m_cells.side - 1, static_cast<int>(0.5 * (u / reach + 1) * m_cells.side));
        const int row = std::min(m_cells.side - 1, static_cast<int>(0.5 * (v / reach + 1) * m_cells.side));
        return m_cells.white[static_cast<std::size_t>(row * m_cells.side + column)] ? 1.F : 0.F;
    }

    const TagCells &m_cells;
    cv::Rect m_rect;
    int m_parts;
    cv::Mat m_fine;
};

struct TagState
{
    Matrix3d map;                    ///< its last value is 1
    double variance = startVariance; ///< of the blur
    double black = 0;
    Vector3d white = Vector3d::Zero(); ///< less black: in the middle, and its change by pixel
};

struct Sample
{
    double error = 0; ///< seen minus predicted
    Row by;
    double predicted = 0, seen = 0;
};

class Alignment
{
public:
    /// part: the image in rect, blurred beforehand by addedPx.
    Alignment(const cv::Mat &part, const TagCells &cells, const Matrix3d &start, const cv::Rect &rect,
              int parts, double addedPx)
        : m_part(part), m_rect(rect), m_added(addedPx * addedPx), m_side(withRim(cells)),
          m_image(cells, rect, parts)
    {
        // Pixels are counted from the tag, or the map's last row would be tangled up with the others.
        m_fromOrigin.topRightCorner<2, 1>() =
            -Vector2d(rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height);
        m_state.map = m_fromOrigin * start;
    }

    /// False where it leads nowhere.
    bool run()
    {
        double movedPx = 0;
        if (!startLight())
            return false;
        for (int i = 0; i < mostIterations; ++i) {
            const Vector2d before = m_state.map.col(2).hnormalized();
            if (!step())
                return false;
            movedPx = (Vector2d(m_state.map.col(2).hnormalized()) - before).norm();
            if (i >= 3 && movedPx < stillPx)
                return true;
        }
        return movedPx < 25 * stillPx;
    }

    Matrix3d map() const { return m_fromOrigin.inverse() * m_state.map; }

    double likeness()
    {
        sample();
        double n = static_cast<double>(m_samples.size()), a = 0, b = 0, aa = 0, bb = 0, ab = 0;
        for (const Sample &s : m_samples) {
            a += s.seen / n;
            b += s.predicted / n;
        }
        for (const Sample &s : m_samples) {
            aa += (s.seen - a) * (s.seen - a);
            bb += (s.predicted - b) * (s.predicted - b);
            ab += (s.seen - a) * (s.predicted - b);
        }
        return ab / std::sqrt(std::max(1e-9, aa * bb));
    }

    /// σ of one coordinate of the middle.
    double sigmaPx() const { return m_sigmaPx; }

    /// White less black, in the middle of the image's part.
    double contrast() const { return m_state.white.x(); }

private:
    void sample()
    {
        m_samples.clear();
        const Matrix3d back = m_state.map.inverse() * m_fromOrigin;
        m_image.draw(back, m_state.variance + m_added);
        for (int y = m_rect.y; y < m_rect.y + m_rect.height; ++y) {
            for (int x = m_rect.x; x < m_rect.x + m_rect.width; ++x) {
                const Vector3d tag = back * Vector3d(x, y, 1);
                const double u = tag.x() / tag.z(), v = tag.y() / tag.z();
                if (std::abs(u) > m_side || std::abs(v) > m_side)
                    continue;
                const TagImage::Look look = m_image.at(x, y);
                const Vector2d position = (m_fromOrigin * Vector3d(x, y, 1)).head<2>();
                const Vector3d light(1, position.x() / m_rect.width, position.y() / m_rect.height);
                const double contrast = m_state.white.dot(light);
                const double depth = m_state.map.row(2).dot(Vector3d(u, v, 1));
                const double across = -contrast * look.slope.x() / depth,
                             down = -contrast * look.slope.y() / depth;
                Sample sample;
                sample.seen = m_part.at<std::uint8_t>(y - m_rect.y, x - m_rect.x);
                sample.predicted = m_state.black + contrast * look.white;
                sample.error = sample.seen - sample.predicted;
                const double on = -(across * position.x() + down * position.y());
                sample.by << across * u, across * v, across, down * u, down * v, down, on * u, on * v,
                    contrast * look.byVariance, 1, look.white * light;
                m_samples.push_back(sample);
            }
        }
    }

    /// Black and white from the start's image alone.
    bool startLight()
    {
        sample();
        if (m_samples.size() < 2 * values)
            return false;
        // Without contrast the derivatives by the map are zero, and those by the light are the pattern
        // itself.
        Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
        Eigen::Vector4d right = Eigen::Vector4d::Zero();
        for (const Sample &s : m_samples) {
            const Eigen::Vector4d by = s.by.tail<4>();
            normal += by * by.transpose();
            right += by * s.seen;
        }
        normal.diagonal().tail<2>().array() += 1e-3 * normal(1, 1);
        const Eigen::Vector4d light = normal.ldlt().solve(right);
        m_state.black = light(0);
        m_state.white = light.tail<3>();
        return light.allFinite() && m_state.white.x() > 0;
    }

    bool step()
    {
        sample();
        if (m_samples.size() < 2 * values)
            return false;
        std::vector<double> errors;
        for (const Sample &s : m_samples)
            errors.push_back(std::abs(s.error));
        const double grey = std::max(leastGreySigma, 1.4826 * upperMedian(std::move(errors)));
        Eigen::Matrix<double, values, values> normal = Eigen::Matrix<double, values, values>::Zero();
        Row right = Row::Zero();
        double squares = 0;
        for (const Sample &s : m_samples) {
            const double off = std::abs(s.error) / grey, weight = off < huber ? 1 : huber / off;
            normal.selfadjointView<Eigen::Lower>().rankUpdate(s.by, weight);
            right += weight * s.error * s.by;
            squares += weight * s.error * s.error;
        }
        normal = normal.selfadjointView<Eigen::Lower>();
        const Row scale = normal.diagonal().cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
        Eigen::Matrix<double, values, values> scaled = scale.asDiagonal() * normal * scale.asDiagonal();
        scaled.diagonal().array() += 1e-6;
        const Eigen::LDLT<Eigen::Matrix<double, values, values>> factors(scaled);
        const Row change = scale.cwiseProduct(factors.solve(scale.cwiseProduct(right)));
        if (!change.allFinite())
            return false;
        for (int i = 0; i < mapValues; ++i)
            m_state.map(i / 3, i % 3) += change(i);
        m_state.variance = std::clamp(m_state.variance + change(8), 0.0, mostVariance);
        m_state.black += change(9);
        m_state.white += change.tail<3>();
        const double freedom = std::max(1.0, static_cast<double>(m_samples.size()) - values);
        const auto variance = [&](int i) {
            return squares / freedom * std::pow(scale(i), 2) * factors.solve(Row::Unit(i))(i);
        };
        m_sigmaPx = std::sqrt(std::max(0.0, 0.5 * (variance(2) + variance(5))));
        return m_state.white.x() > 0;
    }

    const cv::Mat &m_part;
    cv::Rect m_rect;
    double m_added; ///< variance
    double m_side;  ///< of the compared area, from the middle
    Matrix3d m_fromOrigin = Matrix3d::Identity();
    TagImage m_image;
    TagState m_state;
    std::vector<Sample> m_samples;
    double m_sigmaPx = 0;
};

/// Pixels that a square about the tag's middle covers; nullopt where most of it lies beyond the image or the
/// map is none.
std::optional<cv::Rect> rectOf(const Matrix3d &map, double side, const cv::Size &size)
{
    Eigen::AlignedBox2d box;
    for (const double u : {-side, side}) {
        for (const double v : {-side, side}) {
            const Vector3d corner = map * Vector3d(u, v, 1);
            if (!(corner.z() > 1e-6 * std::abs(map(2, 2))))
                return std::nullopt;
            box.extend(Vector2d(corner.hnormalized()));
        }
    }
    const Vector2d sides = box.sizes();
    if (!sides.allFinite() || !(sides.maxCoeff() < mostImagePx) || !(sides.maxCoeff() > leastTagSidePx))
        return std::nullopt;
    const cv::Point least(static_cast<int>(std::floor(box.min().x())) - 1,
                          static_cast<int>(std::floor(box.min().y())) - 1);
    const cv::Point most(static_cast<int>(std::ceil(box.max().x())) + 2,
                         static_cast<int>(std::ceil(box.max().y())) + 2);
    const cv::Rect whole(least, most), seen = whole & cv::Rect({0, 0}, size);
    return seen.area() >= leastSeen * whole.area() ? std::optional(seen) : std::nullopt;
}

/// In the image at half its size: a tag that large is exact enough there, at a quarter of the cost.
std::optional<TagAlignment> alignTagAtHalfSize(const cv::Mat &luma, const TagCells &cells,
                                               const Matrix3d &start)
{
    cv::Mat half;
    cv::resize(luma, half, {}, 0.5, 0.5, cv::INTER_AREA);
    Matrix3d halve = Matrix3d::Identity(); // pixel (0,0) is the centre of the first
    halve.topLeftCorner<2, 3>() << 0.5, 0, -0.25, 0, 0.5, -0.25;
    auto aligned = alignTag(half, cells, halve * start);
    if (aligned) {
        aligned->pixelFromTag = halve.inverse() * aligned->pixelFromTag;
        aligned->sigmaPx *= 2;
    }
    return aligned;
}

} // namespace

std::optional<TagAlignment> alignTag(const cv::Mat &luma, const TagCells &cells, const Matrix3d &start)
{
    if (!start.allFinite() || !(std::abs(start(2, 2)) > 0))
        return std::nullopt;
    Matrix3d map = start / start(2, 2);
    const auto rect = rectOf(map, withRim(cells), luma.size());
    if (!rect)
        return std::nullopt;
    if (std::max(rect->width, rect->height) > mostSidePx)
        return alignTagAtHalfSize(luma, cells, start);
    const int parts = std::max(rect->width, rect->height) <= smallSidePx ? 5 : 3;
    const cv::Mat part = luma(*rect);
    // The edges of a large tag are narrow beside its cells: from half a cell away they pull at nothing.
    const double coarsePx = coarseOfCell * std::min(rect->width, rect->height) / cells.side;
    if (std::max(rect->width, rect->height) > coarseSidePx) {
        if (const auto coarse = alignTagAtHalfSize(luma, cells, start))
            map = coarse->pixelFromTag / coarse->pixelFromTag(2, 2);
    } else if (coarsePx > leastCoarsePx) {
        cv::Mat smooth;
        cv::GaussianBlur(part, smooth, {0, 0}, coarsePx);
        Alignment coarse(smooth, cells, map, *rect, parts, coarsePx);
        if (coarse.run())
            map = coarse.map();
    }
    Alignment alignment(part, cells, map, *rect, parts, 0);
    if (!alignment.run())
        return std::nullopt;
    const TagAlignment aligned{alignment.map(), alignment.likeness(), alignment.sigmaPx(),
                               alignment.contrast()};
    // Where the start's cells are is asked in the tag's own units.
    const Vector2d offInTag = (start.inverse() * aligned.middle().homogeneous()).hnormalized();
    if (!(offInTag.norm() * 0.5 * cells.side / cells.reach < mostMovedCells))
        return std::nullopt;
    return aligned;
}

} // namespace odo
