// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/project_content.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <QDir>

namespace odo {
namespace {

/// By value: a range-for does not keep the Result alive behind a reference into it.
template <class Record>
std::vector<Record> everythingOf(const Result<std::vector<Record>> &records)
{
    return records.value_or(std::vector<Record>());
}

} // namespace

QStringList contentOf(Project &project)
{
    QStringList parts = QDir(QString::fromStdString(project.mediaFolder().string())).entryList(QDir::Files);
    for (const RobotRecord &robot : everythingOf(project.robots().all()))
        parts << QString::fromStdString("robot " + robot.name);
    for (const TeamRecord &team : everythingOf(project.teams().all()))
        parts << QString::fromStdString("team " + team.name + "|" + team.className + "|" + team.pseudonym);
    for (const LayoutRecord &layout : everythingOf(project.layouts().all()))
        parts << QString::fromStdString("layout " + layout.layout.name);
    for (const CameraRecord &camera : everythingOf(project.cameras().all())) {
        const auto intrinsics = project.cameras().currentIntrinsics(camera.id);
        const auto registration = project.cameras().currentRegistration(camera.id);
        parts << QStringLiteral("camera %1 %2 %3")
                     .arg(QString::fromStdString(camera.name))
                     .arg(*intrinsics ? (*intrinsics)->id : 0)
                     .arg(*registration ? (*registration)->id : 0);
    }
    for (const TrialRecord &trial : everythingOf(project.trials().all())) {
        std::string tags;
        for (const std::string &tag : trial.tags)
            tags += "|" + tag;
        parts << QString::fromStdString("trial " + trial.name + "|" + trial.task + "|" + trial.notes +
                                        (trial.starred ? "|star" : "") + (trial.archived ? "|archived" : "") +
                                        (trial.binned ? "|bin" : "") + tags);
        for (const AnalysisRecord &analysis : everythingOf(project.analyses().current(trial.id)))
            parts << QStringLiteral("analysis %1").arg(analysis.id);
    }
    return parts;
}

} // namespace odo
