// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/theme.h"

#include "resources/resources.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QGuiApplication>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QProxyStyle>
#include <QScreen>
#include <QStyleFactory>
#include <QStyleOption>
#include <QSvgRenderer>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>

namespace odo {

namespace {

const QString viridisWord = QStringLiteral("viridis");
std::atomic<ColourScale> scaleInForce = ColourScale::Cividis;

struct PaletteSource
{
    QRgb window, base, alternate, text, muted, button, highlight, highlightText, link;
};

QPalette makePalette(const PaletteSource &source)
{
    QPalette palette(QColor(source.button), QColor(source.window));
    const auto set = [&palette](QPalette::ColorRole role, QRgb colour) {
        palette.setColor(role, QColor(colour));
    };
    set(QPalette::Window, source.window);
    set(QPalette::Base, source.base);
    set(QPalette::AlternateBase, source.alternate);
    set(QPalette::WindowText, source.text);
    set(QPalette::Text, source.text);
    set(QPalette::ButtonText, source.text);
    set(QPalette::Button, source.button);
    set(QPalette::PlaceholderText, source.muted);
    set(QPalette::Highlight, source.highlight);
    set(QPalette::HighlightedText, source.highlightText);
    set(QPalette::Link, source.link);
    set(QPalette::LinkVisited, source.link);
    set(QPalette::ToolTipBase, source.base);
    set(QPalette::ToolTipText, source.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(source.muted));
    return palette;
}

} // namespace

QPalette lightPalette()
{
    return makePalette({.window = 0xffe9edf0,
                        .base = 0xffffffff,
                        .alternate = 0xfff6f8fa,
                        .text = 0xff1b2127,
                        .muted = 0xff5b6672,
                        .button = 0xfff6f8fa,
                        .highlight = 0xff0072b2,
                        .highlightText = 0xffffffff,
                        .link = 0xff005f95});
}

QPalette darkPalette()
{
    return makePalette({.window = 0xff171b1f,
                        .base = 0xff20262c,
                        .alternate = 0xff272e35,
                        .text = 0xffe6eaee,
                        .muted = 0xffa0abb6,
                        .button = 0xff2b333b,
                        .highlight = 0xff2f8fcb,
                        .highlightText = 0xffffffff,
                        .link = 0xff6bbcf0});
}

bool isDark(const QPalette &palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

ThemeColours ThemeColours::of(const QPalette &palette)
{
    const bool dark = isDark(palette);
    ThemeColours colours;
    colours.card = palette.color(QPalette::Base);
    colours.text = palette.color(QPalette::Text);
    colours.muted = palette.color(QPalette::PlaceholderText);
    colours.muted.setAlpha(255); // Qt's own palettes make it by transparency
    if (colours.muted == colours.text)
        colours.muted = QColor(dark ? 0xffa0abb6 : 0xff5b6672);
    colours.border = QColor(dark ? 0xff38424c : 0xffd0d6dc);
    colours.field = QColor(dark ? 0xff75808c : 0xff7d8790);
    colours.grid = QColor(dark ? 0xff323b44 : 0xffe8ebee);
    colours.accent = palette.color(QPalette::Highlight);
    colours.selection = QColor(dark ? 0xff2c4456 : 0xffe4f2fa);
    colours.spike = QColor(dark ? 0xfff0803c : 0xffd55e00);
    colours.point = QColor(dark ? 0xffa8b2bc : 0xff7d8894);
    colours.bubble = QColor(dark ? 0xffe6eaee : 0xff20262c);
    colours.bubbleText = QColor(dark ? 0xff1b2127 : 0xffffffff);
    colours.imageBackground = QColor(dark ? 0xff14181b : 0xffe3e8ec);
    colours.mapGround = QColor(dark ? 0xff262b2f : 0xfff2f1ec);
    colours.mapGrid = QColor(dark ? 0xff3b4248 : 0xffdcdad2);
    return colours;
}

BadgeColours badgeColours(BadgeState state, const QPalette &palette)
{
    const bool dark = isDark(palette);
    switch (state) {
    case BadgeState::Good:
        return dark ? BadgeColours{QColor(0xff1f4a33), QColor(0xffa8e6c1)}
                    : BadgeColours{QColor(0xffd8f3e1), QColor(0xff155c34)};
    case BadgeState::Warning:
        return dark ? BadgeColours{QColor(0xff553f12), QColor(0xfff5d58c)}
                    : BadgeColours{QColor(0xfffdeecb), QColor(0xff6b4a00)};
    case BadgeState::Bad:
        return dark ? BadgeColours{QColor(0xff5a2a1c), QColor(0xffffc2ad)}
                    : BadgeColours{QColor(0xfffbe0d6), QColor(0xff8a2c0a)};
    case BadgeState::Neutral:
        break;
    }
    return dark ? BadgeColours{QColor(0xff343d46), QColor(0xffd3dae1)}
                : BadgeColours{QColor(0xffe6eaee), QColor(0xff3a444e)};
}

QColor seriesColour(int index, const QPalette &palette)
{
    static constexpr std::array<QRgb, 6> light = {0xff0072b2, 0xffd55e00, 0xff009e73,
                                                  0xffcc79a7, 0xffe69f00, 0xff56b4e9};
    static constexpr std::array<QRgb, 6> dark = {0xff56b4e9, 0xfff0803c, 0xff2fc497,
                                                 0xffe09fc4, 0xfff0b429, 0xff3d8fd1};
    const auto position = static_cast<std::size_t>(index) % light.size();
    return QColor(isDark(palette) ? dark[position] : light[position]);
}

Qt::PenStyle seriesDash(int index)
{
    static constexpr std::array<Qt::PenStyle, 4> styles = {Qt::SolidLine, Qt::DashLine, Qt::DotLine,
                                                           Qt::DashDotLine};
    return styles[static_cast<std::size_t>(index) % styles.size()];
}

ColourScale colourScaleFromWord(const QString &word)
{
    return word == viridisWord ? ColourScale::Viridis : ColourScale::Cividis;
}

QString colourScaleWord(ColourScale scale)
{
    return scale == ColourScale::Viridis ? viridisWord : QStringLiteral("cividis");
}

void setShownColourScale(ColourScale scale)
{
    scaleInForce = scale;
}

ColourScale shownColourScale()
{
    return scaleInForce;
}

QColor scaleColour(double fraction, ColourScale scale)
{
    // Every 1/17 of cividis and 1/8 of viridis; between them they are close to linear.
    static constexpr std::array<QRgb, 18> cividis = {
        0xff00204c, 0xff002a66, 0xff00346e, 0xff273f6c, 0xff3c4a6b, 0xff4c556b,
        0xff5b5f6d, 0xff686a70, 0xff757575, 0xff838178, 0xff928c78, 0xffa19876,
        0xffb0a572, 0xffc0b16d, 0xffd1bf66, 0xffe1cc5c, 0xfff3db4f, 0xffffe945};
    static constexpr std::array<QRgb, 9> viridis = {0xff440154, 0xff472d7b, 0xff3b528b,
                                                    0xff2c728e, 0xff21918c, 0xff28ae80,
                                                    0xff5ec962, 0xffaddc30, 0xfffde725};
    const std::span<const QRgb> anchors =
        scale == ColourScale::Viridis ? std::span<const QRgb>(viridis) : cividis;
    const double last = static_cast<double>(anchors.size() - 1);
    const double position = std::clamp(std::isfinite(fraction) ? fraction : 0.0, 0.0, 1.0) * last;
    const auto lower = std::min(static_cast<std::size_t>(position), anchors.size() - 2);
    const double part = position - static_cast<double>(lower);
    const auto mix = [part](int a, int b) { return static_cast<int>(std::lround(a + part * (b - a))); };
    const QRgb a = anchors[lower], b = anchors[lower + 1];
    return QColor(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

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

/// Fusion, but for the frames of fields (lines, numbers, choices): Fusion makes them by darkening the
/// window's colour, which can hardly be seen on a dark ground. Here they have 3:1 to what is on either side
/// (WCAG 2.1, 1.4.11). No choice whose width is that of its contents asks for more room than 44 letters,
/// whatever it offers. A dialog that comes up is no larger than its screen, and its buttons have no icons of
/// the desktop, some of which cannot be seen on a dark ground.
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
    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                  QStyleHintReturn *returned) const override;
    using QProxyStyle::polish;
    void polish(QWidget *widget) override;
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

int FramedStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                           QStyleHintReturn *returned) const
{
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons)
        return 0;
    return QProxyStyle::styleHint(hint, option, widget, returned);
}

void FramedStyle::polish(QWidget *widget)
{
    QProxyStyle::polish(widget);
    constexpr int titleBar = 32;
    if (widget->isWindow() && qobject_cast<QDialog *>(widget))
        widget->resize(widget->size().boundedTo(widget->screen()->availableSize() - QSize(0, titleBar)));
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
    // Under a style sheet the style's name is empty, so the sheet identifies the first call.
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

#include "theme.moc"
