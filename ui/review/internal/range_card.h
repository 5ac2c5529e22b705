// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/range_statistics.h"
#include "ui/models/background_task.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/fact_list.h"

#include <QList>
#include <QObject>
#include <memory>
#include <optional>

class QComboBox;

namespace odo {

/// What to compute of a range.
struct RangeRequest
{
    TrialScenePtr scene;
    std::size_t robot = 0; ///< must have an analysis
    TimeSpan span;
    QList<Quantity> quantities;        ///< to count
    Quantity fitted = Quantity::Speed; ///< to fit, if a shape is set
    std::optional<FitShape> shape = {};
};

/// The metrics of a range; SI.
struct RangeReport
{
    RangeRequest request;
    std::optional<CurveValue> path;
    std::vector<std::optional<RangeStatistics>> statistics; ///< one a quantity
    std::optional<Result<CurveFit>> fit;                    ///< empty: none was requested
};

/// Pure.
RangeReport reportOf(const RangeRequest &request);

/// Makes reports on a thread of its own, so that a range of an hour can be dragged: one at a time, then of
/// what was requested last. GUI thread.
class RangeReporter : public QObject
{
    Q_OBJECT
public:
    explicit RangeReporter(QObject *parent = nullptr);
    void request(RangeRequest request);
    /// Drops the request.
    void forget();
    bool isRunning() const { return m_task.isRunning(); }

Q_SIGNALS:
    void reported(const odo::RangeReport &report);

private:
    void begin();
    void finish();

    std::optional<RangeRequest> m_wanted; ///< not started yet
    std::shared_ptr<RangeReport> m_result;
    bool m_isForgotten = false;
    BackgroundTask m_task;
};

class FactList;
class Timeline;

/// The metrics of the range that is selected: times, path, each quantity that the charts show, and a fit of
/// one of them. They are made on a thread of their own. Hides itself while there is no range or no curve.
class RangeCard : public Card
{
    Q_OBJECT
public:
    explicit RangeCard(Timeline &timeline, QWidget *parent = nullptr);

    void setScene(TrialScenePtr scene);
    /// Those that the charts show; doubles count once.
    void setQuantities(const QList<Quantity> &quantities);
    /// Nothing is being computed.
    bool isSettled() const { return !m_reporter->isRunning(); }

Q_SIGNALS:
    /// What is to be drawn over the curve; nullopt: nothing.
    void fitChanged(const std::optional<odo::FitOverlay> &fit);
    void shownChanged(bool isShown);

private:
    void makeChoices();
    void request();
    void show(const RangeReport &report);
    void setShown(bool isShown);

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    QList<Quantity> m_quantities;
    RangeReporter *m_reporter;
    QComboBox *m_robot, *m_shape, *m_fitted;
    FactList *m_facts;
};

/// A range's metrics in words, each with how it was computed: times and path, then a fact a quantity.
QList<Fact> rangeFacts(const RangeReport &report);
/// The fit in words: coefficients with ±, residual, and what χ² says; or why there is none. Empty: none was
/// requested.
QList<Fact> fitFacts(const RangeReport &report);

} // namespace odo
