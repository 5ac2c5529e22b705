// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shown_names.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <QSettings>
#include <QStringList>
#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>

namespace odo {

NameListModel::NameListModel(QStringList names, QStringList words, QObject *parent)
    : QAbstractListModel(parent), m_names(std::move(names)), m_words(std::move(words))
{
    Q_ASSERT(m_names.size() == m_words.size());
}

int NameListModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_names.size());
}

QVariant NameListModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole)
        return m_words.at(index.row());
    return role == NameRole ? QVariant(m_names.at(index.row())) : QVariant();
}

namespace {

QString choiceWords(const TrialRecord &trial, const std::string &robot)
{
    QStringList words{QString::fromStdString(trial.name)};
    for (const QString &word :
         {QString::fromStdString(robot), shownTeam(trial), QString::fromStdString(trial.task)})
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

QList<int> paletteIndicesOf(const QList<RunChoice> &choices, std::span<const CompareSettings::Run> runs)
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
            const auto analyses = ODO_TRY(project.analyses().currentMetrics(trial.id));
            if (!analyses.empty())
                return trial.name;
        }
    }
    return std::nullopt;
}

namespace {

const QString pseudonymsKey = QStringLiteral("history/pseudonyms");

/// 1: they are, 0: they are not, −1: not asked for yet. Lists of thousands ask for each row: the settings are
/// read once.
std::atomic<int> known = -1;

/// The pseudonyms of the teams that have one, by name.
struct Pseudonyms
{
    std::mutex mutex;
    std::map<std::string, std::string> ofTeam;
};

Pseudonyms &pseudonyms()
{
    static Pseudonyms all;
    return all;
}

} // namespace

bool arePseudonymsShown()
{
    if (known < 0)
        known = QSettings().value(pseudonymsKey).toBool() ? 1 : 0;
    return known == 1;
}

void showPseudonyms(bool shown)
{
    known = shown ? 1 : 0;
    QSettings().setValue(pseudonymsKey, shown);
}

QString shownTeam(const std::string &name, const std::string &pseudonym)
{
    return QString::fromStdString(arePseudonymsShown() && !pseudonym.empty() ? pseudonym : name);
}

QString shownTeam(const TrialRecord &trial)
{
    return shownTeam(trial.teamName, trial.teamPseudonym);
}

QString shownTeam(const TeamRecord &team)
{
    return shownTeam(team.name, team.pseudonym);
}

QString shownTeam(const std::string &name)
{
    Pseudonyms &all = pseudonyms();
    const std::lock_guard lock(all.mutex);
    const auto found = all.ofTeam.find(name);
    return shownTeam(name, found == all.ofTeam.end() ? std::string() : found->second);
}

std::string teamShownBy(const QString &shown)
{
    const std::string text = shown.trimmed().toStdString();
    if (!arePseudonymsShown())
        return text;
    Pseudonyms &all = pseudonyms();
    const std::lock_guard lock(all.mutex);
    const auto found =
        std::ranges::find_if(all.ofTeam, [&](const auto &team) { return team.second == text; });
    return found == all.ofTeam.end() ? text : found->first;
}

void knowPseudonyms(std::span<const TeamRecord> teams)
{
    std::map<std::string, std::string> ofTeam;
    for (const TeamRecord &team : teams)
        if (!team.pseudonym.empty())
            ofTeam[team.name] = team.pseudonym;
    Pseudonyms &all = pseudonyms();
    const std::lock_guard lock(all.mutex);
    all.ofTeam = std::move(ofTeam);
}

} // namespace odo
