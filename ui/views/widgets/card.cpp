// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/card.h"

#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

constexpr int cornerRadius = 5;

} // namespace

Card::Card(const QString &title, QWidget *parent)
    : QFrame(parent), m_header(new QWidget(this)), m_title(new ElidedLabel(m_header)),
      m_badge(new BadgeLabel({}, m_header)), m_remark(new ElidedLabel(m_header)),
      m_headerLayout(new QHBoxLayout(m_header)), m_layout(new QVBoxLayout(this))
{
    setFrameShape(QFrame::NoFrame); // painted by paintEvent
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_remark->setObjectName(QStringLiteral("quiet")); // the style sheet colours it
    m_remark->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_remark->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_headerLayout->setContentsMargins(10, 6, 10, 6);
    m_headerLayout->setSpacing(9);
    m_headerLayout->addWidget(m_title);
    m_headerLayout->addWidget(m_badge);
    m_headerLayout->addWidget(m_remark, 1);
    m_layout->setContentsMargins(1, 1, 1, 1);
    m_layout->setSpacing(1); // the line under the title
    m_layout->addWidget(m_header);
    setTitle(title);
}

QString Card::title() const
{
    return m_title->fullText();
}

void Card::setTitle(const QString &title)
{
    m_title->setFullText(title);
    constexpr int neverCut = 20; // letters: what is beside a title is shortened before it
    m_title->setMinimumWidth(
        std::min(m_title->sizeHint().width(), neverCut * m_title->fontMetrics().averageCharWidth()));
    setAccessibleName(title);
}

void Card::setRemark(const QString &remark)
{
    m_remark->setFullText(remark);
    setAccessibleDescription(remark);
}

QString Card::remark() const
{
    return m_remark->fullText();
}

void Card::setBadge(const Badge &badge)
{
    m_badge->setBadge(badge);
}

void Card::setContent(QWidget *content)
{
    if (m_content) {
        m_layout->removeWidget(m_content);
        m_content->deleteLater();
    }
    m_content = content;
    m_layout->addWidget(content, 1);
}

void Card::addToHeader(QWidget *widget)
{
    m_headerLayout->addWidget(widget);
}

void Card::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setPen(QPen(colours.border, 1));
    painter.setBrush(colours.card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), cornerRadius, cornerRadius);
    if (!m_content)
        return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(QRect(1, m_header->geometry().bottom() + 1, width() - 2, 1), colours.border);
}

} // namespace odo
