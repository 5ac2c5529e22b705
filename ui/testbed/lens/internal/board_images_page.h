// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/lens/internal/board_search.h"

#include <QListWidget>
#include <QWidget>

class QAction;
class QLabel;
class QListWidget;
class QPushButton;

namespace odo {

class BoardCanvas;
class CoveragePanel;
class FilmStrip;
class RmsSoFar;

/// Second page of the lens wizard: the image with the detected board, the coverage that is still missing,
/// the RMS so far, where to hold the board next, the accepted images in a row, and the rejected ones with the
/// reason.
class BoardImagesPage : public QWidget
{
    Q_OBJECT
public:
    explicit BoardImagesPage(BoardSearch &search, QWidget *parent = nullptr);
    /// live: hints and outline where to hold the board; otherwise files are gone through.
    void begin(bool live);

Q_SIGNALS:
    void filesDropped(const QStringList &files);

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    QWidget *makeSide();
    QWidget *makeStrip();
    void showSearched(const SearchedImage &image);
    void showState();
    void showKept(int row);
    void showStatus(const QString &headline, const QString &detail);

    BoardSearch &m_search;
    bool m_live = false;
    BoardCanvas *m_canvas;
    CoveragePanel *m_coverage;
    RmsSoFar *m_rms;
    QListWidget *m_refused;
    FilmStrip *m_strip;
    QLabel *m_headline, *m_detail;
    QPushButton *m_take;
};

/// What a hint says to a person.
QString wordsOf(BoardHint hint);

/// The accepted images, in a row. Delete removes the selected one, Undo restores it.
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
