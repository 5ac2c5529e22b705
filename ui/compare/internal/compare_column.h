// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/shown_names.h"

#include <QWidget>
#include <optional>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QToolButton;

namespace odo {

class Card;
class DifferenceModel;
class FactList;
class MetricGrid;
class Timeline;

/// The right column of Compare: which runs, the time gap at finish and at the cursor, the times from gate to
/// gate, and all metrics, of the second run against the first; of several further runs, of the one that is
/// chosen.
class CompareColumn : public QWidget
{
    Q_OBJECT
public:
    /// chooser: goes to the top.
    CompareColumn(Timeline &timeline, QWidget *chooser, QWidget *parent = nullptr);
    QSize sizeHint() const override; ///< it gives way where the page is narrow
    void setScene(ComparisonScenePtr scene);
    void setGates(const std::vector<PathGate> &gates);

private:
    void showVerdicts();
    void showRun();
    void showMetrics();
    void explainMetricAt(int row);
    void explainSectorAt(int row);
    void explainMetric(std::size_t index);

    Timeline &m_timeline;
    ComparisonScenePtr m_scene;
    Card *m_result, *m_sectorCard, *m_metricCard;
    Card *m_verdictCard; ///< shown where a run is not beyond doubt
    FactList *m_verdicts;
    QComboBox *m_others;     ///< shown for more than two runs
    std::size_t m_other = 1; ///< the run that is shown against the first
    std::vector<PathGate> m_gates;
    MetricGrid *m_metricGrid;
    DifferenceModel *m_sectors, *m_metrics;
    std::vector<SectorTimes> m_sectorTimes; ///< that are shown
    double m_endM = 0, m_hereM = 0;         ///< distances of the two gaps
    std::optional<CurveValue> m_here;
    std::optional<CurveValue> m_end; ///< time difference where the last of both can be compared
};

/// Which runs are compared and how they are aligned: two lists and a button that swaps them, further runs
/// from a menu, the alignment; by hand: the time shift of the second run; by distance: the position.
class RunChooser : public QWidget
{
    Q_OBJECT
public:
    explicit RunChooser(QWidget *parent = nullptr);

    void setChoices(QList<RunChoice> choices);
    /// Emits nothing. Runs that are not among the choices are left out.
    void setRuns(const std::vector<CompareSettings::Run> &wanted);
    std::vector<CompareSettings::Run> runs() const;
    std::optional<AlignBy> alignBy() const;
    double shiftS() const;
    /// By distance: how far from the beginning of what is compared, metres; nullopt: the first common point.
    std::optional<double> stationM() const;
    /// Back to what the runs themselves give. Emits nothing.
    void alignAutomatically();
    /// What the automatic choice came to.
    void setAlignedBy(AlignBy by);

Q_SIGNALS:
    void runsChanged();
    void alignmentChanged();

private:
    void swap();
    void toggleFurther(int choice, bool isWanted);
    void fillMenu();
    void showShift();

    QList<RunChoice> m_choices;
    QList<int> m_further; ///< indices of the runs beside the two
    QComboBox *m_first, *m_second, *m_align;
    QToolButton *m_swap, *m_more;
    QMenu *m_menu;
    QLabel *m_shiftName, *m_positionName;
    QDoubleSpinBox *m_shift, *m_position;
};

/// The alignment in words: "start gate".
QString alignmentWords(AlignBy by);

} // namespace odo
