// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/window_title.h"

#include "core/project/names.h"
#include "core/project/project.h"
#include "ui/models/shown_team.h"

#include <QCoreApplication>
#include <QStringList>

namespace odo {
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
    // An asterisk in brackets would be taken as the place of the "changed" mark.
    return parts.join(QStringLiteral(" — ")).replace(QLatin1String("[*]"), QLatin1String("[ *]"));
}

} // namespace odo
