// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/commands.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/exchange/track_export.h"
#include "core/files/protected_files.h"
#include "core/project/project.h"
#include "ui/report/trial_report.h"

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QJsonObject>
#include <QList>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

namespace odo {

/// How a subcommand is called, for the parser and for the help text.
struct CommandSyntax
{
    QString name;                      ///< "robot add" is "robot"; its verb is the first positional
    QString arguments;                 ///< e.g. "P.odo TRIAL"
    int fewest = 0, most = 0;          ///< positional arguments; most < 0: any number
    QList<QCommandLineOption> options; ///< beside --json and --help, which CommandCall adds
};

/// How a command is called, as it says itself; it does nothing else. Not while another one runs.
CommandSyntax syntaxOf(Subcommand command);

/// One call of a subcommand: its arguments read and checked, and what it needs to answer.
/// A wrong call gives ErrorCode::WrongCall, which the program turns into exit status 2.
class CommandCall
{
public:
    CommandCall(CommandSyntax syntax, CancelToken cancel);

    /// False in the value: help was asked for and printed; the command has nothing to do.
    Result<bool> parse(const QStringList &arguments);

    QString positional(int index) const { return m_parser.positionalArguments().at(index); }
    QStringList positionals() const { return m_parser.positionalArguments(); }
    std::string text(int index) const { return positional(index).toStdString(); }
    bool isSet(const QString &option) const { return m_parser.isSet(option); }
    std::string value(const QString &option) const { return m_parser.value(option).toStdString(); }
    QStringList values(const QString &option) const { return m_parser.values(option); }
    std::vector<std::string> texts(const QString &option) const;
    bool json() const { return m_parser.isSet(QStringLiteral("json")); }

    Result<double> lengthM(const QString &option) const;
    Result<double> number(const QString &option) const;
    /// "NAME=REST" split at the first '='.
    Result<std::vector<std::pair<std::string, std::string>>> pairs(const QString &option) const;
    /// "AxB" as two whole or decimal numbers.
    Result<std::pair<double, double>> sizePair(const QString &option) const;

    tl::unexpected<Error> wrongCall(Message why) const;
    /// That an option which the command needs was not given.
    tl::unexpected<Error> missing(const QString &option) const;
    /// That an option was given without another one that it goes with.
    tl::unexpected<Error> lacks(const QString &option, const QString &needed) const;
    /// That the value of an option is none of those that it may have: "a, b or c".
    tl::unexpected<Error> isNoneOf(const QString &option, const char *words) const;
    /// That two options were given of which only one may be.
    tl::unexpected<Error> exclude(const QString &option, const QString &other) const;
    /// That the first positional argument is none of the command's verbs.
    tl::unexpected<Error> verbNotKnown() const;

    /// The project named by a positional argument. To be written: with a warning for each trial whose
    /// recording was cut off, which is completed first.
    Result<std::unique_ptr<Project>> openProject(int index, Project::Access access) const;

    /// What must not be overwritten while this call lasts, besides the files that it was given.
    InputFiles &recordings() const { return *m_recordings; }

    /// Cancelled by Ctrl-C; progress to standard error when it is a terminal.
    const JobControl &control() const { return m_control; }

    /// Prints one JSON object, or the text for people.
    void answer(const QJsonObject &json, const QString &text) const;
    /// Whether answer() was called, by any call.
    static bool hasAnswered();
    /// One line to standard error, in the form of an error, of something that did not stop the command.
    static void warn(const Message &message);
    static void warnOf(const Error &error);

private:
    CommandSyntax m_syntax;
    QCommandLineParser m_parser;
    JobControl m_control;
    InputFiles m_inputs;
    const std::unique_ptr<InputFiles> m_recordings =
        std::make_unique<InputFiles>(ODO_TEXT("app.is_recording", "it is a recording of the project"));
};

} // namespace odo

