// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/present_window.h"

#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/models/timeline.h"
#include "ui/models/verdict_mark.h"
#include "ui/views/map/floor_map.h"
#include "ui/views/widgets/labels.h"

#include <QCloseEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

constexpr QSize usualPresentSize(1280, 720), leastPresentSize(480, 270);
constexpr std::size_t mostMetrics = 4;

void setHeight(QWidget &label, double pixels, bool isBold = false)
{
    QFont font = label.font();
    font.setPixelSize(std::max(9, static_cast<int>(pixels)));
    font.setBold(isBold);
    label.setFont(font);
}

QLabel *plainLabel(const QString &text = {})
{
    auto *label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

PresentWindow::PresentWindow(Timeline &timeline, QWidget &beside)
    : QWidget(&beside, Qt::Window), m_timeline(timeline), m_beside(beside), m_team(new ElidedLabel),
      m_trial(new ElidedLabel), m_verdict(new BadgeLabel({})), m_map(new FloorMap(timeline)),
      m_results(new QWidget), m_column(new QVBoxLayout(m_results))
{
    setObjectName(QStringLiteral("page"));
    setAttribute(Qt::WA_StyledBackground);
    setWindowTitle(tr("Presentation"));
    setMinimumSize(leastPresentSize);
    m_team->setAccessibleName(tr("Team"));
    m_trial->setAccessibleName(tr("Trial"));
    m_trial->setObjectName(QStringLiteral("quiet"));
    m_trial->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto *head = new QHBoxLayout;
    head->addWidget(m_team, 3);
    head->addWidget(m_verdict);
    head->addWidget(m_trial, 2);
    m_column->setContentsMargins(0, 0, 0, 0);
    auto *body = new QHBoxLayout;
    body->setSpacing(16);
    body->addWidget(m_map, 3);
    body->addWidget(m_results, 2);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 10, 16, 16);
    layout->addLayout(head);
    layout->addLayout(body, 1);
    connect(&m_timeline, &Timeline::currentChanged, this, &PresentWindow::followTime);
}

void PresentWindow::setScene(const TrialScenePtr &scene)
{
    m_scene = scene;
    m_map->setScene(scene);
    fill();
}

bool PresentWindow::isSettled() const
{
    return m_map->isSettled();
}

void PresentWindow::fill()
{
    delete m_results->layout();
    qDeleteAll(m_results->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly));
    m_column = new QVBoxLayout(m_results);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_robots.clear();
    m_verdict->setBadge({});
    if (!m_scene) {
        m_team->setFullText(tr("No trial"));
        m_trial->setFullText({});
        return;
    }
    const QString team = shownTeam(m_scene->trial), trial = QString::fromStdString(m_scene->trial.name);
    m_team->setFullText(team.isEmpty() ? trial : team);
    QStringList more;
    if (!team.isEmpty())
        more << trial;
    if (m_scene->task)
        more << QString::fromStdString(m_scene->trial.task);
    m_trial->setFullText(more.join(QStringLiteral(" · ")));
    if (m_scene->verdict.level() != CheckLevel::Pass)
        m_verdict->setBadge(verdictBadge(m_scene->verdict));
    for (std::size_t robot = 0; robot < m_scene->robots.size(); ++robot)
        addRobot(robot);
    m_column->addStretch(1);
    fitType();
    followTime();
}

