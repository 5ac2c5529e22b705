// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/names.h"

#include "core/base/error.h"
#include "core/base/plain_text.h"
#include "core/files/file_words.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"

#include <QStringDecoder>
#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

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

Message isNotUtf8()
{
    return ODO_TEXT("project.not_utf8", "it is not valid UTF-8 text");
}

Message hasCharacters(qsizetype count)
{
    return ODO_TEXT("project.has_characters", "it has %1 characters")(count);
}

Message retypeName()
{
    return ODO_TEXT("project.type_name_anew", "type the name again");
}

/// ifEmpty: the advice.
Result<void> checkNamed(const Message &what, const std::string &name, const Message &ifEmpty)
{
    const auto refuse = [&](Message why, Message advice) {
        return fail(ErrorCode::InvalidInput, what, std::move(why), std::move(advice));
    };
    const std::optional<QString> text = decode(name);
    if (!text)
        return refuse(isNotUtf8(), retypeName());
    const QList<uint> characters = text->toUcs4();
    if (characters.size() > maxNameLength)
        return refuse(hasCharacters(characters.size()), useAtMost(maxNameLength));
    if (std::any_of(characters.begin(), characters.end(), breaksLine))
        return refuse(
            ODO_TEXT("project.holds_line_break", "it holds a line break or another control character"),
            ODO_TEXT("project.use_one_line", "use a name of one line"));
    if (const auto hidden = std::ranges::find_if(characters, isInvisible); hidden != characters.end())
        return refuse(
            ODO_TEXT("project.holds_invisible", "it holds an invisible character, %1")(
                QStringLiteral("U+%1").arg(*hidden, 4, 16, QLatin1Char('0')).toUpper().toStdString()),
            retypeName());
    if (std::ranges::none_of(characters, isSeen))
        return refuse(ODO_TEXT("project.name_empty", "it is empty"), ifEmpty);
    return {};
}

Message wordOf(RecordKind kind)
{
    switch (kind) {
    case RecordKind::Camera:
        return ODO_TEXT("project.kind_camera", "camera");
    case RecordKind::Robot:
        return ODO_TEXT("project.kind_robot", "robot");
    case RecordKind::Team:
        return ODO_TEXT("project.kind_team", "team");
    case RecordKind::Class:
        return ODO_TEXT("project.kind_class", "class");
    case RecordKind::Task:
        return ODO_TEXT("project.kind_task", "task");
    case RecordKind::Trial:
        return ODO_TEXT("project.kind_trial", "trial");
    case RecordKind::Layout:
        return ODO_TEXT("project.kind_layout", "layout");
    case RecordKind::Marker:
        return ODO_TEXT("project.kind_marker", "marker");
    case RecordKind::Member:
        return ODO_TEXT("project.kind_member", "member");
    case RecordKind::Pseudonym:
        return ODO_TEXT("project.kind_pseudonym", "pseudonym");
    case RecordKind::Track:
        return ODO_TEXT("project.kind_track", "track");
    case RecordKind::Gate:
        return ODO_TEXT("project.kind_gate", "gate");
    case RecordKind::Zone:
        return ODO_TEXT("project.kind_zone", "zone");
    case RecordKind::Metric:
        return ODO_TEXT("project.kind_figure", "metric");
    case RecordKind::Tag:
        return ODO_TEXT("project.kind_tag", "tag");
    case RecordKind::Variable:
        return ODO_TEXT("project.kind_variable", "variable");
    case RecordKind::Calibration:
        return ODO_TEXT("project.kind_calibration", "calibration");
    case RecordKind::Registration:
        return ODO_TEXT("project.kind_registration", "registration");
    case RecordKind::Intrinsics:
        return ODO_TEXT("project.kind_lens", "lens calibration");
    }
    return {};
}

/// Of those that have a table of names: the table, how their names are shown, and a subject.
struct NamedTable
{
    const char *table;
    MessageArgument::Kind argument;
    Message (*subject)(std::string name);
};

NamedTable tableOf(RecordKind kind)
{
    using Argument = MessageArgument::Kind;
    switch (kind) {
    case RecordKind::Camera:
        return {"camera", Argument::Camera, cameraSubject};
    case RecordKind::Robot:
        return {"robot", Argument::Robot, robotSubject};
    case RecordKind::Team:
        return {"team", Argument::Team, teamSubject};
    case RecordKind::Class:
        return {"class", Argument::Class, classSubject};
    case RecordKind::Task:
        return {"task", Argument::Task, taskSubject};
    case RecordKind::Trial:
        return {"trial", Argument::Trial, trialSubject};
    default:
        assert(kind == RecordKind::Layout);
        return {"layout", Argument::Layout, layoutSubject};
    }
}

