// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/status_line.h"

#include "ui/main_window/job_indicator.h"
#include "ui/main_window/workspace.h"
#include "ui/models/shown_units.h"

#include <QLabel>

namespace odo {
namespace {

QString analysisWords(const TrialScenePtr &trial)
{
    if (!trial)
        return StatusLine::tr("No trial");
    QString words = StatusLine::tr("Not tracked yet");
    for (const SceneRobot &robot : trial->robots)
        if (robot.analysis)
            words = StatusLine::tr("Analysis %1, Odograph %2")
                        .arg(robot.analysis->id)
                        .arg(QString::fromStdString(robot.analysis->softwareVersion));
    return words;
}

} // namespace

StatusLine::StatusLine(QWidget *parent)
    : QStatusBar(parent), m_saved(new QLabel), m_analysis(new QLabel), m_units(new QLabel),
      m_job(new JobIndicator)
{
    m_units->setToolTip(tr("Units of lengths, speeds and times; to be chosen in the preferences"));
    for (QLabel *label : {m_saved, m_analysis, m_units}) {
        label->setTextFormat(Qt::PlainText);
        label->setContentsMargins(8, 2, 8, 2);
    }
    setSizeGripEnabled(false);
    setFixedHeight(m_job->sizeHint().height() + 6); // it must not jump when a job begins
    addWidget(m_saved);
    addWidget(m_analysis);
    addPermanentWidget(m_job);
    addPermanentWidget(m_units);
    showUnits();
}

void StatusLine::showState(const Workspace &workspace, const TrialScenePtr &trial)
{
    if (!workspace.project()) {
        m_saved->setText(tr("No project is open"));
        m_analysis->clear();
        return;
    }
    m_saved->setText(workspace.isReadOnly() ? tr("Read only: nothing can be changed")
                     : workspace.isSaved()  ? tr("All changes saved")
                                            : tr("Saving…"));
    m_analysis->setText(analysisWords(trial));
}

void StatusLine::showUnits()
{
    const ShownUnits &units = shownUnits();
    m_units->setText(QStringLiteral("%1 · %2 · s").arg(units.length.name, units.speed.name));
}

} // namespace odo
