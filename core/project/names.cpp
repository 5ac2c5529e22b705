// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/names.h"

#include "core/base/plain_text.h"
#include "core/project/internal/connection.h"

#include <QStringDecoder>
#include <algorithm>

namespace odo {

namespace {

constexpr int namesToList = 12;

/// nullopt when the bytes are not UTF-8.
std::optional<QString> decode(const std::string &text)
{
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString decoded = decoder(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())));
    if (decoder.hasError())
        return std::nullopt;
    return decoded;
}

std::string shortened(const std::string &name)
{
    return QString::fromStdString(name).left(40).toStdString() + (name.size() > 40 ? "…" : "");
}

bool breaksLine(uint character)
{
    const QChar::Category category = QChar::category(character);
    return category == QChar::Other_Control || category == QChar::Separator_Line ||
           category == QChar::Separator_Paragraph;
}

/// Neither a blank nor what only joins or varies others.
bool isSeen(uint character)
{
    return !QChar::isSpace(character) && !isInvisible(character) && character != 0x200c &&
           character != 0x200d && !QChar::isMark(character);
}

QString normal(const QString &name)
{
    return name.normalized(QString::NormalizationForm_C).trimmed();
}

/// Only then can the name be written or be shown in another way than it is stored.
bool hasOtherForms(const std::string &name)
{
    return std::ranges::any_of(name,
                               [](char c) { return static_cast<unsigned char>(c) >= 0x80 || c == '\\'; });
}

/// what, ifEmpty: for the message.
Result<void> checkNamed(const std::string &what, const std::string &name, const std::string &ifEmpty)
{
    const auto refuse = [&](const std::string &why, const std::string &advice) {
        return fail(ErrorCode::InvalidInput, what, why, advice);
    };
    const std::optional<QString> text = decode(name);
    if (!text)
        return refuse("it is not valid UTF-8 text", "type the name anew");
    const QList<uint> characters = text->toUcs4();
    if (characters.size() > maxNameLength)
        return refuse("it has " + std::to_string(characters.size()) + " characters",
                      "use at most " + std::to_string(maxNameLength));
    if (std::any_of(characters.begin(), characters.end(), breaksLine))
        return refuse("it holds a line break or another control character", "use a name of one line");
    if (const auto hidden = std::ranges::find_if(characters, isInvisible); hidden != characters.end())
        return refuse(
            "it holds an invisible character, " +
                QStringLiteral("U+%1").arg(*hidden, 4, 16, QLatin1Char('0')).toUpper().toStdString(),
            "type the name anew");
    if (std::ranges::none_of(characters, isSeen))
        return refuse("it is empty", ifEmpty);
    return {};
}

} // namespace

std::string normalName(const std::string &name)
{
    const std::optional<QString> text = decode(name);
    return text ? normal(*text).toStdString() : name; // which checkName refuses
}

Result<void> checkName(const std::string &kind, const std::string &name)
{
    return checkNamed("name of a " + kind, name, "give the " + kind + " a name");
}

Result<void> checkTitle(const std::string &title)
{
    return checkNamed("title of the project", title, "give the project a title");
}

std::string titleFromName(const std::filesystem::path &file)
{
    // What is not UTF-8 is shown as its bytes.
    for (const std::string &name : {file.stem().string(), file.filename().string()})
        if (const std::string title = normalName(shownName(QString::fromStdString(plainLine(name))));
            checkTitle(title))
            return title;
    return "Odograph";
}

QString firstCharacters(const QString &text, int most)
{
    qsizetype cut = 0, at = 0;
    for (int characters = 0; at < text.size(); ++characters) {
        if (characters == most)
            return text.first(cut) + u'…';
        if (characters < most)
            cut = at;
        at += text.at(at).isHighSurrogate() && at + 1 < text.size() ? 2 : 1;
    }
    return text;
}

std::string shownName(const QString &stored)
{
    // An escaped character is at most eight long, and takes the place of one: no more than this can be shown
    // of it.
    const QString begin = firstCharacters(stored, maxNameLength + 1);
    return firstCharacters(QString::fromStdString(plainLine(begin.toStdString())), maxNameLength)
        .toStdString();
}

