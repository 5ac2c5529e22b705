// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

namespace odo {

/// Which line is whose: the lines of seriesColour and seriesDash with names beside them, long ones cut in
/// their middle and whole in the tool tip. Hidden for fewer than two.
class SeriesKey : public QWidget
{
    Q_OBJECT
public:
    explicit SeriesKey(QWidget *parent = nullptr);
    void setNames(const QStringList &names);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString shown(const QString &name) const;
    QStringList m_names;
};

} // namespace odo
