// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <functional>
#include <vector>

namespace odo {

/// What can be done about a message: a button of it.
struct MessageAction
{
    /// When the button goes, if not with its message.
    enum class Ends { Never, WithProject, AfterUse };

    QString words; ///< of the button
    std::function<void()> act;
    Ends ends = Ends::WithProject;
};

/// What the window says: that something was done, or what somebody has to know.
struct WindowMessage
{
    enum class Kind { Done, Warning, Error };

    Kind kind = Kind::Done;
    QString text;
    std::vector<MessageAction> actions;
    QDateTime time; ///< when it was said last
    int count = 1;  ///< how often it was said
    qint64 id = 0;  ///< given by the list
};

/// The warnings and errors of a window until a person dismisses them, newest first. The same words said again
/// are one message that counts. GUI thread.
class MessageList : public QObject
{
    Q_OBJECT
public:
    /// Of more the oldest go.
    static constexpr std::size_t most = 200;

    using QObject::QObject;
    /// Gives its id.
    qint64 add(WindowMessage message);
    void addAction(qint64 id, MessageAction action);
    void dismiss(qint64 id);
    void dismissAll();
    /// Does what the button says. Nothing where message or button has gone meanwhile.
    void act(qint64 id, std::size_t action);
    /// The project is closed: what was offered for it goes.
    void endProject();
    const std::vector<WindowMessage> &messages() const { return m_messages; }
    /// nullptr: dismissed.
    const WindowMessage *find(qint64 id) const;

Q_SIGNALS:
    void changed();

private:
    std::vector<WindowMessage>::iterator at(qint64 id);

    std::vector<WindowMessage> m_messages;
    qint64 m_lastId = 0;
};

} // namespace odo
