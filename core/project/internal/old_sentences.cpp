// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/old_sentences.h"

#include "core/base/units.h"
#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/connection.h"
#include "core/project/message_json.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <new>
#include <optional>
#include <sqlite3.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace odo {

namespace {

using Kind = MessageArgument::Kind;

/// A project may come from anyone: what is longer, or takes longer to be looked through, is none of ours.
constexpr std::size_t longestText = 5000;
constexpr int mostSteps = 2000;

/// How a unit stood behind its number.
constexpr std::array<std::string_view, 5> units{" mm", " m", " px", " s", " %"};

std::string unitOf(std::string_view behind)
{
    return std::string(behind.empty() ? behind : behind.substr(1));
}

std::string_view unitBefore(std::string_view text)
{
    for (const std::string_view unit : units) {
        const bool isWhole =
            text.size() == unit.size() ||
            (text.size() > unit.size() && std::isalpha(static_cast<unsigned char>(text[unit.size()])) == 0);
        if (isWhole && text.starts_with(unit))
            return unit;
    }
    return {};
}

/// A number as it was written, with its unit behind it or without. unit: behind it in the sentence.
std::optional<MessageArgument> numberIn(std::string_view text, std::string_view unit)
{
    for (const std::string_view own : units) {
        if (unit.empty() && text.ends_with(own)) {
            unit = own;
            text.remove_suffix(own.size());
        }
    }
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const auto point = text.find('.');
    const int decimals = point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point) - 1;
    if (problem != std::errc() || end != text.data() + text.size() || formatNumber(value, decimals) != text)
        return std::nullopt;
    return quantity(value, decimals, unitOf(unit));
}

/// A sentence cut at its placeholders.
struct Pattern
{
    const OldSentence *sentence;
    std::vector<std::string_view> literals; ///< one more than numbers; the first and the last may be empty
    std::vector<std::size_t> numbers;       ///< of the placeholders from 0, in their order
    std::size_t length = 0;                 ///< of all literals

    explicit Pattern(const OldSentence &of) : sentence(&of)
    {
        const std::string_view english = of.english;
        std::size_t begin = 0;
        for (std::size_t at = 0; at + 1 < english.size(); ++at) {
            if (english[at] != '%' || english[at + 1] < '1' || english[at + 1] > '9')
                continue;
            literals.push_back(english.substr(begin, at - begin));
            numbers.push_back(static_cast<std::size_t>(english[at + 1] - '1'));
            begin = at + 2;
        }
        literals.push_back(english.substr(begin));
        length = english.size() - 2 * numbers.size();
    }
};

/// Those with the most words of their own first.
const std::vector<Pattern> &patternsOf(OldSentences of)
{
    static const auto all = [] {
        std::array<std::vector<Pattern>, std::size_t(OldSentences::Changes) + 1> patterns;
        for (std::size_t i = 0; i < patterns.size(); ++i) {
            for (const OldSentence &sentence : oldSentences(OldSentences(i)))
                patterns[i].emplace_back(sentence);
            std::ranges::stable_sort(patterns[i], std::ranges::greater(), &Pattern::length);
        }
        return patterns;
    }();
    return all[std::size_t(of)];
}

constexpr std::array<std::pair<char, Kind>, 10> kindLetters{{{'s', Kind::Label},
                                                             {'c', Kind::Camera},
                                                             {'r', Kind::Robot},
                                                             {'e', Kind::Team},
                                                             {'k', Kind::Class},
                                                             {'a', Kind::Task},
                                                             {'t', Kind::Trial},
                                                             {'l', Kind::Layout},
                                                             {'m', Kind::Marker},
                                                             {'f', Kind::File}}};

Kind kindOf(char letter)
{
    return std::ranges::find(kindLetters, letter, &std::pair<char, Kind>::first)->second;
}

/// The names in "O, U and V"; none in "none".
std::vector<std::string_view> namesIn(std::string_view list)
{
    constexpr std::string_view last = " and ", next = ", ";
    std::vector<std::string_view> names;
    if (list == "none")
        return names;
    const auto end = list.rfind(last);
    std::string_view rest = list.substr(0, end);
    for (auto at = rest.find(next); at != std::string_view::npos; at = rest.find(next)) {
        names.push_back(rest.substr(0, at));
        rest.remove_prefix(at + next.size());
    }
    names.push_back(rest);
    if (end != std::string_view::npos)
        names.push_back(list.substr(end + last.size()));
    return names;
}

/// "left02.jpg (6)"
Message frameIn(std::string_view text)
{
    const auto at = text.rfind(" (");
    if (at != std::string_view::npos && text.ends_with(')')) {
        if (auto count = numberIn(text.substr(at + 2, text.size() - at - 3), {}))
            return messageText("calibration.picture_with_corners")(std::string(text.substr(0, at)),
                                                                   std::move(*count));
    }
    return nameAlone(std::string(text));
}

/// Looks through one text.
class Reader
{
public:
    explicit Reader(OldSentences of) : m_patterns(patternsOf(of)) {}

