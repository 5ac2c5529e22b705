// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/message_json.h"

#include "core/base/units.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace odo {

namespace {

using Kind = MessageArgument::Kind;
using Joint = MessageArgument::Joint;

/// The keys by which names of a kind are stored, and the words of joints. Never change one.
constexpr std::array<std::pair<Kind, const char *>, 10> nameKeys{{{Kind::Camera, "camera"},
                                                                  {Kind::Robot, "robot"},
                                                                  {Kind::Team, "team"},
                                                                  {Kind::Person, "person"},
                                                                  {Kind::Class, "class"},
                                                                  {Kind::Task, "task"},
                                                                  {Kind::Trial, "trial"},
                                                                  {Kind::Layout, "layout"},
                                                                  {Kind::Marker, "marker"},
                                                                  {Kind::File, "file"}}};
constexpr std::array<std::pair<Joint, const char *>, 3> jointWords{
    {{Joint::And, "and"}, {Joint::Or, "or"}, {Joint::Comma, "comma"}}};

constexpr QLatin1String codeKey("code"), argumentsKey("arguments"), numberKey("number"),
    decimalsKey("decimals"), unitKey("unit"), messageKey("message"), listKey("list"), jointKey("joint");

/// A project may come from anyone: more is not read.
constexpr int deepest = 40, mostArguments = 9, mostJoined = 2000, mostDecimals = 9;
constexpr qsizetype longestCode = 100;

/// How joined() puts messages together, two by two.
bool isJoin(std::string_view code)
{
    constexpr std::array joins{Join::Colon, Join::Semicolon, Join::Comma, Join::Space};
    return std::ranges::any_of(joins, [code](Join how) { return code == textOf(how).code; });
}

/// What a message says, of one that was joined from several all of these: sentences within one another would
/// soon be deeper than JSON is read.
std::vector<const MessageArgument *> argumentsOf(const Message &message)
{
    std::vector<const MessageArgument *> all;
    const Message *from = &message;
    while (isJoin(message.code()) && from->arguments.size() == 2 &&
           from->arguments[0].kind == Kind::Message &&
           from->arguments[0].parts.front().code() == message.code() &&
           from->arguments[0].parts.front().arguments.size() == 2) {
        all.push_back(&from->arguments[1]);
        from = &from->arguments[0].parts.front();
    }
    for (auto argument = from->arguments.rbegin(); argument != from->arguments.rend(); ++argument)
        all.push_back(&*argument);
    std::ranges::reverse(all);
    return all;
}

QString text(const std::string &utf8)
{
    return QString::fromStdString(utf8);
}

QJsonValue storedNumber(double number)
{
    // Neither infinite ones nor the sign of a zero go into JSON.
    const bool isWritten = std::isfinite(number) && !(number == 0 && std::signbit(number));
    return isWritten ? QJsonValue(number) : QJsonValue(text(formatNumber(number, 0)));
}

double numberIn(const QJsonValue &stored)
{
    return stored.isString() ? stored.toString().toDouble() : stored.toDouble();
}

QJsonValue toJson(const MessageArgument &argument)
{
    switch (argument.kind) {
    case Kind::Label:
        return text(argument.text);
    case Kind::Number: {
        const QJsonValue number = storedNumber(argument.number);
        if (argument.text.empty() && argument.decimals == 0 && number.isDouble())
            return number;
        return QJsonObject{
            {numberKey, number}, {decimalsKey, argument.decimals}, {unitKey, text(argument.text)}};
    }
    case Kind::Message:
        return QJsonObject{{messageKey, odo::toJson(argument.parts.front())}};
    case Kind::List: {
        QJsonArray parts;
        for (const Message &part : argument.parts)
            parts << odo::toJson(part);
        const auto *joint =
            std::ranges::find(jointWords, argument.joint, &std::pair<Joint, const char *>::first);
        return QJsonObject{{listKey, parts}, {jointKey, QLatin1String(joint->second)}};
    }
    default:
        break;
    }
    const auto *key = std::ranges::find(nameKeys, argument.kind, &std::pair<Kind, const char *>::first);
    return QJsonObject{{QLatin1String(key->second), text(argument.text)}};
}

Message messageFrom(const QJsonObject &json, int depth);

MessageArgument argumentFrom(const QJsonValue &stored, int depth)
{
    if (stored.isDouble())
        return quantity(stored.toDouble(), 0);
    if (stored.isString())
        return stored.toString().toStdString();
    const QJsonObject json = stored.toObject();
    if (json.contains(numberKey))
        return quantity(numberIn(json.value(numberKey)),
                        std::clamp(json.value(decimalsKey).toInt(), 0, mostDecimals),
                        json.value(unitKey).toString().toStdString());
    if (json.contains(messageKey))
        return messageFrom(json.value(messageKey).toObject(), depth);
    if (json.contains(listKey)) {
        std::vector<Message> parts;
        for (const QJsonValue part : json.value(listKey).toArray())
            parts.push_back(messageFrom(part.toObject(), depth));
        const QString word = json.value(jointKey).toString();
        const auto *joint = std::ranges::find_if(
            jointWords, [&word](const auto &known) { return word == QLatin1String(known.second); });
        return listed(std::move(parts), joint == jointWords.end() ? Joint::And : joint->first);
    }
    for (const auto &[kind, key] : nameKeys) {
        if (const QJsonValue name = json.value(QLatin1String(key)); name.isString())
            return {kind, name.toString().toStdString()};
    }
    return {};
}

bool isCode(const QString &text)
{
    return !text.isEmpty() && text.size() <= longestCode && std::ranges::all_of(text, [](QChar letter) {
        return (letter >= u'a' && letter <= u'z') || (letter >= u'0' && letter <= u'9') || letter == u'_' ||
               letter == u'.';
    });
}

Message messageFrom(const QJsonObject &json, int depth)
{
    const QString code = json.value(codeKey).toString();
    if (!isCode(code) || depth > deepest)
        return {};
    Message message(messageText(code.toStdString()));
    const bool joins = isJoin(message.code());
    const QJsonObject arguments = json.value(argumentsKey).toObject();
    for (int number = 1; number <= (joins ? mostJoined : mostArguments); ++number) {
        const auto argument = arguments.find(QString::number(number));
        if (argument == arguments.end())
            break;
        if (joins && number > 2)
            message = (*message.text)(std::move(message));
        message.arguments.push_back(argumentFrom(*argument, depth + 1));
    }
    return message;
}

} // namespace

QJsonObject toJson(const Message &message)
{
    if (message.isEmpty())
        return {};
    QJsonObject arguments;
    for (const MessageArgument *argument : argumentsOf(message))
        arguments.insert(QString::number(arguments.size() + 1), toJson(*argument));
    return {{codeKey, QLatin1String(message.text->code)}, {argumentsKey, arguments}};
}

Message messageFromJson(const QJsonObject &json)
{
    return messageFrom(json, 0);
}

std::string storedMessage(const Message &message)
{
    return message.isEmpty() ? std::string()
                             : QJsonDocument(toJson(message)).toJson(QJsonDocument::Compact).toStdString();
}

Message messageFromStored(const std::string &stored)
{
    if (stored.starts_with('{')) {
        const auto size = static_cast<qsizetype>(stored.size());
        Message message =
            messageFromJson(QJsonDocument::fromJson(QByteArray::fromRawData(stored.data(), size)).object());
        if (!message.isEmpty())
            return message;
    }
    return foreignWords(stored);
}

} // namespace odo
