// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/compare_desk.h"

#include "ui/compare/internal/compare_map.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/models/timeline.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/image/camera_view.h"
#include "ui/views/widgets/theme.h"
#include "ui/views/widgets/zoom_pan.h"

#include <QComboBox>
#include <QPainter>
#include <QSignalBlocker>
#include <QSplitter>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t pictured = 2;

/// Another run of the comparison as it would be seen by a view of this one: where it is, and the way it took
/// in the last moments.
void paintOtherRun(QPainter &painter, const ComparisonScene &scene, std::size_t other, Nanoseconds common,
                   const FloorView &view, const ImageMap &map)
{
    constexpr std::ptrdiff_t trailPoints = 45;
    const Profile &profile = scene.profile(other);
    const std::ptrdiff_t index = pointIndexAt(profile, scene.ownTime(other, common));
    if (index < 0)
        return;
    std::vector<std::optional<Eigen::Vector2d>> positions;
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, index - trailPoints); i <= index; ++i) {
        const ProfilePoint &point = profile.points[static_cast<std::size_t>(i)];
        positions.push_back(point.valid ? std::optional(point.position) : std::nullopt);
    }
    paintPath(painter, positions, profile.heightM, view, map, colourOnImage(int(other)));
    paintGhost(painter,
               {&scene.robot(other), profile.heightM,
                profile.points[static_cast<std::size_t>(index)].position,
                drivenHeadingAt(profile, index).value_or(0), colourOnImage(int(other)),
                QString::fromStdString(scene.name(other))},
               view, map);
}

/// The others can be seen in a run's image only where both mean the same floor.
bool sameFloor(const ComparisonScene &scene, std::size_t a, std::size_t b)
{
    const auto &first = scene.scenes[a]->layout, &second = scene.scenes[b]->layout;
    return first && second && first->name == second->name;
}

} // namespace

CompareDesk::CompareDesk(Timeline &timeline, QWidget *parent)
    : DockDesk(QStringLiteral("compare"), parent), m_timeline(timeline),
      m_mapCard(new Card(tr("Top-down map"))), m_map(new CompareMap(timeline)), m_span(new AxisSpan(this)),
      m_speed(new DistanceChart(timeline, *m_span, Compared::Speed)),
      m_difference(new DistanceChart(timeline, *m_span, Compared::TimeDifference))
{
    m_map->setAccessibleName(tr("Floor map with the paths of the runs and the gates of the sectors"));
    m_map->setToolTip(
        tr("Drag a gate along the path. Keys: Up and Down select a gate, Left and Right move it"));
    m_mapCard->setContent(m_map);
    new ChartImage(*m_map, [this] {
        return ImageHeading{m_mapCard->title(), m_scene ? m_scene->names() : QStringList(), {}};
    });
    m_mapCard->setRemark(tr("both runs"));
    for (std::size_t run = 0; run < pictured; ++run) {
        auto *clock = new Timeline(this);
        auto *image = new CameraView(*clock);
        auto *views = new QComboBox;
        views->setAccessibleName(run == 0 ? tr("Camera of the first run") : tr("Camera of the second run"));
        views->setFocusPolicy(Qt::TabFocus);
        image->addToHeader(views);
        image->setMinimumWidth(leastViewWidth(pictured));
        middle().addWidget(image);
        connect(views, &QComboBox::activated, this, &CompareDesk::showViews);
        connect(image, &CameraView::settled, this, &CompareDesk::settled);
        connect(&image->zoom(), &ZoomPan::doubleClicked, this, [this, image] { toggleEnlarged(image); });
        m_clocks.push_back(clock);
        m_cameraViews.push_back(image);
        m_viewLists.push_back(views);
    }
    middle().addWidget(m_mapCard);
    addDock(m_speed, QStringLiteral("compareSpeedDock"), m_speed->title(), 31);
    addDock(m_difference, QStringLiteral("compareDifferenceDock"), m_difference->title(), 31);
    resetLayout();
    connect(m_speed, &DistanceChart::runToggled, &m_difference->area(), &ChartView::setGroupShown);
    connect(&m_timeline, &Timeline::currentChanged, this, &CompareDesk::followTime);
    connect(&m_map->zoom(), &ZoomPan::doubleClicked, this, [this] { toggleEnlarged(m_mapCard); });
    connect(m_map, &CompareMap::gatesMoved, this, &CompareDesk::gatesMoved);
    connect(m_map, &CompareMap::settled, this, &CompareDesk::settled);
}

