// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/track_reading.h"

#include <QList>
#include <QWidget>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;

namespace odo {

/// What a person can say of tables of tracks that do not say it themselves. Each choice begins as "from the
/// file".
class TrackReadingForm : public QWidget
{
    Q_OBJECT
public:
    explicit TrackReadingForm(QWidget *parent = nullptr);
    TrackReading reading() const;
    std::optional<double> sigmaM() const; ///< accuracy of the source
    /// All that takes the focus, in order.
    QList<QWidget *> fields() const;

Q_SIGNALS:
    void changed();

private:
    QComboBox *addChoice(const QString &label, const QStringList &shown);
    QDoubleSpinBox *addNumber(const QString &label, double most, int decimals, const QString &suffix,
                              const QString &toolTip);
    void place(const QString &label, QWidget *field);

    QGridLayout *m_grid;
    QList<QWidget *> m_fields;
    QComboBox *m_unit, *m_timeUnit, *m_axes, *m_decimal;
    QDoubleSpinBox *m_rate, *m_pixel, *m_confidence, *m_sigma;
};

} // namespace odo
