// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/internal/floor_copy.h"

#include "ui/views/image/camera_view.h"
#include "ui/views/image/floor_read_out.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

namespace odo {

FloorCopy::FloorCopy(CameraView &view, FloorReadOut &readOut)
    : QObject(&view), m_view(view), m_readOut(readOut), m_copy(new QAction(tr("&Copy floor position"), &view))
{
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WindowShortcut);
    m_copy->setEnabled(false);
    view.addAction(m_copy);
    connect(m_copy, &QAction::triggered, this,
            [this] { QGuiApplication::clipboard()->setText(m_readOut.floorText()); });
    connect(&readOut, &FloorReadOut::shown, this,
            [this] { m_copy->setEnabled(!m_readOut.floorText().isEmpty()); });
    connect(&view, &CameraView::pointedAt, this, &FloorCopy::openMenu);
}

void FloorCopy::openMenu(const QPointF &pixel, const QPoint &global)
{
    m_readOut.show(pixel);
    if (!m_copy->isEnabled())
        return;
    QMenu menu(&m_view);
    menu.addAction(m_copy);
    menu.exec(global);
}

} // namespace odo
