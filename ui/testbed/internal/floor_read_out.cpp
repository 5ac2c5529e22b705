// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/internal/floor_read_out.h"

#include "ui/models/number_text.h"
#include "ui/views/image/camera_view.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

namespace odo {

namespace {

/// "1204 ±1.2 mm", in the unit that the person has chosen.
QString coordinateText(double metres, double sigmaM)
{
    const ShownUnit &unit = shownUnits().length;
    return numberText(metres * unit.perSi, sigmaM * unit.perSi, unit.name).text();
}

} // namespace

FloorReadOut::FloorReadOut(CameraView &view)
    : QObject(&view), m_view(view), m_copy(new QAction(tr("&Copy floor position"), &view))
{
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WindowShortcut);
    m_copy->setEnabled(false);
    view.addAction(m_copy);
    connect(m_copy, &QAction::triggered, this, &FloorReadOut::copy);
    connect(&view, &CameraView::hovered, this, &FloorReadOut::show);
    connect(&view, &CameraView::pointedAt, this, &FloorReadOut::openMenu);
}

void FloorReadOut::setReading(std::optional<FloorReading> reading)
{
    m_reading = std::move(reading);
    show(m_pixel);
}

void FloorReadOut::show(const std::optional<QPointF> &pixel)
{
    m_pixel = pixel;
    const auto read =
        m_reading && pixel ? m_reading->at({pixel->x(), pixel->y()}) : std::optional<ReadPosition>();
    m_copy->setEnabled(read.has_value());
    if (read)
        m_text = tr("x %1 · y %2")
                     .arg(coordinateText(read->pointInWorld.x(), read->sigmaM().x()),
                          coordinateText(read->pointInWorld.y(), read->sigmaM().y()));
    else
        m_text = m_reading && pixel ? tr("Not on the floor") : QString();
    m_view.setReadOut(m_text);
}

void FloorReadOut::openMenu(const QPointF &pixel, const QPoint &global)
{
    show(pixel);
    if (!m_copy->isEnabled())
        return;
    QMenu menu(&m_view);
    menu.addAction(m_copy);
    menu.exec(global);
}

void FloorReadOut::copy()
{
    QGuiApplication::clipboard()->setText(m_text);
}

} // namespace odo
