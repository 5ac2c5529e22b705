// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/core_words.h"

#include "ui/models/core_words/subjects.h"

#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <optional>
#include <vector>

namespace odo {

namespace {

QString translated(const char *english)
{
    return QCoreApplication::translate("CoreWords", english);
}

/// The number behind the % at a place, and how many signs both take; nullopt: it is an ordinary %.
std::optional<std::pair<int, int>> placeholderAt(const QString &text, qsizetype at)
{
    if (at + 1 >= text.size() || text.at(at) != u'%' || text.at(at + 1) < u'1' || text.at(at + 1) > u'9')
        return std::nullopt;
    return std::pair(text.at(at + 1).digitValue(), 2);
}

/// A pattern cut at its placeholders.
struct CompiledPattern
{
    const CorePattern *pattern = nullptr;
    QStringList literals;     ///< one more than placeholders; the first and the last may be empty
    std::vector<int> numbers; ///< of the placeholders, in their order
    qsizetype length = 0;     ///< of all literals

    explicit CompiledPattern(const CorePattern &of) : pattern(&of)
    {
        const QString text = QString::fromUtf8(of.english);
        QString literal;
        for (qsizetype i = 0; i < text.size(); ++i) {
            if (const auto placeholder = placeholderAt(text, i)) {
                literals << std::exchange(literal, QString());
                numbers.push_back(placeholder->first);
                i += placeholder->second - 1;
            } else {
                literal += text.at(i);
                ++length;
            }
        }
        literals << literal;
    }
    bool holdsPhrase(int number) const
    {
        return QLatin1String(pattern->phrases).contains(QChar(u'0' + number));
    }
    bool holdsList(int number) const { return QLatin1String(pattern->lists).contains(QChar(u'0' + number)); }

    /// What stands for each placeholder, in their order; nullopt: the text is another.
    std::optional<QStringList> valuesIn(const QString &text) const
    {
        if (!text.startsWith(literals.first()) || !text.endsWith(literals.last()) ||
            text.size() < length + qsizetype(numbers.size()))
            return std::nullopt;
        QStringList values;
        qsizetype from = literals.first().size();
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const bool isLast = i + 1 == numbers.size();
            const QString &next = literals.at(qsizetype(i) + 1);
            const qsizetype to = isLast ? text.size() - next.size() : text.indexOf(next, from + 1);
            if (to <= from)
                return std::nullopt;
            const QString value = text.mid(from, to - from);
            if (!holdsPhrase(numbers[i]) && joinIn(value) >= 0)
                return std::nullopt;
            values << value;
            from = to + next.size();
        }
        return values;
    }

    /// Where two parts of a message meet, searched backwards; −1: nowhere.
    static qsizetype joinIn(const QString &text, qsizetype before = -1)
    {
        for (qsizetype i = (before < 0 ? text.size() : before) - 2; i > 0; --i)
            if (text.at(i + 1) == u' ' && (text.at(i) == u';' || text.at(i) == u':' || text.at(i) == u'.'))
                return i;
        return -1;
    }
};

/// All patterns, those with the most words of their own first, and by their first letter.
class Patterns
{
public:
    Patterns()
    {
        for (const auto &subject : core_words::all())
            m_all.insert(m_all.end(), subject.begin(), subject.end());
        std::vector<CompiledPattern> compiled(m_all.begin(), m_all.end());
        std::ranges::stable_sort(compiled, std::ranges::greater(), &CompiledPattern::length);
        for (CompiledPattern &each : compiled) {
            if (each.numbers.empty())
                m_exact.insert(each.literals.first(), each.pattern);
            else
                m_varying[each.literals.first().isEmpty() ? QChar() : each.literals.first().at(0)].push_back(
                    std::move(each));
        }
    }
    std::span<const CorePattern> all() const { return m_all; }

    struct Found
    {
        const CorePattern *pattern = nullptr;
        const CompiledPattern *compiled = nullptr; ///< nullptr: nothing varies
        QStringList values;
    };
    Found find(const QString &text) const
    {
        if (const auto exact = m_exact.find(text); exact != m_exact.end())
            return {*exact, nullptr, {}};
        Found best;
        for (const QChar first : {text.isEmpty() ? QChar() : text.at(0), QChar()}) {
            const auto bucket = m_varying.find(first);
            if (bucket == m_varying.end())
                continue;
            for (const CompiledPattern &each : *bucket) {
                if (best.compiled && each.length <= best.compiled->length)
                    break;
                if (const auto values = each.valuesIn(text)) {
                    best = {each.pattern, &each, *values};
                    break;
                }
            }
        }
        return best;
    }

private:
    std::vector<CorePattern> m_all;
    QHash<QString, const CorePattern *> m_exact;
    QHash<QChar, std::vector<CompiledPattern>>
        m_varying; ///< of the null letter: those that begin with a placeholder
};

const Patterns &patterns()
{
    static const Patterns all;
    return all;
}

QString replaced(const QString &pattern, const QHash<int, QString> &values)
{
    QString text;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        if (const auto placeholder = placeholderAt(pattern, i)) {
            text += values.value(placeholder->first);
            i += placeholder->second - 1;
        } else {
            text += pattern.at(i);
        }
    }
    return text;
}

