// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/range_statistics.h"
#include "ui/models/background_task.h"
#include "ui/models/trial_scene.h"

#include <QList>
#include <QObject>
#include <memory>
#include <optional>

namespace odo {

/// What is wanted of a range.
struct RangeRequest
{
    TrialScenePtr scene;
    std::size_t robot = 0; ///< must have an analysis
    TimeSpan span;
    QList<Quantity> quantities;        ///< to count
    Quantity fitted = Quantity::Speed; ///< to fit, if a shape is wanted
    std::optional<FitShape> shape = {};
};

/// The figures of a range; SI.
struct RangeReport
{
    RangeRequest request;
    std::optional<CurveValue> path;
    std::vector<std::optional<RangeStatistics>> statistics; ///< one a quantity
    std::optional<Result<CurveFit>> fit;                    ///< empty: none was wanted
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
    /// What was requested is wanted no more.
    void forget();
    bool isRunning() const { return m_task.isRunning(); }

Q_SIGNALS:
    void reported(const odo::RangeReport &report);

private:
    void begin();
    void finish();

    std::optional<RangeRequest> m_wanted; ///< not begun yet
    std::shared_ptr<RangeReport> m_result;
    bool m_isForgotten = false;
    BackgroundTask m_task;
};

} // namespace odo
