// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "core/workflow/compare/compare_trials.h"

#include <QAbstractListModel>
#include <QList>
#include <QString>
#include <QStringList>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// Names for a list to choose from, each with the words that it is shown by. For thousands of them: a combo
/// box's own items would take longer than the window may. GUI thread.
class NameListModel : public QAbstractListModel
{
    Q_OBJECT
public:
    enum Roles {
        NameRole = Qt::UserRole, ///< QString
    };
    /// words: as many as names.
    NameListModel(QStringList names, QStringList words, QObject *parent = nullptr);
    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    int indexOf(const QString &name) const { return static_cast<int>(m_names.indexOf(name)); } ///< −1: none

private:
    const QStringList m_names, m_words;
};

/// A run that can be compared, and what it is called in lists.
struct RunChoice
{
    CompareSettings::Run run;
    QString words;
};

/// The runs of trials, newest first, that are not in the bin, in the order of time: one a trial, or one for
/// each of its robots.
QList<RunChoice> runChoices(std::span<const TrialRecord> trials);

/// The rows of the runs among the choices, each row at most once; missing runs are left out. A run without a
/// robot matches any robot.
QList<int> paletteIndicesOf(const QList<RunChoice> &choices, std::span<const CompareSettings::Run> runs);

/// What a trial suggests itself to be compared with: the newest other trial of the same task that was
/// tracked, or else the newest other one that was. trials: newest first. On the project's thread. Errors:
/// those of the repositories.
Result<std::optional<std::string>> partnerOf(Project &project, std::span<const TrialRecord> trials,
                                             const std::string &name);

/// Whether teams that have a pseudonym are shown by it, on this computer and in every mode alike. Remembered.
/// Any thread.
bool arePseudonymsShown();
void showPseudonyms(bool shown);

/// The single point that decides which name of a team is shown.
QString shownTeam(const std::string &name, const std::string &pseudonym);
QString shownTeam(const TrialRecord &trial); ///< empty without a team
QString shownTeam(const TeamRecord &team);

/// A team of the open project, by name alone; one that is not known is shown by its name.
QString shownTeam(const std::string &name);
/// The other way: the team of the open project that is shown by this; one that is not known has that name.
std::string teamShownBy(const QString &shown);
/// The teams of the open project: messages of core contain only names. Any thread.
void knowPseudonyms(std::span<const TeamRecord> teams);

} // namespace odo
