// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/empty_state.h"

#include "ui/views/theme_icon.h"

#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <QVBoxLayout>

namespace odo {
namespace {

constexpr int columnWidth = 440;
constexpr int iconSide = 56;

/// A label that shows an icon and draws it anew when the palette changes.
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
    label->setFixedWidth(columnWidth);
    return label;
}

} // namespace

EmptyState::EmptyState(const QString &icon, const QString &headline, const QString &text, QWidget *parent)
    : QWidget(parent), m_layout(new QVBoxLayout(this)), m_buttons(new QVBoxLayout)
{
    m_layout->setSpacing(10);
    m_layout->addStretch(2);
    m_layout->addWidget(new IconLabel(icon, this), 0, Qt::AlignHCenter);
    m_layout->addWidget(wrapped(headline, QStringLiteral("headline"), this), 0, Qt::AlignHCenter);
    m_layout->addWidget(wrapped(text, QStringLiteral("subline"), this), 0, Qt::AlignHCenter);
    m_layout->addSpacing(10);
    m_buttons->setSpacing(8);
    m_layout->addLayout(m_buttons);
    m_layout->addStretch(3);
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
    widget->setFixedWidth(columnWidth);
    m_layout->insertWidget(m_layout->count() - 1, widget, 0, Qt::AlignHCenter);
}

} // namespace odo
