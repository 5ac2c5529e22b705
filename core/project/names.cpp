// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/names.h"

#include "core/project/connection.h"

#include <QStringDecoder>

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

} // namespace

Result<void> checkName(const std::string &kind, const std::string &name)
{
    const auto refuse = [&](const std::string &why, const std::string &advice) {
        return fail(ErrorCode::InvalidInput, "name of a " + kind, why, advice);
    };
    const std::optional<QString> text = decode(name);
    if (!text)
        return refuse("it is not valid UTF-8 text", "type the name anew");
    if (text->trimmed().isEmpty())
        return refuse("it is empty", "give the " + kind + " a name");
    const QList<uint> characters = text->toUcs4();
    if (characters.size() > maxNameLength)
        return refuse("it has " + std::to_string(characters.size()) + " characters",
                      "use at most " + std::to_string(maxNameLength));
    if (std::any_of(characters.begin(), characters.end(), breaksLine))
        return refuse("it holds a line break or another control character", "use a name of one line");
    return {};
}

Result<void> checkText(const std::string &kind, const std::string &text)
{
    if (!decode(text))
        return fail(ErrorCode::InvalidInput, kind, "it is not valid UTF-8 text", "type the text anew");
    return {};
}

Result<void> checkNameIsFree(const ProjectConnection &connection, const std::string &table,
                             const std::string &kind, const std::string &name)
{
    Statement statement(connection,
                        QStringLiteral("SELECT id FROM %1 WHERE name=?").arg(QString::fromStdString(table)));
    const auto taken = statement.bind(name).firstRow();
    if (!taken)
        return tl::unexpected(taken.error());
    if (*taken)
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
            list += (list.empty() ? "'" : ", '") + shortened(row.text(0)) + "'";
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

} // namespace odo
