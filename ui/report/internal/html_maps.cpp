// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/quantity_curve.h"
#include "ui/models/number_text.h"
#include "ui/report/internal/html_figures.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/run_map.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/curves/simplified_line.h"
#include "ui/views/map/trial_map.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double mapWidth = 480, mapMargin = 26, tallestMap = 640, finestMap = 0.15;
constexpr std::size_t mostPathPoints = 6000, mostMapSpikes = 300;

class HtmlMapWords
{
    Q_DECLARE_TR_FUNCTIONS(HtmlMap)
};

QString mapCoordinate(double value)
{
    return QString::number(std::round(10 * value) / 10, 'g', 7);
}

QString pointsOf(const QPolygonF &line)
{
    QString points;
    for (const QPointF &point : line)
        points += (points.isEmpty() ? QString() : QStringLiteral(" ")) + mapCoordinate(point.x()) + u',' +
                  mapCoordinate(point.y());
    return points;
}

/// The floor in the lengths of a drawing: X to the right, Y up.
class SvgMap
{
public:
    SvgMap(HtmlWriter &page, const Eigen::AlignedBox2d &bounds, MapWords words)
        : m_page(page), m_bounds(bounds), m_words(std::move(words))
    {
        const Eigen::Vector2d size = bounds.sizes().cwiseMax(Eigen::Vector2d(0.01, 0.01));
        m_scale = std::min((mapWidth - 2 * mapMargin) / size.x(), (tallestMap - 2 * mapMargin) / size.y());
        m_height = m_scale * size.y() + 2 * mapMargin;
        m_left = (mapWidth - m_scale * size.x()) / 2;
    }

    QPointF at(const Eigen::Vector2d &point) const
    {
        return {m_left + m_scale * (point.x() - m_bounds.min().x()),
                m_height - mapMargin - m_scale * (point.y() - m_bounds.min().y())};
    }
    void begin()
    {
        m_page.open("svg", {{"viewBox", QStringLiteral("0 0 %1 %2").arg(mapWidth).arg(std::ceil(m_height))},
                            {"role", QStringLiteral("img")},
                            {"aria-label", m_words.title}});
        writeGrid();
    }
    void end() { m_page.close(); }
    void label(const QPointF &where, const QString &text)
    {
        m_page.element(
            "text", literalName(text),
            {{"x", mapCoordinate(where.x())},
             {"y", mapCoordinate(where.y())},
             {"text-anchor", where.x() > mapWidth / 2 ? QStringLiteral("end") : QStringLiteral("start")}});
    }
    void line(const QString &style, const QPolygonF &points, bool isClosed = false,
              const QString &colour = {})
    {
        if (points.size() < 2)
            return;
        HtmlAttributes attributes{{"class", style}, {"points", pointsOf(simplified(points, finestMap))}};
        if (!colour.isEmpty())
            attributes << std::pair("stroke", colour);
        m_page.shape(isClosed ? "polygon" : "polyline", attributes);
    }
    void dot(const QString &style, const QPointF &centre, double radius)
    {
        m_page.shape("circle", {{"class", style},
                                {"cx", mapCoordinate(centre.x())},
                                {"cy", mapCoordinate(centre.y())},
                                {"r", mapCoordinate(radius)}});
    }
    void spike(const QPointF &centre)
    {
        m_page.shape("path", {{"class", QStringLiteral("spikes")},
                              {"d", QStringLiteral("M%1 %2l4 7h-8Z")
                                        .arg(mapCoordinate(centre.x()), mapCoordinate(centre.y() - 4))}});
    }
    void layout(const MarkerLayout &layout)
    {
        for (const Marker &marker : layout.markers) {
            const QPointF centre = at(marker.pointInWorld);
            dot(QStringLiteral("marker"), centre, 3);
            label(centre + QPointF(centre.x() > mapWidth / 2 ? -6 : 6, -6),
                  QString::fromStdString(marker.label));
        }
    }
    void task(const Task &task)
    {
        for (const Zone &zone : task.zones) {
            line(zone.rule == ZoneRule::StayOutside ? QStringLiteral("zone out") : QStringLiteral("zone"),
                 polygon(zone.corners), true);
            if (!zone.corners.empty())
                label(at(zone.corners.front()) + QPointF(4, -4), QString::fromStdString(zone.name));
        }
        line(QStringLiteral("course"), polygon(task.path.points), task.path.closed);
        for (const Gate &gate : task.gates) {
            line(QStringLiteral("gate"), polygon({gate.from, gate.to}));
            label(at(gate.to) + QPointF(4, -4), QString::fromStdString(gate.name));
        }
    }
    QPolygonF polygon(const std::vector<Eigen::Vector2d> &points) const
    {
        QPolygonF all;
        for (const Eigen::Vector2d &point : points)
            all << at(point);
        return all;
    }

private:
    /// A line every round distance, with how far apart they are.
    void writeGrid()
    {
        const double perSi = shownUnits().distance.perSi;
        const AxisTicks across = niceTicks(perSi * m_bounds.min().x(), perSi * m_bounds.max().x(), 6);
        QString lines;
        const double step = across.step / perSi;
        for (double x = std::ceil(m_bounds.min().x() / step) * step; x <= m_bounds.max().x(); x += step)
            lines += QStringLiteral("M%1 %2V%3")
                         .arg(mapCoordinate(at({x, 0}).x()), mapCoordinate(mapMargin),
                              mapCoordinate(m_height - mapMargin));
        for (double y = std::ceil(m_bounds.min().y() / step) * step; y <= m_bounds.max().y(); y += step)
            lines += QStringLiteral("M%1 %2H%3")
                         .arg(mapCoordinate(m_left), mapCoordinate(at({0, y}).y()),
                              mapCoordinate(mapWidth - m_left));
        m_page.shape("path", {{"class", QStringLiteral("grid")}, {"d", lines}});
        m_page.element("text", m_words.square.arg(distanceText(step, m_words.locale)),
                       {{"x", mapCoordinate(m_left)}, {"y", mapCoordinate(m_height - 7)}});
    }

