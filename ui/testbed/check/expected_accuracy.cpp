// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/expected_accuracy.h"

#include "core/base/units.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QImage>
#include <QLineF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr int keyWidth = 150, keyHeight = 10;
constexpr double farOut = 0.8;     // of the way from the middle to the border
constexpr double leastRatio = 1.2; // a map of one value has colours too

class AccuracyLayerWords
{
    Q_DECLARE_TR_FUNCTIONS(AccuracyLayer)
};

QString keyTitle()
{
    return AccuracyLayerWords::tr("expected ±, hatched: not visible");
}

struct Range
{
    double lowM = 1e-3, highM = 1e-3 * leastRatio;
    /// The colours go by ratios: twice as bad is as far from good as four times from twice.
    double fraction(double sigmaM) const { return std::log(sigmaM / lowM) / std::log(highM / lowM); }
    double at(double fraction) const { return lowM * std::pow(highM / lowM, fraction); }
};

std::optional<Range> rangeOf(const SketchedAccuracy &accuracy)
{
    Range range{std::numeric_limits<double>::infinity(), 0};
    for (const double sigma : accuracy.sigmaM) {
        if (!(sigma > 0))
            continue;
        range.lowM = std::min(range.lowM, sigma);
        range.highM = std::max(range.highM, sigma);
    }
    if (range.highM <= 0)
        return std::nullopt;
    range.highM = std::max(range.highM, leastRatio * range.lowM);
    return range;
}

/// 1, 2 or 5 of a power of ten.
QString levelText(double metres)
{
    return AccuracyLayerWords::tr("%1 mm").arg(QLocale().toString(toMillimetres(metres), 'g', 2));
}

QImage imageOf(const SketchedAccuracy &accuracy, const Range &range)
{
    const FloorGrid &grid = accuracy.grid;
    QImage image(grid.columns, grid.rows, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const double sigma = accuracy.sigmaM[grid.index(column, row)];
            if (sigma > 0) // image rows go down as Y does
                image.setPixelColor(column, grid.rows - 1 - row, scaleColour(range.fraction(sigma)));
        }
    }
    return image;
}

/// The line of one level through one field of the grid, by the values at its corners (marching squares).
void addContour(const SketchedAccuracy &accuracy, int column, int row, double levelM,
                std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> &lines)
{
    const FloorGrid &grid = accuracy.grid;
    const std::array<std::pair<int, int>, 4> corners = {
        {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
    std::vector<Eigen::Vector2d> crossings;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto &[c0, r0] = corners[i];
        const auto &[c1, r1] = corners[(i + 1) % corners.size()];
        const double a = accuracy.sigmaM[grid.index(c0, r0)], b = accuracy.sigmaM[grid.index(c1, r1)];
        if (std::isnan(a) || std::isnan(b))
            return;
        if ((a < levelM) != (b < levelM))
            crossings.emplace_back(grid.at(c0, r0) +
                                   (levelM - a) / (b - a) * (grid.at(c1, r1) - grid.at(c0, r0)));
    }
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        lines.emplace_back(crossings[i], crossings[i + 1]);
}

void drawLevel(QPainter &painter, const SketchedAccuracy &accuracy, double levelM, const ToScreen &toScreen)
{
    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines;
    for (int row = 0; row + 1 < accuracy.grid.rows; ++row)
        for (int column = 0; column + 1 < accuracy.grid.columns; ++column)
            addContour(accuracy, column, row, levelM, lines);
    painter.setPen(QPen(QColor(255, 255, 255, 220), 1.2));
    for (const auto &[from, to] : lines)
        painter.drawLine(toScreen(from), toScreen(to));
    if (lines.empty())
        return;
    // Nearest to the middle, since markers and borders lie outside.
    const FloorGrid &grid = accuracy.grid;
    const Eigen::Vector2d middle = 0.5 * (grid.lowerM + grid.at(grid.columns - 1, grid.rows - 1));
    const auto nearest =
        std::ranges::min_element(lines, {}, [&](const auto &line) { return (line.first - middle).norm(); });
    const Eigen::Vector2d reach = (nearest->first - middle).cwiseAbs().cwiseQuotient(middle - grid.lowerM);
    // a line that only cuts off a corner says enough by its colour, and a marker is there
    if (reach.minCoeff() < farOut)
        drawHaloText(painter, toScreen(nearest->first) + QPointF(3, -4), levelText(levelM), Qt::white);
}

QRectF positionOf(const FloorGrid &grid, const ToScreen &toScreen)
{
    const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * grid.stepM);
    return QRectF(toScreen(grid.at(0, grid.rows - 1) + Eigen::Vector2d(-half.x(), half.y())),
                  toScreen(grid.at(grid.columns - 1, 0) + Eigen::Vector2d(half.x(), -half.y())));
}

} // namespace