    Message read(std::string_view text)
    {
        for (const bool mayHoldJoins : {false, true}) { // a name may look like the end of a sentence
            m_mayHoldJoins = mayHoldJoins;
            m_steps = mostSteps;
            if (auto known = clauses(text))
                return *known;
            std::vector<Message> all;
            if (addSentences(text, all))
                return joined(std::move(all), Join::Space);
        }
        return knownAmong(text);
    }

private:
    using Text = std::string_view;

    /// All sentences of a text, each with its full stop; false where one of them is none of ours.
    bool addSentences(Text text, std::vector<Message> &all)
    {
        for (auto at = text.find(". "); at != Text::npos && m_steps > 0; at = text.find(". ", at + 1)) {
            auto first = clauses(text.substr(0, at + 1));
            if (!first)
                continue;
            all.push_back(std::move(*first));
            if (addSentences(text.substr(at + 2), all))
                return true;
            all.pop_back();
        }
        auto last = clauses(text);
        if (last)
            all.push_back(std::move(*last));
        return last.has_value();
    }

    /// One sentence, or a part of one, whose parts are all known.
    std::optional<Message> clauses(Text text)
    {
        if (--m_steps < 0)
            return std::nullopt;
        if (auto known = whole(text))
            return known;
        if (text.ends_with('.') && !text.ends_with("..")) {
            if (auto known = clauses(text.substr(0, text.size() - 1)))
                return messageText("calibration.sentence")(std::move(*known));
        }
        for (const auto &[sign, join] :
             {std::pair(Text("; "), Join::Semicolon), std::pair(Text(": "), Join::Colon)}) {
            for (auto at = text.rfind(sign); at != Text::npos && at > 0; at = text.rfind(sign, at - 1)) {
                auto second = whole(text.substr(at + sign.size()));
                auto first = second ? clauses(text.substr(0, at)) : std::nullopt;
                if (first)
                    return joined({std::move(*first), std::move(*second)}, join);
            }
        }
        return std::nullopt;
    }

    std::optional<Message> whole(Text text)
    {
        for (const Pattern &pattern : m_patterns) {
            if (text.size() < pattern.length + pattern.numbers.size() ||
                !text.starts_with(pattern.literals.front()) || !text.ends_with(pattern.literals.back()))
                continue;
            std::vector<MessageArgument> arguments(pattern.numbers.size());
            if (pattern.numbers.empty() ? text.size() == pattern.length
                                        : fill(pattern, text, 0, pattern.literals.front().size(), arguments))
                return Message(messageText(pattern.sentence->code), std::move(arguments));
        }
        return std::nullopt;
    }

    /// What stands for the placeholders from one on, whose values begin there.
    bool fill(const Pattern &pattern, Text text, std::size_t which, std::size_t from,
              std::vector<MessageArgument> &arguments)
    {
        const Text next = pattern.literals[which + 1];
        const bool isLast = which + 1 == pattern.numbers.size();
        for (std::size_t to = isLast ? text.size() - next.size() : text.find(next, from + 1);
             to != Text::npos && to > from; to = isLast ? Text::npos : text.find(next, to + 1)) {
            if (--m_steps < 0)
                return false;
            auto argument = argumentIn(pattern, which, text.substr(from, to - from));
            if (!argument || (!isLast && !fill(pattern, text, which + 1, to + next.size(), arguments)))
                continue;
            arguments[pattern.numbers[which]] = std::move(*argument);
            return true;
        }
        return false;
    }

    std::optional<MessageArgument> argumentIn(const Pattern &pattern, std::size_t which, Text value)
    {
        const Text letters = pattern.sentence->arguments, unit = unitBefore(pattern.literals[which + 1]);
        const std::size_t number = pattern.numbers[which];
        const char letter = letters[number];
        if (letter == 'w') {
            if (auto figure = numberIn(value, unit))
                return figure;
            return clauses(value);
        }
        if (!m_mayHoldJoins && std::ranges::any_of(std::array<Text, 3>{"; ", ": ", ". "}, [value](Text join) {
                return value.find(join) != Text::npos;
            }))
            return std::nullopt;
        if (letter == 'n')
            return numberIn(value, unit);
        if (std::isupper(static_cast<unsigned char>(letter)) != 0) {
            std::vector<Message> parts;
            for (const Text name : namesIn(value))
                parts.push_back(letter == 'P' ? frameIn(name)
                                              : nameAlone({kindOf(static_cast<char>(std::tolower(letter))),
                                                           std::string(name)}));
            return listed(std::move(parts));
        }
        return MessageArgument(kindOf(letter), std::string(value));
    }

