// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/completion/project_names.h"

#include "core/base/file_system.h"
#include "core/exchange/track_export.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

using Names = void (*)(Project &, const NameSink &);

template <class Records>
void takeNames(const Result<Records> &records, const NameSink &take)
{
    if (records)
        for (const auto &each : *records)
            take(QString::fromStdString(each.name), {});
}

void takeTexts(const Result<std::vector<std::string>> &texts, const NameSink &take)
{
    if (texts)
        for (const std::string &text : *texts)
            take(QString::fromStdString(text), {});
}

void takeTrials(Project &project, bool inBin, const NameSink &take)
{
    const auto names = project.trials().names();
    if (!names)
        return;
    for (const TrialName &trial : *names)
        if (trial.binned == inBin)
            take(QString::fromStdString(trial.name), QString::fromStdString(trial.teamName));
}

void layouts(Project &project, const NameSink &take)
{
    if (const auto all = project.layouts().all())
        for (const LayoutRecord &each : *all)
            take(QString::fromStdString(each.layout.name), {});
}

void tasks(Project &project, const NameSink &take)
{
    if (const auto all = project.tasks().all())
        for (const TaskRecord &each : *all)
            take(QString::fromStdString(each.name), {});
}

void columns(Project &, const NameSink &take)
{
    for (const std::string &column : csvColumns())
        take(QString::fromStdString(column), {});
}

void metrics(Project &project, const NameSink &take)
{
    take(QStringLiteral("score"), {});
    takeTexts(project.analyses().metricNames(), take);
}

Names namesOf(const QString &kind)
{
    static const QHash<QString, Names> kinds{
        {QStringLiteral("TRIAL"), [](Project &p, const NameSink &take) { takeTrials(p, false, take); }},
        {QStringLiteral("TRIAL_IN_BIN"), [](Project &p, const NameSink &take) { takeTrials(p, true, take); }},
        {QStringLiteral("CAMERA"),
         [](Project &p, const NameSink &take) { takeNames(p.cameras().all(), take); }},
        {QStringLiteral("R"), [](Project &p, const NameSink &take) { takeNames(p.robots().all(), take); }},
        {QStringLiteral("TEAM"), [](Project &p, const NameSink &take) { takeNames(p.teams().all(), take); }},
        {QStringLiteral("CLASS"),
         [](Project &p, const NameSink &take) { takeTexts(p.teams().classes(), take); }},
        {QStringLiteral("TASK"), tasks},
        {QStringLiteral("LAYOUT"), layouts},
        {QStringLiteral("COLUMN"), columns},
        {QStringLiteral("METRIC"), metrics}};
    return kinds.value(kind, nullptr);
}

/// Whether it has a log that nobody uses: SQLite would make an index of it to read it.
bool isLeftByCrash(const std::filesystem::path &file)
{
    const std::string name = file.string();
    return files::isFile(name + "-wal") && !files::isFile(name + "-shm");
}

} // namespace

void namesInProject(const std::filesystem::path &file, const QString &kind, const NameSink &take)
{
    const Names names = namesOf(kind);
    if (!names || !Project::checkHeader(file) || isLeftByCrash(file))
        return;
    // Project::open would bring an older one up to date, and look all of it through
    if (const auto project = Project::openChecked(file, Project::Access::ReadOnly))
        names(**project, take);
}

} // namespace odo
