// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/widgets/card.h"

class QAction;
class QHBoxLayout;
class QTableView;

namespace odo {

class SpikeModel;
class Timeline;

/// The spikes with their reasons; choosing one moves the time there, and the time selects the spike at it.
/// Several can be chosen: with Ctrl and Shift, all of a reason, or all of the selected range of time. Enter,
/// a double click or Shift+F1 explains how it was found.
class SpikeList : public Card
{
    Q_OBJECT
public:
    explicit SpikeList(Timeline &timeline, QWidget *parent = nullptr);
    void setScene(TrialScenePtr scene);
    QTableView *table() const { return m_table; }
    /// Buttons below the list, for what can be done at the present time.
    void setActions(const QList<QAction *> &actions);
    /// That choose several.
    QList<QAction *> selectActions() const { return {m_sameReason, m_inRange}; }

Q_SIGNALS:
    void robotChosen(std::size_t robot); ///< of the spike that was chosen; an index into TrialScene::robots
    /// Of that robot, the frames of the first view of all spikes that are chosen.
    void samplesChosen(const std::vector<std::int64_t> &frames);

protected:
    void changeEvent(QEvent *event) override;

private:
    void explain();
    void followTime();
    void applyColours();
    void makeSelectActions();
    template <class IsMeant>
    void selectRows(const IsMeant &isMeant);
    void showChosen();

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    SpikeModel *m_model;
    QTableView *m_table;
    QHBoxLayout *m_buttons;
    QAction *m_sameReason, *m_inRange;
};

} // namespace odo
