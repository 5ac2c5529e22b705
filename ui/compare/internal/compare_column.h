// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "ui/models/comparison_scene.h"

#include <QWidget>
#include <optional>
#include <vector>

class QComboBox;

namespace odo {

class Card;
class DifferenceModel;
class FigureGrid;
class Timeline;

/// The right column of Compare: which runs, how far apart they are in time at the end and here, the times
/// from gate to gate, and all figures, of the second run against the first; of several further runs, of the
/// one that is chosen.
class CompareColumn : public QWidget
{
    Q_OBJECT
public:
    /// chooser: stands at the top.
    CompareColumn(Timeline &timeline, QWidget *chooser, QWidget *parent = nullptr);
    void setScene(ComparisonScenePtr scene);
    void setGates(const std::vector<PathGate> &gates);

private:
    void showRun();
    void showFigures();
    void explainMetricAt(int row);
    void explainSectorAt(int row);
    void explainFigure(std::size_t figure);

    Timeline &m_timeline;
    ComparisonScenePtr m_scene;
    Card *m_result, *m_sectorCard, *m_metricCard;
    QComboBox *m_others;     ///< shown for more than two runs
    std::size_t m_other = 1; ///< the run that is shown against the first
    std::vector<PathGate> m_gates;
    FigureGrid *m_figures;
    DifferenceModel *m_sectors, *m_metrics;
    std::vector<SectorTimes> m_sectorTimes; ///< that are shown
    double m_endM = 0, m_hereM = 0;         ///< distances of the two figures
    std::optional<CurveValue> m_here;
    std::optional<CurveValue> m_end; ///< time difference where the last of both can be compared
};

} // namespace odo
