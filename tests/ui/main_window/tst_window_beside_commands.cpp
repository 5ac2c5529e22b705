// SPDX-License-Identifier: GPL-3.0-or-later
// A window that holds a project while subcommands write to it, each a process of its own; either is killed
// now and then. What either has said to be saved is there afterwards, and each sees what the other saved. The
// window is this program, called with the project: it does what is written to it, a line a deed, and says a
// line for each that is saved, or that it sees.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/program.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QSocketNotifier>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <cstdio>
#include <memory>
#include <random>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

using namespace odo;
using namespace odo::test;

namespace {

/// What the window does.
class DrivenProcess : public QObject
{
public:
    explicit DrivenProcess(const QString &file) : m_input(STDIN_FILENO, QSocketNotifier::Read)
    {
        m_window.show();
        if (!m_window.openProject(file.toStdString()))
            ::_exit(3);
        connect(&m_window.workspace(), &Workspace::changed, this, [this] { tellTrials(); });
        connect(&m_window.workspace(), &Workspace::savedChanged, this, [this] { tellSaved(); });
        connect(&m_input, &QSocketNotifier::activated, this, [this] { obey(); });
        say("open");
    }

private:
    static void say(const std::string &line)
    {
        std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    }
    Project &project() { return *m_window.workspace().project(); }
    void tellTrials()
    {
        for (const TrialName &trial : project().trials().names().value_or(std::vector<TrialName>()))
            say("sees " + trial.name);
    }
    void tellSaved()
    {
        if (m_window.workspace().isSaved() && !m_unsaved.empty())
            say("saved " + std::exchange(m_unsaved, {}));
    }
    void obey()
    {
        char line[200];
        const ssize_t length = ::read(STDIN_FILENO, line, sizeof line);
        if (length <= 0)
            return QApplication::quit();
        for (const QByteArray &deed : QByteArray(line, length).trimmed().split('\n')) {
            if (deed == "quit") {
                m_window.close();
                return QApplication::quit();
            }
            const std::string name = deed.toStdString();
            const auto done = project().change(foreignWords("add team " + name), [&]() -> Result<void> {
                const auto team = project().teams().add({0, name, ""});
                return team ? Result<void>() : tl::unexpected(team.error());
            });
            if (done)
                m_unsaved = name;
            say((done ? "changed " + name : "failed " + done.error().message()));
        }
    }

    MainWindow m_window;
    QSocketNotifier m_input;
    std::string m_unsaved;
};

/// The window's process, as the test sees it.
class Window
{
public:
    explicit Window(const QString &project)
    {
        m_process.start(QCoreApplication::applicationFilePath(), {project});
    }
    void send(const std::string &deed) { m_process.write((deed + "\n").c_str()); }
    /// Whether it says the line within that time; what it says else is remembered.
    bool says(const QByteArray &line, int withinMs)
    {
        QElapsedTimer time;
        time.start();
        while (!m_said.contains(line)) {
            const int left = withinMs - int(time.elapsed());
            if (left <= 0 || (!m_process.canReadLine() && !m_process.waitForReadyRead(left)))
                return false;
            while (m_process.canReadLine())
                m_said.insert(m_process.readLine().trimmed());
        }
        return true;
    }
    QByteArray said() const { return QByteArrayList(m_said.begin(), m_said.end()).join('\n'); }
    void kill()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    bool quits()
    {
        send("quit");
        return m_process.waitForFinished(20000) && m_process.exitStatus() == QProcess::NormalExit &&
               m_process.exitCode() == 0;
    }

private:
    QProcess m_process;
    QSet<QByteArray> m_said;
};

} // namespace

