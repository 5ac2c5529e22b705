// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QWidget>

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

} // namespace odo
