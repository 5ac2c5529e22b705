// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/quantity_curve.h"
#include "ui/models/trial_scene.h"
#include "ui/views/card.h"

#include <QList>

namespace odo {

class ChartArea;
class SeriesKey;
class Timeline;

/// One quantity against time for all robots of a trial: smoothed line with its 95 % band, measured points,
/// spikes, and a cursor at the shared time with the value there. A click or drag moves the time. Of several
/// quantities the one that is shown is chosen in its header.
class ProfileChart : public Card
{
    Q_OBJECT
public:
    ProfileChart(Timeline &timeline, Quantity quantity, QWidget *parent = nullptr);
    /// The first one is shown at first; quantities must not be empty.
    ProfileChart(Timeline &timeline, QList<Quantity> quantities, QWidget *parent = nullptr);
    ~ProfileChart() override;

    void setScene(TrialScenePtr scene);
    void setQuantity(Quantity quantity);
    QWidget *chartArea() const;

private:
    void describe();

    ChartArea *m_area;
    SeriesKey *m_key;
    Quantity m_quantity;
    TrialScenePtr m_scene;
};

} // namespace odo
