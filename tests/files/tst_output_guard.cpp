// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"
#include "core/files/protected_files.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace odo;
namespace fs = std::filesystem;

namespace {

const std::string projectBytes =
    std::string("SQLite format 3\0", 16) + std::string(52, '\0') + "Odog" + std::string(200, '\0');

const char *const theProject = "it is the project itself",
                  *const besideIt = "it is the log, the lock or a backup of a project",
                  *const inMedia = "it is in the media folder of project 'p.odo'";

void write(const fs::path &file, const std::string &bytes)
{
    std::ofstream(file, std::ios::binary) << bytes;
}

/// Whether another process could take the file's lock: whether this one still has it.
bool isLockFree(const fs::path &file)
{
    const pid_t child = ::fork();
    if (child == 0) {
        const int descriptor = ::open(file.c_str(), O_RDWR);
        struct flock lock
        {
        };
        lock.l_type = F_WRLCK;
        ::_exit(::fcntl(descriptor, F_SETLK, &lock) == 0 ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WEXITSTATUS(status) == 0;
}

} // namespace

/// What may never be overwritten, under all names that lead there.
class TestOutputGuard : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<OpenProjectFile> m_open;
    const fs::path m_start = fs::current_path();

    fs::path path(const std::string &name) const { return fs::path(m_folder.path().toStdString()) / name; }
    /// Why it is refused; empty: it is allowed.
    static std::string refusal(const OutputTarget &target, std::optional<FileKind> kind = FileKind::Csv)
    {
        const auto place = checkOutput(target, kind);
        return place ? std::string() : place.error().why.english();
    }

private Q_SLOTS:
    void initTestCase()
    {
        fs::create_directories(path("p.media/calibration"));
        fs::create_directories(path("other.media"));
        fs::create_directories(path("free.media"));
        fs::create_directories(path("sub"));
        for (const char *folder : {"proj.media", "bare.media", "CAPS.media", "beside/old.media/deep"})
            fs::create_directories(path(folder));
        for (const char *name :
             {"proj.media/a.csv", "bare.media/a.csv", "CAPS.media/a.csv", "beside/old.media/deep/a.csv"})
            write(path(name), "a,b\n");
        for (const char *name :
             {"p.odo", "other.odo", "sub/third.odo", "Proj.x", "bare", "caps.ODO", "beside/new"})
            write(path(name), projectBytes);
        for (const char *name : {"p.odo-wal", "p.media/run_A.mkv", "p.media/calibration/a.png",
                                 "other.media/run.mkv", "p.odo.bak-3", "p.odo.damaged"})
            write(path(name), "a,b\n");
        write(path("foreign.db"), std::string("SQLite format 3\0", 16) + std::string(300, '\0'));
        write(path("table.csv"), "t_s,x_mm\n0,1\n");
        write(path("letter.txt"), "Dear Anna\n");
        write(path("empty"), "");
        write(path("logo.png"), "a,b\n");
        fs::create_symlink("p.odo", path("link.csv"));
        fs::create_symlink(path("p.odo"), path("link2.csv"));
        fs::create_symlink("link.csv", path("link3.csv"));
        fs::create_symlink("p.odo.lock", path("dangling.csv"));
        fs::create_symlink("p.media/new.csv", path("dangling_media.csv"));
        fs::create_symlink(m_folder.path().toStdString(), path("sub/up"));
        fs::create_symlink("../p.media", path("sub/media"));
        fs::create_symlink("nowhere.csv", path("dangling_free.csv"));
        write(path("table.odo"), "t_s,x_mm\n0,1\n");
        fs::create_symlink("new.odo", path("to_new_project.csv"));
        fs::create_symlink("table.csv", path("seems_project.odo"));
        fs::create_symlink("loop2", path("loop1"));
        fs::create_symlink("loop1", path("loop2"));
        fs::create_hard_link(path("p.odo"), path("hard.csv"));
        fs::create_hard_link(path("p.odo-wal"), path("hard_wal.csv"));
        fs::create_hard_link(path("p.media/run_A.mkv"), path("hard_video.csv"));
        fs::create_hard_link(path("p.media/calibration/a.png"), path("hard_picture.csv"));
        fs::create_hard_link(path("table.csv"), path("hard_free.csv"));
        QCOMPARE(::mkfifo(path("fifo").c_str(), 0600), 0);
        m_open = std::make_unique<OpenProjectFile>(path("p.odo"));
        fs::current_path(path("sub"));
    }
    void cleanupTestCase() { fs::current_path(m_start); }

    void refusals_data()
    {
        QTest::addColumn<QString>("target");
        QTest::addColumn<QString>("why");
        const auto add = [&](const std::string &target, const std::string &why) {
            QTest::newRow(target.c_str()) << QString::fromStdString(target) << QString::fromStdString(why);
        };
        const std::string root = m_folder.path().toStdString();
        // The project, by each way that leads to it.
        for (const std::string &name :
             {root + "/p.odo", root + "//p.odo", root + "/./p.odo", root + "/sub/../p.odo",
              std::string("../p.odo"), std::string("./..//p.odo"), root + "/link.csv", root + "/link2.csv",
              root + "/link3.csv", std::string("up/p.odo"), root + "/hard.csv"})
            add(name, theProject);
        // What lies beside it, whether it is there or not, in capitals too.
        for (const char *suffix :
             {"-wal", "-shm", "-journal", ".lock", ".bak-3", ".bak-7", ".damaged", ".damaged.2", "-WAL"})
            add(root + "/p.odo" + suffix, besideIt);
        add(root + "/P.ODO-shm", besideIt);
        add(root + "/gone.odo-wal", besideIt);
        add(root + "/dangling.csv", besideIt);
        add(root + "/hard_wal.csv", besideIt);
        // Its media.
        for (const char *name : {"p.media/run_A.mkv", "p.media/new.csv", "p.media/calibration/a.png",
                                 "p.media/calibration/new.csv", "dangling_media.csv", "hard_video.csv",
                                 "hard_picture.csv", "sub/../p.media/run_A.mkv"})
            add(root + '/' + name, inMedia);
        add("media/run_A.mkv", inMedia);
        add("up/p.media/new.csv", inMedia);
        add(root + "/other.media/run.mkv", "it is in the media folder of project 'other.odo'");
        add(root + "/other.media/new.csv", "it is in the media folder of project 'other.odo'");
        // A project is known by its content, whatever it is called.
        for (const char *name : {"proj.media/a.csv", "proj.media/new.csv"})
            add(root + '/' + name, "it is in the media folder of project 'Proj.x'");
        add(root + "/bare.media/a.csv", "it is in the media folder of project 'bare'");
        add(root + "/CAPS.media/a.csv", "it is in the media folder of project 'caps.ODO'");
        add(root + "/beside/old.media/deep/a.csv", "it is in a media folder beside a project");
        for (const char *name : {"Proj.x-wal", "proj.x.lock", "bare.bak-1"})
            add(root + '/' + name, besideIt);
        // What else must stay.
        add(root + "/other.odo", "it is another project");
        add("third.odo", "it is another project");
        add(root + "/foreign.db", "it is a database");
        // A name that says it is a project.
        for (const char *name :
             {"new.odo", "NEW.Odo", ".odo", "table.odo", "to_new_project.csv", "seems_project.odo"})
            add(root + '/' + name, "only projects have a name ending in .odo");
        add(root, "it is a folder");
        add(root + '/', "it is a folder");
        add(".", "it is a folder");
        add(root + "/sub/up", "it is a folder");
        add(root + "/fifo", "it is a named pipe");
        add("/dev/null", "it is a device");
        add("/dev/zero", "it is a device");
        add("", "it has no name");
        add(root + "/letter.txt", "a file of another kind has that name");
        add(root + "/loop1", "it cannot be written (Too many levels of symbolic links)");
        add(root + '/' + std::string(300, 'n'), "its name is too long");
        add(root + "/not there/a.csv", "folder '" + root + "/not there' does not exist");
        add(root + "/table.csv/a.csv", "it cannot be written (Not a directory)");
    }
    void refusals()
    {
        QFETCH(QString, target);
        QFETCH(QString, why);
        const auto refused = checkOutput(target.toStdString(), FileKind::Csv);
        QVERIFY(!refused.has_value());
        QCOMPARE(QString::fromStdString(refused.error().why.english()), why);
        QCOMPARE(QString::fromStdString(refused.error().what.english()),
                 QStringLiteral("file '%1'").arg(target));
        const bool isWrongCall = refused.error().code == ErrorCode::WrongCall;
        QCOMPARE(isWrongCall,
                 why.startsWith(QStringLiteral("it is ")) || why.startsWith(QStringLiteral("a ")) ||
                     why.startsWith(QStringLiteral("only ")) || why == QStringLiteral("it has no name"));
    }

    void aSocketIsRefused()
    {
        const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        const std::string name = path("socket").string();
        QVERIFY(name.size() < sizeof address.sun_path);
        std::copy(name.begin(), name.end(), address.sun_path);
        QCOMPARE(::bind(descriptor, reinterpret_cast<sockaddr *>(&address), sizeof address), 0);
        QCOMPARE(refusal(path("socket")), std::string("it is a socket"));
        ::close(descriptor);
    }

    void nothingIsRefusedThatMayBeWritten()
    {
        for (const char *name : {"new.csv", "table.csv", "empty", "dangling_free.csv", "hard_free.csv",
                                 "free.media/a.csv", "p.media.csv", "p.mediax", "p.odo.csv", "p.odo-walk",
                                 "beside/old.media/new.csv", "bare-walk", "a bare.lock", "letter.txt.lock",
                                 "sub/../new.csv", "p.media/../new.csv", "sub/media/../new.csv"})
            QCOMPARE(refusal(path(name)), std::string());
        QCOMPARE(checkOutput(path("table.csv"), FileKind::Csv)->kind, FileKind::Csv);
        QVERIFY(!checkOutput(path("new.csv"), FileKind::Csv)->exists);
        QCOMPARE(refusal(path("new.odo"), FileKind::Project), std::string());
        QCOMPARE(checkOutput(path("dangling_free.csv"), FileKind::Csv)->real,
                 fs::canonical(path("")) / "nowhere.csv");
    }

    void forceReplacesAnotherKindButNeverWhatMustStay()
    {
        QCOMPARE(refusal({path("letter.txt"), Existing::ReplaceAny}), std::string());
        QCOMPARE(refusal(path("letter.txt"), std::nullopt), std::string()); // the kind isn't known yet
        QCOMPARE(refusal({path("table.csv"), Existing::Refuse}), std::string("it already exists"));
        for (const char *name : {"p.odo", "hard.csv", "p.odo-wal", "p.media/new.csv", "other.odo",
                                 "foreign.db", "fifo", "new.odo", "table.odo"})
            QVERIFY2(!refusal({path(name), Existing::ReplaceAny}).empty(), name);
    }

    void inputsStay()
    {
        QCOMPARE(refusal(path("logo.png")), std::string());
        {
            InputFiles inputs;
            inputs.add(path("sub/../logo.png"));
            QCOMPARE(refusal(path("logo.png")), std::string("it is an input of the same command"));
            InputFiles recordings(foreignWords("it is a recording of the project"));
            recordings.add(path("table.csv"));
            QCOMPARE(refusal({path("hard_free.csv"), Existing::ReplaceAny}),
                     std::string("it is a recording of the project"));
        }
        QCOMPARE(refusal(path("logo.png")), std::string());
    }

    void ownMediaMayBeNewOnly()
    {
        OutputTarget target = path("p.media/new.mkv");
        target.isOwnMedia = true;
        QCOMPARE(refusal(target), std::string());
        target.file = path("p.media/run_A.mkv");
        QCOMPARE(refusal(target), std::string("it already exists"));
    }

    void aProjectThatWasRenamedIsKnown()
    {
        write(path("moved.odo"), projectBytes);
        const OpenProjectFile open(path("moved.odo"));
        fs::rename(path("moved.odo"), path("elsewhere"));
        QCOMPARE(refusal(path("elsewhere")), std::string(theProject));
        QCOMPARE(refusal(path("moved.odo")), std::string(theProject)); // its name is still its own
        fs::remove(path("elsewhere"));
    }

    void linkedMediaAreKnown()
    {
        fs::create_directories(path("disk/videos"));
        write(path("linked.odo"), projectBytes);
        fs::create_symlink(path("disk/videos"), path("linked.media"));
        // by its name
        QCOMPARE(refusal(path("linked.media/a.csv")),
                 std::string("it is in the media folder of project 'linked.odo'"));
        const OpenProjectFile open(path("linked.odo"));
        // by what it is
        QCOMPARE(refusal(path("disk/videos/a.csv")),
                 std::string("it is in the media folder of project 'linked.odo'"));
    }

    /// To open and close an open project would drop SQLite's locks on it.
    void theLocksOfAnOpenProjectStay()
    {
        const int descriptor = ::open(path("p.odo").c_str(), O_RDWR | O_CLOEXEC);
        struct flock lock
        {
        };
        lock.l_type = F_WRLCK;
        QCOMPARE(::fcntl(descriptor, F_SETLK, &lock), 0);
        write(path("p.odo-shm"), "index of the log");
        const int index = ::open(path("p.odo-shm").c_str(), O_RDWR | O_CLOEXEC);
        QCOMPARE(::fcntl(index, F_SETLK, &lock), 0);
        for (const char *name : {"p.odo", "hard.csv", "link.csv", "p.odo-wal", "new.csv", "p.media/run_A.mkv",
                                 "free.media/a.csv"})
            static_cast<void>(refusal({path(name), Existing::ReplaceAny}));
        QVERIFY(!isLockFree(path("p.odo")));
        QVERIFY(!isLockFree(path("p.odo-shm")));
        ::close(index);
        fs::remove(path("p.odo-shm"));
        ::close(descriptor);
        QVERIFY(isLockFree(path("p.odo")));
    }

    void aFileThatIsWriteProtectedStays()
    {
        if (::geteuid() == 0)
            QSKIP("root may write to anything");
        write(path("protected.csv"), "a,b\n");
        fs::permissions(path("protected.csv"), fs::perms::owner_read);
        QCOMPARE(refusal(path("protected.csv")), std::string("it cannot be written (Permission denied)"));
    }
};

ODOGRAPH_TEST(TestOutputGuard, QCoreApplication)
#include "tst_output_guard.moc"
