// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/live_board.h"

#include "core/base/steady_now.h"
#include "ui/record/internal/health_watch.h"
#include "ui/record/internal/live_image_area.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace odo {

LiveBoard::LiveBoard(const QList<QAction *> &tools, QWidget *parent)
    : QWidget(parent), m_images(new QSplitter), m_mapCard(new Card(tr("Top-down map"))), m_map(new LiveMap),
      m_health(new FactList)
{
    setTarget({});
    m_mapCard->setContent(m_map);
    auto *scroll = scrolled(m_health, tr("Health of cameras, map and disk"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *healthCard = new Card(tr("Health"));
    healthCard->setContent(scroll);
    for (QAction *tool : tools)
        healthCard->addToHeader(actionButton(tool, tool->iconText()));
    auto *below = new QSplitter;
    below->addWidget(m_mapCard);
    below->addWidget(healthCard);
    below->setSizes({500, 420});
    auto *all = new QSplitter(Qt::Vertical);
    all->addWidget(m_images);
    all->addWidget(below);
    all->setSizes({330, 390});
    for (QSplitter *each : {m_images, below, all}) {
        each->setHandleWidth(8);
        each->setChildrenCollapsible(false);
    }
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(all);
}

void LiveBoard::setCameras(const RunningCameras &running)
{
    const auto &cameras = running.cameras();
    while (m_areas.size() > cameras.size()) {
        delete m_cards.back();
        m_cards.pop_back();
        m_areas.pop_back();
    }
    while (m_areas.size() < cameras.size()) {
        auto *area = new LiveImageArea;
        auto *card = new Card({});
        card->setContent(area);
        m_images->addWidget(card);
        connect(
            area, &LiveImageArea::shownSizeChanged, this,
            [this, view = m_areas.size()](const QSize &pixels) { Q_EMIT shownSizeChanged(view, pixels); });
        m_areas.push_back(area);
        m_cards.push_back(card);
    }
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        const QString title = tr("Camera %1").arg(QString::fromStdString(cameras[v].name));
        m_cards[v]->setTitle(title);
        m_areas[v]->setAccessibleName(tr("Live view of %1").arg(title));
        m_cards[v]->setBadge(cameras[v].floorView ? Badge{}
                                                  : Badge{tr("not registered"), BadgeState::Warning});
        if (running.isOpening())
            m_areas[v]->setWords(tr("Opening the camera…"));
        Q_EMIT shownSizeChanged(v, (QSizeF(m_areas[v]->size()) * devicePixelRatioF()).toSize());
    }
}

void LiveBoard::setTarget(const std::optional<BroadcastTarget> &target)
{
    m_mapCard->setRemark(
        target ? tr("live, sent to %1")
                     .arg(QString::fromStdString(target->address) + u':' + QString::number(target->port))
               : tr("live"));
}

void LiveBoard::onMaps(const std::function<void(LiveMap &)> &act)
{
    act(*m_map);
    m_moreMaps.removeAll(nullptr);
    for (const QPointer<LiveMap> &map : m_moreMaps)
        act(*map);
}

QWidget *LiveBoard::makeMap()
{
    auto *map = new LiveMap;
    map->setFloor(m_floor);
    map->setRobots(m_robots);
    m_moreMaps << map;
    return map;
}

void LiveBoard::setFloor(const TrialScenePtr &floor)
{
    m_floor = floor;
    for (std::size_t v = 0; v < m_areas.size(); ++v)
        m_areas[v]->setFloor(floor, v);
    onMaps([&](LiveMap &map) { map.setFloor(floor); });
}

void LiveBoard::setRobots(const std::vector<RobotRecord> &robots)
{
    m_robots = robots;
    onMaps([&](LiveMap &map) { map.setRobots(robots); });
    for (LiveImageArea *area : m_areas)
        area->setRobots(robots);
}

void LiveBoard::setImage(const LiveFrame &live)
{
    if (live.view < m_areas.size())
        m_areas[live.view]->setImage(live);
}

void LiveBoard::addMoment(const LiveMoment &moment)
{
    onMaps([&](LiveMap &map) { map.addPosition(moment.robot, moment.position); });
    Q_EMIT momentShown();
    if (!moment.position.point.valid)
        return;
    for (LiveImageArea *area : m_areas)
        area->addPosition(moment.robot, moment.position.point.position);
}

void LiveBoard::forgetPaths()
{
    onMaps([](LiveMap &map) { map.forgetPaths(); });
    for (LiveImageArea *area : m_areas)
        area->forgetPaths();
}

void LiveBoard::setHealth(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                          const LiveStatistics &live, const CaptureHealth &before)
{
    m_health->setFacts(healthFacts(health, cameras, live, m_map->robots(), before));
    for (std::size_t v = 0; v < std::min(m_areas.size(), health.views.size()); ++v) {
        const ViewHealth &view = health.views[v];
        const bool delivers = view.state == ViewHealth::State::Delivering;
        m_areas[v]->setWords(delivers                                    ? QString()
                             : view.state == ViewHealth::State::Starting ? tr("Waiting for the first frame…")
                                                                         : tr("No frames now"));
        m_cards[v]->setRemark(
            delivers ? tr("%1 frames/s").arg(locale().toString(view.framesPerSecond, 'f', 1)) : QString());
    }
}

namespace {

constexpr double standingMps = 0.05;
constexpr Nanoseconds longestSilence = std::chrono::seconds(1);
constexpr std::size_t longestPath = 30 * 60 * 10; // ten minutes: a longer way is a thicket

} // namespace

LiveMap::LiveMap(QWidget *parent) : MapCanvas(parent)
{
    setAccessibleName(tr("Live floor map with the robots"));
}

void LiveMap::setFloor(TrialScenePtr floor)
{
    m_floor = std::move(floor);
    forgetStill();
}

void LiveMap::setRobots(std::vector<RobotRecord> robots)
{
    m_positions = paletteIndices(robots);
    m_robots.clear();
    for (RobotRecord &robot : robots)
        m_robots.push_back({std::move(robot), {}, {}, {}});
    forgetStill();
}

void LiveMap::forgetPaths()
{
    for (Driven &driven : m_robots)
        driven.path.clear();
    forgetStill();
}

std::optional<Eigen::Vector2d> LiveMap::latestPosition(std::size_t robot) const
{
    if (robot >= m_robots.size() || !m_robots[robot].now || !m_robots[robot].now->point.valid)
        return std::nullopt;
    return m_robots[robot].now->point.position;
}

std::vector<SeenRobot> LiveMap::robots() const
{
    const Nanoseconds now = steadyNow();
    std::vector<SeenRobot> seen;
    for (const Driven &driven : m_robots) {
        const bool fresh =
            driven.now && now - driven.now->sample.time < longestSilence && driven.now->sample.position;
        seen.push_back({driven.robot.name, fresh ? driven.now : std::nullopt});
    }
    return seen;
}

QColor LiveMap::colourOf(std::size_t robot) const
{
    return m_robots.size() == 1 ? drawnColour(m_robots.front().robot.drawingColour,
                                              ThemeColours::of(palette()).spike, palette())
                                : seriesColour(m_positions[robot], palette());
}

void LiveMap::addPosition(std::size_t robot, const LivePosition &position)
{
    if (robot >= m_robots.size())
        return;
    Driven &driven = m_robots[robot];
    driven.now = position;
    const ProfilePoint &point = position.point;
    if (point.valid && point.speedMps > std::max(standingMps, 2 * point.sigmaSpeedMps))
        driven.headingRad = std::atan2(point.velocity.y(), point.velocity.x());
    if (driven.path.size() >= longestPath) {
        driven.path.erase(driven.path.begin(), driven.path.begin() + longestPath / 2);
        forgetStill();
    }
    driven.path.push_back(point.valid ? std::optional(point.position) : std::nullopt);
    addToStill([&](QPainter &painter) { drawStep(painter, robot, driven.path.size() - 1); });
    update();
}

MapPlan LiveMap::plan() const
{
    return {m_floor ? m_floor->floorBounds()
                    : Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)),
            QSizeF(size())};
}

