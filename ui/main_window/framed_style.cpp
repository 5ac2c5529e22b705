// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/framed_style.h"

#include "ui/views/theme.h"

#include <QComboBox>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

namespace odo {
namespace {

constexpr qreal radius = 2; // Fusion's

/// Over Fusion's own, which does not show which choice has the focus, but after the Tab key.
void drawFrame(const QStyleOption &option, const QRect &rect, QPainter &painter)
{
    const ThemeColours colours = ThemeColours::of(option.palette);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (option.state & QStyle::State_HasFocus)
        painter.setPen(colours.accent);
    else
        painter.setPen(option.state & QStyle::State_Enabled ? colours.field : colours.border);
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
    painter.restore();
}

} // namespace

FramedStyle::FramedStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void FramedStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                                const QWidget *widget) const
{
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isChoice = element == PE_PanelButtonCommand && qobject_cast<const QComboBox *>(widget);
    if (element == PE_FrameLineEdit || isChoice)
        drawFrame(*option, option->rect, *painter);
}

void FramedStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                     QPainter *painter, const QWidget *widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox)
        drawFrame(*option, option->rect.adjusted(0, 1, 0, -1), *painter); // where Fusion has it
}

QSize FramedStyle::sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size, const QWidget *widget) const
{
    constexpr int mostLetters = 44; // a name may be of any length; what does not fit is cut
    QSize wanted = QProxyStyle::sizeFromContents(type, option, size, widget);
    const auto *choice = type == CT_ComboBox ? qobject_cast<const QComboBox *>(widget) : nullptr;
    if (choice && choice->sizeAdjustPolicy() != QComboBox::AdjustToMinimumContentsLengthWithIcon)
        wanted.setWidth(std::min(wanted.width(), mostLetters * option->fontMetrics.averageCharWidth()));
    return wanted;
}

} // namespace odo
