// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/completion/completion.h"
#include "app/guarded_application.h"
#include "app/workbench.h"
#include "core/base/error.h"
#include "core/base/plain_text.h"
#include "core/base/platform/crash_handler.h"
#include "core/base/platform/process.h"
#include "core/base/platform/user_folders.h"
#include "core/base/shortage.h"
#include "core/project/project_rescue.h"

#include <QApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstring>
#include <new>

namespace {

using namespace odo;

/// As a desktop calls it, where nobody sees a terminal.
constexpr const char *windowOption = "--window";

constexpr int exitDone = 0, exitFailed = 1, exitWrongCall = 2;

void printHelp()
{
    std::puts("odograph [PROJECT.odo]           open the workbench\n"
              "odograph --window [PROJECT.odo]  the same, but show problems with the project in the window\n"
              "odograph COMMAND ...             run without a window; odograph help COMMAND shows how\n");
    for (const NamedCommand &command : allCommands())
        std::printf("  %-14s %s\n", command.name, command.summary);
}

/// Files and answers are written with a point, whatever the locale; what a person reads goes through QLocale.
void keepNumbersPlain()
{
    std::setlocale(LC_NUMERIC, "C");
}

/// For the shells: silent whatever happens, and nothing is written but the answer.
int runCompletion(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    keepNumbersPlain();
    return answerCompletion(QCoreApplication::arguments().mid(2)) ? exitDone : exitFailed;
}

bool isJsonAsked = false, isOutputClosed = false;

void printJson(const Error &error)
{
    try {
        std::fputs(QJsonDocument(errorJson(error)).toJson().constData(), stdout);
        std::fflush(stdout);
    } catch (const std::bad_alloc &) { // the line on standard error says it
    }
}

int report(const Result<void> &result)
{
    if (result)
        return exitDone;
    std::fprintf(stderr, "odograph: %s\n", result.error().message().c_str());
    if (isJsonAsked && !CommandCall::hasAnswered())
        printJson(result.error());
    switch (result.error().code) {
    case ErrorCode::WrongCall:
        return exitWrongCall;
    case ErrorCode::Cancelled:
        return exitStatusOfStop();
    default:
        return exitFailed;
    }
}

/// Standard error belongs to our one line; Qt's remarks on platform plugins are for nobody there.
void dropRemarks(QtMsgType type, const QMessageLogContext &, const QString &message)
{
    if ((type == QtCriticalMsg || type == QtFatalMsg) && !shortageNowOfSystem()) // which we report ourselves
        std::fprintf(stderr, "odograph: %s\n", plainLine(message.toStdString()).c_str());
}

/// Whoever reads the answer must not take half of it for the whole.
Result<void> printed()
{
    errno = isOutputClosed ? EBADF : 0;
    if (!isOutputClosed && std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
        return {};
    const Message why = errno != 0 ? ODO_TEXT("app.answer_not_written_as", "it could not be written (%1)")(
                                         foreignWords(std::strerror(errno)))
                                   : ODO_TEXT("app.answer_not_written", "it could not be written");
    return fail(ErrorCode::Io, ODO_TEXT("app.answer", "the output"), why,
                ODO_TEXT("app.ask_again", "the command succeeded; free some disk space and repeat it"));
}

/// If a command was stopped, what it was doing just then does not matter, and would look like the cause.
Result<void> ofCommand(const char *name, Result<void> failed)
{
    const Error stopped = cancelled(nameAlone(std::string(name))).value();
    if (failed.error().code == ErrorCode::Cancelled && failed.error().why == stopped.why)
        failed.error().what = stopped.what;
    return failed;
}

int runCommand(const NamedCommand &command, int argc, char **argv)
{
    qInstallMessageHandler(dropRemarks);
    watchStopSignals();
    qputenv("QT_NO_GLIB", "1");              // which would write of its own where files run out
    constexpr std::size_t filesOfEvents = 2; // Qt's pipe, which must be had
    needFiles(filesOfEvents);
    std::unique_ptr<QCoreApplication> application;
    const auto says = [&](const char *word) {
        return std::any_of(argv, argv + argc, [word](const char *a) { return std::strcmp(a, word) == 0; });
    };
    const bool opensWindow = says("--open");
    const bool paints = command.needsWindow ||
                        (command.run == runExport &&
                         (says("video") || says("--format=video") || says("html") || says("--format=html")));
    if (paints) {
        // An image of the window needs no display, and must look the same with one.
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application = std::make_unique<QApplication>(argc, argv);
    } else if (opensWindow) {
        application = std::make_unique<QApplication>(argc, argv);
    } else {
        application = std::make_unique<QCoreApplication>(argc, argv);
    }
    QCoreApplication::setApplicationName(QStringLiteral("odograph"));
    keepNumbersPlain();
    if (paints || opensWindow)
        keepPaintersReady();
    const Result<void> done = orShortage(nameAlone(std::string(command.name)), [&] {
        return command.run(QCoreApplication::arguments().mid(2), stopToken());
    });
    return report(done ? printed() : ofCommand(command.name, done));
}

int openWorkbench(int argc, char **argv)
{
    GuardedApplication application(argc, argv);
    // its settings lie in a folder of that name
    QCoreApplication::setOrganizationName(QStringLiteral("odograph"));
    QCoreApplication::setApplicationName(QStringLiteral("odograph"));
    keepNumbersPlain();
    watchStopSignals();
    keepPaintersReady();
    QStringList arguments = QCoreApplication::arguments().mid(1);
    const bool hasTerminal = arguments.removeAll(QLatin1String(windowOption)) == 0;
    const auto project = arguments.isEmpty()
                             ? std::nullopt
                             : std::optional<std::filesystem::path>(arguments.first().toStdString());
    if (project && hasTerminal) {
        if (auto worth = worthOpening(*project); !worth)
            return report(worth); // without a window
    }
    runWorkbench(project);
    return exitDone;
}

int run(int argc, char **argv)
{
    if (argc > 1 && std::strcmp(argv[1], completionCommand) == 0)
        return runCompletion(argc, argv);
    shareMemoryPools();
    // where it cannot, the program does its work all the same
    watchForCrashes(stateFolder(), ODOGRAPH_VERSION);
    dropSenselessScales();
    for (int i = 1; i < argc; ++i) {
        // Qt would make another name of it.
        if (!QUtf8StringView(argv[i]).isValidUtf8())
            return report(fail(ErrorCode::WrongCall, quotedName(std::string(argv[i])),
                               ODO_TEXT("app.not_utf8", "it is not valid UTF-8"),
                               ODO_TEXT("app.rename_file", "rename the file or folder")));
    }
    const std::string_view first = argc > 1 ? argv[1] : "";
    if (first == "--help" || first == "-h" || first == "help") {
        printHelp();
        return report(printed());
    }
    if (first == "--version") {
        std::puts("odograph " ODOGRAPH_VERSION);
        return report(printed());
    }
    for (const NamedCommand &command : allCommands()) {
        if (first == command.name)
            return runCommand(command, argc, argv);
    }
    const bool isProject =
        first.ends_with(".odo") || QFileInfo(QString::fromLocal8Bit(argc > 1 ? argv[1] : "")).isFile();
    if (argc == 1 || (argc == 2 && isProject) || (argc <= 3 && first == windowOption))
        return openWorkbench(argc, argv);
    return report(fail(ErrorCode::WrongCall, quotedName(std::string(first)),
                       ODO_TEXT("app.neither_command_nor_project", "neither a command nor a project"),
                       ODO_TEXT("app.see_help", "see odograph help")));
}

} // namespace

int main(int argc, char **argv)
{
    static char option[] = "--help";
    if (argc > 2 && std::strcmp(argv[1], "help") == 0) { // help COMMAND is COMMAND --help
        std::rotate(argv + 1, argv + 2, argv + argc);
        argv[argc - 1] = option;
    }
    isOutputClosed = openStandardFiles();
    isJsonAsked =
        std::any_of(argv + 1, argv + argc, [](const char *word) { return std::strcmp(word, "--json") == 0; });
    treatFileLimitAsError();
    catchWhatNobodyCatches();
    try {
        return run(argc, argv);
    } catch (...) {
        if (const MessageText *why = shortageBeingHandled())
            endForShortage(*why);
        return report(tl::unexpected(shortageNow(cannotDoThis())));
    }
}
