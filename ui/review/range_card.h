// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/range_report.h"
#include "ui/views/card.h"
#include "ui/views/chart_area.h"

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

} // namespace odo
