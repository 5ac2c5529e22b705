// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/views/profile_curve.h"

#include <QWidget>

class QTableView;

namespace odo {

class Card;
class DifferenceModel;
class FigureGrid;
class Timeline;

/// The right column of Compare: which runs, how far apart they are in time at the end and here, the times
/// from gate to gate, and all figures, of the second run against the first.
class CompareColumn : public QWidget
{
    Q_OBJECT
public:
    /// chooser: stands at the top.
    CompareColumn(Timeline &timeline, QWidget *chooser, QWidget *parent = nullptr);
    void setScene(ComparisonScenePtr scene);
    void setGates(const std::vector<PathGate> &gates);

private:
    void showFigures();

    Timeline &m_timeline;
    ComparisonScenePtr m_scene;
    Card *m_result, *m_sectorCard, *m_metricCard;
    FigureGrid *m_figures;
    DifferenceModel *m_sectors, *m_metrics;
    std::optional<CurveValue> m_end; ///< time difference where the last of both can be compared
};

} // namespace odo
