// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/message.h"

#include "core/base/units.h"

#include <map>
#include <memory>
#include <mutex>

namespace odo {

namespace {

struct Registry
{
    std::mutex mutex;
    std::map<std::string_view, const MessageText *> known;
    /// What other versions said; each lives as long as the program.
    std::map<std::string, std::unique_ptr<MessageText>, std::less<>> unknown;
};

Registry &registry()
{
    static Registry all;
    return all;
}

} // namespace

bool message_internal::enrol(const MessageText &text)
{
    Registry &all = registry();
    const std::lock_guard lock(all.mutex);
    return all.known.emplace(text.code, &text).second;
}

const MessageText &messageText(std::string_view code)
{
    Registry &all = registry();
    const std::lock_guard lock(all.mutex);
    if (const auto found = all.known.find(code); found != all.known.end())
        return *found->second;
    auto &[name, text] = *all.unknown.try_emplace(std::string(code)).first;
    if (!text)
        text = std::make_unique<MessageText>(MessageText{name.c_str(), name.c_str()});
    return *text;
}

std::vector<const MessageText *> allMessageTexts()
{
    Registry &all = registry();
    const std::lock_guard lock(all.mutex);
    std::vector<const MessageText *> texts;
    for (const auto &[code, text] : all.known)
        texts.push_back(text);
    return texts;
}

MessageArgument::MessageArgument() = default;
MessageArgument::MessageArgument(const MessageArgument &) = default;
MessageArgument::MessageArgument(MessageArgument &&) noexcept = default;
MessageArgument &MessageArgument::operator=(const MessageArgument &) = default;
MessageArgument &MessageArgument::operator=(MessageArgument &&) noexcept = default;
MessageArgument::~MessageArgument() = default;

MessageArgument::MessageArgument(Kind itsKind, std::string name) : kind(itsKind), text(std::move(name)) {}

MessageArgument::MessageArgument(std::string label) : text(std::move(label)) {}

MessageArgument::MessageArgument(Message message) : kind(Kind::Message)
{
    parts.push_back(std::move(message));
}

bool MessageArgument::operator==(const MessageArgument &) const = default;

MessageArgument quantity(double value, int decimals, std::string unit)
{
    MessageArgument number(MessageArgument::Kind::Number, std::move(unit));
    number.number = value;
    number.decimals = decimals;
    return number;
}

MessageArgument listed(std::vector<Message> parts, MessageArgument::Joint joint)
{
    MessageArgument list(MessageArgument::Kind::List, {});
    list.joint = joint;
    list.parts = std::move(parts);
    return list;
}

MessageArgument listed(const std::vector<std::string> &names, MessageArgument::Kind kind,
                       MessageArgument::Joint joint)
{
    std::vector<Message> parts;
    for (const std::string &name : names)
        parts.push_back(nameAlone({kind, name}));
    return listed(std::move(parts), joint);
}

Message nameAlone(MessageArgument name)
{
    return ODO_TEXT("base.name", "%1")(std::move(name));
}

Message foreignWords(std::string words)
{
    return words.empty() ? Message() : ODO_TEXT("base.foreign", "%1")(std::move(words));
}

const MessageText &textOf(Join how)
{
    switch (how) {
    case Join::Colon:
        return ODO_TEXT("base.colon", "%1: %2");
    case Join::Semicolon:
        return ODO_TEXT("base.semicolon", "%1; %2");
    case Join::Comma:
        return ODO_TEXT("base.comma", "%1, %2");
    case Join::Space:
        break;
    }
    return ODO_TEXT("base.space", "%1 %2");
}

namespace {

const MessageText &textOf(MessageArgument::Joint joint)
{
    switch (joint) {
    case MessageArgument::Joint::And:
        return ODO_TEXT("base.and", "%1 and %2");
    case MessageArgument::Joint::Or:
        return ODO_TEXT("base.or", "%1 or %2");
    case MessageArgument::Joint::Comma:
        break;
    }
    return textOf(Join::Comma);
}

/// Text with its placeholders filled in; placeholders in the arguments are not expanded.
template <class Value>
std::string filled(const std::string &words, const Value &value)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char digit = words[i] == '%' && i + 1 < words.size() ? words[i + 1] : '0';
        if (digit < '1' || digit > '9') {
            text += words[i];
            continue;
        }
        text += value(static_cast<std::size_t>(digit - '1'));
        ++i;
    }
    return text;
}

} // namespace

Message joined(std::vector<Message> messages, Join how)
{
    Message all;
    for (Message &each : messages) {
        if (each.isEmpty())
            continue;
        all = all.isEmpty() ? std::move(each) : textOf(how)(std::move(all), std::move(each));
    }
    return all;
}

std::string MessageLanguage::number(double value, int decimals) const
{
    return formatNumber(value, decimals);
}

std::string MessageLanguage::name(const MessageArgument &name) const
{
    return name.text;
}

std::string MessageLanguage::render(const Message &message) const
{
    return message.isEmpty() ? std::string() : filled(words(*message.text), [&](std::size_t which) {
        return which < message.arguments.size() ? render(message.arguments[which]) : std::string();
    });
}

std::string MessageLanguage::render(const MessageArgument &argument) const
{
    switch (argument.kind) {
    case MessageArgument::Kind::Number: {
        const char *const gap = argument.text.empty() || argument.text == "°" ? "" : " ";
        return number(argument.number, argument.decimals) + gap + argument.text;
    }
    case MessageArgument::Kind::List:
        return list(argument);
    case MessageArgument::Kind::Message:
        return render(argument.parts.front());
    default:
        return name(argument);
    }
}

std::string MessageLanguage::list(const MessageArgument &list) const
{
    if (list.parts.empty())
        return words(ODO_TEXT("base.none", "none"));
    std::string all = render(list.parts.front());
    for (std::size_t i = 1; i < list.parts.size(); ++i) {
        const bool isLast = i + 1 == list.parts.size();
        const std::string next = render(list.parts[i]);
        all = filled(words(textOf(isLast ? list.joint : MessageArgument::Joint::Comma)),
                     [&](std::size_t which) { return which == 0 ? all : next; });
    }
    return all;
}

std::string Message::english() const
{
    return MessageLanguage().render(*this);
}

} // namespace odo
