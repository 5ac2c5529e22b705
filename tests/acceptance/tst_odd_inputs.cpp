// SPDX-License-Identifier: GPL-3.0-or-later
// What a person names as an input is no regular file: each command says at once what it is.
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QTest>
#include <filesystem>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace odo;
using namespace odo::test;

class TestOddInputs : public QObject, CallingTest
{
    Q_OBJECT

    /// "%I" stands for the input.
    static constexpr const char *calls[] = {
        "layout add %P other %I",
        "task add %P lap %I",
        "intrinsics import %P A %I",
        "register %P --camera A --layout floor --pixels %I",
        "register %P --camera A --layout floor --image %I",
        "register %P --camera A --layout floor --video %I",
        "import %P --trial other --video A=%I",
        "import %P --trial other --track red=%I",
        "calibrate %P A %I",
        "robot add %P blue --pick %I --box 1,2,30,40",
        "report %P run -o %/report.pdf --logo %I",
        "list %I",
    };

    void makeSocket(const QString &at)
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        const QByteArray name = at.toLocal8Bit();
        QVERIFY(name.size() < qsizetype(sizeof address.sun_path));
        std::copy(name.begin(), name.end(), address.sun_path);
        m_socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
        QCOMPARE(::bind(m_socket, reinterpret_cast<const sockaddr *>(&address), sizeof address), 0);
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(good("new %P --title Lesson").exitStatus, 0);
        QCOMPARE(good("robot add %P red --colour #d72328").exitStatus, 0);
        QCOMPARE(good("camera add %P A").exitStatus, 0);
        write("layout.csv", "label,x_mm,y_mm\nO,0,0\nU,3000,0\nV,0,2200\nD,3000,2200\n");
        write("run.csv", "t_s,x_mm,y_mm\n0,0,0\n0.1,10,0\n0.2,30,0\n0.3,60,0\n0.4,90,0\n0.5,120,0\n");
        QCOMPARE(good("layout add %P floor %/layout.csv").exitStatus, 0);
        QCOMPARE(good("import %P --trial run --track red=%/run.csv").exitStatus, 0);
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("folder")));
        QCOMPARE(::mkfifo(path("pipe").toLocal8Bit().constData(), 0600), 0);
        makeSocket(path("socket"));
        for (const char *what : {"pipe", "folder", "layout.csv", "run.csv"})
            std::filesystem::create_symlink(what,
                                            path((std::string("link to ") + what).c_str()).toStdString());
        std::filesystem::create_symlink("loop", path("loop").toStdString());
    }
    void cleanupTestCase() { ::close(m_socket); }

    void isSaidAtOnce_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("input");
        QTest::addColumn<QByteArray>("words");
        for (const char *line : calls) {
            const auto row = [&](const char *name, const QString &input, const char *words) {
                QTest::addRow("%s: %s", line, name) << QString::fromUtf8(line) << input << QByteArray(words);
            };
            row("pipe", path("pipe"), "it is a named pipe; ");
            row("link to a pipe", path("link to pipe"), "it is a named pipe; ");
            row("folder", path("folder"), "it is a folder; ");
            row("link to a folder", path("link to folder"), "it is a folder; ");
            row("socket", path("socket"), "it is a socket; ");
            row("endless device", QStringLiteral("/dev/zero"), "it is a device; ");
            row("terminal", QStringLiteral("/dev/ptmx"), "it is a device; ");
            row("loop of links", path("loop"), "it cannot be accessed (Too many levels of symbolic links); ");
            row("nothing", path("nothing"), "the file does not exist; ");
        }
    }
    void isSaidAtOnce()
    {
        QFETCH(QString, line);
        QFETCH(QString, input);
        QFETCH(QByteArray, words);
        QStringList arguments = filled(line);
        for (QString &argument : arguments)
            argument.replace(QStringLiteral("%I"), input);
        const QByteArray before = fileHash(m_project);
        const QStringList filesBefore = QDir(m_folder.path()).entryList();
        const ProgramRun run = runProgram(arguments);
        QVERIFY2(run.exitStatus == 1,
                 qPrintable(QString::number(run.exitStatus) + QString::fromUtf8(run.err)));
        QVERIFY2(run.err.startsWith("odograph: ") && run.err.count('\n') == 1, run.err);
        QVERIFY2(run.err.contains(words) && run.err.contains(input.toUtf8()), run.err);
        QVERIFY2(run.out.isEmpty(), run.out);
        QCOMPARE(fileHash(m_project), before);
        QCOMPARE(QDir(m_folder.path()).entryList(), filesBefore);
    }

    void aLinkToAFileIsThatFile()
    {
        QStringList layout = filled(QStringLiteral("layout add %P linked"));
        const ProgramRun added = runProgram(layout << path("link to layout.csv"));
        QVERIFY2(added.exitStatus == 0, added.err);
        QStringList track = filled(QStringLiteral("import %P --trial linked --track"));
        const ProgramRun imported = runProgram(track << QStringLiteral("red=") + path("link to run.csv"));
        QVERIFY2(imported.exitStatus == 0, imported.err);
    }

private:
    int m_socket = -1;
};

ODOGRAPH_TEST(TestOddInputs, QCoreApplication)
#include "tst_odd_inputs.moc"
