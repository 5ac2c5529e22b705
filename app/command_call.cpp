// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"

#include "core/base/file_system.h"
#include "core/base/plain_text.h"
#include "core/base/platform/crash_handler.h"
#include "core/base/platform/process.h"
#include "core/base/units.h"
#include "core/project/project_rescue.h"
#include "core/project/repositories.h"
#include "core/workflow/record/completed_recordings.h"
#include "ui/main_window/language.h"
#include "ui/report/report_maker.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <algorithm>
#include <cstdio>

namespace odo {

namespace {

bool isAnswered = false;
CommandSyntax *askedSyntax = nullptr; ///< where parse() puts it instead

/// Shows progress on one line of a terminal, and clears it when the last copy is gone.
class TerminalProgress
{
public:
    ~TerminalProgress()
    {
        if (m_shown)
            std::fputs("\r\033[K", stderr);
    }
    void show(double fraction, const Message &text)
    {
        m_shown = true;
        std::fprintf(stderr, "\r\033[K%3d %%  %s", int(fraction * 100), plainLine(text.english()).c_str());
        std::fflush(stderr);
    }

private:
    bool m_shown = false;
};

} // namespace

CommandSyntax syntaxOf(Subcommand command)
{
    CommandSyntax syntax;
    askedSyntax = &syntax;
    static_cast<void>(command({}, {}));
    askedSyntax = nullptr;
    return syntax;
}

CommandCall::CommandCall(CommandSyntax syntax, CancelToken cancel) : m_syntax(std::move(syntax))
{
    m_syntax.options << QCommandLineOption(QStringLiteral("json"),
                                           QStringLiteral("Print one JSON object and nothing else."))
                     << QCommandLineOption({QStringLiteral("h"), QStringLiteral("help")},
                                           QStringLiteral("Show this help."));
    m_parser.addOptions(m_syntax.options);
    m_control.cancel = std::move(cancel);
    if (isStandardErrorSeen()) {
        m_control.progress = [terminal = std::make_shared<TerminalProgress>()](
                                 double fraction, const Message &text) { terminal->show(fraction, text); };
    }
}

Result<bool> CommandCall::parse(const QStringList &arguments)
{
    if (askedSyntax) {
        *askedSyntax = m_syntax;
        return false;
    }
    if (!m_parser.parse(QStringList(QStringLiteral("odograph ") + m_syntax.name) + arguments))
        return wrongCall(foreignWords(
            m_parser.errorText().chopped(m_parser.errorText().endsWith(u'.') ? 1 : 0).toStdString()));
    if (m_parser.isSet(QStringLiteral("help"))) {
        std::fputs(("odograph " + m_syntax.name.toStdString() + " " + m_syntax.arguments.toStdString() + "\n")
                       .c_str(),
                   stdout);
        const QString options = m_parser.helpText().section(QStringLiteral("Options:"), 1);
        std::fputs(("\nOptions:" + options.toStdString()).c_str(), stdout);
        return false;
    }
    for (const QCommandLineOption &each : m_syntax.options)
        if (each.valueName() == QStringLiteral("FILE") && !each.names().contains(option::output))
            for (const std::string &file : texts(each.names().constLast()))
                m_inputs.add(file);
    const auto count = m_parser.positionalArguments().size();
    if (count < m_syntax.fewest)
        return wrongCall(ODO_TEXT("app.something_missing", "an argument is missing"));
    if (m_syntax.most >= 0 && count > m_syntax.most)
        return wrongCall(
            ODO_TEXT("app.argument_too_many", "'%1' is one argument too many")(text(m_syntax.most)));
    return true;
}

std::vector<std::string> CommandCall::texts(const QString &option) const
{
    std::vector<std::string> all;
    for (const QString &text : values(option))
        all.push_back(text.toStdString());
    return all;
}

Result<double> CommandCall::lengthM(const QString &option) const
{
    auto length = parseLengthM(value(option));
    constexpr double longestM = 1000;
    if (!length || *length <= 0 || *length > longestM)
        return wrongCall(ODO_TEXT("app.not_a_length", "--%1 '%2' is not a length above zero and up to 1 km")(
            option.toStdString(), value(option)));
    return length;
}

Result<double> CommandCall::number(const QString &option) const
{
    auto number = parseNumber(value(option));
    if (!number)
        return wrongCall(
            ODO_TEXT("app.not_a_number", "--%1 '%2' is not a number")(option.toStdString(), value(option)));
    return number;
}

Result<std::vector<std::pair<std::string, std::string>>> CommandCall::pairs(const QString &option) const
{
    std::vector<std::pair<std::string, std::string>> all;
    for (const QString &text : values(option)) {
        const auto equals = text.indexOf(u'=');
        if (equals <= 0 || equals + 1 == text.size())
            return wrongCall(ODO_TEXT("app.not_name_and_value", "--%1 '%2' is not of the form NAME=VALUE")(
                option.toStdString(), text.toStdString()));
        all.emplace_back(text.left(equals).toStdString(), text.mid(equals + 1).toStdString());
    }
    return all;
}

Result<std::pair<double, double>> CommandCall::sizePair(const QString &option) const
{
    constexpr double largestSide = 1e6;
    const std::string text = value(option);
    const auto middle = text.find('x');
    if (middle != std::string::npos) {
        const auto first = parseNumber(std::string_view(text).substr(0, middle));
        const auto second = parseNumber(std::string_view(text).substr(middle + 1));
        if (first && second && *first > 0 && *second > 0 && std::max(*first, *second) <= largestSide)
            return std::pair(*first, *second);
    }
    return wrongCall(ODO_TEXT(
        "app.not_a_size", "--%1 '%2' is not of the form AxB, with numbers above zero and up to 1,000,000")(
        option.toStdString(), text));
}

tl::unexpected<Error> CommandCall::wrongCall(Message why) const
{
    return fail(ErrorCode::WrongCall, nameAlone(m_syntax.name.toStdString()), std::move(why),
                ODO_TEXT("app.call_as", "call it as: odograph %1 %2")(m_syntax.name.toStdString(),
                                                                      m_syntax.arguments.toStdString()));
}

tl::unexpected<Error> CommandCall::missing(const QString &option) const
{
    return wrongCall(ODO_TEXT("app.option_missing", "%1 is missing")(
        (option == option::output ? QStringLiteral("-o") : QStringLiteral("--") + option).toStdString()));
}

tl::unexpected<Error> CommandCall::lacks(const QString &option, const QString &needed) const
{
    return wrongCall(
        ODO_TEXT("app.option_needs", "--%1 needs --%2")(option.toStdString(), needed.toStdString()));
}

tl::unexpected<Error> CommandCall::isNoneOf(const QString &option, const char *words) const
{
    return wrongCall(
        ODO_TEXT("app.option_is_one_of", "--%1 is %2")(option.toStdString(), std::string(words)));
}

tl::unexpected<Error> CommandCall::exclude(const QString &option, const QString &other) const
{
    return wrongCall(ODO_TEXT("app.options_exclude", "--%1 and --%2 cannot be used together")(
        option.toStdString(), other.toStdString()));
}

tl::unexpected<Error> CommandCall::verbNotKnown() const
{
    return wrongCall(ODO_TEXT("app.verb_not_known", "'%1' is not known")(text(0)));
}

Result<std::unique_ptr<Project>> CommandCall::openProject(int index, Project::Access access) const
{
    noteOpenProject(files::absolute(text(index)));
    auto project = Project::open(text(index), access);
    if (!project || access == Project::Access::ReadOnly)
        return project;
    if (const auto warning = locationWarning((*project)->file()))
        warn(*warning);
    const auto recovered = ODO_TRY(recoverTrials(**project, m_control));
    for (const Message &told : recovered)
        warn(told);
    return project;
}

void CommandCall::answer(const QJsonObject &json, const QString &text) const
{
    const std::string out = this->json() ? QJsonDocument(json).toJson(QJsonDocument::Indented).toStdString()
                                         : plainText(text.toStdString()) + '\n';
    if (m_control.progress)
        std::fputs("\r\033[K", stderr);
    std::fwrite(out.data(), 1, out.size(), stdout);
    isAnswered = true;
}

bool CommandCall::hasAnswered()
{
    return isAnswered;
}

namespace {

void printWarning(const std::string &line)
{
    std::fprintf(stderr, "odograph: %s\n", plainLine(line).c_str());
}

} // namespace

void CommandCall::warn(const Message &message)
{
    printWarning(message.english());
}

void CommandCall::warnOf(const Error &error)
{
    printWarning(error.message());
}

QCommandLineOption forceOption()
{
    return {option::force, QStringLiteral("Replace a file of another kind as well.")};
}

QList<QCommandLineOption> outputOptions(const QString &description)
{
    return {{{QStringLiteral("o"), option::output},
             description + QStringLiteral(" - is standard output."),
             QStringLiteral("FILE")},
            forceOption()};
}

QCommandLineOption csvStyleOption()
{
    return {option::csvStyle, QStringLiteral("CSV style, by the program that reads it."),
            QStringLiteral("analysis|international|continental"), QStringLiteral("analysis")};
}

Result<CsvStyle> csvStyleOf(const CommandCall &call)
{
    const auto style = parseCsvStyle(call.value(option::csvStyle));
    if (!style)
        return call.wrongCall(
            ODO_TEXT("app.csv_style_is", "--csv-style is analysis, international or continental"));
    return *style;
}

namespace {

QStringList codes()
{
    QStringList codes;
    for (const Language &each : languages())
        codes << each.code;
    return codes;
}

} // namespace

QCommandLineOption languageOption()
{
    return {option::language, QStringLiteral("Language of the texts and numbers."), codes().join(u'|'),
            QStringLiteral("en")};
}

Result<void> applyLanguage(const CommandCall &call)
{
    const QString code = QString::fromStdString(call.value(option::language));
    if (!codes().contains(code))
        return call.wrongCall(ODO_TEXT("app.language_is_one_of", "--language is one of %1")(
            codes().join(QStringLiteral(", ")).toStdString()));
    installLanguage(*qApp, code);
    return {};
}

QList<QCommandLineOption> reportOptionSyntax()
{
    return {{option::paper, QStringLiteral("Paper size."), QStringLiteral("a4|letter"), QStringLiteral("a4")},
            {option::school, QStringLiteral("School name at the top of each page."), QStringLiteral("TEXT")},
            {option::logo, QStringLiteral("Image at the top of each page (PNG, JPEG, SVG)."),
             QStringLiteral("FILE")},
            {option::remark, QStringLiteral("A line at the bottom of each page."), QStringLiteral("TEXT")},
            {option::method,
             QStringLiteral(
                 "Adds a second page for each trial: how its metrics were computed, and what was measured.")},
            languageOption()};
}

Result<ReportOptions> readReportOptions(const CommandCall &call)
{
    ReportOptions options;
    const QString wanted = QString::fromStdString(call.value(option::paper));
    options.paper = paperFromWord(wanted);
    if (paperWord(options.paper) != wanted)
        return call.wrongCall(ODO_TEXT("app.report_paper_is", "--paper is a4 or letter"));
    options.letterhead.school = QString::fromStdString(call.value(option::school));
    options.letterhead.remark = QString::fromStdString(call.value(option::remark));
    options.withMethod = call.isSet(option::method);
    ODO_TRY(applyLanguage(call));
    if (call.isSet(option::logo)) {
        options.letterhead.logo = ODO_TRY(readLogo(call.value(option::logo)));
    }
    return options;
}

} // namespace odo
