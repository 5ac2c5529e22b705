// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QStringList>
#include <QWidget>
#include <vector>

namespace odo {

class SeriesKeyEntry;

/// Which line is whose: a button a line, with a piece of it (seriesColour and seriesDash) and its name, long
/// ones cut in their middle and whole in the tool tip. A click, or Space, hides the line and shows it again.
/// Hidden for fewer than two. GUI thread.
class SeriesKey : public QWidget
{
    Q_OBJECT
public:
    explicit SeriesKey(QWidget *parent = nullptr);
    /// All of them are shown then. places: of their colours in the palette (colourPlaces); by themselves one
    /// after the other.
    void setNames(const QStringList &names, const std::vector<int> &places = {});

Q_SIGNALS:
    void toggled(int index, bool isShown);

private:
    QList<SeriesKeyEntry *> m_entries;
};

} // namespace odo
