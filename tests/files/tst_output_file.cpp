// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"
#include "core/files/protected_files.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace odo;
namespace fs = std::filesystem;

namespace {

std::string contentOf(const fs::path &file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path &file, const std::string &bytes)
{
    std::ofstream(file, std::ios::binary) << bytes;
}

/// Has another process make something, and kills it while it does.
template <class Work>
void killDuring(const Work &work)
{
    int ready[2];
    QCOMPARE(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto made = work();
        static_cast<void>(!::write(ready[1], made ? "y" : "n", 1));
        for (;;)
            ::pause();
    }
    char is = 0;
    QCOMPARE(::read(ready[0], &is, 1), ssize_t(1));
    QCOMPARE(is, 'y');
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ready[0]);
    ::close(ready[1]);
}

} // namespace

/// How files are written for a person: whole or not at all, and nothing left.
class TestOutputFile : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;

    fs::path path(const std::string &name = {}) const
    {
        return fs::path(m_folder->path().toStdString()) / name;
    }
    std::vector<std::string> names() const
    {
        std::vector<std::string> all;
        for (const auto &each : fs::directory_iterator(path()))
            all.push_back(each.path().filename().string());
        std::ranges::sort(all);
        return all;
    }
    static mode_t modeOf(const fs::path &file)
    {
        struct stat status
        {
        };
        return ::stat(file.c_str(), &status) == 0 ? status.st_mode & 0777U : 0;
    }

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void appearsWhenCommitted()
    {
        const mode_t before = ::umask(027);
        {
            const auto output = OutputFile::open(path("a.csv"), FileKind::Csv);
            QVERIFY(output.has_value());
            QCOMPARE(names().size(), std::size_t(1));
            QVERIFY(isTemporaryName(names().front()));
            QVERIFY((*output)->write("t,x\n1,2\n").has_value());
            QVERIFY((*output)->commit().has_value());
        }
        ::umask(before);
        QCOMPARE(names(), std::vector<std::string>{"a.csv"});
        QCOMPARE(contentOf(path("a.csv")), std::string("t,x\n1,2\n"));
        QCOMPARE(modeOf(path("a.csv")), mode_t(0640)); // as the user's umask has it
    }

    void leavesNothingWithoutCommit()
    {
        write(path("a.csv"), "old,x\n");
        {
            const auto output = OutputFile::open(path("a.csv"), FileKind::Csv);
            QVERIFY((*output)->write("new").has_value());
        }
        QCOMPARE(names(), std::vector<std::string>{"a.csv"});
        QCOMPARE(contentOf(path("a.csv")), std::string("old,x\n"));
    }

    void replacesTheSameKindAndKeepsItsReaders()
    {
        write(path("a.csv"), "old,x\n");
        fs::permissions(path("a.csv"), fs::perms(0604));
        fs::create_symlink("a.csv", path("link.csv"));
        QVERIFY(writeOutput(path("link.csv"), "new,x\n").has_value());
        QVERIFY(fs::is_symlink(path("link.csv")));
        QCOMPARE(contentOf(path("a.csv")), std::string("new,x\n"));
        QCOMPARE(modeOf(path("a.csv")), mode_t(0604));
        const auto refused = writeOutput(path("a.csv"), "{\"json\": 1}");
        QVERIFY(!refused.has_value());
        QCOMPARE(
            refused.error().message(),
            "file '" + path("a.csv").string() +
                "': a file of another kind has that name; choose another name, or replace it with --force");
        QVERIFY(writeOutput({path("a.csv"), Existing::ReplaceAny}, "{\"json\": 1}").has_value());
        QCOMPARE(contentOf(path("a.csv")), std::string("{\"json\": 1}"));
    }

    void looksAgainBeforeItGetsItsName()
    {
        const auto output = OutputFile::open({path("a.csv"), Existing::ReplaceAny}, FileKind::Csv);
        write(path("a.csv"), "meanwhile");
        const OpenProjectFile open(path("a.csv"));
        const auto refused = (*output)->commit();
        QVERIFY(!refused.has_value());
        QCOMPARE(refused.error().why.english(), std::string("it is the project itself"));
        QCOMPARE(contentOf(path("a.csv")), std::string("meanwhile"));
        const auto other = OutputFile::open({path("b.csv"), Existing::Refuse}, FileKind::Csv);
        write(path("b.csv"), "meanwhile");
        QCOMPARE((*other)->commit().error().code, ErrorCode::AlreadyExists);
        QCOMPARE(contentOf(path("b.csv")), std::string("meanwhile"));
    }

    void manyToOneNameAtOnce()
    {
        std::atomic<int> failures = 0;
        std::vector<std::thread> threads;
        for (char letter = 'a'; letter < 'a' + 25; ++letter)
            threads.emplace_back([&, letter] {
                std::string text(100'000, letter);
                text.replace(0, 4, "h,h\n");
                for (int i = 0; i < 2; ++i)
                    failures += !writeOutput(path("one.csv"), text);
            });
        for (std::thread &thread : threads)
            thread.join();
        QCOMPARE(failures.load(), 0);
        QCOMPARE(names(), std::vector<std::string>{"one.csv"});
        const std::string content = contentOf(path("one.csv"));
        QCOMPARE(content.size(), std::size_t(100'000));
        QVERIFY(content.starts_with("h,h\n") &&
                content.find_first_not_of(content.back(), 4) == std::string::npos);
    }

    void whatAKilledProgramLeftIsSwept()
    {
        killDuring([&] {
            static auto file = OutputFile::open(path("a.csv"), FileKind::Csv);
            return file.has_value();
        });
        killDuring([&] {
            static auto folder = TemporaryFolder::make(path(), foreignWords("folder"));
            std::ofstream((*folder)->path() / "inside") << "x";
            return folder.has_value();
        });
        // The second has swept what the first left.
        QCOMPARE(names().size(), std::size_t(1));
        QVERIFY(writeOutput(path("b.csv"), "a,b\n").has_value());
        QCOMPARE(names(), std::vector<std::string>{"b.csv"});
    }

    void whatIsBeingWrittenIsNotSwept()
    {
        const auto first = OutputFile::open(path("a.csv"), FileKind::Csv);
        const auto folder = TemporaryFolder::make(path(), foreignWords("folder"));
        write(path(".odograph-short.part"), "not ours");
        write(path("x.odograph-aaaaaaaaaaaa.part"), "not ours");
        QVERIFY(writeOutput(path("b.csv"), "a,b\n").has_value());
        QVERIFY(fs::exists((*first)->temporary()) && fs::exists((*folder)->path()));
        QVERIFY((*first)->commit().has_value());
        QCOMPARE(names().size(), std::size_t(5));
    }

    /// Whatever it is called.
    void whatIsNotItsOwnIsNotSwept()
    {
        write(path("notes.txt"), "Dear Anna\n");
        write(path(".odograph-aaaaaaaaaaaa.part"), "somebody's own");
        fs::create_hard_link(path("notes.txt"), path(".odograph-bbbbbbbbbbbb.part"));
        fs::create_directories(path(".odograph-cccccccccccc.part/new"));
        write(path(".odograph-cccccccccccc.part/new/photo.jpg"), "somebody's own");
        fs::create_directories(path(".odograph-dddddddddddd.part"));
        const auto before = names();
        {
            const auto folder = TemporaryFolder::make(path(), foreignWords("folder")).value();
            write(folder->path() / "kept.csv", "a");
            // a copy is somebody's own
            fs::copy(folder->path().parent_path(), path(".odograph-eeeeeeeeeeee.part"),
                     fs::copy_options::recursive);
        }
        QVERIFY(writeOutput(path("a.csv"), "a,b\n").has_value());
        for (const std::string &name : before)
            QVERIFY2(fs::exists(path(name)), name.c_str());
        QCOMPARE(names().size(), before.size() + 2);
        QCOMPARE(contentOf(path(".odograph-cccccccccccc.part/new/photo.jpg")), std::string("somebody's own"));
        QCOMPARE(contentOf(path(".odograph-eeeeeeeeeeee.part/new/kept.csv")), std::string("a"));
        const auto refused =
            writeOutput({path(".odograph-ffffffffffff.part"), Existing::ReplaceAny}, "a,b\n");
        QCOMPARE(refused.error().code, ErrorCode::WrongCall);
        QCOMPARE(refused.error().message(),
                 "file '" + path(".odograph-ffffffffffff.part").string() +
                     "': Odograph uses such names for temporary files; choose another name");
    }

    void aFolderKeepsWhatWasPublished()
    {
        const auto folder = TemporaryFolder::make(path(), foreignWords("folder")).value();
        QCOMPARE(modeOf(folder->path()), mode_t(0700));
        write(folder->path() / "a", "1");
        write(path("there"), "2");
        QVERIFY(giveFreeName(folder->path() / "a", path("there")) == std::errc::file_exists);
        QVERIFY(!giveFreeName(folder->path() / "a", path("new")));
        QCOMPARE(contentOf(path("there")), std::string("2"));
        QCOMPARE(contentOf(path("new")), std::string("1"));
        QVERIFY(!fs::exists(folder->path() / "a"));
    }

    void saysWhyItCannotBe()
    {
        const auto nowhere = TemporaryFile::make(path("no"), foreignWords("file 'x'"));
        QCOMPARE(nowhere.error().code, ErrorCode::NotFound);
        QVERIFY(nowhere.error().message().starts_with("file 'x': folder '"));
        const auto special = TemporaryFile::make("/proc/self", foreignWords("file 'x'"));
        QVERIFY(!special.has_value());
        QCOMPARE(OutputFile::open("", FileKind::Csv).error().why.english(), std::string("it has no name"));
        if (fs::exists("/dev/full")) {
            const auto output = OutputFile::open(path("full.csv"), FileKind::Csv);
            QVERIFY(::dup2(::open("/dev/full", O_WRONLY | O_CLOEXEC), (*output)->descriptor()) >= 0);
            QCOMPARE((*output)->write("x").error().why.english(),
                     std::string("it cannot be written (No space left on device)"));
        }
    }
};

ODOGRAPH_TEST(TestOutputFile, QCoreApplication)
#include "tst_output_file.moc"