class TestWindowBesideCommands : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QFile track(m_folder.filePath(QStringLiteral("track.csv")));
        QVERIFY(track.open(QIODevice::WriteOnly));
        track.write("t_s,x_mm,y_mm\n");
        for (int i = 0; i < 180; ++i)
            track.write(QByteArray::number(i / 30.0, 'f', 4) + ',' +
                        QByteArray::number(500 * std::cos(i / 30.0), 'f', 3) + ',' +
                        QByteArray::number(500 * std::sin(i / 30.0), 'f', 3) + '\n');
    }

    void nothingThatWasSavedIsLost_data()
    {
        QTest::addColumn<int>("seed");
        bool isGiven = false;
        const int runs = qEnvironmentVariableIntValue("ODOGRAPH_RUNS", &isGiven);
        for (int seed = 0; seed < (isGiven ? runs : 6); ++seed)
            QTest::addRow("%d", seed) << seed;
    }
    void nothingThatWasSavedIsLost()
    {
        QFETCH(int, seed);
        std::mt19937 random(static_cast<unsigned>(seed) + 1);
        const QTemporaryDir folder;
        const auto file = storeExample(folder.path().toStdString());
        QVERIFY(file);
        m_project = QString::fromStdString(file->string());
        m_teams.clear();
        m_trials.clear();
        auto window = std::make_unique<Window>(m_project);
        QVERIFY(window->says("open", 20000));
        for (int step = 0; step < 8; ++step) {
            switch (random() % 6) {
            case 0:
            case 1:
                edit(*window, step, random() % 2 == 0);
                break;
            case 2:
            case 3:
                import(*window, step);
                break;
            case 4:
                killACommand(step, int(random() % 60));
                break;
            case 5:
                if (random() % 2 == 0)
                    window->kill();
                else
                    QVERIFY2(window->quits(), window->said().constData());
                expectAll();
                window = std::make_unique<Window>(m_project);
                QVERIFY(window->says("open", 20000));
                break;
            }
            if (QTest::currentTestFailed())
                return;
        }
        window->kill();
        expectAll();
    }

private:
    void edit(Window &window, int step, bool waitsUntilSaved)
    {
        const std::string name = "team " + std::to_string(step);
        window.send(name);
        QVERIFY2(window.says(QByteArray::fromStdString("changed " + name), 10000), window.said().constData());
        m_teams.insert(name); // it is in the log, which no kill of a process takes away
        if (waitsUntilSaved)
            QVERIFY2(window.says(QByteArray::fromStdString("saved " + name), 10000),
                     window.said().constData());
        const auto seen = runProgram({QStringLiteral("list"), m_project, QStringLiteral("--json")});
        QVERIFY2(seen.exitStatus == 0, seen.err.constData());
    }

    QStringList importing(int step) const
    {
        return {
            QStringLiteral("import"),  m_project,
            QStringLiteral("--trial"), QStringLiteral("beside %1").arg(step),
            QStringLiteral("--track"), QStringLiteral("R=") + m_folder.filePath(QStringLiteral("track.csv"))};
    }

    void import(Window &window, int step)
    {
        const ProgramRun done = runProgram(importing(step));
        QVERIFY2(done.exitStatus == 0, done.err.constData());
        m_trials.insert("beside " + std::to_string(step));
        constexpr int seenWithinMs = 2000;
        QVERIFY2(window.says("sees beside " + QByteArray::number(step), seenWithinMs),
                 window.said().constData());
    }

    void killACommand(int step, int afterMs) const
    {
        QProcess command;
        command.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), importing(step));
        command.waitForFinished(afterMs);
        command.kill();
        command.waitForFinished();
    }

    /// All that was acknowledged is in the project, which is sound.
    void expectAll() const
    {
        const ProgramRun check = runProgram({QStringLiteral("check"), m_project, QStringLiteral("--json")});
        QVERIFY2(!check.out.contains("damaged") && !check.err.contains("damaged"), check.out.constData());
        const auto project = Project::open(m_project.toStdString(), Project::Access::ReadOnly);
        QVERIFY2(project, project ? "" : project.error().message().c_str());
        for (const std::string &team : m_teams)
            QVERIFY2((*project)->teams().find(team), team.c_str());
        for (const std::string &trial : m_trials)
            QVERIFY2((*project)->trials().find(trial), trial.c_str());
    }

    QTemporaryDir m_folder;
    QString m_project;
    std::set<std::string> m_teams, m_trials;
};

int main(int argc, char **argv)
{
    if (argc == 2 && argv[1][0] == '/') {
        QApplication application(argc, argv);
        beginWithoutSettings();
        DrivenProcess window(QString::fromLocal8Bit(argv[1]));
        return QApplication::exec();
    }
    QCoreApplication application(argc, argv);
    TestWindowBesideCommands test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_window_beside_commands.moc"
