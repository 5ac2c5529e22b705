// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/film_strip.h"

#include <QAction>
#include <QPixmap>
#include <QScrollBar>
#include <algorithm>

namespace odo {
namespace {

constexpr QSize thumbnail(112, 63);

} // namespace

FilmStrip::FilmStrip(QWidget *parent)
    : QListWidget(parent), m_remove(new QAction(tr("&Take out"), this)), m_undo(new QAction(tr("&Undo"), this))
{
    setViewMode(QListView::IconMode);
    setFlow(QListView::LeftToRight);
    setWrapping(false);
    setMovement(QListView::Static);
    setIconSize(thumbnail);
    setSpacing(4);
    setUniformItemSizes(true);
    setTextElideMode(Qt::ElideMiddle);
    setAccessibleName(tr("Pictures that count"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedHeight(thumbnail.height() + fontMetrics().height() + horizontalScrollBar()->sizeHint().height() + 34);
    m_remove->setShortcut(QKeySequence::Delete);
    m_undo->setShortcut(QKeySequence::Undo);
    for (QAction *action : {m_remove, m_undo}) {
        action->setShortcutContext(Qt::WindowShortcut);
        addAction(action);
    }
    setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_remove, &QAction::triggered, this, [this] {
        if (currentRow() >= 0)
            Q_EMIT removeRequested(currentRow());
    });
    connect(m_undo, &QAction::triggered, this, &FilmStrip::undoRequested);
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) { m_remove->setEnabled(row >= 0); });
    setState({});
}

void FilmStrip::setState(const SearchState &state)
{
    const int row = currentRow();
    QStringList there, wanted;
    for (int i = 0; i < count(); ++i)
        there << item(i)->text();
    for (const KeptPicture &picture : state.kept)
        wanted << picture.name;
    m_undo->setEnabled(state.canUndo);
    if (there == wanted) {
        m_remove->setEnabled(row >= 0);
        return;
    }
    // While a camera runs, pictures are added at the end: those that are there stay as they are.
    const auto common = std::mismatch(there.begin(), there.end(), wanted.begin(), wanted.end()).first - there.begin();
    while (count() > common)
        delete takeItem(count() - 1);
    for (int i = int(common); i < wanted.size(); ++i) {
        const QImage &image = state.kept[std::size_t(i)].image;
        const QPixmap icon = QPixmap::fromImage(image.scaled(thumbnail * devicePixelRatioF(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
        auto *picture = new QListWidgetItem(QIcon(icon), wanted.at(i), this);
        picture->setToolTip(wanted.at(i));
        picture->setSizeHint({thumbnail.width() + 14, thumbnail.height() + fontMetrics().height() + 12});
    }
    const bool added = wanted.size() > there.size();
    setCurrentRow(row < 0 ? -1 : std::min(row, count() - 1));
    if (added)
        scrollToItem(item(count() - 1)); // the newest
    m_remove->setEnabled(currentRow() >= 0);
}

} // namespace odo
