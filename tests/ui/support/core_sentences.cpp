// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/core_sentences.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace odo {
namespace {

struct Token
{
    enum class Kind { Name, Text, Sign };
    Kind kind = Kind::Sign;
    QString text; ///< of a Text what it says
    int line = 1;
    bool opens() const { return kind == Kind::Sign && QStringLiteral("([{").contains(text); }
    bool closes() const { return kind == Kind::Sign && QStringLiteral(")]}").contains(text); }
};
using Tokens = std::span<const Token>;

/// Cuts a source into names (numbers too), texts and signs; comments and lines of the preprocessor are passed
/// over.
class Lexer
{
public:
    explicit Lexer(const QString &source) : m_source(source) {}
    std::vector<Token> tokens()
    {
        static const QRegularExpression token(
            QStringLiteral(R"re(\s+|//[^\n]*|/\*.*?\*/|^\h*\#(?:\\\n|[^\n])*|)re"
                           R"re((?<raw>R"(?<end>[^(]*)\(.*?\)\k<end>")|"(?<text>(?:\\.|[^"\\])*)"|)re"
                           R"re((?<sign>(?:u8|[uUL])?'(?:\\.|[^'\\])+')|(?<name>\d[\w.']*|\w+)|::|->|.)re"),
            QRegularExpression::DotMatchesEverythingOption | QRegularExpression::MultilineOption);
        std::vector<Token> tokens;
        for (auto each = token.globalMatch(m_source); each.hasNext();) {
            const auto match = each.next();
            const QString all = match.captured();
            if (match.hasCaptured(QStringLiteral("text")))
                tokens.push_back(
                    {Token::Kind::Text, unescaped(match.captured(QStringLiteral("text"))), m_line});
            else if (match.hasCaptured(QStringLiteral("raw")) || match.hasCaptured(QStringLiteral("sign")) ||
                     match.hasCaptured(QStringLiteral("name")))
                tokens.push_back({Token::Kind::Name, all, m_line});
            else if (!all.at(0).isSpace() && !all.startsWith(u'#') && !all.startsWith(QLatin1String("//")) &&
                     !all.startsWith(QLatin1String("/*")))
                tokens.push_back({Token::Kind::Sign, all, m_line});
            m_line += int(all.count(u'\n'));
        }
        return tokens;
    }

private:
    static QString unescaped(QString text)
    {
        return text.replace(QStringLiteral("\\\""), QStringLiteral("\""))
            .replace(QStringLiteral("\\n"), QStringLiteral("\n"))
            .replace(QStringLiteral("\\\\"), QStringLiteral("\\"));
    }
    const QString &m_source;
    int m_line = 1;
};

/// Where the bracket that opens at a token closes; the number of tokens: nowhere.
std::size_t closing(Tokens tokens, std::size_t at)
{
    int depth = 0;
    for (; at < tokens.size(); ++at) {
        depth += tokens[at].opens() ? 1 : tokens[at].closes() ? -1 : 0;
        if (depth == 0)
            return at;
    }
    return at;
}

/// The first of some signs outside brackets; the number of tokens: there is none.
std::size_t found(Tokens tokens, const QStringList &signs)
{
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].opens())
            i = closing(tokens, i);
        else if (tokens[i].kind == Token::Kind::Sign && signs.contains(tokens[i].text))
            return i;
    }
    return tokens.size();
}

std::vector<Tokens> parted(Tokens tokens, const QString &sign)
{
    std::vector<Tokens> parts;
    for (;;) {
        const std::size_t at = found(tokens, {sign});
        parts.push_back(tokens.first(at));
        if (at == tokens.size())
            return parts;
        tokens = tokens.subspan(at + 1);
    }
}

bool hasText(Tokens tokens)
{
    return std::ranges::any_of(tokens, [](const Token &token) { return token.kind == Token::Kind::Text; });
}

bool isBracketed(Tokens tokens)
{
    return !tokens.empty() && tokens.front().opens() && closing(tokens, 0) + 1 == tokens.size();
}

QStringList saidBy(Tokens expression);

/// One term of a sum.
QStringList saidByTerm(Tokens term)
{
    const auto isText = [](const Token &token) { return token.kind == Token::Kind::Text; };
    if (std::ranges::all_of(term, isText)) {
        QString text;
        for (const Token &token : term)
            text += token.text;
        return {text};
    }
    const bool isString =
        term.size() > 4 && term[0].text == QLatin1String("std") && term[2].text == QLatin1String("string");
    const Tokens rest = isString ? term.subspan(3) : term;
    if (hasText(rest) && isBracketed(rest))
        return saidBy(rest.subspan(1, rest.size() - 2));
    return {QStringLiteral("Q")};
}

/// All that an expression may say.
QStringList saidBy(Tokens expression)
{
    const std::size_t question = found(expression, {QStringLiteral("?")});
    if (question < expression.size()) {
        const Tokens choices = expression.subspan(question + 1);
        int open = 1;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (choices[i].opens())
                i = closing(choices, i);
            else if (choices[i].kind == Token::Kind::Sign && choices[i].text == u'?')
                ++open;
            else if (choices[i].kind == Token::Kind::Sign && choices[i].text == u':' && --open == 0)
                return saidBy(choices.first(i)) + saidBy(choices.subspan(i + 1));
        }
    }
    QStringList said{QString()};
    for (const Tokens term : parted(expression, QStringLiteral("+"))) {
        const QStringList before = std::exchange(said, {});
        for (const QString &start : before)
            for (const QString &end : saidByTerm(term))
                said << start + end;
    }
    return said;
}

