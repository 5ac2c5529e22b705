// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace odo {

/// Fusion, but for the frames of fields (lines, numbers, choices): Fusion makes them by darkening the
/// window's colour, which can hardly be seen on a dark ground. Here they have 3:1 to what is on either side
/// (WCAG 2.1, 1.4.11). No choice whose width is that of its contents asks for more room than 44 letters, whatever it offers.
class FramedStyle : public QProxyStyle
{
    Q_OBJECT
public:
    FramedStyle();
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                            const QWidget *widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                           const QWidget *widget) const override;
};

} // namespace odo
