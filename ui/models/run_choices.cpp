// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/run_choices.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/shown_team.h"

#include <QStringList>
#include <algorithm>

namespace odo {

namespace {

QString choiceWords(const TrialRecord &trial, const std::string &robot)
{
    QStringList words{QString::fromStdString(trial.name)};
    for (const QString &word : {QString::fromStdString(robot), shownTeam(trial), QString::fromStdString(trial.task)})
        if (!word.isEmpty())
            words << word;
    return words.join(QStringLiteral(" · "));
}

bool isSame(const CompareSettings::Run &a, const CompareSettings::Run &b)
{
    return a.trial == b.trial && (a.robot == b.robot || a.robot.empty() || b.robot.empty());
}

} // namespace

QList<RunChoice> runChoices(std::span<const TrialRecord> trials)
{
    QList<RunChoice> choices;
    for (auto each = trials.rbegin(); each != trials.rend(); ++each) {
        const TrialRecord &trial = *each;
        if (trial.binned)
            continue;
        if (trial.robotNames.size() < 2)
            choices.append({{trial.name, {}}, choiceWords(trial, {})});
        else
            for (const std::string &robot : trial.robotNames)
                choices.append({{trial.name, robot}, choiceWords(trial, robot)});
    }
    return choices;
}

QList<int> placesOf(const QList<RunChoice> &choices, std::span<const CompareSettings::Run> runs)
{
    QList<int> places;
    for (const CompareSettings::Run &run : runs)
        for (int i = 0; i < choices.size(); ++i)
            if (isSame(choices[i].run, run) && !places.contains(i)) {
                places << i;
                break;
            }
    return places;
}

Result<std::optional<std::string>> partnerOf(Project &project, std::span<const TrialRecord> trials,
                                             const std::string &name)
{
    constexpr int mostAsked = 40; // a year's trials need not be gone through for a suggestion
    const auto self = std::ranges::find(trials, name, &TrialRecord::name);
    if (self == trials.end())
        return std::nullopt;
    for (const bool sameTask : {true, false}) {
        int asked = 0;
        for (const TrialRecord &trial : trials) {
            if (trial.binned || trial.id == self->id || (trial.task == self->task) != sameTask)
                continue;
            if (++asked > mostAsked)
                break;
            const auto analyses = project.analyses().currentMetrics(trial.id);
            if (!analyses)
                return tl::unexpected(analyses.error());
            if (!analyses->empty())
                return trial.name;
        }
    }
    return std::nullopt;
}

} // namespace odo