void PresentWindow::addRobot(std::size_t robot)
{
    const SceneRobot &shown = m_scene->robots[robot];
    RobotPart part{plainLabel(QString::fromStdString(shown.robot.name)),
                   plainLabel(),
                   plainLabel(shownUnits().speed.name),
                   {},
                   {}};
    part.name->setVisible(m_scene->robots.size() > 1);
    part.speed->setAccessibleName(tr("Speed now"));
    part.unit->setObjectName(QStringLiteral("quiet"));
    auto *now = new QHBoxLayout;
    now->addWidget(part.speed, 0, Qt::AlignBaseline);
    now->addWidget(part.unit, 1, Qt::AlignBaseline);
    auto *grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    const auto add = [&](const QString &name, const NumberText &value) {
        auto *caption = plainLabel(name);
        caption->setObjectName(QStringLiteral("quiet"));
        caption->setWordWrap(true);
        const int row = grid->rowCount();
        grid->addWidget(caption, row, 0);
        auto *number = plainLabel(value.text());
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(number, row, 1);
        part.captions.push_back(caption);
        part.values.push_back(number);
    };
    if (const auto score = scoreOf(*m_scene, robot))
        add(metricName("score"), scoreNumber(*score));
    if (shown.analysis) {
        const std::size_t more = mostMetrics / (m_scene->robots.size() > 1 ? 2 : 1);
        for (const Metric &metric : informativeMetrics(shown.analysis->profile.metrics, more))
            add(metricName(metric.name), metricNumber(metric));
    } else {
        part.unit->setText(tr("Not tracked yet"));
    }
    if (robot > 0)
        m_column->addSpacing(2 * m_column->spacing());
    m_column->addWidget(part.name);
    m_column->addLayout(now);
    m_column->addLayout(grid);
    m_robots.push_back(std::move(part));
}

void PresentWindow::followTime()
{
    const Nanoseconds time = m_timeline.currentTime();
    for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        if (!analysis)
            continue;
        const Profile &profile = partAt(*analysis, time);
        const std::ptrdiff_t index = pointIndexAt(profile, time);
        const bool isKnown = index >= 0 && profile.points[static_cast<std::size_t>(index)].valid;
        constexpr int decimals = 2;
        m_robots[robot].speed->setText(
            isKnown ? QLocale().toString(profile.points[static_cast<std::size_t>(index)].speedMps *
                                             shownUnits().speed.perSi,
                                         'f', shownUnits().speed.perSi > 1 ? 0 : decimals)
                    : QStringLiteral("–"));
    }
}

/// By the window's height, or less where it is narrow.
void PresentWindow::fitType()
{
    const double percent = std::min(height() / 100.0, width() / 178.0);
    const double share =
        m_robots.size() > 1 ? 1.6 / static_cast<double>(std::min<std::size_t>(3, m_robots.size())) : 1;
    setHeight(*m_team, 8 * percent, true);
    setHeight(*m_trial, 4 * percent);
    setHeight(*m_verdict, 3 * percent);
    for (const RobotPart &part : m_robots) {
        setHeight(*part.name, 4 * percent, true);
        setHeight(*part.speed, 18 * percent * share, true);
        setHeight(*part.unit, 6 * percent * share);
        for (QLabel *caption : part.captions)
            setHeight(*caption, 3 * percent);
        for (QLabel *value : part.values)
            setHeight(*value, 4.5 * percent, true);
    }
}

void PresentWindow::present()
{
    const QScreen *own = m_beside.screen();
    const QList<QScreen *> screens = QGuiApplication::screens();
    const auto other = std::ranges::find_if(screens, [own](const QScreen *screen) { return screen != own; });
    if (other != screens.end()) {
        setGeometry((*other)->geometry());
        showFullScreen();
    } else {
        resize(usualPresentSize.boundedTo(own->availableSize()));
        show();
    }
    raise();
    activateWindow();
}

void PresentWindow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitType();
}

void PresentWindow::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
        close();
        break;
    case Qt::Key_F11:
        isFullScreen() ? showNormal() : showFullScreen();
        break;
    case Qt::Key_Space:
        m_timeline.toggle();
        break;
    case Qt::Key_Left:
        m_timeline.step(-1);
        break;
    case Qt::Key_Right:
        m_timeline.step(1);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void PresentWindow::closeEvent(QCloseEvent *event)
{
    QWidget::closeEvent(event);
    Q_EMIT closed();
}

} // namespace odo
