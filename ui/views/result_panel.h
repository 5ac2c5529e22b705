// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/card.h"

class QComboBox;

namespace odo {

class FigureGrid;

/// The figures of one robot's run, two in a row, each with its unit and ±. Choosing one tells how it was
/// computed.
class ResultPanel : public Card
{
    Q_OBJECT
public:
    explicit ResultPanel(QWidget *parent = nullptr);
    void setScene(TrialScenePtr scene);

private:
    void showRobot(int robot);

    TrialScenePtr m_scene;
    std::size_t m_robot = 0;
    std::optional<Score> m_score; ///< stands before the others
    std::vector<Metric> m_shown;
    FigureGrid *m_grid;
    QComboBox *m_robots; ///< shown for more than one robot
};

} // namespace odo
