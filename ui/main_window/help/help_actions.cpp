// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/help_actions.h"

#include "ui/main_window/help/lesson.h"
#include "ui/main_window/language.h"
#include "ui/main_window/preferences/command_keys.h"
#include "ui/main_window/project_pages.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

class QWidget;

namespace odo {

class CommandKeys;

namespace {

class HelpDialogsWords
{
    Q_DECLARE_TR_FUNCTIONS(HelpDialogs)
};

/// A table of the commands of each menu that have keys.
QString commandTables(const CommandKeys &keys)
{
    QString html, group;
    for (const CommandKeys::Command &command : keys.commands()) {
        if (command.keys.isEmpty())
            continue;
        if (command.group != group) {
            if (!group.isEmpty())
                html += QStringLiteral("</table>");
            group = command.group;
            html += QStringLiteral("<h3>%1</h3><table cellspacing=\"0\" cellpadding=\"3\">")
                        .arg(group.toHtmlEscaped());
        }
        const QString key = QKeySequence::listToString(command.keys, QKeySequence::NativeText);
        html += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                    .arg(key.toHtmlEscaped(), command.words.toHtmlEscaped());
    }
    return group.isEmpty() ? html : html + QStringLiteral("</table>");
}

} // namespace

/// The list of keys, and what this program is. Not modal for the first, which one wants to read while
/// working.
void showKeys(const CommandKeys &keys, QWidget &window)
{
    auto *dialog = new QDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(HelpDialogsWords::tr("Keys"));
    auto *text = new QTextBrowser;
    text->setAccessibleName(HelpDialogsWords::tr("List of keys"));
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(commandTables(keys) + helpPage(QStringLiteral("keys")));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(460, 560);
    dialog->show();
}

void showAbout(QWidget &window)
{
    QMessageBox box(&window);
    box.setWindowTitle(HelpDialogsWords::tr("About Odograph"));
    box.setTextFormat(Qt::PlainText);
    box.setText(HelpDialogsWords::tr("Odograph %1").arg(QStringLiteral(ODOGRAPH_VERSION)));
    box.setInformativeText(HelpDialogsWords::tr(
        "Measures how a mobile robot moved, from the videos of ordinary cameras.\n\n"
        "Free software under the GNU General Public License, version 3 or later, without any warranty.\n\n"
        "The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation "
        "of Mobile Robot Trajectory”, 2018."));
    box.exec();
}

HelpActions::HelpActions(const CommandKeys &keys, HelpPanel &panel, QWidget &window)
    : QObject(&window), m_keys(keys), m_panel(panel), m_window(window), m_lesson(new Lesson(this)),
      m_help(new QAction(tr("&Help on this page"), this)), m_learn(new QAction(tr("&First lesson"), this)),
      m_showKeys(new QAction(tr("&Keys"), this)), m_about(new QAction(tr("&About Odograph"), this))
{
    nameCommands({{m_help, "help"}, {m_learn, "lesson"}, {m_showKeys, "keys"}});
    m_help->setCheckable(true);
    m_help->setShortcut(QKeySequence(Qt::Key_F1));
    m_showKeys->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_F1));
    m_panel.hide();
    connect(m_help, &QAction::toggled, &m_panel, &QWidget::setVisible);
    connect(&m_panel, &HelpPanel::closed, this, [this] { m_help->setChecked(false); });
    connect(m_learn, &QAction::triggered, this, &HelpActions::beginLesson);
    connect(m_showKeys, &QAction::triggered, this, [this] { showKeys(m_keys, m_window); });
    connect(m_about, &QAction::triggered, this, [this] { showAbout(m_window); });
    showPage();
}

void HelpActions::fillMenu(QMenu &menu)
{
    menu.addActions({m_help, m_learn, m_showKeys});
    menu.addSeparator();
    menu.addAction(m_about);
}

void HelpActions::setPages(const ProjectPages *pages)
{
    m_pages = pages;
    showPage();
    if (!pages) {
        m_lesson->stop();
        return;
    }
    connect(pages, &ProjectPages::shown, this, &HelpActions::showPage);
    // it stands there then
    connect(pages, &ProjectPages::shown, m_lesson, &Lesson::look, Qt::QueuedConnection);
    connect(&pages->review(), &ReviewPage::trialShown, m_lesson, &Lesson::look);
    connect(&pages->review().timeline(), &Timeline::currentChanged, m_lesson, &Lesson::look);
}

void HelpActions::showPage()
{
    m_panel.showPage(m_pages ? modeWord(m_pages->mode()) : QStringLiteral("welcome"));
}

void HelpActions::beginLesson()
{
    if (m_pages)
        m_lesson->start(firstLesson(*m_pages));
    else
        Q_EMIT demoWanted();
}

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
