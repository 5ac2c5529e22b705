// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

namespace odo {

/// Which line is whose: the lines of seriesColour and seriesDash with names beside them, long ones cut in
/// their middle and whole in the tool tip. Hidden for fewer than two.
class SeriesKey : public QWidget
{
    Q_OBJECT
public:
    explicit SeriesKey(QWidget *parent = nullptr);
    /// places: of their colours in the palette (colourPlaces); by themselves one after the other.
    void setNames(const QStringList &names, std::vector<int> places = {});

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString shown(const QString &name) const;
    QStringList m_names;
    std::vector<int> m_places; ///< empty: one after the other
};

} // namespace odo
