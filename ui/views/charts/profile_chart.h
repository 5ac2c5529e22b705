// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/curve_fit.h"
#include "core/analysis/quantity_curve.h"
#include "core/base/units.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/chart_view.h"
#include "ui/views/charts/trial_curves.h"
#include "ui/views/widgets/card.h"

#include <QList>
#include <optional>

class QComboBox;

namespace odo {

class ChartBubbles;
class ChartSpan;
class SeriesKey;
class Timeline;

/// A fit that is drawn over the curve of a robot.
struct FitOverlay
{
    std::size_t robot = 0;
    Quantity quantity = Quantity::Speed;
    TimeSpan span;
    CurveFit fit;
};

/// The plot of one quantity, a group of curves a robot; inside ProfileChart. A click goes to a time, a drag
/// selects a range; a bubble explains how its value was computed. Stretches in which less than usual is known
/// of a robot are shaded, with words where the mouse rests.
class ChartArea : public ChartView
{
    Q_OBJECT
public:
    /// span: shared with other charts, with the same scene; must outlive this.
    ChartArea(Timeline &timeline, ChartSpan &span, Quantity quantity, QWidget *parent = nullptr);
    ~ChartArea() override;

    void setScene(TrialScenePtr scene);
    void setQuantity(Quantity quantity);
    /// nullopt: none. It is drawn where its quantity is shown.
    void setFit(std::optional<FitOverlay> fit);
    /// The curves of the scene are there; those of a long one take a moment.
    bool isSettled() const { return !m_maker->isRunning(); }
    /// Something is shaded.
    bool hasUncertainIntervals() const { return !m_stretches.empty(); }

    QSize minimumSizeHint() const override { return {220, 110}; }

Q_SIGNALS:
    void settled();

protected:
    void paintOver(QPainter &painter) override;
    void goTo(double x) override;
    void dragTo(double from, double x) override;
    QString wordsAt(const QPoint &position) const override;

private:
    void rebuild();
    void showCurves();
    void showFit();

    Timeline &m_timeline;
    ChartSpan &m_span;
    Quantity m_quantity;
    ChartBubbles *m_bubbles;
    TrialScenePtr m_scene;
    std::vector<UncertainInterval> m_stretches; ///< of the scene
    CurveMaker *m_maker;
    std::optional<FitOverlay> m_fit;
};

/// One quantity against time, or the distance travelled, for all robots of a trial: smoothed line with its 95
/// % band, measured points, spikes, the range that is selected, and a cursor at the shared time with the
/// value there. See ChartArea for what the mouse does. Of several quantities the one that is shown is chosen
/// in its header.
class ProfileChart : public Card
{
    Q_OBJECT
public:
    ProfileChart(Timeline &timeline, Quantity quantity, QWidget *parent = nullptr);
    /// The first one is shown at first; quantities must not be empty. span: shared with other charts, must
    /// outlive this.
    ProfileChart(Timeline &timeline, ChartSpan &span, QList<Quantity> quantities, QWidget *parent = nullptr);
    ~ProfileChart() override;

    void setScene(TrialScenePtr scene);
    void setQuantity(Quantity quantity);
    Quantity quantity() const { return m_quantity; }
    /// Drawn where its quantity is shown; nullopt: none.
    void setFit(std::optional<FitOverlay> fit);
    ChartArea *chartArea() const;
    /// Its curves are there.
    bool isSettled() const;

Q_SIGNALS:
    void quantityChanged();
    void settled();

private:
    void describe();
    void offerSeparation(bool isOffered);

    ChartSpan &m_span;
    ChartArea *m_area;
    SeriesKey *m_key;
    QList<Quantity> m_quantities;
    QComboBox *m_choice = nullptr; ///< nullptr: there is no choice
    Quantity m_quantity;
    TrialScenePtr m_scene;
};

/// "Speed": the name of a quantity.
QString quantityName(Quantity quantity);

} // namespace odo