CompareDesk::~CompareDesk() = default;

void CompareDesk::setScene(ComparisonScenePtr scene)
{
    endEnlarging(); // another run may have no image
    m_scene = std::move(scene);
    for (std::size_t run = 0; run < pictured; ++run) {
        const TrialScenePtr shown = m_scene ? m_scene->scenes[run] : nullptr;
        const QString before = m_viewLists[run]->currentText();
        const QSignalBlocker quiet(m_viewLists[run]);
        m_viewLists[run]->clear();
        for (std::size_t view = 0; shown && view < shown->views.size(); ++view)
            m_viewLists[run]->addItem(QString::fromStdString(shown->views[view].camera));
        m_viewLists[run]->setCurrentIndex(std::max(0, m_viewLists[run]->findText(before)));
        m_viewLists[run]->setVisible(m_viewLists[run]->count() > 1);
        m_clocks[run]->setFrameTimes(shown ? shown->frameTimes() : std::vector<Nanoseconds>());
    }
    showViews();
    m_map->setScene(m_scene);
    m_map->setGates(m_scene ? m_scene->compared.gates : std::vector<PathGate>());
    m_mapCard->setRemark(!m_scene || m_scene->compared.comparison.isTasksPath
                             ? tr("dashed: the task's path")
                             : tr("along the first run's path"));
    const PathSpan common = m_scene ? comparedSpan(*m_scene) : PathSpan();
    m_span->setWhole(common.lowM, common.highM);
    m_speed->setScene(m_scene);
    m_difference->setScene(m_scene);
    followTime();
}

void CompareDesk::showViews()
{
    for (std::size_t run = 0; run < pictured; ++run) {
        CameraView &image = *m_cameraViews[run];
        const auto view = static_cast<std::size_t>(std::max(0, m_viewLists[run]->currentIndex()));
        image.setScene(m_scene ? m_scene->scenes[run] : nullptr, view);
        const bool hasVideo = m_scene && !m_scene->scenes[run]->views.empty();
        image.setVisible(hasVideo || !m_scene); // an imported track has none
        if (!hasVideo) {
            image.setOverlay({});
            continue;
        }
        image.setTitle(run == 0 ? tr("First") : tr("Second"));
        image.setRemark(QString::fromStdString(m_scene->name(run)));
        image.setBadge({}); // Review shows the registration; the names need the space
        image.setRobotColour(colourOnImage(int(run)));
        image.setOverlay([scene = m_scene, run](QPainter &painter, std::size_t shown, std::int64_t frame,
                                                const ImageMap &map) {
            const TrialScene &own = *scene->scenes[run];
            if (!own.views[shown].floorView)
                return;
            const Nanoseconds common = scene->commonTime(run, own.timeOf(shown, frame));
            for (std::size_t other = 0; other < scene->runCount(); ++other)
                if (other != run && sameFloor(*scene, run, other))
                    paintOtherRun(painter, *scene, other, common, *own.views[shown].floorView, map);
        });
    }
}

void CompareDesk::followTime()
{
    for (std::size_t run = 0; m_scene && run < pictured; ++run)
        m_clocks[run]->setCurrentTime(m_scene->ownTime(run, m_timeline.currentTime()));
}

bool CompareDesk::isSettled() const
{
    return m_map->isSettled() &&
           std::ranges::all_of(m_cameraViews, [](const CameraView *image) { return image->isSettled(); });
}

DistanceArea::DistanceArea(Timeline &timeline, AxisSpan &span, Compared what, QWidget *parent)
    : ChartView(span, comparedAxes(what), parent), m_timeline(timeline), m_what(what),
      m_bubbles(new ChartBubbles(*this))
{
    connect(&m_timeline, &Timeline::currentChanged, viewport(), qOverload<>(&QWidget::update));
}

