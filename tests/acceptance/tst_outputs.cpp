// SPDX-License-Identifier: GPL-3.0-or-later
// Every command that writes a file against everything that no output may take the place of.
// ODOGRAPH_MUTATIONS: how many calls are drawn out of all combinations instead of the few of each run.
#include "core/video/video_reader.h"
#include "tests/support/demo_lesson.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <memory>
#include <random>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

using namespace odo::test;
namespace fs = std::filesystem;

namespace {

/// How a protected file is called. %1 is the lesson's folder, %2 the file's name in it.
struct Spelling
{
    const char *name;
    const char *text;    ///< what is written on the command line
    const char *linksTo; ///< of the link "%1/link" that is made first; null: none
    bool isHardLink = false;
};
constexpr Spelling spellings[] = {{"plain", "%1/%2", nullptr},
                                  {"dots", "%1/./sub/../%2", nullptr},
                                  {"slashes", "%1//%2", nullptr},
                                  {"linked folder", "%1/sub/up/%2", nullptr},
                                  {"absolute link", "%1/link", "%1/%2"},
                                  {"relative link", "%1/link", "./%2"},
                                  {"link through a folder", "%1/sub/up/link", "sub/up/%2"},
                                  {"hard link", "%1/link", "%1/%2", true}};

/// In the lesson's folder; what no output may take the place of, or become.
const char *const protectedNames[] = {"demo.odo",
                                      "demo.odo-wal",
                                      "demo.odo-shm",
                                      "demo.odo-journal",
                                      "demo.odo.lock",
                                      "demo.odo.bak-3",
                                      "demo.odo.damaged",
                                      "demo.media/circle_A.mkv",
                                      "demo.media/new",
                                      "demo.media/calibration/new.png",
                                      "other.odo",
                                      "foreign.db",
                                      "folder",
                                      "fifo",
                                      "device"};

/// The commands; %1 is the project, the output follows.
const QStringList &commands()
{
    static const QStringList all{QStringLiteral("export %1 circle -o"),
                                 QStringLiteral("export %1 circle --format tum -o"),
                                 QStringLiteral("export %1 circle --format json -o"),
                                 QStringLiteral("export %1 circle --format tracker -o"),
                                 QStringLiteral("export %1 circle --format html -o"),
                                 QStringLiteral("export %1 straight --format video --size 320x180 -o"),
                                 QStringLiteral("report %1 circle -o"),
                                 QStringLiteral("compare %1 figure-eight figure-eight_with_reflections -o"),
                                 QStringLiteral("snapshot %1 circle -o"),
                                 QStringLiteral("target tags -o"),
                                 QStringLiteral("layout export %1 Gym_floor"),
                                 QStringLiteral("intrinsics export %1 A")};
    return all;
}

struct Mutation
{
    int command = 0, thing = 0, spelling = 0;
    bool force = false;
};

/// So many that each command, thing and spelling comes up.
constexpr int fewMutations = 2 * int(std::size(protectedNames));

/// The nth of them, and after those any, drawn with a seed.
Mutation mutation(int n)
{
    if (n < fewMutations)
        return {n % int(commands().size()), n % int(std::size(protectedNames)), n % int(std::size(spellings)),
                n % 2 == 1};
    static std::mt19937 random(32);
    const auto below = [&](std::size_t count) { return static_cast<int>(random() % count); };
    return {below(std::size_t(commands().size())), below(std::size(protectedNames)),
            below(std::size(spellings)), below(2) == 1};
}

} // namespace

