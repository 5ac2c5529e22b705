// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/widgets/card.h"

#include <QStringList>
#include <vector>

class QComboBox;
class QMenu;
class QTableView;

namespace odo {

class SampleModel;
class Timeline;

/// Every sample of a robot's run as a table, with columns that a person chooses. The row of the present time
/// is the current one, and a chosen row is gone to. Ctrl+C copies the selected rows with headings, or all. A
/// hidden table computes nothing. GUI thread.
class SampleTable : public Card
{
    Q_OBJECT
public:
    explicit SampleTable(Timeline &timeline, QWidget *parent = nullptr);
    /// A null scene clears.
    void setScene(const TrialScenePtr &scene);

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeHeader();
    void fill();
    void showRun();
    void offerColumns();
    void showColumns();
    void followTime();
    void goToCurrent();
    void copy();
    std::vector<int> shownColumns() const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    bool m_isStale = false;
    bool m_isFollowing = false; ///< the current row is set by the time, not by a person
    SampleModel *m_model;
    QStringList m_columns; ///< that are shown, by their words; kept in the settings
    QComboBox *m_robot;
    QMenu *m_columnMenu;
    QTableView *m_table;
};

} // namespace odo