void DistanceArea::setScene(ComparisonScenePtr scene)
{
    m_scene = std::move(scene);
    showAllGroups();
    setAxes(comparedAxes(m_what));
    setContent(m_scene ? comparedContent(*m_scene, m_what) : nullptr);
}

void DistanceArea::paintOver(QPainter &painter)
{
    constexpr double rounding = 1e-3;
    m_bubbles->clear();
    if (!m_scene)
        return;
    const ChartPlot shown = plot();
    double distance = m_scene->distanceAt(0, m_timeline.currentTime());
    if (distance < shown.low - rounding || distance > shown.high + rounding)
        return;
    distance = std::clamp(distance, shown.low, shown.high);
    drawChartCursor(painter, shown, distance, palette());
    double top = shown.rect.top();
    const std::size_t compared = m_scene->runCount() - (m_what == Compared::Speed ? 0 : 1);
    for (std::size_t run = 0; run < m_scene->runCount(); ++run) {
        const auto value = comparedAt(*m_scene, m_what, run, distance);
        if (!value || !isGroupShown(int(run)))
            continue;
        QString text = numberText(value->value, value->sigma, comparedUnit(m_what)).text();
        if (compared > 1)
            text = joinedWords(QString::fromStdString(m_scene->name(run)), text);
        const QRectF bubble = drawChartBubble(painter, shown, {distance, value->value}, top, text,
                                              seriesColour(int(run), palette()), palette());
        m_bubbles->add(bubble, [scene = m_scene, what = m_what, run, distance, value = *value] {
            return what == Compared::Speed
                       ? explainSpeedOverDistance(
                             *scene, run, distance,
                             numberText(value.value, value.sigma, comparedUnit(what)).text())
                       : explainTimeDifference(*scene, run, distance, {value.value, value.sigma});
        });
        top = bubble.bottom() + bubbleGap;
    }
}

void DistanceArea::goTo(double distanceM)
{
    if (!m_scene)
        return;
    const RunComparison &comparison = m_scene->compared.comparison;
    const auto arrival = comparison.runs.front().arrivals.at(comparison.originM + distanceM);
    if (!arrival)
        return;
    m_timeline.pause();
    m_timeline.setCurrentTime(m_scene->commonTime(0, fromSeconds(arrival->timeS)));
}

DistanceChart::DistanceChart(Timeline &timeline, AxisSpan &span, Compared what, QWidget *parent)
    : Card(what == Compared::Speed ? tr("Speed over distance") : tr("Time difference over distance"), parent),
      m_what(what), m_area(new DistanceArea(timeline, span, what)),
      m_key(what == Compared::Speed ? new SeriesKey(this) : nullptr)
{
    setContent(m_area);
    m_area->setAccessibleName(title());
    new ChartImage(
        *m_area,
        [this] {
            return ImageHeading{title(), m_names, remark()};
        },
        m_key);
    if (!m_key)
        return;
    addToHeader(m_key);
    connect(m_key, &SeriesKey::toggled, m_area, &ChartView::setGroupShown);
    connect(m_key, &SeriesKey::toggled, this, &DistanceChart::runToggled);
}

void DistanceChart::setScene(ComparisonScenePtr scene)
{
    m_names = scene ? scene->names() : QStringList();
    if (m_key)
        m_key->setNames(m_names);
    QString remark;
    if (scene && m_what == Compared::Speed)
        remark = tr("%1 · smoothed ±95 %").arg(shownUnits().speed.name);
    else if (scene)
        remark = scene->runCount() == 2
                     ? tr("s · above 0: %2 is later than %1 · ±95 % · grey: not significant")
                           .arg(m_names[0], m_names[1])
                     : tr("s · above 0: later than %1 · ±95 % · grey: not significant").arg(m_names[0]);
    setRemark(remark);
    m_area->setScene(std::move(scene));
    m_area->setAccessibleDescription(remark);
}

} // namespace odo