    /// The sentences that are known, and the others as they are.
    Message knownAmong(Text text)
    {
        m_mayHoldJoins = false;
        m_steps = mostSteps;
        std::vector<Message> all;
        std::string unknown;
        while (!text.empty() && m_steps > 0) {
            std::size_t end = 0;
            std::optional<Message> known;
            do {
                end = std::min(text.find(". ", end), text.size() - 1) + 1;
                known = clauses(text.substr(0, end));
            } while (!known && end < text.size() && m_steps > 0);
            if (!known) { // the first of them is foreign
                end = std::min(text.find(". "), text.size() - 1) + 1;
                unknown += (unknown.empty() ? "" : " ") + std::string(text.substr(0, end));
            } else {
                all.push_back(foreignWords(std::exchange(unknown, {})));
                all.push_back(std::move(*known));
            }
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        if (!text.empty())
            unknown += (unknown.empty() ? "" : " ") + std::string(text);
        all.push_back(foreignWords(std::move(unknown)));
        return joined(std::move(all), Join::Space);
    }

    const std::vector<Pattern> &m_patterns;
    bool m_mayHoldJoins = false;
    int m_steps = mostSteps;
};

} // namespace

Message fromOldSentence(OldSentences of, const std::string &text)
{
    if (text.empty() || text.size() > longestText)
        return foreignWords(text);
    return Reader(of).read(text);
}

namespace {

struct SentenceColumn
{
    const char *table, *column;
    OldSentences of;
};
constexpr SentenceColumn columns[] = {{"intrinsics", "verdict", OldSentences::Calibrations},
                                      {"intrinsics", "lens_reason", OldSentences::Calibrations},
                                      {"intrinsics", "origin", OldSentences::Origins},
                                      {"rejected_picture", "reason", OldSentences::Pictures},
                                      {"registration", "verdict", OldSentences::Registrations},
                                      {"registration_check", "words", OldSentences::Registrations},
                                      {"spike", "reason", OldSentences::Spikes},
                                      {"imported_track", "reading", OldSentences::Readings},
                                      {"change_entry", "words", OldSentences::Changes}};

/// The function of SQL that makes a stored message of OldSentences and a text, while it lives. Triggers,
/// which keep imported tracks and the list of changes from ever being changed, rest meanwhile.
class MessageFunction
{
public:
    explicit MessageFunction(sqlite3 *handle) : m_handle(handle)
    {
        set(&MessageFunction::convert);
        sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    }
    ~MessageFunction()
    {
        sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 1, nullptr);
        set(nullptr);
    }
    MessageFunction(const MessageFunction &) = delete;
    MessageFunction &operator=(const MessageFunction &) = delete;

private:
    using Function = void (*)(sqlite3_context *, int, sqlite3_value **);
    void set(Function function)
    {
        sqlite3_create_function_v2(m_handle, "stored_message", 2, SQLITE_UTF8 | SQLITE_DIRECTONLY, nullptr,
                                   function, nullptr, nullptr, nullptr);
    }
    static void convert(sqlite3_context *context, int, sqlite3_value **values) noexcept
    {
        try {
            const auto of = OldSentences(sqlite3_value_int(values[0]));
            const auto *text = reinterpret_cast<const char *>(sqlite3_value_text(values[1]));
            const auto size = static_cast<std::size_t>(sqlite3_value_bytes(values[1]));
            const std::string stored =
                storedMessage(fromOldSentence(of, text ? std::string(text, size) : std::string()));
            sqlite3_result_text(context, stored.data(), static_cast<int>(stored.size()), SQLITE_TRANSIENT);
        } catch (const std::bad_alloc &) {
            sqlite3_result_error_nomem(context);
        }
    }

    sqlite3 *const m_handle;
};

Result<void> convertColumns(ProjectConnection &connection)
{
    const MessageFunction function(connection.handle());
    for (const SentenceColumn &each : columns) {
        const QString sql = QStringLiteral("UPDATE %1 SET %2=stored_message(%3, %2) WHERE %2<>''")
                                .arg(QLatin1String(each.table), QLatin1String(each.column))
                                .arg(int(each.of));
        ODO_TRY(connection.execute(sql));
    }
    return {};
}

/// Of what the columns belong to.
Result<std::vector<DigestedPart>> touchedParts(const ProjectConnection &connection)
{
    std::vector<DigestedPart> parts;
    const auto add = [&](const char *sql, std::initializer_list<DigestPart> of) {
        Statement analyses(connection, QString::fromLatin1(sql));
        return analyses.eachRow([&](const Statement &row) -> Result<void> {
            for (const DigestPart part : of)
                parts.push_back({row.integer(0), part});
            return {};
        });
    };
    auto read = add("SELECT DISTINCT analysis_id FROM analysis_digest",
                    {DigestPart::Registrations, DigestPart::Results});
    if (read)
        read = add("SELECT DISTINCT analysis.id FROM analysis JOIN imported_track USING (trial_id, robot_id)",
                   {DigestPart::Measurements});
    if (!read)
        return tl::unexpected(read.error());
    return parts;
}

} // namespace

Result<void> storeMessages(ProjectConnection &connection)
{
    const auto parts = ODO_TRY(touchedParts(connection));
    // Digests name a table that came later: until then all observations are in force.
    ODO_TRY(connection.execute(QStringLiteral(
        "CREATE TEMP VIEW series_in_force AS SELECT id AS series_id FROM observation_series")));
    ODO_TRY(keepDigestsRight(connection, parts, [&] { return convertColumns(connection); }));
    return connection.execute(QStringLiteral("DROP VIEW temp.series_in_force"));
}

} // namespace odo