void add(QList<CoreSentence> &sentences, Tokens expression, const QString &place)
{
    static const QRegularExpression word(QStringLiteral("\\p{Ll}{3}"));
    if (!hasText(expression))
        return;
    if (isBracketed(expression)) {
        for (const Tokens each : parted(expression.subspan(1, expression.size() - 2), QStringLiteral(",")))
            add(sentences, each, place);
        return;
    }
    for (const QString &words : saidBy(expression))
        if (words.contains(word))
            sentences.append({place + u':' + QString::number(expression.front().line), words});
}

/// "it has %.1f %%" as "it has Q %".
QString withoutFormats(QString format)
{
    static const QRegularExpression figure(QStringLiteral("%[-+0-9.]*(?:ll?|z)?[a-z]"));
    return format.replace(figure, QStringLiteral("Q")).replace(QStringLiteral("%%"), QStringLiteral("%"));
}

bool isNameOfWords(const QString &name)
{
    static const QRegularExpression words(
        QStringLiteral("(?:^|_|[a-z])(?i:what|why|advice|warning|remark|toUse|told|bad|rejected|doubt)s?$"));
    return words.match(name).hasMatch();
}

bool isSign(Tokens tokens, std::size_t at, const QString &sign)
{
    return at < tokens.size() && tokens[at].kind == Token::Kind::Sign && tokens[at].text == sign;
}

/// What is given in the brackets that open at a token.
std::vector<Tokens> arguments(Tokens tokens, std::size_t at)
{
    const std::size_t end = std::min(closing(tokens, at), tokens.size());
    return parted(tokens.subspan(at + 1, end - at - 1), QStringLiteral(","));
}

/// What is put into the thing that is named before a token: `= …`, `+= …`, `[] = …`, `{…}` or
/// `.push_back(…)`.
std::vector<Tokens> putInto(Tokens tokens, std::size_t at)
{
    if (isSign(tokens, at, QStringLiteral(".")) && at + 2 < tokens.size() &&
        (tokens[at + 1].text == QLatin1String("push_back") ||
         tokens[at + 1].text == QLatin1String("emplace_back")))
        return arguments(tokens, at + 2);
    while (isSign(tokens, at, QStringLiteral("[")) || isSign(tokens, at, QStringLiteral("]")) ||
           isSign(tokens, at, QStringLiteral("+")))
        ++at;
    if (isSign(tokens, at, QStringLiteral("{")))
        return arguments(tokens, at);
    if (!isSign(tokens, at, QStringLiteral("=")) || isSign(tokens, at + 1, QStringLiteral("=")))
        return {};
    const Tokens rest = tokens.subspan(at + 1);
    return {rest.first(
        found(rest, {QStringLiteral(";"), QStringLiteral(","), QStringLiteral(")"), QStringLiteral("}")}))};
}