class TestOutputs : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QString m_project;
    int m_calls = 0; ///< that were made: not everything can be linked to

    QString path(const QString &name) const { return m_folder.filePath(name); }
    QStringList callOf(const QString &command) const
    {
        QStringList arguments = QString(command).replace(QStringLiteral("%1"), m_project).split(u' ');
        for (QString &argument : arguments)
            if (argument != m_project)
                argument.replace(u'_', u' ');
        return arguments;
    }
    /// All that is there: names, kinds, sizes, times and identities.
    QStringList content() const
    {
        QStringList all;
        QDirIterator each(m_folder.path(),
                          QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                          QDirIterator::Subdirectories);
        while (each.hasNext()) {
            struct stat status
            {
            };
            const QString name = each.next();
            if (::lstat(name.toLocal8Bit().constData(), &status) != 0)
                continue;
            const bool isFolder = S_ISDIR(status.st_mode); // its time tells of what came and went
            all << QStringLiteral("%1 %2 %3 %4 %5")
                       .arg(name)
                       .arg(status.st_mode)
                       .arg(status.st_ino)
                       .arg(isFolder ? 0 : status.st_size)
                       .arg(isFolder ? 0 : status.st_mtim.tv_sec * 1'000'000'000 + status.st_mtim.tv_nsec);
        }
        all.sort();
        return all;
    }
    /// 0 where the video cannot be read to its end.
    static std::size_t frameCount(const QString &file)
    {
        const auto video = odo::VideoReader::open(file.toStdString());
        return video && (*video)->info().frameTimes.size() > 1 &&
                       (*video)->frameAt(std::int64_t((*video)->info().frameTimes.size()) - 1)
                   ? (*video)->info().frameTimes.size()
                   : 0;
    }
    /// Empty: refused in one line, and nothing is otherwise than it was.
    QString wrong(const Mutation &mutated)
    {
        const Spelling &spelling = spellings[mutated.spelling];
        const QString thing = QString::fromUtf8(protectedNames[mutated.thing]);
        const auto fill = [&](const char *text) {
            return QString::fromUtf8(text)
                .replace(QStringLiteral("%1"), m_folder.path())
                .replace(QStringLiteral("%2"), thing);
        };
        const fs::path link = path(QStringLiteral("link")).toStdString();
        std::error_code problem;
        fs::remove(link, problem);
        if (spelling.isHardLink)
            fs::create_hard_link(fill(spelling.linksTo).toStdString(), link, problem);
        else if (spelling.linksTo)
            fs::create_symlink(fill(spelling.linksTo).toStdString(), link, problem);
        if (problem) // there is nothing to link to, or no file
            return {};
        const QStringList before = content();
        QStringList call = callOf(commands().at(mutated.command)) << fill(spelling.text);
        if (mutated.force)
            call << QStringLiteral("--force");
        const ProgramRun run = runProgram(call);
        ++m_calls;
        const QString words =
            call.join(u' ') + QStringLiteral(" (") + QString::fromUtf8(spelling.name) + QStringLiteral("): ");
        if (run.exitStatus != 2 || !run.out.isEmpty())
            return words + QStringLiteral("status %1, %2")
                               .arg(run.exitStatus)
                               .arg(QString::fromUtf8(run.out + run.err));
        if (!run.err.startsWith("odograph: file '") || run.err.count('\n') != 1 ||
            !run.err.contains(": it is ") || !run.err.endsWith("; choose another name\n"))
            return words + QString::fromUtf8(run.err);
        if (const QStringList after = content(); after != before)
            return words + QStringLiteral("changed the folder:\n") + before.join(u'\n') +
                   QStringLiteral("\n---\n") + after.join(u'\n');
        return {};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(provideDemoLesson(m_folder.path()), QString());
        m_project = path(QStringLiteral("demo.odo"));
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("folder")) &&
                QDir(m_folder.path()).mkpath(QStringLiteral("sub")));
        QVERIFY(QFile::copy(m_project, path(QStringLiteral("other.odo"))) &&
                QFile::copy(m_project, path(QStringLiteral("demo.odo.bak-3"))));
        const auto write = [&](const char *name, const QByteArray &bytes) {
            QFile file(path(QString::fromUtf8(name)));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        };
        write("demo.odo.damaged", "t_s,x_mm\n");
        write("foreign.db", QByteArray("SQLite format 3").append(200, '\0'));
        fs::create_symlink("..", path(QStringLiteral("sub/up")).toStdString());
        QCOMPARE(::mkfifo(path(QStringLiteral("fifo")).toLocal8Bit().constData(), 0600), 0);
        // One of its own: an administrator could lose the real one. Others can make none, and use a link to
        // it.
        if (::mknod(path(QStringLiteral("device")).toLocal8Bit().constData(), S_IFCHR | 0600,
                    ::makedev(1, 3)) != 0)
            fs::create_symlink("/dev/null", path(QStringLiteral("device")).toStdString());
    }

    void nothingTakesThePlaceOfWhatMustStay()
    {
        const QByteArray project = fileHash(m_project),
                         video = fileHash(path(QStringLiteral("demo.media/circle_A.mkv")));
        const int asked = qEnvironmentVariableIntValue("ODOGRAPH_MUTATIONS");
        for (int n = 0; n < fewMutations || m_calls < asked; ++n) {
            const QString what = wrong(mutation(n));
            QVERIFY2(what.isEmpty(), qPrintable(what));
        }
        QVERIFY(m_calls > fewMutations / 2);
        QFile::remove(path(QStringLiteral("link")));
        QCOMPARE(fileHash(m_project), project);
        QCOMPARE(fileHash(path(QStringLiteral("demo.media/circle_A.mkv"))), video);
        qInfo("%d calls were refused, and nothing was changed", m_calls);
    }

    void inputsStay()
    {
        const QString logo = path(QStringLiteral("logo.png"));
        QVERIFY(QFile::copy(path(QStringLiteral("calibration/A_01.png")), logo));
        const QByteArray before = fileHash(logo);
        for (const QString &command :
             {QStringLiteral("report %1 circle --force --logo"),
              QStringLiteral("compare %1 figure-eight figure-eight_with_reflections --force --logo")}) {
            const ProgramRun run = runProgram(callOf(command) << logo << QStringLiteral("-o")
                                                              << path(QStringLiteral("sub/../logo.png")));
            QVERIFY2(run.exitStatus == 2 &&
                         run.err.contains("it is an input of the same command; choose another name"),
                     run.err);
        }
        QCOMPARE(fileHash(logo), before);
    }

    void recordingsElsewhereStay()
    {
        // The videos of a copy are in the media folder of the original; without that they are nobody's by
        // their place.
        QTemporaryDir elsewhere;
        const QString copy = elsewhere.filePath(QStringLiteral("copy.odo"));
        const QString media = elsewhere.filePath(QStringLiteral("demo.media"));
        QVERIFY(QFile::copy(m_project, copy));
        fs::create_directory(media.toStdString());
        const QString video = media + QStringLiteral("/circle_A.mkv");
        QVERIFY(QFile::copy(path(QStringLiteral("demo.media/circle_A.mkv")), video));
        const QByteArray before = fileHash(video);
        const ProgramRun run = runProgram({QStringLiteral("export"), copy, QStringLiteral("circle"),
                                           QStringLiteral("-o"), video, QStringLiteral("--force")});
        QVERIFY2(run.exitStatus == 2 &&
                     run.err.contains("it is a recording of the project; choose another name"),
                 run.err);
        QCOMPARE(fileHash(video), before);
    }

    void theSameKindIsReplacedAndAnotherWithForceOnly()
    {
        for (const QString &command : commands()) {
            const bool isVideo = command.contains(QLatin1String("video")),
                       isImage = command.startsWith(QLatin1String("snapshot"));
            const QString file = path(QStringLiteral("out/") + (isVideo   ? QStringLiteral("o.mp4")
                                                                : isImage ? QStringLiteral("o.png")
                                                                          : QStringLiteral("o")));
            QDir(m_folder.path()).mkpath(QStringLiteral("out"));
            const auto run = [&](const QStringList &more) {
                return runProgram(callOf(command) << file << more);
            };
            const auto write = [&](const QByteArray &bytes) {
                QFile old(file);
                QVERIFY(old.open(QIODevice::WriteOnly) && old.write(bytes) == bytes.size());
            };
            write("");
            QVERIFY2(run({}).exitStatus == 0, qPrintable(command)); // an empty file is of any kind
            QVERIFY2(run({}).exitStatus == 0, qPrintable(command));
            write("a letter to nobody");
            const ProgramRun refused = run({});
            QVERIFY2(refused.exitStatus == 2 &&
                         refused.err.contains("a file of another kind has that name; choose another name, or "
                                              "replace it with --force"),
                     refused.err);
            QFile kept(file);
            QVERIFY(kept.open(QIODevice::ReadOnly));
            QCOMPARE(kept.readAll(), QByteArray("a letter to nobody"));
            QVERIFY2(run({QStringLiteral("--force")}).exitStatus == 0, qPrintable(command));
            QCOMPARE(QDir(path(QStringLiteral("out"))).entryList(QDir::Files | QDir::Hidden).size(), 1);
            QDir(path(QStringLiteral("out"))).removeRecursively();
        }
    }

    void manyToOneName_data()
    {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QString>("name");
        QTest::newRow("table") << QStringLiteral("export %1 circle -o") << QStringLiteral("one.csv");
        QTest::newRow("video") << QStringLiteral("export %1 straight --format video --size 320x180 -o")
                               << QStringLiteral("one.mp4");
    }
    void manyToOneName()
    {
        QFETCH(QString, command);
        QFETCH(QString, name);
        QTemporaryDir out;
        const QString file = out.filePath(name), alone = out.filePath(QStringLiteral("alone_") + name);
        QCOMPARE(runProgram(callOf(command) << alone).exitStatus, 0);
        const int count = qEnvironmentVariableIntValue("ODOGRAPH_MUTATIONS") > 0 ? 50 : 3;
        std::vector<std::unique_ptr<QProcess>> processes;
        for (int i = 0; i < count; ++i) {
            processes.push_back(std::make_unique<QProcess>());
            processes.back()->start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), callOf(command) << file);
        }
        for (const auto &process : processes) {
            QVERIFY(process->waitForFinished(600'000));
            QVERIFY2(process->exitCode() == 0, process->readAllStandardError().constData());
        }
        QCOMPARE(QDir(out.path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList({QStringLiteral("alone_") + name, name}));
        if (name.endsWith(QLatin1String("csv"))) // a video's threads share its bytes out as they come
            QCOMPARE(fileHash(file), fileHash(alone));
        else
            QCOMPARE(frameCount(file), frameCount(alone));
    }

    void whatAKillLeftIsSwept()
    {
        QTemporaryDir out;
        const QDir folder(out.path());
        const auto left = [&] {
            return folder.entryList({QStringLiteral(".odograph-*.part")}, QDir::Dirs | QDir::Hidden).size();
        };
        QProcess process;
        process.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                      callOf(QStringLiteral("export %1 circle --format video -o"))
                          << folder.filePath(QStringLiteral("a.mp4")));
        QTRY_COMPARE_WITH_TIMEOUT(left(), 1, 60'000);
        process.kill();
        QVERIFY(process.waitForFinished());
        QCOMPARE(left(), 1);
        QVERIFY(!folder.exists(QStringLiteral("a.mp4")));
        QCOMPARE(runProgram({QStringLiteral("target"), QStringLiteral("tags"), QStringLiteral("-o"),
                             folder.filePath(QStringLiteral("b.pdf"))})
                     .exitStatus,
                 0);
        QCOMPARE(folder.entryList(QDir::Files | QDir::Hidden), QStringList{QStringLiteral("b.pdf")});
    }
};

ODOGRAPH_TEST(TestOutputs, QCoreApplication)
#include "tst_outputs.moc"
