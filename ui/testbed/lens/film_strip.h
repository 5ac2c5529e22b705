// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/lens/board_search.h"

#include <QListWidget>

class QAction;

namespace odo {

/// The pictures that count, in a row. Delete takes the chosen one out, Undo puts it back.
class FilmStrip : public QListWidget
{
    Q_OBJECT
public:
    explicit FilmStrip(QWidget *parent = nullptr);
    void setState(const SearchState &state);
    QAction *removeAction() const { return m_remove; }
    QAction *undoAction() const { return m_undo; }

Q_SIGNALS:
    void removeRequested(int index);
    void undoRequested();

private:
    QAction *m_remove, *m_undo;
};

} // namespace odo
