// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/hub_argument.h"
#include "core/base/platform/process.h"
#include "core/project/project.h"
#include "ui/scoreboard/scoreboard.h"

#include <QEventLoop>
#include <QSocketNotifier>
#include <cstdio>
#include <optional>

namespace odo {

namespace {

QList<QCommandLineOption> scoreboardSyntax()
{
    return {
        {option::port, QStringLiteral("The port to listen on; 0: any that is free."), QStringLiteral("PORT"),
         QStringLiteral("8080")},
        {option::address,
         QStringLiteral("The address to listen on: 127.0.0.1 for this computer only, one of its addresses "
                        "in a network, or 0.0.0.0 for all of them."),
         QStringLiteral("ADDRESS"), QStringLiteral("127.0.0.1")},
        {option::ofClass, QStringLiteral("The class; default: all that are not archived."),
         QStringLiteral("CLASS")},
        {option::task, QStringLiteral("The task; default: that of the newest trial."),
         QStringLiteral("TASK")},
        {option::metric,
         QStringLiteral("The metric to rank by; default: the score, or else the most informative metric."),
         QStringLiteral("METRIC")}};
}

Result<ScoreboardSettings> readSettings(const CommandCall &call)
{
    ScoreboardSettings settings;
    settings.choice = {call.value(option::ofClass), call.value(option::task), call.value(option::metric)};
    bool isNumber = false;
    settings.port = QString::fromStdString(call.value(option::port)).toUShort(&isNumber);
    if (!isNumber)
        return call.wrongCall(ODO_TEXT("app.port_is", "--port is a number from 0 to 65535"));
    const QString address = QString::fromStdString(call.value(option::address));
    settings.address =
        QHostAddress(address == QStringLiteral("localhost") ? QStringLiteral("127.0.0.1") : address);
    if (settings.address.isNull())
        return call.wrongCall(
            ODO_TEXT("app.address_is", "--address is an address as 127.0.0.1, 192.168.1.20, ::1 or 0.0.0.0"));
    return settings;
}

/// Of a project, or of the school's hub where its address is given.
Result<std::unique_ptr<Scoreboard>> startBoard(const CommandCall &call, const ScoreboardSettings &settings)
{
    const QString source = call.positional(0);
    if (source.startsWith(QStringLiteral("postgresql://")) ||
        source.startsWith(QStringLiteral("postgres://")))
        return Scoreboard::start(ODO_TRY(hubAddressAt(call, 0)), settings);
    return Scoreboard::start(ODO_TRY(call.openProject(0, Project::Access::ReadOnly)), settings);
}

QString startText(const Scoreboard &board)
{
    const QString task = QString::fromStdString(board.choice().task);
    return QStringLiteral("Standings%1: %2\n%3\nCtrl-C ends them.")
        .arg(task.isEmpty() ? QString() : QStringLiteral(" of the task '%1'").arg(task), board.url(),
             board.address().isLoopback()
                 ? QStringLiteral("Only this computer can open the page; --address 0.0.0.0 shows it to the "
                                  "whole network.")
                 : QStringLiteral("Everyone in the network can open the page."));
}

} // namespace

Result<void> runScoreboard(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("scoreboard"),
                      QStringLiteral("P.odo ... | URL [--port 8080] [--address 127.0.0.1] [--class CLASS] "
                                     "[--task TASK] [--metric METRIC]"),
                      1, 1, scoreboardSyntax()},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto settings = ODO_TRY(readSettings(call));
    const auto board = ODO_TRY(startBoard(call, settings));
    call.answer({{QStringLiteral("address"), board->address().toString()},
                 {QStringLiteral("port"), board->port()},
                 {QStringLiteral("url"), board->url()},
                 {QStringLiteral("task"), QString::fromStdString(board->choice().task)},
                 {QStringLiteral("class"), QString::fromStdString(board->choice().className)},
                 {QStringLiteral("metric"), QString::fromStdString(board->choice().metric)}},
                startText(*board));
    std::fflush(stdout); // whoever started it waits for the address

    QEventLoop loop;
    std::optional<Error> end;
    QObject::connect(board.get(), &Scoreboard::ended, &loop, [&](const Error &error) {
        end = error;
        loop.quit();
    });
    std::optional<QSocketNotifier> stop;
    if (stopDescriptor() >= 0) {
        stop.emplace(stopDescriptor(), QSocketNotifier::Read);
        QObject::connect(&*stop, &QSocketNotifier::activated, &loop, &QEventLoop::quit);
    }
    if (!cancel.isCancelled())
        loop.exec();
    return end ? Result<void>(tl::unexpected(*end)) : cancelled(nameAlone(std::string("scoreboard")));
}

} // namespace odo
