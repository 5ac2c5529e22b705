// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace odo {

struct Message;

/// The English words of a message, with %1 to %9 for its arguments, and the code that it is known by wherever
/// it is stored or given to a program. A published code never changes; its words may. Made by ODO_TEXT.
struct MessageText
{
    const char *code = "";
    const char *english = "";

    /// The message of these words with its arguments, %1 first.
    template <class... Arguments>
    Message operator()(Arguments &&...arguments) const;
};

template <class Type>
constexpr bool isCount =
    std::is_integral_v<Type> && !std::is_same_v<Type, bool> && !std::is_same_v<Type, char>;

/// What varies in a message: a number with its unit, a name of a known kind, a list, or another message.
/// Plain value.
struct MessageArgument
{
    enum class Kind {
        Number,
        List,    ///< parts joined by Joint
        Message, ///< one part
        Camera,  ///< a name, here and below
        Robot,
        Team, ///< a window may show a pseudonym instead
        Person,
        Class,
        Task,
        Trial,
        Layout,
        Marker,
        File,
        Label, ///< any other text that is nobody's words: a column, an address, what was typed
    };
    enum class Joint { And, Or, Comma };

    Kind kind = Kind::Label;
    std::string text; ///< the name; of a number its unit
    double number = 0;
    int decimals = 0;
    Joint joint = Joint::And;
    std::vector<Message> parts;

    MessageArgument();
    MessageArgument(Kind itsKind, std::string name);
    template <class Count>
    requires isCount<Count> MessageArgument(Count count);
    MessageArgument(std::string label);
    MessageArgument(const char *) = delete; ///< words of ours are a Message
    MessageArgument(Message message);
    MessageArgument(const MessageArgument &);
    MessageArgument(MessageArgument &&) noexcept;
    MessageArgument &operator=(const MessageArgument &);
    MessageArgument &operator=(MessageArgument &&) noexcept;
    ~MessageArgument();

    bool operator==(const MessageArgument &) const;
};

/// A sentence for a person, or a part of one: words and arguments, put together where it is shown. core makes
/// it, the command line prints its English, the windows translate it, a project stores its code and
/// arguments. Nobody takes a sentence apart again. Plain value; safe to pass between threads.
struct Message
{
    const MessageText *text = nullptr; ///< static; null: empty
    std::vector<MessageArgument> arguments;

    Message() = default;
    Message(const MessageText &words) : text(&words) {}
    Message(const MessageText &words, std::vector<MessageArgument> with)
        : text(&words), arguments(std::move(with))
    {
    }

    bool isEmpty() const { return text == nullptr; }
    std::string_view code() const { return text ? text->code : ""; }
    /// In English, one line unless an argument has more; numbers with a point.
    std::string english() const;
    bool operator==(const Message &other) const
    {
        return code() == other.code() && arguments == other.arguments;
    }
};

template <class Count>
requires isCount<Count> MessageArgument::MessageArgument(Count count) : MessageArgument(Kind::Number, {})
{
    number = static_cast<double>(count);
}

template <class... Arguments>
Message MessageText::operator()(Arguments &&...arguments) const
{
    std::vector<MessageArgument> all;
    all.reserve(sizeof...(arguments));
    (all.emplace_back(std::forward<Arguments>(arguments)), ...);
    return {*this, std::move(all)};
}

/// A number as it is shown: with so many decimals, and its unit ("mm", "%", "frames/s") behind it.
MessageArgument quantity(double value, int decimals, std::string unit = {});

/// A name of a known kind.
struct Named
{
    static MessageArgument camera(std::string name)
    {
        return {MessageArgument::Kind::Camera, std::move(name)};
    }
    static MessageArgument robot(std::string name) { return {MessageArgument::Kind::Robot, std::move(name)}; }
    static MessageArgument team(std::string name) { return {MessageArgument::Kind::Team, std::move(name)}; }
    static MessageArgument person(std::string name)
    {
        return {MessageArgument::Kind::Person, std::move(name)};
    }
    static MessageArgument schoolClass(std::string name)
    {
        return {MessageArgument::Kind::Class, std::move(name)};
    }
    static MessageArgument task(std::string name) { return {MessageArgument::Kind::Task, std::move(name)}; }
    static MessageArgument trial(std::string name) { return {MessageArgument::Kind::Trial, std::move(name)}; }
    static MessageArgument layout(std::string name)
    {
        return {MessageArgument::Kind::Layout, std::move(name)};
    }
    static MessageArgument marker(std::string label)
    {
        return {MessageArgument::Kind::Marker, std::move(label)};
    }
    static MessageArgument file(const std::filesystem::path &path)
    {
        return {MessageArgument::Kind::File, path.string()};
    }
};

/// "A, B and C", or "none" of an empty list.
MessageArgument listed(std::vector<Message> parts,
                       MessageArgument::Joint joint = MessageArgument::Joint::And);
MessageArgument listed(const std::vector<std::string> &names, MessageArgument::Kind kind,
                       MessageArgument::Joint joint = MessageArgument::Joint::And);

/// One name as a message of its own, such as the subject of an error: "A.csv".
Message nameAlone(MessageArgument name);
/// What is not ours: a library's or a device's own words. They are never translated.
Message foreignWords(std::string words);

/// How messages are put into words. This one speaks English, a window another language.
class MessageLanguage
{
public:
    virtual ~MessageLanguage() = default;
    virtual std::string words(const MessageText &text) const { return text.english; }
    virtual std::string number(double value, int decimals) const; ///< without its unit
    virtual std::string name(const MessageArgument &name) const;  ///< of any kind of name

    std::string render(const Message &message) const;

private:
    std::string render(const MessageArgument &argument) const;
    std::string list(const MessageArgument &list) const;
};

/// How messages follow one another.
enum class Join {
    Colon,     ///< "%1: %2"
    Semicolon, ///< "%1; %2"
    Comma,     ///< "%1, %2"
    Space,     ///< "%1 %2": whole sentences with their full stops
};
/// The words that join two of them.
const MessageText &textOf(Join how);
/// Messages as one; empty ones are left out.
Message joined(std::vector<Message> messages, Join how);

/// The words of a code, as this program has them. A code that it does not know gives itself as its words.
/// Any thread.
const MessageText &messageText(std::string_view code);
/// All that this program can say, each once, in the order of their codes. Any thread.
std::vector<const MessageText *> allMessageTexts();

namespace message_internal {

bool enrol(const MessageText &text);

/// One for each ODO_TEXT: Source is the type of a lambda, unique to that use.
template <class Source>
struct Enrolled
{
    static constexpr MessageText text = Source{}();
    inline static const bool isKnown = enrol(text);
    static const MessageText &get()
    {
        (void)isKnown; // instantiates it, so that it is enrolled when the program starts
        return text;
    }
};

} // namespace message_internal

/// Words of a message, read here by the translation tool too: ODO_TEXT("layout.twice", "%1 is there twice").
/// The code is "folder.subject", in lower case with underscores, and used only once.
#define ODO_TEXT(code, english)                                                                              \
    (::odo::message_internal::Enrolled<decltype([] { return ::odo::MessageText{code, english}; })>::get())

} // namespace odo