/// The expressions behind a name that say something; none where it is another name.
std::vector<Tokens> expressionsAt(Tokens tokens, std::size_t at, const QStringList &makers)
{
    const QString &name = tokens[at].text;
    const bool isCall = isSign(tokens, at + 1, QStringLiteral("("));
    const bool reports =
        name == QLatin1String("report") && at > 0 && isSign(tokens, at - 1, QStringLiteral("."));
    if ((isCall && (reports || makers.contains(name))) ||
        (name == QLatin1String("Error") && tokens[at + 1].opens()))
        return arguments(tokens, at + 1);
    if (name == QLatin1String("snprintf") && at + 2 < tokens.size() && isNameOfWords(tokens[at + 2].text))
        return arguments(tokens, at + 1);
    if (name == QLatin1String("ErrorCode") &&
        isSign(tokens, at + 3, QStringLiteral(","))) { // of an Error in braces
        const Tokens rest = tokens.subspan(at + 4);
        return parted(rest.first(found(rest, {QStringLiteral("}"), QStringLiteral(")")})),
                      QStringLiteral(","));
    }
    return isNameOfWords(name) ? putInto(tokens, at + 1) : std::vector<Tokens>();
}

} // namespace

QStringList errorMakers(const QString &source)
{
    QStringList makers{QStringLiteral("fail")};
    static const QRegularExpression declared(
        QStringLiteral("(?:tl::unexpected<Error>|^\\h*Error)\\s+(?:\\w+::)*(\\w+)\\("),
        QRegularExpression::MultilineOption);
    for (auto each = declared.globalMatch(source); each.hasNext();)
        makers << each.next().captured(1);
    static const QRegularExpression lambda(
        QStringLiteral("auto (\\w+) = \\[[^\\]]*\\]\\([^)]*\\)[^;{]*\\{\\s*return (\\w+)[({]"));
    for (auto each = lambda.globalMatch(source); each.hasNext();) {
        const auto match = each.next();
        if (makers.contains(match.captured(2)) || match.captured(2) == QLatin1String("Error"))
            makers << match.captured(1);
    }
    return makers;
}

QList<CoreSentence> sentencesIn(const QString &source, const QString &place, const QStringList &makers)
{
    std::vector<Token> all = Lexer(source).tokens();
    for (std::size_t i = 0; i + 2 < all.size(); ++i)
        if (all[i].text == QLatin1String("snprintf") && isNameOfWords(all[i + 2].text))
            for (std::size_t j = i + 1, end = closing(all, j); j < end; ++j)
                if (all[j].kind == Token::Kind::Text)
                    all[j].text = withoutFormats(all[j].text);
    const Tokens tokens(all);
    QList<CoreSentence> sentences;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (tokens[i].kind != Token::Kind::Name)
            continue;
        for (const Tokens expression : expressionsAt(tokens, i, makers))
            add(sentences, expression, place);
    }
    return sentences;
}

QList<CoreSentence> coreSentences(const QString &tree, const QString &folder)
{
    QMap<QString, QString> sources;
    QDirIterator files(tree + u'/' + folder, {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (file.open(QIODevice::ReadOnly))
            sources[file.fileName().mid(tree.size() + 1)] = QString::fromUtf8(file.readAll());
    }
    QStringList shared{QStringLiteral("checkName"), QStringLiteral("checkText"), QStringLiteral("addWarning"),
                       QStringLiteral("tell")}; // they pass on what they are given
    for (auto each = sources.constBegin(); each != sources.constEnd(); ++each)
        if (each.key().endsWith(QLatin1String(".h")))
            shared << errorMakers(each.value());
    QList<CoreSentence> sentences;
    for (auto each = sources.constBegin(); each != sources.constEnd(); ++each)
        sentences << sentencesIn(each.value(), each.key(), shared + errorMakers(each.value()));
    return sentences;
}

} // namespace odo
