// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/theme_icon.h"

#include "resources/resources.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

namespace odo {
namespace {

class ThemeIconEngine : public QIconEngine
{
public:
    ThemeIconEngine(const QString &name, const QColor &colour)
        : m_svg(resourceBytes(QStringLiteral("icons/%1.svg").arg(name))), m_colour(colour)
    {
    }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        QColor colour =
            m_colour.isValid() ? m_colour : QGuiApplication::palette().color(QPalette::WindowText);
        if (mode == QIcon::Disabled)
            colour.setAlphaF(0.4f);
        QByteArray coloured = m_svg;
        coloured.replace("#000000", colour.name(QColor::HexRgb).toLatin1());
        QSvgRenderer renderer(coloured);
        painter->save();
        painter->setOpacity(painter->opacity() * colour.alphaF());
        renderer.render(painter, QRectF(rect));
        painter->restore();
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine *clone() const override { return new ThemeIconEngine(*this); }

private:
    QByteArray m_svg;
    QColor m_colour;
};

} // namespace

QIcon themeIcon(const QString &name, const QColor &colour)
{
    return QIcon(new ThemeIconEngine(name, colour));
}

} // namespace odo
