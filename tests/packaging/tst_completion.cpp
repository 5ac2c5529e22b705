// SPDX-License-Identifier: GPL-3.0-or-later
// What the Tab key gives in bash, zsh and fish, each run as a person runs it: on a terminal of its own.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int longestWaitMs = 20'000;
const QByteArray prompt = "ready> ", endOfAnswer = "end of words\n", runEnd = "the words were kept";

QString completionFile(const char *name)
{
    return qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + QStringLiteral("/packaging/desktop/completion/") +
           QLatin1String(name);
}

/// A shell at a terminal, and the pipe `answer` in its folder, through which a command says what it was
/// called with.
class TerminalShell
{
public:
    TerminalShell(const QStringList &call, const QString &folder)
    {
        const QByteArray pipe = (folder + QStringLiteral("/answer")).toUtf8();
        static_cast<void>(::mkfifo(pipe.constData(), 0600));
        m_answers = ::open(pipe.constData(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
        m_child = ::forkpty(&m_terminal, nullptr, nullptr, nullptr);
        if (m_child == 0)
            become(call, folder);
        waitUntil([this] { // the shell's own prompt
            return std::ranges::any_of(std::array{"$ ", "% ", "> ", "# "},
                                       [this](const char *end) { return m_screen.contains(end); });
        });
    }
    ~TerminalShell()
    {
        ::close(m_terminal);
        ::close(m_answers);
        ::kill(m_child, SIGKILL);
        ::waitpid(m_child, nullptr, 0);
    }
    void type(const QString &keys)
    {
        const QByteArray bytes = keys.toUtf8();
        QCOMPARE(::write(m_terminal, bytes.constData(), std::size_t(bytes.size())), bytes.size());
    }
    bool waitForPrompt()
    {
        return waitUntil([this] { return m_screen.contains(prompt); });
    }
    /// What the command that is typed last says through the pipe, when the shell can read the next line.
    QByteArray answer(qsizetype typedAt)
    {
        m_answer.clear();
        const bool isThere = waitUntil([this, typedAt] {
            const qsizetype ran = m_screen.indexOf(runEnd, typedAt);
            return m_answer.endsWith(endOfAnswer) && ran >= 0 && m_screen.indexOf(prompt, ran) >= 0;
        });
        return isThere ? m_answer.chopped(endOfAnswer.size()) : QByteArray();
    }
    QByteArray screen() const { return m_screen; }

private:
    [[noreturn]] static void become(const QStringList &call, const QString &folder)
    {
        std::vector<QByteArray> words;
        for (const QString &word : call)
            words.push_back(word.toUtf8());
        std::vector<char *> pointers;
        for (QByteArray &word : words)
            pointers.push_back(word.data());
        pointers.push_back(nullptr);
        if (::chdir(folder.toUtf8().constData()) == 0)
            ::execvp(pointers.front(), pointers.data());
        ::_exit(1);
    }
    /// Whether something was there within a time.
    bool readScreen(int waitMs)
    {
        pollfd ready[2]{{m_terminal, POLLIN, 0}, {m_answers, POLLIN, 0}};
        if (::poll(ready, 2, waitMs) <= 0)
            return false;
        char block[4096];
        if ((ready[1].revents & POLLIN) != 0) {
            if (const auto count = ::read(m_answers, block, sizeof block); count > 0)
                m_answer.append(block, count);
        }
        if ((ready[0].revents & POLLIN) == 0)
            return ready[0].revents == 0;
        const auto count = ::read(m_terminal, block, sizeof block);
        if (count <= 0)
            return false;
        m_screen.append(block, count);
        if (QByteArray(block, count).contains("\x1b[c")) // fish asks what the terminal is
            static_cast<void>(::write(m_terminal, "\x1b[?1;2c", 7));
        return true;
    }
    template <class Condition>
    bool waitUntil(const Condition &condition)
    {
        QElapsedTimer clock;
        clock.start();
        while (!condition())
            if (clock.hasExpired(longestWaitMs) || !readScreen(longestWaitMs))
                return false;
        return true;
    }

    int m_answers = -1;
    int m_terminal = -1;
    pid_t m_child = -1;
    QByteArray m_screen, m_answer;
};

const QStringList trials{QStringLiteral("stop-and-go"),       QStringLiteral("circle"),
                         QStringLiteral("circle with rover"), QStringLiteral("Müller läuft"),
                         QStringLiteral("It's Tom's run"),    QStringLiteral("He said \"go\" $HOME! \\o/"),
                         QStringLiteral("t1:a=b@c"),          QStringLiteral("50% & more; *x*")};

} // namespace

class TestCompletion : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QString m_project;

