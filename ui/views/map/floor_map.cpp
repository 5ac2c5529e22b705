// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map/floor_map.h"

#include "ui/models/number_text.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/shown_message.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/image/patient_layer.h"
#include "ui/views/map/floor_image.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/map/trial_map.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"
#include "ui/views/widgets/zoom_pan.h"

#include <QAction>
#include <QComboBox>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>
#include <QToolButton>
#include <algorithm>

namespace odo {

class Timeline;

/// What colours the trails of a map.
enum class MapColouring {
    Speed,
    Disagreement, ///< of the views: a dot a frame
};

/// The floor from above; inside FloorMap. A click on a trail goes to the time when the robot was there. A
/// haze lies where less than usual is known of a robot, with words where the mouse rests.
class MapArea : public MapCanvas
{
    Q_OBJECT
public:
    explicit MapArea(Timeline &timeline, QWidget *parent = nullptr);

    void setScene(TrialScenePtr scene);
    void setColouring(MapColouring colouring);
    /// Of each robot of the scene; empty: not known yet.
    void setDisagreements(std::vector<ViewDisagreement> disagreements);
    bool isSettled() const { return !m_maker.isRunning() && m_course->isSettled(); }
    QPointF fromWorld(const Eigen::Vector2d &point) const;
    ZoomPan &zoom() const { return *m_zoom; }

    QSize sizeHint() const override { return {340, 300}; }
    QSize minimumSizeHint() const override { return {160, 100}; }

Q_SIGNALS:
    void settled();

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    /// When a robot was nearest to a position; nullopt where none came near.
    std::optional<Nanoseconds> timeNear(const QPointF &position) const;
    MapPlan fittedPlan() const;
    MapPlan plan() const;
    void showFloor();
    void setHovered(const std::optional<QPointF> &position);
    void paintStill(QPainter &painter) const override;
    void drawCourse(QPainter &painter);
    void paintDisagreements(QPainter &painter) const;
    void paintLegend(QPainter &painter) const;

    Timeline &m_timeline;
    ZoomPan *m_zoom;
    PatientLayer *m_course; ///< trails and marks
    FloorImageMaker m_maker;
    TrialScenePtr m_scene;
    std::vector<UncertainInterval> m_stretches; ///< of the scene
    Eigen::AlignedBox2d m_bounds;               ///< of the floor that must be seen
    double m_topSpeedMps = 0;                   ///< end of the colour scale
    FloorImage m_floor;
    MapColouring m_colouring = MapColouring::Speed;
    std::vector<ViewDisagreement> m_disagreements;
    double m_topDisagreementM = 0;    ///< end of its colour scale
    std::optional<QPointF> m_hovered; ///< where the mouse is
};

MapArea::MapArea(Timeline &timeline, QWidget *parent)
    : MapCanvas(parent), m_timeline(timeline), m_zoom(new ZoomPan(*this)), m_course(new PatientLayer(*this)),
      m_bounds(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_zoom->setDragFilter([this](const QPointF &position) { return !timeNear(position); });
    connect(m_zoom, &ZoomPan::changed, this, [this] {
        m_course->renew();
        forgetStill();
    });
    connect(m_course, &PatientLayer::ready, this, &MapArea::settled);
    connect(&m_timeline, &Timeline::currentChanged, this, qOverload<>(&QWidget::update));
    connect(&m_maker, &FloorImageMaker::ready, this, [this](const FloorImage &image) {
        m_floor = image;
        forgetStill();
        Q_EMIT settled();
    });
}

void MapArea::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_floor = {};
    m_stretches = m_scene ? uncertainIntervals(*m_scene) : std::vector<UncertainInterval>();
    setDisagreements({});
    if (m_scene) {
        m_bounds = m_scene->floorBounds();
        m_topSpeedMps = topSpeedMps(*m_scene);
    }
    showFloor();
    m_maker.make(m_scene, m_bounds, fittedPlan().scalePx() * devicePixelRatioF());
    update();
}

void MapArea::resizeEvent(QResizeEvent *event)
{
    MapCanvas::resizeEvent(event);
    m_course->renew();
    showFloor();
    m_maker.setScale(fittedPlan().scalePx() * devicePixelRatioF());
}

void MapArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_course->forget();
    MapCanvas::changeEvent(event);
}

/// After its bounds or the widget's size have changed.
void MapArea::showFloor()
{
    m_zoom->setFrame(QRectF(rect()), fittedPlan().mostZoom());
}

MapPlan MapArea::fittedPlan() const
{
    return {m_bounds, QSizeF(size())};
}

MapPlan MapArea::plan() const
{
    return {m_bounds, QSizeF(size()), m_zoom->state().scale(), m_zoom->state().shift()};
}

QPointF MapArea::fromWorld(const Eigen::Vector2d &point) const
{
    return plan().fromWorld(point);
}

void MapArea::setColouring(MapColouring colouring)
{
    m_colouring = colouring;
    m_course->forget();
    update();
}

