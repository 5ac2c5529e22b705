// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_filter.h"

#include <QStringList>
#include <QWidget>

class QComboBox;
class QDateEdit;
class QHBoxLayout;
class QLayout;
class QToolButton;

namespace odo {

/// What a trial filter can be, so that it can be chosen from.
struct FilterOffer
{
    QStringList classes, teams, tasks, robots;
    QStringList classesShown; ///< names, those that are archived with that word
    QStringList teamsShown; ///< names or pseudonyms, one for each team
};

/// The choices above the list of trials: class, team, task, robot, dates, place, star. The text is not its
/// own.
class TrialFilterBar : public QWidget
{
    Q_OBJECT
public:
    explicit TrialFilterBar(QWidget *parent = nullptr);
    /// Keeps what is chosen where it is still there.
    void setOffer(const FilterOffer &offer);
    TrialFilter filter() const; ///< without a text
    /// A small widget at the right end.
    void addAtEnd(QWidget *widget);

Q_SIGNALS:
    void changed();

private:
    QComboBox *addChoice(QLayout &row, const QString &name, const QString &any);
    void showDates();

    QComboBox *m_class, *m_team, *m_task, *m_robot, *m_dates, *m_place;
    QDateEdit *m_from, *m_to;
    QToolButton *m_starred;
    QHBoxLayout *m_lower;
};

} // namespace odo
