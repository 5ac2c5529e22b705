// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/quantity_curve.h"
#include "ui/models/trial_scene.h"
#include "ui/views/card.h"

#include <QList>
#include <optional>

class QComboBox;

namespace odo {

class ChartArea;
class ChartSpan;
class SeriesKey;
class Timeline;
struct FitOverlay;

/// One quantity against time, or the way driven, for all robots of a trial: smoothed line with its 95 % band,
/// measured points, spikes, the range that is selected, and a cursor at the shared time with the value there.
/// ChartArea tells what the mouse does. Of several quantities the one that is shown is chosen in its header.
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
    QWidget *chartArea() const;
    /// Its curves are there.
    bool isSettled() const;

Q_SIGNALS:
    void quantityChanged();
    void settled();

private:
    void describe();

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
