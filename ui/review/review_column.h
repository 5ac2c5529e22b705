// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QStringList>
#include <QWidget>

class QAction;
class QComboBox;

namespace odo {

class Card;
class FactList;
class RangeCard;
class ResultPanel;
class SpikeList;
class Timeline;

/// The right column of Review: which trial, its figures, its spikes, its facts; or, before it was tracked,
/// the way to get them. While a range is selected, its figures take the place of the facts.
class ReviewColumn : public QWidget
{
    Q_OBJECT
public:
    /// chooser: stands at the top.
    ReviewColumn(Timeline &timeline, QWidget *chooser, QWidget *parent = nullptr);
    void setScene(const TrialScenePtr &scene);
    RangeCard &range() const { return *m_range; }

    SpikeList &spikes() const { return *m_spikes; }

Q_SIGNALS:
    void trackRequested();

private:
    Card *makeTrackCard();

    Card *m_track;
    ResultPanel *m_result;
    SpikeList *m_spikes;
    RangeCard *m_range;
    Card *m_trial;
    FactList *m_facts;
};

/// Which trial is shown: a list of all, and the ones before and after. Owns the two actions, for menus.
class TrialChooser : public QWidget
{
    Q_OBJECT
public:
    explicit TrialChooser(QWidget *parent = nullptr);
    /// Names in the order of the list, and the words that each is shown by ("Trial 3 · Falcon"); as many.
    void setTrials(const QStringList &names, const QStringList &words);
    /// Emits nothing.
    void setCurrent(const QString &name);
    QAction *previousAction() const { return m_previous; }
    QAction *nextAction() const { return m_next; }

Q_SIGNALS:
    void chosen(const QString &name);

private:
    void step(int by);
    void updateActions();

    QComboBox *m_trials;
    QAction *m_previous;
    QAction *m_next;
};

} // namespace odo
