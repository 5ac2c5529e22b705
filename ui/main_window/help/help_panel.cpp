// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/help_panel.h"

#include "ui/main_window/language.h"
#include "ui/views/theme_icon.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

namespace odo {
namespace {
constexpr int panelWidth = 300, margin = 12, listIndent = 16;
}

HelpPanel::HelpPanel(QWidget *parent) : QFrame(parent), m_text(new QTextBrowser)
{
    setObjectName(QStringLiteral("helpPanel"));
    setAccessibleName(tr("Help"));
    setFixedWidth(panelWidth);
    auto *title = new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Help")));
    auto *close = new QToolButton;
    close->setIcon(themeIcon(QStringLiteral("close")));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close the help (F1)"));
    close->setAccessibleName(tr("Close the help"));
    connect(close, &QToolButton::clicked, this, &HelpPanel::closed);
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->document()->setDocumentMargin(margin);
    m_text->document()->setIndentWidth(listIndent);
    m_text->setAccessibleName(tr("Help on this page"));
    auto *head = new QHBoxLayout;
    head->setContentsMargins(margin, 6, 6, 0);
    head->addWidget(title, 1);
    head->addWidget(close);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(head);
    layout->addWidget(m_text, 1);
}

void HelpPanel::showPage(const QString &name)
{
    m_wanted = name;
    if (isVisible())
        layOut();
}

void HelpPanel::layOut()
{
    if (!m_wanted.isEmpty())
        m_text->setHtml(helpPage(std::exchange(m_wanted, {})));
}

void HelpPanel::showEvent(QShowEvent *event)
{
    layOut();
    QFrame::showEvent(event);
}

} // namespace odo
