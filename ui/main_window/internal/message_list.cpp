// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/message_list.h"

#include <algorithm>
#include <utility>

namespace odo {

qint64 MessageList::add(WindowMessage message)
{
    const auto said = std::ranges::find_if(m_messages, [&](const WindowMessage &each) {
        return each.kind == message.kind && each.text == message.text;
    });
    message.time = QDateTime::currentDateTime();
    message.id = said == m_messages.end() ? ++m_lastId : said->id;
    if (said != m_messages.end()) {
        message.count = said->count + 1;
        m_messages.erase(said);
    }
    const qint64 id = message.id;
    m_messages.insert(m_messages.begin(), std::move(message));
    if (m_messages.size() > most)
        m_messages.pop_back();
    Q_EMIT changed();
    return id;
}

std::vector<WindowMessage>::iterator MessageList::at(qint64 id)
{
    return std::ranges::find(m_messages, id, &WindowMessage::id);
}

const WindowMessage *MessageList::find(qint64 id) const
{
    const auto found = std::ranges::find(m_messages, id, &WindowMessage::id);
    return found == m_messages.end() ? nullptr : &*found;
}

void MessageList::addAction(qint64 id, MessageAction action)
{
    if (const auto found = at(id); found != m_messages.end()) {
        found->actions.push_back(std::move(action));
        Q_EMIT changed();
    }
}

void MessageList::dismiss(qint64 id)
{
    if (const auto found = at(id); found != m_messages.end()) {
        m_messages.erase(found);
        Q_EMIT changed();
    }
}

void MessageList::dismissAll()
{
    m_messages.clear();
    Q_EMIT changed();
}

void MessageList::act(qint64 id, std::size_t action)
{
    const auto found = at(id);
    if (found == m_messages.end() || action >= found->actions.size())
        return;
    const MessageAction chosen = found->actions[action]; // the list may change meanwhile
    if (chosen.ends == MessageAction::Ends::AfterUse)
        dismiss(id);
    chosen.act();
}

void MessageList::endProject()
{
    for (WindowMessage &message : m_messages)
        std::erase_if(message.actions, [](const MessageAction &action) {
            return action.ends == MessageAction::Ends::WithProject;
        });
    Q_EMIT changed();
}

} // namespace odo
