// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/window_bars.h"

#include "core/project/names.h"
#include "core/project/project.h"
#include "ui/main_window/workspace.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

namespace odo {

namespace {
constexpr int barWidth = 84;
constexpr int iconSide = 24;
const QColor iconColour(0xdc, 0xe3, 0xe9);
} // namespace

ModeBar::ModeBar(QWidget *parent)
    : QFrame(parent), m_group(new QActionGroup(this)), m_layout(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("modeBar"));
    setAccessibleName(tr("Modes"));
    m_layout->setContentsMargins(0, 8, 0, 8);
    m_layout->setSpacing(0);
    m_layout->addStretch(1);
    connect(m_group, &QActionGroup::triggered, this,
            [this](QAction *action) { Q_EMIT chosen(action->data().toInt()); });
}

void ModeBar::addMode(const QString &icon, const QString &name)
{
    const int mode = static_cast<int>(m_group->actions().size());
    auto *action = new QAction(themeIcon(icon, iconColour), name, m_group);
    nameCommands({{action, icon.toLatin1().constData()}});
    action->setCheckable(true);
    action->setIconVisibleInMenu(false); // it is drawn for the dark bar
    action->setData(mode);
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + mode)));
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(name, action->shortcut().toString(QKeySequence::NativeText)));
    auto *button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({iconSide, iconSide});
    button->setFixedWidth(barWidth);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(name);
    m_layout->insertWidget(mode, button);
}

void ModeBar::setCurrent(int mode)
{
    const QList<QAction *> modes = m_group->actions();
    if (mode >= 0 && mode < modes.size())
        modes.at(mode)->setChecked(true);
}

void ModeBar::setModesEnabled(bool enabled)
{
    m_group->setEnabled(enabled);
}

QList<QAction *> ModeBar::modeActions() const
{
    return m_group->actions();
}

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

constexpr int leastHubWidth = 80;

} // namespace

StatusLine::StatusLine(QWidget *parent)
    : QStatusBar(parent), m_saved(new QLabel), m_analysis(new QLabel), m_units(new QLabel),
      m_hub(new QToolButton), m_job(new JobIndicator)
{
    m_units->setToolTip(tr("Units of lengths, speeds and times; change them in the preferences"));
    for (QLabel *label : {m_saved, m_analysis, m_units}) {
        label->setTextFormat(Qt::PlainText);
        label->setContentsMargins(8, 2, 8, 2);
    }
    m_hub->setProperty("flat", true);
    m_hub->setFocusPolicy(Qt::TabFocus);
    m_hub->setMinimumWidth(leastHubWidth); // rather than a window that is too wide
    m_hub->setAccessibleName(tr("The school's hub"));
    m_hub->hide();
    connect(m_hub, &QToolButton::clicked, this, &StatusLine::hubRequested);
    setSizeGripEnabled(false);
    setFixedHeight(m_job->sizeHint().height() + 6); // it must not jump when a job begins
    addWidget(m_saved);
    addWidget(m_hub);
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

void StatusLine::showHub(const QString &words)
{
    m_hub->setText(words);
    m_hub->setAccessibleName(words.isEmpty() ? tr("The school's hub") : words);
    m_hub->setToolTip(tr("%1. Click for more about the school's hub").arg(words));
    m_hub->setVisible(!words.isEmpty());
}

namespace {
constexpr int steps = 1000;
constexpr int progressWidth = 180;
constexpr int textWidth = 320;
} // namespace

JobIndicator::JobIndicator(QWidget *parent)
    : QWidget(parent), m_text(new ElidedLabel(this)), m_bar(new QProgressBar(this)),
      m_cancel(new QPushButton(tr("Cancel"), this))
{
    m_text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_text->setFixedWidth(textWidth);
    m_bar->setRange(0, steps);
    m_bar->setFixedWidth(progressWidth);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Progress"));
    m_cancel->setAccessibleName(tr("Cancel the running job"));
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_cancel->setEnabled(false);
        m_text->setFullText(tr("Stopping…"));
        Q_EMIT cancelRequested();
    });
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 1, 6, 1);
    layout->addWidget(m_text);
    layout->addWidget(m_bar);
    layout->addWidget(m_cancel);
    hide();
}

void JobIndicator::begin(const QString &text)
{
    m_cancel->setEnabled(true);
    m_bar->setValue(0);
    m_text->setFullText(text);
    show();
}

void JobIndicator::setProgress(double fraction, const QString &text)
{
    m_bar->setValue(static_cast<int>(fraction * steps));
    if (m_cancel->isEnabled()) // once stopping was asked for, that is what there is to say
        m_text->setFullText(text);
}

void JobIndicator::end()
{
    hide();
}

QString JobIndicator::text() const
{
    return m_text->fullText();
}

namespace {

class WindowTitleWords
{
    Q_DECLARE_TR_FUNCTIONS(WindowTitle)
};

} // namespace

QString windowTitleOf(const Project *project, const TrialScenePtr &trial)
{
    QStringList parts;
    if (project)
        parts << QString::fromStdString(project->title().value_or(titleFromName(project->file())));
    if (trial) {
        QStringList words(QString::fromStdString(trial->trial.name));
        if (!trial->trial.teamName.empty())
            words << WindowTitleWords::tr("Team %1").arg(shownTeam(trial->trial));
        parts << words.join(QStringLiteral(", "));
    }
    parts << WindowTitleWords::tr("Odograph");
    // Qt would replace "[*]" by its mark for changed windows.
    return parts.join(QStringLiteral(" — ")).replace(QLatin1String("[*]"), QLatin1String("[ *]"));
}

} // namespace odo
