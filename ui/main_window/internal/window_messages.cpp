// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/window_messages.h"

#include "core/project/names.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <chrono>

namespace odo {

namespace {

constexpr int noteIconSide = 20, noteButtonMargin = 14, noteWidth = 560, listWidth = 480, noteEdge = 12;
constexpr int mostNoteButtons = 3;
constexpr qsizetype longestShown = 600;
constexpr std::chrono::seconds doneStays{8}, warningStays{20}, stillNeeded{2};

QString iconOf(WindowMessage::Kind kind)
{
    return kind == WindowMessage::Kind::Done ? QStringLiteral("information") : QStringLiteral("warning");
}

QToolButton *closeButton(const QString &accessibleName, const QString &toolTip)
{
    auto *close = new QToolButton;
    close->setProperty("flat", true);
    close->setIcon(themeIcon(QStringLiteral("close")));
    close->setAccessibleName(accessibleName);
    close->setToolTip(toolTip);
    close->setFocusPolicy(Qt::TabFocus);
    return close;
}

} // namespace

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent), m_icon(new QLabel), m_text(new QLabel), m_timer(new QTimer(this))
{
    setObjectName(QStringLiteral("messageBar"));
    setProperty("floating", true);
    showAsWords(*m_text);
    auto *close = closeButton(tr("Close the message"), tr("Close"));
    connect(close, &QToolButton::clicked, this, [this] {
        hide();
        Q_EMIT closed();
    });
    m_timer->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, &MessageBar::leave);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    for (int i = 0; i < mostNoteButtons; ++i) {
        auto *button = new QPushButton(this);
        button->setAutoDefault(true);        // Enter presses it, too
        button->setFocusPolicy(Qt::NoFocus); // until it has words
        button->hide();
        connect(button, &QPushButton::clicked, this, [this, i] {
            hide();
            Q_EMIT acted(i);
        });
        buttons->addWidget(button);
        m_buttons << button;
    }
    buttons->addStretch(1);
    auto *column = new QVBoxLayout;
    column->addWidget(m_text, 1);
    column->addLayout(buttons);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 8, 8, 8);
    layout->setSpacing(10);
    layout->addWidget(m_icon, 0, Qt::AlignTop);
    layout->addLayout(column, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    hide();
}

/// Not from under the mouse or the keys of a person who reads it.
void MessageBar::leave()
{
    if (underMouse() || isAncestorOf(QApplication::focusWidget()))
        m_timer->start(stillNeeded);
    else
        hide();
}

void MessageBar::present(const WindowMessage &message)
{
    const bool isDone = message.kind == WindowMessage::Kind::Done;
    setProperty("kind", isDone ? QStringLiteral("good") : QStringLiteral("bad"));
    for (QWidget *widget : std::initializer_list<QWidget *>{this, m_text}) {
        widget->style()->unpolish(widget);
        widget->style()->polish(widget);
    }
    const QColor colour = m_text->palette().color(QPalette::WindowText);
    m_icon->setPixmap(themeIcon(iconOf(message.kind), colour).pixmap(noteIconSide));
    m_fullText = message.text;
    const QString shown = firstCharacters(message.text, longestShown);
    m_text->setText(breakable(shown.size() < message.text.size() ? shown + u'…' : shown));
    for (qsizetype i = 0; i < m_buttons.size(); ++i) {
        QPushButton *button = m_buttons[i];
        const bool isThere = i < static_cast<qsizetype>(message.actions.size());
        button->setText(isThere ? message.actions[static_cast<std::size_t>(i)].words : QString());
        button->setFocusPolicy(isThere ? Qt::StrongFocus : Qt::NoFocus);
        button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) +
                                2 * noteButtonMargin);
        button->setVisible(isThere);
    }
    m_timer->start(isDone ? doneStays : warningStays);
    raise();
    show();
    QAccessibleEvent announcement(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&announcement);
}

QString MessageBar::text() const
{
    return isHidden() ? QString() : m_fullText;
}