Result<void> checkText(const std::string &kind, const std::string &text)
{
    const std::optional<QString> decoded = decode(text);
    if (!decoded)
        return fail(ErrorCode::InvalidInput, kind, "it is not valid UTF-8 text", "type the text anew");
    const qsizetype characters = decoded->toUcs4().size();
    if (characters > maxTextLength)
        return fail(ErrorCode::InvalidInput, kind, "it has " + std::to_string(characters) + " characters",
                    "use at most " + std::to_string(maxTextLength));
    return {};
}

Result<RecordId> idNamed(const ProjectConnection &connection, const std::string &table,
                         const std::string &name)
{
    const QString rows = QStringLiteral("SELECT id, name FROM %1").arg(QString::fromStdString(table));
    Statement exact(connection, rows + QStringLiteral(" WHERE name=?"));
    const std::string wanted = normalName(name);
    const auto found = exact.bind(wanted).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (*found)
        return exact.integer(0);
    if (!hasOtherForms(name))
        return 0;
    RecordId other = 0; // stored by an older version, or by another program
    Statement all(connection, rows + QStringLiteral(" ORDER BY id DESC"));
    auto read = all.eachRow([&](const Statement &row) -> Result<void> {
        if (normalName(row.name(1)) == wanted)
            other = row.integer(0);
        return {};
    });
    return read.map([other] { return other; });
}

Result<void> checkNameIsFree(const ProjectConnection &connection, const std::string &table,
                             const std::string &kind, const std::string &name)
{
    const auto taken = idNamed(connection, table, name);
    if (!taken)
        return tl::unexpected(taken.error());
    if (*taken != 0)
        return fail(ErrorCode::AlreadyExists, kind + " '" + shortened(name) + "'",
                    "the project has a " + kind + " of that name already", "choose another name");
    return {};
}

tl::unexpected<Error> noSuchName(const ProjectConnection &connection, const std::string &table,
                                 const std::string &kind, const std::string &name)
{
    Statement statement(connection,
                        QStringLiteral("SELECT name FROM %1 ORDER BY id").arg(QString::fromStdString(table)));
    std::string list;
    int count = 0;
    const auto listed = statement.eachRow([&](const Statement &row) -> Result<void> {
        if (++count <= namesToList)
            list += (list.empty() ? "'" : ", '") + shortened(row.name(0)) + "'";
        return {};
    });
    if (!listed)
        return tl::unexpected(listed.error());
    if (count > namesToList)
        list += " and " + std::to_string(count - namesToList) + " more";
    return fail(ErrorCode::NotFound, kind + " '" + shortened(name) + "'",
                "there is no such " + kind + " in the project",
                count == 0 ? "it has no " + kind + " yet: add one first" : "it has " + list);
}

tl::unexpected<Error> noSuchId(const ProjectConnection &connection, const std::string &kind, std::int64_t id)
{
    return fail(ErrorCode::NotFound, connection.displayName(),
                "it has no " + kind + " with the number " + std::to_string(id), "run a check of the project");
}

Result<RecordId> idOfName(ProjectConnection &connection, const std::string &table, const std::string &name)
{
    if (name.empty())
        return 0;
    const auto known = idNamed(connection, table, name);
    if (!known || *known != 0)
        return known;
    if (auto valid = checkName(table, name); !valid)
        return tl::unexpected(valid.error());
    Statement insert(connection,
                     QStringLiteral("INSERT INTO %1 (name) VALUES (?)").arg(QString::fromStdString(table)));
    if (auto done = insert.bind(normalName(name)).run(); !done)
        return tl::unexpected(done.error());
    return insert.insertedId();
}

Result<std::vector<std::string>> textsOf(const ProjectConnection &connection, const QString &sql)
{
    std::vector<std::string> texts;
    Statement select(connection, sql);
    auto read = select.eachRow([&texts](const Statement &row) -> Result<void> {
        texts.push_back(row.name(0));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return texts;
}

Result<void> runFor(const ProjectConnection &connection, const char *sql, RecordId id)
{
    Statement statement(connection, QString::fromLatin1(sql));
    return statement.bind(id).run();
}

} // namespace odo