void MapArea::setDisagreements(std::vector<ViewDisagreement> disagreements)
{
    constexpr double leastM = 0.001;
    m_disagreements = std::move(disagreements);
    std::vector<double> apart;
    for (const ViewDisagreement &robot : m_disagreements)
        for (const Disagreement &position : robot.positions)
            apart.push_back(position.apartM);
    std::sort(apart.begin(), apart.end());
    // A few extreme values must not leave one colour for all others.
    m_topDisagreementM = apart.empty() ? 0 : std::max(leastM, apart[(apart.size() - 1) * 95 / 100]);
    m_course->forget();
    forgetStill();
}

void MapArea::paintDisagreements(QPainter &painter) const
{
    constexpr double radius = 3;
    std::vector<const Disagreement *> positions;
    QStringList words;
    for (std::size_t robot = 0; robot < m_disagreements.size(); ++robot) {
        const QString disagreement = disagreementWords(m_disagreements[robot]);
        words << (m_disagreements.size() > 1
                      ? joinedWords(QString::fromStdString(m_scene->robots[robot].robot.name), disagreement)
                      : disagreement);
        for (const Disagreement &position : m_disagreements[robot].positions)
            positions.push_back(&position);
    }
    // The largest on top.
    std::stable_sort(positions.begin(), positions.end(),
                     [](const Disagreement *a, const Disagreement *b) { return a->apartM < b->apartM; });
    painter.setPen(QPen(isDark(palette()) ? QColor(235, 238, 240, 120) : QColor(25, 30, 35, 90), 0.6));
    for (const Disagreement *position : positions) {
        painter.setBrush(scaleColour(std::min(1.0, position->apartM / m_topDisagreementM)));
        painter.drawEllipse(fromWorld(position->position), radius, radius);
    }
    const ThemeColours colours = ThemeColours::of(palette());
    const QRectF room(8, 4, width() - 16, height());
    const QRectF box = QFontMetricsF(font()).boundingRect(room, Qt::TextWordWrap, words.join(u'\n'));
    QColor ground = colours.mapGround;
    ground.setAlpha(225);
    painter.fillRect(QRectF(0, 0, width(), box.height() + 8), ground);
    painter.setPen(colours.text);
    painter.drawText(room, Qt::TextWordWrap, words.join(u'\n'));
}

void MapArea::paintLegend(QPainter &painter) const
{
    if (m_colouring == MapColouring::Speed)
        drawSpeedLegend(painter, plan(), m_topSpeedMps, palette());
    else if (m_topDisagreementM > 0)
        drawScaleLegend(painter, plan(), tr("0 to %1 apart").arg(lengthText(m_topDisagreementM)), palette());
}

void MapArea::paintStill(QPainter &painter) const
{
    drawMapGround(painter, plan(), *m_scene, m_floor, palette());
}

void MapArea::drawCourse(QPainter &painter)
{
    const QRectF frame = QRectF(fromWorld(m_bounds.corner(Eigen::AlignedBox2d::TopLeft)),
                                fromWorld(m_bounds.corner(Eigen::AlignedBox2d::BottomRight)))
                             .normalized();
    if (m_colouring == MapColouring::Disagreement)
        return m_course->draw(painter, frame, false, [this]() -> PatientLayer::Paint {
            return [this](QPainter &layer) {
                paintDisagreements(layer);
                drawMapMarks(layer, plan(), *m_scene, palette());
            };
        });
    m_course->draw(painter, frame, hasLongTrail(*m_scene), [this]() -> PatientLayer::Paint {
        return [scene = m_scene, plan = plan(), top = m_topSpeedMps, colours = palette()](QPainter &layer) {
            for (const SceneRobot &robot : scene->robots)
                if (robot.analysis)
                    drawSpeedTrail(layer, plan, robot.analysis->profile, top, colours);
            drawMapMarks(layer, plan, *scene, colours);
        };
    });
}

void MapArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    if (!m_scene) {
        painter.fillRect(rect(), colours.mapGround);
        return;
    }
    drawStill(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    drawCourse(painter);
    paintLegend(painter);
    drawTrialRobots(painter, plan(), *m_scene, m_timeline.currentTime(), palette());
    if (m_hovered && !ChartImage::isPaintedBy(painter, *this)) {
        const Eigen::Vector2d point = plan().toWorld(*m_hovered);
        drawReadOut(painter, QRectF(rect()).adjusted(0, 0, 0, -MapPlan::footHeight),
                    tr("x %1 · y %2").arg(coordinateText(point.x()), coordinateText(point.y())));
    }
    drawChartFocus(painter, *this);
}

std::optional<Nanoseconds> MapArea::timeNear(const QPointF &position) const
{
    constexpr double reachPx = 20;
    double nearest = reachPx;
    std::optional<Nanoseconds> time;
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        for (std::size_t i = 0; analysis && i < analysis->profile.points.size(); ++i) {
            const ProfilePoint &point = analysis->profile.points[i];
            if (!point.valid)
                continue;
            const double apart = QLineF(fromWorld(point.position), position).length();
            if (apart < nearest) {
                nearest = apart;
                time = analysis->profile.samples[i].time;
            }
        }
    }
    return time;
}