void LiveMap::drawStep(QPainter &painter, std::size_t robot, std::size_t to) const
{
    const auto &path = m_robots[robot].path;
    if (to == 0 || !path[to] || !path[to - 1])
        return;
    const MapPlan map = plan();
    painter.setPen(QPen(colourOf(robot), 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(map.fromWorld(*path[to - 1]), map.fromWorld(*path[to]));
}

void LiveMap::paintStill(QPainter &painter) const
{
    const MapPlan map = plan();
    drawMapGrid(painter, map, palette(), false);
    if (m_floor->layout)
        drawMapMarkers(painter, map, *m_floor->layout, palette());
    if (m_floor->task) {
        const auto toScreen = [&map](const Eigen::Vector2d &point) { return map.fromWorld(point); };
        drawZones(painter, m_floor->task->zones, toScreen, palette());
        drawReferencePath(painter, m_floor->task->path, toScreen, palette());
        drawGates(painter, m_floor->task->gates, toScreen, palette());
    }
    for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
        for (std::size_t i = 1; i < m_robots[robot].path.size(); ++i)
            drawStep(painter, robot, i);
    }
}

void LiveMap::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    if (!m_floor || !m_floor->layout) {
        painter.fillRect(rect(), colours.mapGround);
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No camera is registered to the floor: robots cannot be located"));
        return;
    }
    drawStill(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < m_robots.size(); ++i) {
        if (!latestPosition(i))
            continue;
        const Driven &driven = m_robots[i];
        const ProfilePoint &point = driven.now->point;
        MapRobot sign{
            &driven.robot, point.position, point.sigmaXM, point.sigmaYM, driven.headingRad, colourOf(i), {}};
        if (m_robots.size() > 1)
            sign.label = QString::fromStdString(driven.robot.name);
        drawMapRobot(painter, plan(), sign, palette());
    }
}

} // namespace odo
