// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/fact_list.h"

#include "ui/models/shown_message.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace odo {

namespace {

class ExplanationDialogWords
{
    Q_DECLARE_TR_FUNCTIONS(ExplanationDialog)
};

constexpr QSize usualSize(480, 420);

} // namespace

QString howComputedWords()
{
    return ExplanationDialogWords::tr("How was this computed?");
}

void showExplanation(QWidget *parent, const Explanation &explanation)
{
    auto *dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("explanation"));
    dialog->setWindowTitle(howComputedWords());
    auto *text = new QPlainTextEdit(explanation.text());
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setAccessibleName(howComputedWords());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton *copy = buttons->addButton(ExplanationDialogWords::tr("&Copy"), QDialogButtonBox::ActionRole);
    QObject::connect(copy, &QPushButton::clicked, dialog,
                     [words = explanation.text()] { QApplication::clipboard()->setText(words); });
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(usualSize);
    dialog->show();
}

namespace {

constexpr int rowMargin = 5;

void empty(QGridLayout *layout)
{
    while (QLayoutItem *item = layout->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

QToolButton *howButton(const Fact &fact, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setText(QStringLiteral("?"));
    button->setProperty("flat", true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolTip(howComputedWords());
    button->setAccessibleName(QStringLiteral("%1: %2").arg(fact.name, howComputedWords()));
    QObject::connect(button, &QToolButton::clicked, button,
                     [button, how = *fact.how] { showExplanation(button->window(), how); });
    return button;
}

QWidget *withBadgeBeneath(QLabel *value, const Badge &badge, QWidget *parent)
{
    auto *both = new QWidget(parent);
    auto *layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, rowMargin + 2);
    layout->setSpacing(0);
    layout->addWidget(value);
    layout->addWidget(new BadgeLabel(badge, both), 0, Qt::AlignLeft);
    return both;
}

} // namespace

FactList::FactList(Badges badges) : m_badges(badges), m_layout(new QGridLayout(this))
{
    m_layout->setContentsMargins(10, 0, 10, 0);
    m_layout->setHorizontalSpacing(14);
    m_layout->setVerticalSpacing(0);
    m_layout->setColumnStretch(1, 1);
}

void FactList::setFacts(const QList<Fact> &facts)
{
    empty(m_layout);
    for (int row = 0; row < facts.size(); ++row)
        addRow(row, facts.at(row));
}

void FactList::addRow(int row, const Fact &fact)
{
    auto *name = new QLabel(fact.name, this);
    name->setObjectName(QStringLiteral("quiet"));
    auto *value = new QLabel(breakable(fact.value), this);
    value->setWordWrap(true);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAccessibleName(QStringLiteral("%1: %2").arg(fact.name, fact.value));
    for (QLabel *label : {name, value}) {
        label->setTextFormat(Qt::PlainText);
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->setContentsMargins(0, rowMargin, 0, rowMargin + 1);
    }
    m_layout->addWidget(name, row, 0);
    const bool hasBadge = !fact.badge.text.isEmpty(), isBeside = hasBadge && m_badges == Badges::Beside;
    m_layout->addWidget(hasBadge && !isBeside ? withBadgeBeneath(value, fact.badge, this) : value, row, 1, 1,
                        isBeside || fact.how ? 1 : 2);
    if (fact.how)
        m_layout->addWidget(howButton(fact, this), row, 2, Qt::AlignRight | Qt::AlignTop);
    if (isBeside)
        m_layout->addWidget(new BadgeLabel(fact.badge, this), row, 2, Qt::AlignRight | Qt::AlignVCenter);
}

void FactList::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(ThemeColours::of(palette()).grid);
    for (int row = 0; row < m_layout->rowCount(); ++row)
        if (const QLayoutItem *value = m_layout->itemAtPosition(row, 1))
            painter.drawLine(0, value->geometry().bottom(), width(), value->geometry().bottom());
}

QScrollArea *scrolled(FactList *facts, const QString &accessibleName)
{
    auto *body = new QWidget;
    body->setObjectName(QStringLiteral("cardBody"));
    auto *layout = new QVBoxLayout(body);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(facts);
    layout->addStretch(1);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setAccessibleName(accessibleName);
    scroll->setWidget(body);
    return scroll;
}

} // namespace odo
