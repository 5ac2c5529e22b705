// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QWidget>

namespace odo {

class Card;
class FactList;
class ResultPanel;
class SpikeList;
class Timeline;

/// The right column of Review: which trial, its figures, its spikes, its facts; or, before it was tracked,
/// the way to get them.
class ReviewColumn : public QWidget
{
    Q_OBJECT
public:
    /// chooser: stands at the top.
    ReviewColumn(Timeline &timeline, QWidget *chooser, QWidget *parent = nullptr);
    void setScene(TrialScenePtr scene);

Q_SIGNALS:
    void trackRequested();

private:
    Card *makeTrackCard();

    Card *m_track;
    ResultPanel *m_result;
    SpikeList *m_spikes;
    Card *m_trial;
    FactList *m_facts;
};

} // namespace odo
