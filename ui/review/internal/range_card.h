// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/range_report.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/fact_list.h"

class QComboBox;

namespace odo {

class FactList;
class Timeline;

/// The figures of the range that is selected: times, path, each quantity that the charts show, and a fit of
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

/// A range's figures in words, each with how it was computed: times and path, then a fact a quantity.
QList<Fact> rangeFacts(const RangeReport &report);
/// The fit in words: coefficients with ±, residual, and what χ² says; or why there is none. Empty: none was
/// wanted.
QList<Fact> fitFacts(const RangeReport &report);

} // namespace odo