    /// The words of a line that Tab has completed, behind the program's name.
    QStringList completedLine(TerminalShell &shell, const QString &line)
    {
        // the shell reads the keys behind the Tab when it has completed the line
        const qsizetype typedAt = shell.screen().size();
        shell.type(line + QStringLiteral("\t\x01./keep \r"));
        const QByteArray words = shell.answer(typedAt);
        if (words.isEmpty())
            return {QStringLiteral("nothing: ") + QString::fromUtf8(shell.screen().right(400))};
        const QStringList lines = QString::fromUtf8(words).split(u'\n');
        return lines.mid(1, lines.size() - 2);
    }
    static QStringList wordsFor(const QStringList &words)
    {
        const ProgramRun run =
            runProgram(QStringList{QStringLiteral("complete"), QStringLiteral("words")} + words);
        QStringList lines = QString::fromUtf8(run.out).split(u'\n', Qt::SkipEmptyParts);
        for (QString &line : lines)
            line = line.section(u'\t', 0, 0);
        return run.err.isEmpty() ? lines : QStringList{QString::fromUtf8(run.err)};
    }
    QStringList contents() const
    {
        QStringList all;
        for (const QFileInfo &file :
             QDir(m_folder.path()).entryInfoList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot))
            all << file.fileName() + QString::fromLatin1(fileHash(file.filePath()).toHex());
        return all;
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = m_folder.filePath(QStringLiteral("my class.odo"));
        const auto project = Project::create(m_project.toStdString(), "A class");
        QVERIFY(project.has_value());
        CameraRecord camera;
        camera.name = "A";
        QVERIFY((*project)->cameras().add(camera).has_value());
        for (const QString &name : trials) {
            TrialRecord trial;
            trial.name = name.toStdString();
            QVERIFY((*project)->trials().add(trial, {}).has_value());
        }
        TrialRecord deleted;
        deleted.name = "deleted";
        deleted = *(*project)->trials().add(deleted, {});
        QVERIFY((*project)->trials().setBinned(deleted.id, true));
        QFile keep(m_folder.filePath(QStringLiteral("keep")));
        QVERIFY(keep.open(QIODevice::WriteOnly));
        keep.write("#!/bin/sh\nprintf '%s\\n' \"$@\" 'end of words' >answer; echo the words were kept\n");
        keep.close();
        QVERIFY(keep.setPermissions(keep.permissions() | QFileDevice::ExeOwner));
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("home")));
        qputenv("HOME", m_folder.filePath(QStringLiteral("home")).toUtf8());
        for (const char *folder : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
            qputenv(folder, qgetenv("HOME"));
        qputenv("LC_ALL", "C.UTF-8");
        qputenv("PATH",
                QFileInfo(qEnvironmentVariable("ODOGRAPH_PROGRAM")).path().toUtf8() + ':' + qgetenv("PATH"));
    }

    void theProgramKnowsWhatComesNext_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QStringList>("answer");
        const QString none = QStringLiteral("none"), show = QStringLiteral("show"), nothing;
        const auto row = [](const char *name, QStringList words, QStringList answer) {
            QTest::newRow(name) << std::move(words) << std::move(answer);
        };
        row("command", {QStringLiteral("exp")}, {QStringLiteral("projects"), QStringLiteral("export")});
        row("help of", {QStringLiteral("help"), QStringLiteral("tra")}, {none, QStringLiteral("track")});
        row("project", {show, nothing}, {QStringLiteral("projects")});
        row("trials", {show, m_project, QStringLiteral("circ")}, {none, trials[1], trials[2]});
        row("trials behind an option", {show, QStringLiteral("--json"), m_project, QStringLiteral("M")},
            {none, trials[3]});
        row("no trial twice as long", {show, m_project, trials[0], QStringLiteral("c")}, {none});
        row("any number of trials", {QStringLiteral("report"), m_project, trials[0], QStringLiteral("c")},
            {none, trials[1], trials[2]});
        row("camera", {QStringLiteral("register"), m_project, QStringLiteral("--camera"), nothing},
            {none, QStringLiteral("A")});
        row("camera and file", {QStringLiteral("import"), m_project, QStringLiteral("--video"), nothing},
            {none, QStringLiteral("A=")});
        row("file of a camera",
            {QStringLiteral("import"), m_project, QStringLiteral("--video"), QStringLiteral("A=x")},
            {QStringLiteral("files")});
        row("verb", {QStringLiteral("layout"), QStringLiteral("ex")}, {none, QStringLiteral("export")});
        row("output", {QStringLiteral("report"), m_project, QStringLiteral("-o"), nothing},
            {QStringLiteral("files")});
        row("option", {QStringLiteral("export"), m_project, trials[0], QStringLiteral("--csv")},
            {none, QStringLiteral("--csv-style")});
        row("values",
            {QStringLiteral("export"), m_project, trials[0], QStringLiteral("--format"), QStringLiteral("t")},
            {none, QStringLiteral("tum"), QStringLiteral("tracker")});
        row("value in one word", {QStringLiteral("export"), m_project, QStringLiteral("--format=t")},
            {none, QStringLiteral("--format=tum"), QStringLiteral("--format=tracker")});
        row("paper", {QStringLiteral("report"), m_project, QStringLiteral("--paper"), nothing},
            {none, QStringLiteral("a4"), QStringLiteral("letter")});
        const QString trial = QStringLiteral("trial");
        row("trials in the bin", {trial, QStringLiteral("restore"), m_project, nothing},
            {none, QStringLiteral("deleted")});
        row("trials outside of it", {trial, QStringLiteral("remove"), m_project, QStringLiteral("de")},
            {none});
        row("columns",
            {QStringLiteral("export"), m_project, trials[0], QStringLiteral("--columns"),
             QStringLiteral("fl")},
            {none, QStringLiteral("flags")});
        row("columns behind a comma",
            {QStringLiteral("export"), m_project, trials[0], QStringLiteral("--columns=t_s,v")},
            {none, QStringLiteral("--columns=t_s,vx_mm_s"), QStringLiteral("--columns=t_s,vy_mm_s"),
             QStringLiteral("--columns=t_s,views")});
        row("metrics behind a comma",
            {QStringLiteral("table"), m_project, QStringLiteral("--metrics"), QStringLiteral("duration,s")},
            {none, QStringLiteral("duration,score")});
        row("behind dashes", {show, QStringLiteral("--"), m_project, QStringLiteral("-")}, {none});
        row("no command", {QStringLiteral("nonsense"), QStringLiteral("--x")}, {none});
        row("no project", {show, m_folder.filePath(QStringLiteral("no.odo")), nothing}, {none});
        row("not a project", {show, m_folder.filePath(QStringLiteral("keep")), nothing}, {none});
        row("a folder", {show, m_folder.path(), nothing}, {none});
        row("a device", {show, QStringLiteral("/dev/zero"), nothing}, {none});
    }
    void theProgramKnowsWhatComesNext()
    {
        QFETCH(QStringList, words);
        QFETCH(QStringList, answer);
        const QStringList before = contents();
        QStringList given = wordsFor(words);
        if (given.size() > 1)
            std::sort(given.begin() + 1, given.end());
        std::sort(answer.begin() + 1, answer.end());
        QCOMPARE(given, answer);
        QCOMPARE(contents(), before);
        QVERIFY(QDir(qEnvironmentVariable("HOME")).isEmpty());
    }

    void aLogThatACrashLeftStaysAsItIs()
    {
        const QString crashed = m_folder.filePath(QStringLiteral("crashed.odo"));
        QVERIFY(QFile::copy(m_project, crashed));
        QFile log(crashed + QStringLiteral("-wal"));
        QVERIFY(log.open(QIODevice::WriteOnly) && log.write(QByteArray(40, 'x')) == 40);
        log.close();
        const QStringList before = contents();
        QCOMPARE(wordsFor({QStringLiteral("show"), crashed, QString()}), QStringList{QStringLiteral("none")});
        QCOMPARE(contents(), before);
    }

    void everyOptionOfEveryCommandIsOffered()
    {
        const ProgramRun help = runProgram({QStringLiteral("help")});
        static const QRegularExpression command(QStringLiteral("^  ([a-z-]+) +"),
                                                QRegularExpression::MultilineOption),
            option(QStringLiteral("^  (?:-\\w, )?--([a-z-]+)"), QRegularExpression::MultilineOption);
        auto commands = command.globalMatch(QString::fromUtf8(help.out));
        QVERIFY(commands.hasNext());
        const QStringList offeredCommands = wordsFor({QString()});
        while (commands.hasNext()) {
            const QString name = commands.next().captured(1);
            QVERIFY2(offeredCommands.contains(name), qPrintable(name));
            const QStringList offered = wordsFor({name, QStringLiteral("--")});
            auto options =
                option.globalMatch(QString::fromUtf8(runProgram({QStringLiteral("help"), name}).out)
                                       .section(QStringLiteral("Options:"), 1));
            QVERIFY2(options.hasNext(), qPrintable(name));
            while (options.hasNext()) {
                const QString word = QStringLiteral("--") + options.next().captured(1);
                QVERIFY2(offered.contains(word), qPrintable(name + u' ' + word));
            }
        }
    }

    void wrongCallsAreSilent()
    {
        for (const QStringList &words : {QStringList{},
                                         {QStringLiteral("words")},
                                         {QStringLiteral("bash")},
                                         {QStringLiteral("bash"), QStringLiteral("odograph")},
                                         {QStringLiteral("csh"), QStringLiteral("--json")}}) {
            const ProgramRun run = runProgram(QStringList{QStringLiteral("complete")} + words);
            QCOMPARE(run.exitStatus, 1);
            QVERIFY2(run.out.isEmpty() && run.err.isEmpty(), (run.out + run.err).constData());
        }
    }

    void shellsCompleteLines_data()
    {
        QTest::addColumn<QStringList>("shell");
        QTest::addColumn<QString>("prepare");
        QTest::newRow("bash") << QStringList{QStringLiteral("bash"), QStringLiteral("--norc"),
                                             QStringLiteral("--noprofile"), QStringLiteral("-i")}
                              << QStringLiteral("source '%1'").arg(completionFile("odograph.bash"));
        QTest::newRow("zsh") << QStringList{QStringLiteral("zsh"), QStringLiteral("-f"), QStringLiteral("-i")}
                             << QStringLiteral("fpath=('%1' $fpath); autoload -Uz compinit; compinit -D -u")
                                    .arg(completionFile(""));
        QTest::newRow("fish") << QStringList{QStringLiteral("fish"), QStringLiteral("-N"),
                                             QStringLiteral("-i")}
                              << QStringLiteral("source '%1'").arg(completionFile("odograph.fish"));
    }
    void shellsCompleteLines()
    {
        QFETCH(QStringList, shell);
        QFETCH(QString, prepare);
        if (QStandardPaths::findExecutable(shell.first()).isEmpty())
            QSKIP("this shell is not installed");
        qputenv("TERM", shell.first() == u"fish" ? "xterm" : "dumb");
        TerminalShell terminal(shell, m_folder.path());
        // the prompt that it then shows is not what is typed
        const QString shown = shell.first() == u"fish"
                                  ? QStringLiteral("; function fish_prompt; echo -n rea'dy> '; end\r")
                                  : QStringLiteral("; PS1=rea'dy> '\r");
        terminal.type(prepare + shown);
        QVERIFY2(terminal.waitForPrompt(), terminal.screen().constData());
        const QString show = QStringLiteral("show"), project = QStringLiteral("my class.odo");
        const QString before = QStringLiteral("odograph show 'my class.odo' ");
        QCOMPARE(completedLine(terminal, QStringLiteral("odograph expo")),
                 QStringList{QStringLiteral("export")});
        QCOMPARE(completedLine(terminal, QStringLiteral("odograph show my")), (QStringList{show, project}));
        const std::pair<const char *, QString> lines[] = {
            {"stop", trials[0]},      {"circle\\ w", trials[2]}, {"\"circle w", trials[2]},
            {"'circle w", trials[2]}, {"Müll", trials[3]},       {"It\\'s", trials[4]},
            {"\"It's", trials[4]},    {"He", trials[5]},         {"t1", trials[6]},
            {"t1:", trials[6]},       {"50", trials[7]},         {"\"50", trials[7]}};
        for (const auto &[typed, trial] : lines)
            QCOMPARE(completedLine(terminal, before + QString::fromUtf8(typed)),
                     (QStringList{show, project, trial}));
        QCOMPARE(
            completedLine(terminal, QStringLiteral("odograph calibrate 'my class.odo' A kee")),
            (QStringList{QStringLiteral("calibrate"), project, QStringLiteral("A"), QStringLiteral("keep")}));
        QCOMPARE(completedLine(terminal, QStringLiteral("odograph import my\\ class.odo --video A=kee")),
                 (QStringList{QStringLiteral("import"), project, QStringLiteral("--video"),
                              QStringLiteral("A=keep")}));
    }
};

ODOGRAPH_TEST(TestCompletion, QCoreApplication)
#include "tst_completion.moc"