    HtmlWriter &m_page;
    const Eigen::AlignedBox2d m_bounds;
    const MapWords m_words;
    double m_scale = 1, m_height = 1, m_left = 0;
};

/// A path in pieces of one colour each; every piece begins where the one before ends.
void writeSpeedPath(SvgMap &map, const Profile &profile, double topMps)
{
    constexpr int colours = 10;
    const std::size_t step = std::max<std::size_t>(1, profile.points.size() / mostPathPoints);
    const auto levelAt = [&](const ProfilePoint &point) {
        return topMps > 0 ? std::min(colours - 1, int(colours * point.speedMps / topMps)) : 0;
    };
    for (const bool isRim : {true, false})
        for (const ProfilePiece &piece : piecesOf(profile)) {
            QPolygonF line;
            int level = -1;
            const auto flush = [&] {
                const QString colour = scaleColour((level + 0.5) / colours).name();
                map.line(isRim             ? QStringLiteral("rim")
                         : piece.isBridged ? QStringLiteral("run bridged")
                                           : QStringLiteral("run"),
                         line, false, isRim ? QString() : colour);
                if (!line.isEmpty())
                    line = {line.last()};
            };
            for (std::size_t i = piece.first; i <= piece.last;
                 i = i == piece.last ? i + 1 : std::min(i + step, piece.last)) {
                const int own = isRim ? 0 : levelAt(profile.points[i]);
                if (level >= 0 && own != level)
                    flush();
                level = own;
                line << map.at(profile.points[i].position);
            }
            flush();
        }
}

void writeMapSpikes(SvgMap &map, const Profile &profile)
{
    const std::size_t step = std::max<std::size_t>(1, profile.spikes.size() / mostMapSpikes);
    for (std::size_t i = 0; i < profile.spikes.size(); i += step) {
        const auto index = std::size_t(profile.spikes[i].sampleIndex);
        if (index < profile.samples.size() && profile.samples[index].position)
            map.spike(map.at(*profile.samples[index].position));
    }
}

/// Ends of a run.
void writeEnds(SvgMap &map, const Profile &profile)
{
    const auto isValid = [](const ProfilePoint &point) { return point.valid; };
    const auto first = std::ranges::find_if(profile.points, isValid);
    const auto last = std::find_if(profile.points.rbegin(), profile.points.rend(), isValid);
    if (first == profile.points.end())
        return;
    map.dot(QStringLiteral("start"), map.at(first->position), 4);
    map.dot(QStringLiteral("finish"), map.at(last->position), 4);
}

void writeRun(HtmlWriter &page, const TrialScene &scene, std::size_t robot, const MapWords &words)
{
    const Profile &profile = scene.robots[robot].analysis->profile;
    SvgMap map(page, scene.floorBounds(), words);
    map.begin();
    if (scene.layout)
        map.layout(*scene.layout);
    if (scene.task)
        map.task(*scene.task);
    writeSpeedPath(map, profile, topSpeedMps(scene));
    writeMapSpikes(map, profile);
    writeEnds(map, profile);
    map.end();
}

void endFigure(HtmlWriter &page, const QString &title, const QString &remark)
{
    page.open("figcaption");
    page.element("strong", title);
    page.text(QStringLiteral(" – ") + remark);
    page.close();
    page.close();
}

} // namespace

QString runMap(const TrialScene &scene, std::size_t robot, const MapWords &words)
{
    HtmlWriter page;
    writeRun(page, scene, robot, words);
    return page.take();
}

void writeRunMap(HtmlWriter &page, const TrialScene &scene, std::size_t robot)
{
    const QString title = HtmlMapWords::tr("The run from above");
    page.open("figure");
    writeRun(page, scene, robot, {title, HtmlMapWords::tr("a square: %1"), QLocale()});
    endFigure(page, title,
              HtmlMapWords::tr("coloured by speed, from 0 (dark) to %1 (light); ring: start, dot: end")
                  .arg(speedText(topSpeedMps(scene), std::nullopt)));
}

void writeComparedMap(HtmlWriter &page, const ComparisonScene &scene)
{
    const QString title = HtmlMapWords::tr("Both runs from above");
    page.open("figure");
    SvgMap map(page, scene.floorBounds(), {title, HtmlMapWords::tr("a square: %1"), QLocale()});
    map.begin();
    const TrialScene &first = *scene.scenes.front();
    if (first.layout)
        map.layout(*first.layout);
    if (first.task)
        map.task(*first.task);
    for (std::size_t run = 0; run < scene.runCount(); ++run) {
        const Profile &profile = scene.profile(run);
        const std::size_t step = std::max<std::size_t>(1, profile.points.size() / mostPathPoints);
        for (const ProfilePiece &piece : piecesOf(profile)) {
            QPolygonF line;
            for (std::size_t i = piece.first; i <= piece.last; i += step)
                line << map.at(profile.points[i].position);
            map.line(QStringLiteral("line s%1").arg(run), line);
        }
    }
    map.end();
    endFigure(page, title, HtmlMapWords::tr("in the colours of the runs"));
}

} // namespace odo