namespace odo::option {

// What the options of the subcommands are called, without their dashes.

inline const QString adopt = QStringLiteral("adopt");
inline const QString again = QStringLiteral("again");
inline const QString address = QStringLiteral("address");
inline const QString align = QStringLiteral("align");
inline const QString at = QStringLiteral("at");
inline const QString axes = QStringLiteral("axes");
inline const QString bench = QStringLiteral("bench");
inline const QString board = QStringLiteral("board");
inline const QString entry = QStringLiteral("entry");
inline const QString box = QStringLiteral("box");
inline const QString camera = QStringLiteral("camera");
inline const QString clear = QStringLiteral("clear");
inline const QString clearGuidance = QStringLiteral("clear-guidance");
inline const QString colour = QStringLiteral("colour");
inline const QString columns = QStringLiteral("columns");
inline const QString csvStyle = QStringLiteral("csv-style");
inline const QString date = QStringLiteral("date");
inline const QString decimal = QStringLiteral("decimal");
inline const QString delta = QStringLiteral("delta");
inline const QString device = QStringLiteral("device");
inline const QString filesOfA = QStringLiteral("a");
inline const QString filesOfB = QStringLiteral("b");
inline const QString find = QStringLiteral("find");
inline const QString force = QStringLiteral("force");
inline const QString format = QStringLiteral("format");
inline const QString formula = QStringLiteral("formula");
inline const QString frame = QStringLiteral("frame");
inline const QString height = QStringLiteral("height");
inline const QString hidden = QStringLiteral("hidden");
inline const QString hint = QStringLiteral("hint");
inline const QString ignore = QStringLiteral("ignore");
inline const QString image = QStringLiteral("image");
inline const QString joint = QStringLiteral("joint");
inline const QString keep = QStringLiteral("keep");
inline const QString labels = QStringLiteral("labels");
inline const QString language = QStringLiteral("language");
inline const QString layout = QStringLiteral("layout");
inline const QString log = QStringLiteral("log");
inline const QString logo = QStringLiteral("logo");
inline const QString media = QStringLiteral("media");
inline const QString method = QStringLiteral("method");
inline const QString metric = QStringLiteral("metric");
inline const QString metrics = QStringLiteral("metrics");
inline const QString minConfidence = QStringLiteral("min-confidence");
inline const QString mode = QStringLiteral("mode");
inline const QString model = QStringLiteral("model");
inline const QString name = QStringLiteral("name");
inline const QString note = QStringLiteral("note");
inline const QString ofClass = QStringLiteral("class");
inline const QString offset = QStringLiteral("offset");
inline const QString open = QStringLiteral("open");
inline const QString origin = QStringLiteral("origin");
inline const QString originAt = QStringLiteral("origin-at");
inline const QString output = QStringLiteral("output");
inline const QString paper = QStringLiteral("paper");
inline const QString pattern = QStringLiteral("pattern");
inline const QString pick = QStringLiteral("pick");
inline const QString pixel = QStringLiteral("pixel");
inline const QString pixels = QStringLiteral("pixels");
inline const QString point = QStringLiteral("point");
inline const QString port = QStringLiteral("port");
inline const QString preRoll = QStringLiteral("pre-roll");
inline const QString range = QStringLiteral("range");
inline const QString rate = QStringLiteral("rate");
inline const QString reach = QStringLiteral("reach");
inline const QString reason = QStringLiteral("reason");
inline const QString recordings = QStringLiteral("recordings");
inline const QString recover = QStringLiteral("recover");
inline const QString reference = QStringLiteral("reference");
inline const QString remark = QStringLiteral("remark");
inline const QString removeStrays = QStringLiteral("remove-strays");
inline const QString reverse = QStringLiteral("reverse");
inline const QString robot = QStringLiteral("robot");
inline const QString school = QStringLiteral("school");
inline const QString search = QStringLiteral("search");
inline const QString seconds = QStringLiteral("seconds");
inline const QString seed = QStringLiteral("seed");
inline const QString sigma = QStringLiteral("sigma");
inline const QString size = QStringLiteral("size");
inline const QString smoother = QStringLiteral("smoother");
inline const QString speed = QStringLiteral("speed");
inline const QString spike = QStringLiteral("spike");
inline const QString square = QStringLiteral("square");
inline const QString sslVision = QStringLiteral("ssl-vision");
inline const QString startOn = QStringLiteral("start-on");
inline const QString stopOn = QStringLiteral("stop-on");
inline const QString sync = QStringLiteral("sync");
inline const QString checkLine = QStringLiteral("check-line");
inline const QString tape = QStringLiteral("tape");
inline const QString task = QStringLiteral("task");
inline const QString team = QStringLiteral("team");
inline const QString teams = QStringLiteral("teams");
inline const QString theme = QStringLiteral("theme");
inline const QString through = QStringLiteral("through");
inline const QString time = QStringLiteral("time");
inline const QString times = QStringLiteral("times");
inline const QString timeUnit = QStringLiteral("time-unit");
inline const QString track = QStringLiteral("track");
inline const QString trial = QStringLiteral("trial");
inline const QString turn = QStringLiteral("turn");
inline const QString unit = QStringLiteral("unit");
inline const QString use = QStringLiteral("use");
inline const QString valid = QStringLiteral("valid");
inline const QString variable = QStringLiteral("var");
inline const QString video = QStringLiteral("video");
inline const QString xAxis = QStringLiteral("x-axis");

} // namespace odo::option

namespace odo {

class CommandCall;
class Project;

/// "--force", of every command that writes a file.
QCommandLineOption forceOption();
/// "-o FILE" and "--force" (CommandOutput).
QList<QCommandLineOption> outputOptions(const QString &description);

/// --csv-style, for commands that write CSV.
QCommandLineOption csvStyleOption();
/// WrongCall where it is not known.
Result<CsvStyle> csvStyleOf(const CommandCall &call);

/// --language, for commands that write what people read: reports, images, videos. What a command answers
/// stays English.
QCommandLineOption languageOption();
/// Installs it (language.h). WrongCall where it is not known.
Result<void> applyLanguage(const CommandCall &call);

/// --paper, --school, --logo, --remark, --method, --language: the options of all commands that write a
/// report.
QList<QCommandLineOption> reportOptionSyntax();
/// Installs the language. WrongCall for a paper or language that is not known; Io for a logo that cannot be
/// read.
Result<ReportOptions> readReportOptions(const CommandCall &call);

} // namespace odo