/// A number, be it with its unit, as the language writes it; anything else as it is.
QString localNumber(QString value)
{
    static const QRegularExpression decimal(QStringLiteral("^-?[0-9]+\\.[0-9]+( (px|mm|m|ms|s|%|°))?$"));
    if (decimal.match(value).hasMatch())
        value.replace(u'.', QLocale().decimalPoint());
    return value;
}

QString shownList(const QString &names)
{
    if (names == QLatin1String("none"))
        return translated(QT_TRANSLATE_NOOP("CoreWords", "none"));
    const qsizetype last = names.lastIndexOf(QStringLiteral(" and "));
    return last < 0 ? names
                    : replaced(translated(QT_TRANSLATE_NOOP("CoreWords", "%1 and %2")),
                               {{1, names.left(last)}, {2, names.mid(last + 5)}});
}

/// A sentence, or a part, that one pattern knows; nullopt: none does.
std::optional<QString> shownPart(const QString &english)
{
    const bool stops = english.endsWith(u'.') && !english.endsWith(QLatin1String(".."));
    const Patterns::Found found = patterns().find(stops ? english.chopped(1) : english);
    if (!found.pattern)
        return std::nullopt;
    const QString pattern = translated(found.pattern->english);
    QString sentence = pattern;
    if (found.compiled) {
        QHash<int, QString> values;
        for (std::size_t i = 0; i < found.compiled->numbers.size(); ++i) {
            const int number = found.compiled->numbers[i];
            const QString value = found.values.at(qsizetype(i));
            const QString words = found.compiled->holdsPhrase(number) ? shownWords(value)
                                  : found.compiled->holdsList(number) ? shownList(value)
                                                                      : value;
            values[number] =
                pattern == QString::fromUtf8(found.pattern->english) ? words : localNumber(words);
        }
        sentence = replaced(pattern, values);
    }
    return stops ? fullSentence(sentence) : sentence;
}

QString joinedBy(const QString &first, QChar sign, const QString &second)
{
    if (sign == u':')
        return joinedWords(first, second);
    if (sign == u';')
        return replaced(translated(QT_TRANSLATE_NOOP("CoreWords", "%1; %2")), {{1, first}, {2, second}});
    return replaced(translated(QT_TRANSLATE_NOOP("CoreWords", "%1 %2")), {{1, first}, {2, second}});
}

} // namespace

QString shownWords(const QString &english)
{
    if (const auto whole = shownPart(english))
        return *whole;
    qsizetype first = -1;
    for (qsizetype at = CompiledPattern::joinIn(english); at > 0;
         at = CompiledPattern::joinIn(english, at + 1)) {
        first = at;
        if (const auto part = shownPart(english.left(english.at(at) == u'.' ? at + 1 : at)))
            return joinedBy(*part, english.at(at), shownWords(english.mid(at + 2)));
    }
    if (first < 0)
        return english;
    return joinedBy(english.left(english.at(first) == u'.' ? first + 1 : first), english.at(first),
                    shownWords(english.mid(first + 2)));
}

QString shownWords(const std::string &english)
{
    return shownWords(QString::fromStdString(english));
}

std::span<const CorePattern> corePatterns()
{
    return patterns().all();
}

const CorePattern *corePatternOf(const QString &english)
{
    return patterns().find(english).pattern;
}

QString joinedWords(const QString &what, const QString &why)
{
    return replaced(translated(QT_TRANSLATE_NOOP("CoreWords", "%1: %2")), {{1, what}, {2, why}});
}

QString fullSentence(const QString &words)
{
    static const QString signs = QStringLiteral(".?!。？！");
    return words.isEmpty() || signs.contains(words.back())
               ? words
               : replaced(translated(QT_TRANSLATE_NOOP("CoreWords", "%1.")), {{1, words}});
}

namespace {

QString shown(const std::string &part)
{
    return shownWords(QString::fromStdString(part).simplified());
}

QString sentence(QString text)
{
    if (text.isEmpty())
        return text;
    text[0] = text.at(0).toUpper();
    return fullSentence(text);
}

} // namespace

QString errorInWords(const Error &error)
{
    QStringList sentences{
        sentence(error.why.empty() ? shown(error.what) : joinedWords(shown(error.what), shown(error.why)))};
    if (!error.advice.empty())
        sentences << sentence(shown(error.advice));
    return sentences.join(QLatin1Char(' '));
}

QString errorLine(const Error &error)
{
    return shownWords(error.message());
}

} // namespace odo