QString namesIn(RecordKind kind)
{
    return QStringLiteral("SELECT id, name FROM %1 ").arg(QLatin1String(tableOf(kind).table));
}

} // namespace

Message projectSubject(const std::filesystem::path &file)
{
    return ODO_TEXT("project.project", "project '%1'")(Named::file(file));
}

std::string normalName(const std::string &name)
{
    const std::optional<QString> text = decode(name);
    return text ? normal(*text).toStdString() : name; // which checkName refuses
}

Result<void> checkName(RecordKind kind, const std::string &name)
{
    return checkNamed(ODO_TEXT("project.name_of", "name of a %1")(wordOf(kind)), name,
                      ODO_TEXT("project.give_a_name", "give the %1 a name")(wordOf(kind)));
}

Result<void> checkTitle(const std::string &title)
{
    return checkNamed(ODO_TEXT("project.title", "title of the project"), title,
                      ODO_TEXT("project.give_a_title", "give the project a title"));
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

Result<void> checkText(const Message &what, const std::string &text)
{
    const std::optional<QString> decoded = decode(text);
    if (!decoded)
        return fail(ErrorCode::InvalidInput, what, isNotUtf8(),
                    ODO_TEXT("project.type_text_anew", "type the text again"));
    const qsizetype characters = decoded->toUcs4().size();
    if (characters > maxTextLength)
        return fail(ErrorCode::InvalidInput, what, hasCharacters(characters), useAtMost(maxTextLength));
    return {};
}

Result<RecordId> idNamed(const ProjectConnection &connection, RecordKind kind, const std::string &name)
{
    Statement exact(connection, namesIn(kind) + QStringLiteral("WHERE name=?"));
    const std::string wanted = normalName(name);
    const auto found = ODO_TRY(exact.bind(wanted).firstRow());
    if (found)
        return exact.integer(0);
    if (!hasOtherForms(name))
        return 0;
    RecordId other = 0; // stored by an older version, or by another program
    Statement all(connection, namesIn(kind) + QStringLiteral("ORDER BY id DESC"));
    auto read = all.eachRow([&](const Statement &row) -> Result<void> {
        if (normalName(row.name(1)) == wanted)
            other = row.integer(0);
        return {};
    });
    return read.map([other] { return other; });
}

Result<void> checkNameIsFree(const ProjectConnection &connection, RecordKind kind, const std::string &name)
{
    const auto taken = ODO_TRY(idNamed(connection, kind, name));
    if (taken != 0)
        return fail(ErrorCode::AlreadyExists, tableOf(kind).subject(shortened(name)),
                    ODO_TEXT("project.name_taken", "the project already has a %1 of that name")(wordOf(kind)),
                    chooseAnotherName());
    return {};
}

tl::unexpected<Error> noSuchName(const ProjectConnection &connection, RecordKind kind,
                                 const std::string &name)
{
    const NamedTable named = tableOf(kind);
    Statement statement(connection, namesIn(kind) + QStringLiteral("ORDER BY id"));
    std::vector<Message> names;
    int count = 0;
    const auto read = statement.eachRow([&](const Statement &row) -> Result<void> {
        if (++count <= namesToList)
            names.push_back(quotedName({named.argument, shortened(row.name(1))}));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    const bool isMore = count > namesToList;
    if (isMore)
        names.push_back(ODO_TEXT("project.more_names", "%1 more")(count - namesToList));
    using Joint = MessageArgument::Joint;
    return fail(ErrorCode::NotFound, named.subject(shortened(name)),
                ODO_TEXT("project.no_such_name", "the project has no such %1")(wordOf(kind)),
                count == 0 ? joined({ODO_TEXT("project.has_none_yet", "it has no %1 yet")(wordOf(kind)),
                                     ODO_TEXT("project.add_one_first", "add one first")},
                                    Join::Colon)
                           : ODO_TEXT("project.has_names", "it has %1")(
                                 listed(std::move(names), isMore ? Joint::And : Joint::Comma)));
}

tl::unexpected<Error> noSuchId(const ProjectConnection &connection, RecordKind kind, std::int64_t id)
{
    return fail(ErrorCode::NotFound, connection.subject(),
                ODO_TEXT("project.no_such_number", "it has no %1 with the number %2")(wordOf(kind), id),
                runProjectCheck());
}

Result<RecordId> idOfName(ProjectConnection &connection, RecordKind kind, const std::string &name)
{
    if (name.empty())
        return 0;
    const auto known = idNamed(connection, kind, name);
    if (!known || *known != 0)
        return known;
    ODO_TRY(checkName(kind, name));
    Statement insert(
        connection,
        QStringLiteral("INSERT INTO %1 (name) VALUES (?)").arg(QLatin1String(tableOf(kind).table)));
    ODO_TRY(insert.bind(normalName(name)).run());
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