void MapArea::mousePressEvent(QMouseEvent *event)
{
    const auto time = event->button() == Qt::LeftButton ? timeNear(event->position()) : std::nullopt;
    if (time) {
        m_timeline.pause();
        m_timeline.setCurrentTime(*time);
    }
}

void MapArea::setHovered(const std::optional<QPointF> &position)
{
    m_hovered = position;
    update();
}

void MapArea::mouseMoveEvent(QMouseEvent *event)
{
    setHovered(event->position());
    MapCanvas::mouseMoveEvent(event);
}

void MapArea::leaveEvent(QEvent *event)
{
    setHovered(std::nullopt);
    MapCanvas::leaveEvent(event);
}

bool MapArea::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return MapCanvas::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const auto time = timeNear(help->pos());
    const QString words = time ? uncertaintyTextAt(m_stretches, *time) : QString();
    showToolTip(*help, words, this);
    return true;
}

FloorMap::FloorMap(Timeline &timeline, QWidget *parent)
    : Card(tr("Top-down map"), parent), m_area(new MapArea(timeline, this)), m_colouring(new QComboBox(this)),
      m_how(new QToolButton(this)), m_disagreement(new QAction(tr("Map: &views' disagreement"), this))
{
    setContent(m_area);
    new ChartImage(*m_area, [this] {
        return ImageHeading{title(), {m_scene ? QString::fromStdString(m_scene->trial.name) : QString()}, {}};
    });
    m_area->setAccessibleName(tr("Floor map with the robots' trails"));
    m_colouring->setAccessibleName(tr("Colour of the trails on the map"));
    m_colouring->setFocusPolicy(Qt::TabFocus); // Space goes on playing
    m_colouring->addItems({tr("Speed"), tr("Disagreement")});
    m_colouring->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_colouring->setMinimumWidth(10 * fontMetrics().averageCharWidth()); // its list has the whole words
    m_how->setText(QStringLiteral("?"));
    m_how->setProperty("flat", true);
    m_how->setFocusPolicy(Qt::StrongFocus);
    m_how->setToolTip(howComputedWords());
    m_how->setAccessibleName(tr("Disagreement of the views: %1").arg(howComputedWords()));
    m_how->hide();
    addToHeader(m_how);
    addToHeader(m_colouring);
    m_disagreement->setObjectName(QStringLiteral("viewsDisagreement"));
    m_disagreement->setCheckable(true);
    m_disagreement->setShortcut(QKeySequence(Qt::Key_V));
    connect(m_disagreement, &QAction::toggled, this, &FloorMap::setColouring);
    connect(m_colouring, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_disagreement->setChecked(index == 1); });
    connect(m_how, &QToolButton::clicked, this, &FloorMap::explain);
    connect(&m_task, &BackgroundTask::finished, this, &FloorMap::takeComparison);
    connect(m_area, &MapArea::settled, this, &FloorMap::settled);
    setColouring(false);
}

FloorMap::~FloorMap() = default;

void FloorMap::setColouring(bool byDisagreement)
{
    m_colouring->setCurrentIndex(byDisagreement ? 1 : 0);
    setRemark(tr("colour"));
    m_area->setColouring(byDisagreement ? MapColouring::Disagreement : MapColouring::Speed);
    m_how->setVisible(byDisagreement);
    compare();
}

void FloorMap::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_area->setScene(m_scene);
    m_found.reset();
    m_compared.reset();
    compare();
}

void FloorMap::compare()
{
    if (!m_disagreement->isChecked() || !m_scene || m_compared == m_scene || m_task.isRunning())
        return;
    m_compared = m_scene;
    m_found = std::make_shared<std::vector<ViewDisagreement>>();
    m_task.start([scene = m_scene, found = m_found](const JobControl &) -> Result<void> {
        *found = disagreementsOf(*scene);
        return {};
    });
}

void FloorMap::takeComparison()
{
    if (!m_found || m_compared != m_scene) { // another trial came meanwhile
        compare();
        return;
    }
    m_area->setDisagreements(*m_found);
    QStringList words;
    for (const ViewDisagreement &robot : *m_found)
        words << disagreementWords(robot);
    m_area->setAccessibleDescription(words.join(QStringLiteral("; ")));
    if (isSettled())
        Q_EMIT settled();
}

void FloorMap::explain()
{
    if (!m_scene || m_compared != m_scene || m_task.isRunning())
        return;
    for (std::size_t robot = 0; robot < m_found->size(); ++robot)
        if (m_scene->robots[robot].analysis)
            showExplanation(window(), explainDisagreement(*m_scene, robot, (*m_found)[robot]));
}

bool FloorMap::isSettled() const
{
    return m_area->isSettled() && !m_task.isRunning();
}
QPointF FloorMap::fromWorld(const Eigen::Vector2d &pointInWorld) const
{
    return m_area->fromWorld(pointInWorld);
}
QWidget *FloorMap::mapArea() const
{
    return m_area;
}
ZoomPan &FloorMap::zoom() const
{
    return m_area->zoom();
}

} // namespace odo

#include "floor_map.moc"
