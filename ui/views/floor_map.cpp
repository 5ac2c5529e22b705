// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/floor_map.h"

#include "ui/views/chart_picture.h"
#include "ui/views/explanation_dialog.h"
#include "ui/views/map_area.h"

#include <QAction>
#include <QComboBox>
#include <QToolButton>

namespace odo {

FloorMap::FloorMap(Timeline &timeline, QWidget *parent)
    : Card(tr("Top-down map"), parent), m_area(new MapArea(timeline, this)), m_colouring(new QComboBox(this)),
      m_how(new QToolButton(this)), m_disagreement(new QAction(tr("Map: &views' disagreement"), this))
{
    setContent(m_area);
    new ChartPicture(*m_area, [this] { return PictureHeading{title(), {m_scene ? QString::fromStdString(m_scene->trial.name) : QString()}, {}}; });
    m_area->setAccessibleName(tr("Map of the floor with the robots' trails"));
    m_colouring->setAccessibleName(tr("What colours the trails of the map"));
    m_colouring->setFocusPolicy(Qt::TabFocus); // Space goes on playing
    m_colouring->addItems({tr("Speed"), tr("Disagreement")});
    m_colouring->setSizeAdjustPolicy(QComboBox::AdjustToContents);
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

} // namespace odo