std::vector<double> accuracyLevelsM(const SketchedAccuracy &accuracy)
{
    const auto range = rangeOf(accuracy);
    std::vector<double> levels;
    if (!range)
        return levels;
    for (double decade = std::pow(10, std::floor(std::log10(range->lowM))); decade < range->highM;
         decade *= 10)
        for (const double step : {1, 2, 5})
            if (step * decade > range->lowM && step * decade < range->highM)
                levels.push_back(step * decade);
    return levels;
}

void drawAccuracy(QPainter &painter, const SketchedAccuracy &accuracy, const ToScreen &toScreen,
                  const QPalette &palette)
{
    if (accuracy.sigmaM.empty())
        return;
    const QRectF position = positionOf(accuracy.grid, toScreen);
    painter.fillRect(position, QBrush(ThemeColours::of(palette).muted, Qt::BDiagPattern));
    const auto range = rangeOf(accuracy);
    if (!range)
        return;
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(position, imageOf(accuracy, *range));
    for (const double level : accuracyLevelsM(accuracy))
        drawLevel(painter, accuracy, level, toScreen);
    painter.restore();
}

QSize accuracyKeySize(const QFontMetrics &metrics)
{
    return {std::max(keyWidth, metrics.horizontalAdvance(keyTitle())) + 16,
            keyHeight + 2 * metrics.height() + 10};
}

void drawAccuracyKey(QPainter &painter, const SketchedAccuracy &accuracy, const QRect &area,
                     const QPalette &palette)
{
    const auto range = rangeOf(accuracy);
    if (!range)
        return;
    const ThemeColours colours = ThemeColours::of(palette);
    const QFontMetrics metrics = painter.fontMetrics();
    QColor ground = colours.card;
    ground.setAlpha(215);
    const QSize size = accuracyKeySize(metrics);
    const QRect box(QPoint(area.left() + 8, area.bottom() - 8 - size.height()), size);
    painter.fillRect(box, ground);
    const QRect bar(box.left() + 8, box.top() + metrics.height() + 4, box.width() - 16, keyHeight);
    for (int x = 0; x < bar.width(); ++x)
        painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(),
                         scaleColour(double(x) / (bar.width() - 1)));
    painter.setPen(colours.text);
    painter.drawText(QPoint(bar.left(), box.top() + metrics.ascent() + 2), keyTitle());
    const int base = bar.bottom() + metrics.ascent() + 2;
    const QString low = levelText(range->lowM), high = levelText(range->highM),
                  middle = levelText(range->at(0.5));
    painter.drawText(QPoint(bar.left(), base), low);
    painter.drawText(QPoint(bar.center().x() - metrics.horizontalAdvance(middle) / 2, base), middle);
    painter.drawText(QPoint(bar.right() - metrics.horizontalAdvance(high), base), high);
}

namespace {

constexpr double followedPx = 0.1; // of one coordinate of what the tracker follows
constexpr double marginM = 0.3;    // robots drive beyond the markers too

} // namespace

ExpectedAccuracy expectedAccuracy(const AccuracyRequest &request)
{
    ExpectedAccuracy expected;
    std::vector<FloorView> views;
    std::optional<std::size_t> alone;
    for (std::size_t i = 0; i < request.cameras.size(); ++i) {
        const auto *planned = std::get_if<PlannedCamera>(&request.cameras[i]);
        Result<FloorView> view = planned ? plannedView(*planned, request.layout)
                                         : Result<FloorView>(std::get<FloorView>(request.cameras[i]));
        expected.problems.push_back(view ? std::nullopt : std::optional(view.error()));
        if (!view)
            continue;
        if (request.alone == i)
            alone = views.size();
        views.push_back(std::move(*view));
    }
    const FloorGrid grid = gridOver(request.layout, marginM);
    AccuracyMap map = accuracyMap(views, grid, followedPx, request.robotHeightM);
    if (request.alone && !alone) // the one that is asked for cannot be there
        std::ranges::fill(map.fusedSigmaM, std::numeric_limits<double>::quiet_NaN());
    expected.map = {grid, alone ? std::move(map.cameraSigmaM[*alone]) : std::move(map.fusedSigmaM)};
    expected.summary = summariseAccuracy(grid, expected.map.sigmaM, request.layout);
    return expected;
}

AccuracyMaker::AccuracyMaker(QObject *parent) : QObject(parent)
{
    connect(&m_task, &BackgroundTask::finished, this, [this] {
        Q_EMIT ready(*m_made);
        if (m_next)
            begin(*std::exchange(m_next, std::nullopt));
    });
}

void AccuracyMaker::make(AccuracyRequest request)
{
    if (m_task.isRunning())
        m_next = std::move(request);
    else
        begin(std::move(request));
}

void AccuracyMaker::begin(AccuracyRequest request)
{
    m_made = std::make_shared<ExpectedAccuracy>();
    m_task.start([made = m_made, request = std::move(request)](const JobControl &) -> Result<void> {
        *made = expectedAccuracy(request);
        return {};
    });
}

} // namespace odo
