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
/// Enter, a double click or Shift+F1 explains how it was found.
class SpikeList : public Card
{
    Q_OBJECT
public:
    explicit SpikeList(Timeline &timeline, QWidget *parent = nullptr);
    void setScene(TrialScenePtr scene);
    QTableView *table() const { return m_table; }
    /// Buttons below the list, for what can be done at the present time.
    void setActions(const QList<QAction *> &actions);

Q_SIGNALS:
    void robotChosen(std::size_t robot); ///< of the spike that was chosen; an index into TrialScene::robots

protected:
    void changeEvent(QEvent *event) override;

private:
    void explain();
    void followTime();
    void applyColours();

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    SpikeModel *m_model;
    QTableView *m_table;
    QHBoxLayout *m_buttons;
};

} // namespace odo
