// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/result_panel.h"

#include "ui/models/figure_text.h"
#include "ui/models/metric_choice.h"
#include "ui/models/score_text.h"
#include "ui/models/shown_team.h"
#include "ui/views/explanation_dialog.h"
#include "ui/views/figure_grid.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QStringList>

namespace odo {

namespace {
constexpr std::size_t shownFigures = 6;
}

ResultPanel::ResultPanel(QWidget *parent)
    : Card(tr("Result"), parent), m_grid(new FigureGrid(this)), m_robots(new QComboBox(this))
{
    setContent(m_grid);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_robots->setAccessibleName(tr("Robot whose result is shown"));
    m_robots->hide();
    addToHeader(m_robots);
    connect(m_robots, &QComboBox::currentIndexChanged, this, &ResultPanel::showRobot);
    m_grid->setChoosable(howComputedWords());
    connect(m_grid, &FigureGrid::chosen, this, [this](std::size_t figure) {
        const std::size_t scored = m_score ? 1 : 0; // the score stands first
        showExplanation(window(), figure < scored ? explainScore(*m_score, analysisInputs(*m_scene, m_robot))
                                                  : explainMetric(*m_scene, m_robot, m_shown.at(figure - scored)));
    });
}

void ResultPanel::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    const QSignalBlocker blocked(m_robots);
    m_robots->clear();
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot)
        m_robots->addItem(QString::fromStdString(m_scene->robots[robot].robot.name));
    m_robots->setVisible(m_robots->count() > 1);
    showRobot(m_robots->count() > 0 ? 0 : -1);
}

void ResultPanel::showRobot(int robot)
{
    const bool known = m_scene && robot >= 0 && robot < static_cast<int>(m_scene->robots.size());
    if (!known) {
        m_grid->setFigures({});
        setRemark({});
        return;
    }
    const SceneRobot &shown = m_scene->robots[static_cast<std::size_t>(robot)];
    QStringList remark;
    if (!m_scene->trial.teamName.empty())
        remark += shownTeam(m_scene->trial);
    if (m_robots->count() == 1)
        remark += tr("robot “%1”").arg(QString::fromStdString(shown.robot.name));
    setRemark(remark.join(QStringLiteral(" · ")));
    std::vector<NamedFigure> figures;
    m_robot = static_cast<std::size_t>(robot);
    m_score = scoreOf(*m_scene, m_robot);
    if (m_score)
        figures.push_back({metricName("score"), scoreFigure(*m_score)});
    m_shown = shown.analysis ? tellingMetrics(shown.analysis->profile.metrics, shownFigures - figures.size())
                             : std::vector<Metric>();
    for (const Metric &metric : m_shown)
        figures.push_back({metricName(metric.name), metricFigure(metric)});
    m_grid->setFigures(std::move(figures));
}

} // namespace odo
