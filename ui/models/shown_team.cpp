// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shown_team.h"

#include <QSettings>
#include <atomic>

namespace odo {

namespace {

const QString pseudonymsKey = QStringLiteral("history/pseudonyms");

/// 1: they are, 0: they are not, −1: not asked for yet. Lists of thousands ask for each row: the settings are
/// read once.
std::atomic<int> known = -1;

QString veiled(QString sentence, const std::vector<TeamRecord> &teams)
{
    const auto quoted = [](const std::string &name) { return QStringLiteral("'%1'").arg(QString::fromStdString(name)); };
    for (const TeamRecord &team : teams) {
        if (team.pseudonym.empty())
            continue;
        sentence.replace(quoted(team.name), quoted(team.pseudonym));
        for (const std::string &member : team.members)
            sentence.replace(quoted(member), QStringLiteral("'…'"));
    }
    return sentence;
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

Error shownError(Error error, const std::vector<TeamRecord> &teams)
{
    if (!arePseudonymsShown())
        return error;
    for (std::string *part : {&error.what, &error.why, &error.advice})
        *part = veiled(QString::fromStdString(*part), teams).toStdString();
    return error;
}

} // namespace odo
