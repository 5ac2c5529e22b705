// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/empty_state.h"

#include "ui/views/widgets/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <QVBoxLayout>

namespace odo {
namespace {

constexpr int columnWidth = 440;
constexpr int iconSide = 56;

/// A label that shows an icon and redraws it when the palette changes.
class IconLabel : public QWidget
{
public:
    IconLabel(const QString &name, QWidget *parent) : QWidget(parent), m_icon(themeIcon(name))
    {
        setFixedSize(iconSide, iconSide);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setOpacity(0.55);
        m_icon.paint(&painter, rect());
    }

private:
    QIcon m_icon;
};

QLabel *wrapped(const QString &text, const QString &name, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignHCenter);
    return label;
}

} // namespace

EmptyState::EmptyState(const QString &icon, const QString &headline, const QString &text, QWidget *parent)
    : QWidget(parent), m_buttons(new QVBoxLayout)
{
    // A column of fixed width, in which wrapped labels get the height that they need.
    auto *column = new QWidget(this);
    column->setFixedWidth(columnWidth);
    m_layout = new QVBoxLayout(column);
    m_layout->setSpacing(10);
    m_layout->addWidget(new IconLabel(icon, column), 0, Qt::AlignHCenter);
    m_layout->addWidget(wrapped(headline, QStringLiteral("headline"), column));
    m_layout->addWidget(wrapped(text, QStringLiteral("subline"), column));
    m_layout->addSpacing(10);
    m_buttons->setSpacing(8);
    m_layout->addLayout(m_buttons);
    auto *across = new QHBoxLayout(this);
    across->addStretch(1);
    auto *down = new QVBoxLayout;
    down->addStretch(2);
    down->addWidget(column);
    down->addStretch(3);
    across->addLayout(down);
    across->addStretch(1);
}

QPushButton *EmptyState::addButton(const QString &icon, const QString &text)
{
    auto *button = new QPushButton(text, this);
    button->setProperty("primary", !m_hasButton);
    button->setIcon(m_hasButton ? themeIcon(icon) : themeIcon(icon, Qt::white));
    button->setMinimumHeight(34);
    button->setFixedWidth(columnWidth * 2 / 3);
    m_hasButton = true;
    m_buttons->addWidget(button, 0, Qt::AlignHCenter);
    return button;
}

void EmptyState::addWidget(QWidget *widget)
{
    m_layout->addWidget(widget);
}

} // namespace odo
