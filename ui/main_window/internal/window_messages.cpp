// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/window_messages.h"

#include "ui/models/shown_message.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QLocale>
#include <QStyle>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

namespace odo {

namespace {

constexpr int noteWidth = 560, listWidth = 480, noteEdge = 12;

} // namespace

WindowMessages::WindowMessages(QWidget &page, QObject *parent)
    : QObject(parent), m_page(page), m_bar(new MessageBar(page.parentWidget())),
      m_panel(new MessagePanel(m_list, page.parentWidget())), m_bell(new QToolButton),
      m_action(new QAction(themeIcon(QStringLiteral("bell")), tr("&Messages"), this))
{
    nameCommands({{m_action, "messages"}});
    m_action->setShortcut(QKeySequence(Qt::Key_F8));
    m_action->setCheckable(true);
    m_action->setIconVisibleInMenu(false);
    m_bell->setProperty("flat", true);
    m_bell->setObjectName(QStringLiteral("messageBell"));
    m_bell->setIcon(m_action->icon());
    m_bell->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_bell->setFocusPolicy(Qt::TabFocus);
    connect(m_bell, &QToolButton::clicked, m_action, &QAction::toggle);
    connect(m_action, &QAction::toggled, this, &WindowMessages::showPanel);
    connect(m_panel, &MessagePanel::closed, this, [this] { m_action->setChecked(false); });
    connect(m_panel, &MessagePanel::rowsChanged, this, &WindowMessages::place);
    connect(&m_list, &MessageList::changed, this, &WindowMessages::follow);
    connect(m_bar, &MessageBar::closed, this, [this] { m_list.dismiss(m_shown.id); });
    connect(m_bar, &MessageBar::acted, this, [this](qsizetype action) {
        if (m_shown.id != 0)
            m_list.act(m_shown.id, static_cast<std::size_t>(action));
        else if (action < static_cast<qsizetype>(m_shown.actions.size()))
            m_shown.actions[static_cast<std::size_t>(action)].act();
    });
    m_page.installEventFilter(this);
    follow();
}

bool WindowMessages::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
        place();
    return QObject::eventFilter(watched, event);
}

/// Over the lower right corner of the page; the list above the message.
void WindowMessages::place()
{
    const QRect page = m_page.geometry().adjusted(noteEdge, noteEdge, -noteEdge, -noteEdge);
    const auto put = [&page](QWidget &widget, int width, int height) {
        QRect rect(0, 0, width, std::min(height, page.height()));
        rect.moveBottomRight(page.bottomRight());
        widget.setGeometry(rect);
    };
    const int ofBar = std::min(noteWidth, page.width());
    put(*m_bar, ofBar, m_bar->layout()->totalHeightForWidth(ofBar));
    const int ofPanel = std::min(listWidth, page.width());
    put(*m_panel, ofPanel, m_panel->heightFor(ofPanel));
}

void WindowMessages::follow()
{
    const auto count = static_cast<int>(m_list.messages().size());
    m_bell->setText(count > 0 ? QLocale().toString(count) : QString());
    m_bell->setAccessibleName(count > 0 ? tr("%n message(s)", "", count) : tr("No messages."));
    const QString key = m_action->shortcut().toString(QKeySequence::NativeText);
    m_bell->setToolTip(QStringLiteral("%1 (%2)").arg(m_bell->accessibleName(), key));
    m_bell->setProperty("kind", count > 0 ? QStringLiteral("bad") : QString());
    m_bell->style()->unpolish(m_bell);
    m_bell->style()->polish(m_bell);
    if (m_shown.id != 0 && !m_list.find(m_shown.id))
        m_bar->hide(); // dismissed in the list
}

void WindowMessages::showPanel(bool shown)
{
    if (shown) {
        m_focusBefore = QApplication::focusWidget();
        m_bar->hide(); // the list has it
        m_panel->raise();
        m_panel->show();
        place();
        m_panel->setFocus();
        return;
    }
    const bool hadFocus = m_panel->isAncestorOf(QApplication::focusWidget()) || m_panel->hasFocus();
    m_panel->hide();
    if (hadFocus && m_focusBefore)
        m_focusBefore->setFocus();
}

void WindowMessages::addRemedies(WindowMessage &message, const Message &words)
{
    for (const Remedy remedy : remediesOf(words)) {
        const QString button = remedyWords(remedy);
        const bool isThere =
            std::ranges::find(message.actions, button, &MessageAction::words) != message.actions.end();
        if (!isThere)
            message.actions.push_back(
                {button, [this, remedy, trial = trialIn(words)] { Q_EMIT remedyWanted(remedy, trial); }});
    }
}

void WindowMessages::showError(const Error &error)
{
    if (error.code == ErrorCode::Cancelled)
        return showDone(tr("Cancelled. Nothing was changed."));
    WindowMessage message{WindowMessage::Kind::Error, errorInWords(error), {}, {}};
    addRemedies(message, wholeMessage(error));
    show(std::move(message));
}

void WindowMessages::showWarning(const QString &text)
{
    show({WindowMessage::Kind::Warning, text, {}, {}});
}

void WindowMessages::keepWarning(const QString &text)
{
    m_list.add({WindowMessage::Kind::Warning, text, {}, {}});
}

void WindowMessages::showDone(const DoneWork &work)
{
    WindowMessage message{
        work.warnings.empty() ? WindowMessage::Kind::Done : WindowMessage::Kind::Warning, work.words, {}, {}};
    for (const Message &warning : work.warnings)
        addRemedies(message, warning);
    if (const QFileInfo file(work.file); !work.file.isEmpty()) {
        const auto add = [&message](const QString &words, const QString &path) {
            message.actions.push_back({words,
                                       [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); },
                                       MessageAction::Ends::Never});
        };
        if (!file.isDir())
            add(tr("Open"), file.absoluteFilePath());
        add(tr("Show in folder"), file.isDir() ? file.absoluteFilePath() : file.absolutePath());
    }
    show(std::move(message));
}

void WindowMessages::show(WindowMessage message)
{
    m_shown = message;
    if (message.kind != WindowMessage::Kind::Done)
        m_shown.id = m_list.add(std::move(message));
    if (m_shown.id == 0 || m_panel->isHidden()) // the list has it
        m_bar->present(m_shown);
    place();
}

void WindowMessages::offer(MessageAction action)
{
    m_shown.actions.push_back(action);
    m_list.addAction(m_shown.id, std::move(action));
    if (!m_bar->isHidden())
        m_bar->present(m_shown);
    place();
}

void WindowMessages::hideBar()
{
    m_bar->hide();
}

void WindowMessages::endProject()
{
    m_list.endProject();
    m_bar->hide(); // its buttons went
}

} // namespace odo
