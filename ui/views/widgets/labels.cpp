// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/labels.h"

#include "ui/views/widgets/theme.h"

#include <QEvent>
#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QToolTip>

namespace odo {

BadgeLabel::BadgeLabel(const Badge &badge, QWidget *parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setAlignment(Qt::AlignCenter);
    setContentsMargins(8, 1, 8, 1);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Maximum);
    setBadge(badge);
}

void BadgeLabel::setBadge(const Badge &badge)
{
    m_state = badge.state;
    setText(badge.text);
    setHidden(badge.text.isEmpty());
    update();
}

void BadgeLabel::paintEvent(QPaintEvent *)
{
    const BadgeColours colours = badgeColours(m_state, palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.ground);
    const qreal radius = qMin(9.0, height() / 2.0);
    painter.drawRoundedRect(rect(), radius, radius);
    painter.setPen(colours.text);
    painter.drawText(contentsRect(), Qt::AlignCenter, text());
}

ElidedLabel::ElidedLabel(QWidget *parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

void ElidedLabel::setFullText(const QString &text)
{
    if (text == m_fullText)
        return;
    m_fullText = text;
    setAccessibleName(text);
    updateGeometry();
    elide();
}

QSize ElidedLabel::sizeHint() const
{
    // One pixel more than the text: rounding must not elide a text that fits.
    constexpr int mostLetters = 100; // it is shortened anyhow
    const int width = qMin(fontMetrics().horizontalAdvance(m_fullText.left(2 * mostLetters)) + 1,
                           mostLetters * fontMetrics().averageCharWidth());
    return {width + contentsMargins().left() + contentsMargins().right(), QLabel::sizeHint().height()};
}

QSize ElidedLabel::minimumSizeHint() const
{
    return {qMin(sizeHint().width(), fontMetrics().horizontalAdvance(QStringLiteral("mmm…"))),
            QLabel::minimumSizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent *event)
{
    QLabel::resizeEvent(event);
    elide();
}

void ElidedLabel::changeEvent(QEvent *event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        updateGeometry();
        elide();
    }
}

void ElidedLabel::elide()
{
    const QString shown = fontMetrics().elidedText(m_fullText, Qt::ElideRight, contentsRect().width());
    if (shown != text())
        setText(shown);
    setToolTip(shown == m_fullText ? QString() : m_fullText.toHtmlEscaped());
}

void showToolTip(const QHelpEvent &help, const QString &words, QWidget *widget)
{
    if (words.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(help.globalPos(), words, widget);
}

void showAsWords(QLabel &label)
{
    label.setWordWrap(true);
    label.setTextFormat(Qt::PlainText);
    label.setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void showAsVerdict(QLabel &verdict, QLabel &advice)
{
    showAsWords(verdict);
    showAsWords(advice);
    verdict.setStyleSheet(QStringLiteral("font-weight: 600"));
    advice.setObjectName(QStringLiteral("quiet"));
}

} // namespace odo
