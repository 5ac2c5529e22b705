// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/files/protected_files.h"
#include "core/project/project.h"

#include <QCommandLineParser>
#include <QJsonObject>
#include <QStringList>
#include <memory>
#include <optional>

namespace odo {

/// How a subcommand is called, for the parser and for the help text.
struct CommandSyntax
{
    QString name;      ///< "robot add" is "robot"; its verb is the first positional
    QString arguments; ///< e.g. "P.odo TRIAL"
    int fewest = 0, most = 0; ///< positional arguments; most < 0: any number
    QList<QCommandLineOption> options; ///< beside --json and --help, which every command has
};

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

    tl::unexpected<Error> wrongCall(const QString &why) const;

    /// The project named by a positional argument. To be written: with a warning for each trial whose recording was cut off, which
    /// is completed first.
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
    static void warn(const std::string &message);

private:
    CommandSyntax m_syntax;
    QCommandLineParser m_parser;
    JobControl m_control;
    InputFiles m_inputs;
    const std::unique_ptr<InputFiles> m_recordings = std::make_unique<InputFiles>("it is a recording of the project");
};

} // namespace odo