MessagePanel::MessagePanel(MessageList &list, QWidget *parent)
    : QFrame(parent), m_list(list), m_none(new QLabel(tr("No messages."))),
      m_dismissAll(new QPushButton(tr("Dismiss &all"))), m_rows(new QWidget),
      m_rowLayout(new QVBoxLayout(m_rows))
{
    setObjectName(QStringLiteral("messagePanel"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Messages"));
    auto *title = new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Messages")));
    m_close = closeButton(tr("Close the list of messages"), tr("Close (Esc)"));
    connect(m_close, &QToolButton::clicked, this, &MessagePanel::closed);
    m_dismissAll->setAutoDefault(true);
    connect(m_dismissAll, &QPushButton::clicked, &m_list, &MessageList::dismissAll);
    m_none->setObjectName(QStringLiteral("quiet"));
    m_none->setContentsMargins(noteEdge, 0, noteEdge, noteEdge);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(noteEdge, 6, 6, 6);
    head->addWidget(title, 1);
    head->addWidget(m_dismissAll);
    head->addWidget(m_close);
    m_rowLayout->setContentsMargins(0, 0, 0, 0);
    m_rowLayout->setSpacing(0);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_rows);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    layout->addLayout(head);
    layout->addWidget(m_none);
    layout->addWidget(scroll, 1);
    connect(&m_list, &MessageList::changed, this, [this] {
        if (isVisible())
            fill();
    });
    hide();
}

void MessagePanel::showEvent(QShowEvent *event)
{
    fill();
    QFrame::showEvent(event);
}

/// The focus stays in the list: at the message that is now where the dismissed one was.
void MessagePanel::fill()
{
    const QWidget *focus = QApplication::focusWidget();
    int row = -1;
    for (int i = 0; i < m_rowLayout->count(); ++i)
        if (m_rowLayout->itemAt(i)->widget()->isAncestorOf(focus))
            row = i;
    while (m_rowLayout->count() > 0) {
        QWidget *old = m_rowLayout->takeAt(0)->widget();
        old->hide();
        old->deleteLater(); // its button may be what dismissed it
    }
    setTabOrder(this, m_dismissAll);
    setTabOrder(m_dismissAll, m_close);
    QWidget *before = m_close;
    for (const WindowMessage &message : m_list.messages()) {
        QWidget *made = makeRow(message);
        m_rowLayout->addWidget(made);
        made->show(); // now, not when the event loop runs again
        for (auto *button : made->findChildren<QAbstractButton *>()) {
            setTabOrder(before, button);
            before = button;
        }
    }
    const int count = m_rowLayout->count();
    m_none->setVisible(count == 0);
    m_dismissAll->setVisible(count > 0);
    if (row >= 0 && count > 0)
        m_rowLayout->itemAt(std::min(row, count - 1))->widget()->findChild<QToolButton *>()->setFocus();
    else if (row >= 0 || isAncestorOf(focus))
        setFocus();
    Q_EMIT rowsChanged();
}

QWidget *MessagePanel::makeRow(const WindowMessage &message)
{
    auto *row = new QFrame(m_rows);
    row->setObjectName(QStringLiteral("messageRow"));
    auto *icon = new QLabel;
    icon->setPixmap(themeIcon(iconOf(message.kind)).pixmap(noteIconSide));
    auto *text = new QLabel(breakable(message.text));
    showAsWords(*text);
    const QString time = QLocale().toString(message.time.time(), QLocale::ShortFormat);
    auto *when = new QLabel(message.count > 1 ? tr("%1, %n times", "", message.count).arg(time) : time);
    when->setObjectName(QStringLiteral("quiet"));
    auto *foot = new QHBoxLayout;
    foot->addWidget(when, 1);
    for (std::size_t i = 0; i < message.actions.size(); ++i) {
        auto *button = new QPushButton(message.actions[i].words);
        button->setAutoDefault(true);
        connect(button, &QPushButton::clicked, this, [this, id = message.id, i] {
            Q_EMIT closed(); // what it begins is not to be covered
            m_list.act(id, i);
        });
        foot->addWidget(button);
    }
    auto *dismiss =
        closeButton(tr("Dismiss: %1").arg(firstCharacters(message.text, longestShown)), tr("Dismiss"));
    connect(dismiss, &QToolButton::clicked, this, [this, id = message.id] { m_list.dismiss(id); });
    auto *column = new QVBoxLayout;
    column->setSpacing(4);
    column->addWidget(text);
    column->addLayout(foot);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(noteEdge, 8, 6, 8);
    layout->addWidget(icon, 0, Qt::AlignTop);
    layout->addLayout(column, 1);
    layout->addWidget(dismiss, 0, Qt::AlignTop);
    return row;
}

int MessagePanel::heightFor(int width) const
{
    constexpr int border = 2;
    int height = layout()->itemAt(0)->sizeHint().height() + 2 * border;
    if (m_rowLayout->count() == 0)
        return height + m_none->sizeHint().height();
    for (int i = 0; i < m_rowLayout->count(); ++i)
        height += m_rowLayout->itemAt(i)->widget()->layout()->totalHeightForWidth(width - border) + border;
    return height;
}

void MessagePanel::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        Q_EMIT closed();
    else
        QFrame::keyPressEvent(event);
}

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
