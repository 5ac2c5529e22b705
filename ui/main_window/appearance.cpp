// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/appearance.h"

#include "resources/resources.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QComboBox>
#include <QHash>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

namespace odo {

/// Fusion, but for the frames of fields (lines, numbers, choices): Fusion makes them by darkening the
/// window's colour, which can hardly be seen on a dark ground. Here they have 3:1 to what is on either side
/// (WCAG 2.1, 1.4.11). No choice whose width is that of its contents asks for more room than 44 letters,
/// whatever it offers.
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

QSize FramedStyle::sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                                    const QWidget *widget) const
{
    constexpr int mostLetters = 44; // a name may be of any length; what does not fit is cut
    QSize wanted = QProxyStyle::sizeFromContents(type, option, size, widget);
    const auto *choice = type == CT_ComboBox ? qobject_cast<const QComboBox *>(widget) : nullptr;
    if (choice && choice->sizeAdjustPolicy() != QComboBox::AdjustToMinimumContentsLengthWithIcon)
        wanted.setWidth(std::min(wanted.width(), mostLetters * option->fontMetrics.averageCharWidth()));
    return wanted;
}

namespace {

struct NamedColour
{
    const char *name, *light, *dark;
};

// What only the style sheet needs, beside the palette; contrast of text to its ground is 4.5:1 or better.
constexpr NamedColour namedColours[] = {
    {"menu", "#f6f8fa", "#222830"},        {"stripe", "#f6f8fa", "#2a313a"},
    {"hover", "#e2e7ec", "#343d47"},       {"selection", "#dceefa", "#1d4a66"},
    {"primary", "#0072b2", "#1b6ea6"},     {"primaryHover", "#0067a3", "#1f78b4"},
    {"bar", "#25303a", "#13171c"},         {"barText", "#b4bfc9", "#a3aeb9"},
    {"barHover", "#2d3a46", "#1d242b"},    {"barChecked", "#354553", "#29333d"},
    {"barMark", "#56b4e9", "#56b4e9"},     {"barFocus", "#f0e442", "#f0e442"},
    {"barDisabled", "#6b7883", "#5b6670"},
};

QHash<QString, QColor> coloursOf(const QPalette &palette)
{
    const bool dark = isDark(palette);
    QHash<QString, QColor> colours;
    for (const NamedColour &named : namedColours)
        colours.insert(QString::fromLatin1(named.name),
                       QColor(QLatin1String(dark ? named.dark : named.light)));
    const ThemeColours theme = ThemeColours::of(palette);
    const BadgeColours good = badgeColours(BadgeState::Good, palette),
                       bad = badgeColours(BadgeState::Bad, palette);
    colours.insert({{QStringLiteral("window"), palette.color(QPalette::Window)},
                    {QStringLiteral("card"), theme.card},
                    {QStringLiteral("border"), theme.border},
                    {QStringLiteral("line"), theme.grid},
                    {QStringLiteral("text"), theme.text},
                    {QStringLiteral("quiet"), theme.muted},
                    {QStringLiteral("accent"), theme.accent},
                    {QStringLiteral("tip"), palette.color(QPalette::ToolTipBase)},
                    {QStringLiteral("tipText"), palette.color(QPalette::ToolTipText)},
                    {QStringLiteral("goodBack"), good.ground},
                    {QStringLiteral("goodText"), good.text},
                    {QStringLiteral("badBack"), bad.ground},
                    {QStringLiteral("badText"), bad.text}});
    return colours;
}

QString styleSheetOf(const QPalette &palette)
{
    QString sheet = QString::fromUtf8(resourceBytes(QStringLiteral("style/odograph.qss")));
    const QHash<QString, QColor> colours = coloursOf(palette);
    for (auto colour = colours.cbegin(); colour != colours.cend(); ++colour)
        sheet.replace(QLatin1Char('@') + colour.key() + QLatin1Char('@'), colour.value().name());
    return sheet;
}

bool desktopIsDark()
{
    // Without a palette of ours the application shows the desktop's (Qt 6.4 has no other way to ask for it).
    QApplication::setPalette(QPalette());
    return isDark(QApplication::palette());
}

} // namespace

Theme themeFromName(const QString &name)
{
    if (name == QLatin1String("light"))
        return Theme::Light;
    return name == QLatin1String("dark") ? Theme::Dark : Theme::System;
}

QString themeName(Theme theme)
{
    switch (theme) {
    case Theme::Light:
        return QStringLiteral("light");
    case Theme::Dark:
        return QStringLiteral("dark");
    case Theme::System:
        break;
    }
    return QStringLiteral("system");
}

void applyAppearance(QApplication &application, Theme theme)
{
    // Under a style sheet the style's name is empty, so the first call is told by the sheet.
    if (application.styleSheet().isEmpty()) {
        QApplication::setStyle(new FramedStyle);
        QApplication::setWindowIcon(themeIcon(QStringLiteral("odograph")));
    }
    const bool dark = theme == Theme::System ? desktopIsDark() : theme == Theme::Dark;
    const QPalette palette = dark ? darkPalette() : lightPalette();
    QApplication::setPalette(palette);
    application.setStyleSheet(styleSheetOf(palette));
}

} // namespace odo

#include "appearance.moc"
