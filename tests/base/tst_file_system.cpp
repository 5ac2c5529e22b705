// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_system.h"

#include "tests/fault/scarce.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <new>
#include <unistd.h>

using namespace odo;
using namespace odo::test;

/// Paths that the system refuses get an answer and a reason, never an exception.
class TestFileSystem : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QString::fromUtf8(name)).toStdString();
    }
    static std::vector<std::string> sorted(std::vector<std::string> names)
    {
        std::ranges::sort(names);
        return names;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("full/below")));
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("empty")));
        for (const char *name : {"full/a", "full/Übung ♥", "full/.hidden", "full/below/deep"})
            QVERIFY(QFile(QString::fromStdString(path(name).string())).open(QIODevice::WriteOnly));
        QVERIFY(QFile::link(QStringLiteral("nowhere"), QString::fromStdString(path("full/link").string())));
    }

    void allIsThereOnce()
    {
        auto problem = std::make_error_code(std::errc::io_error);
        QCOMPARE(sorted(files::namesIn(path("full"), problem)),
                 (std::vector<std::string>{".hidden", "a", "below", "link", "Übung ♥"}));
        QVERIFY(!problem);
        QVERIFY(files::namesIn(path("empty"), problem).empty());
        QVERIFY(!problem);
    }

    void whatIsNoFolderIsTold()
    {
        std::error_code problem;
        QVERIFY(files::namesIn(path("missing"), problem).empty());
        QVERIFY(problem == std::errc::no_such_file_or_directory);
        QVERIFY(files::namesIn(path("full/a"), problem).empty());
        QVERIFY(problem == std::errc::not_a_directory);
    }

    void whatIsThereIsTold()
    {
        QVERIFY(files::isFolder(path("full")) && files::isFile(path("full/a")));
        QCOMPARE(files::kindOfItself(path("full/link")), files::Kind::Link);
        QVERIFY(!files::exists(path("full/link")) && !files::isSame(path("full"), path("empty")));
        QVERIFY(files::isSame(path("full"), path("full/below/..")));
        std::error_code problem = std::make_error_code(std::errc::io_error);
        QCOMPARE(files::kindOf(path("missing"), problem), files::Kind::Missing);
        QVERIFY(!problem); // it can be known that it is not there
        QCOMPARE(files::sizeOf(path("full/a"), problem), std::uintmax_t(0));
        QVERIFY(!problem);
        QVERIFY(files::diskSpace(path("full"), problem).bytes > 0 && !problem);
        QCOMPARE(files::linkTarget(path("full/link"), problem), std::filesystem::path("nowhere"));
    }

    void whatTheSystemRefusesIsAnAnswer_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<int>("reason");
        QTest::newRow("too long a name") << QByteArray(3000, 'A') << ENAMETOOLONG;
        QTest::newRow("too long a path") << QByteArray("AAAAAAAAA/").repeated(1000) << ENAMETOOLONG;
        QTest::newRow("a loop of links") << QByteArray("loop/below") << ELOOP;
    }
    void whatTheSystemRefusesIsAnAnswer()
    {
        QFETCH(QByteArray, name);
        QFETCH(int, reason);
        QFile::link(QStringLiteral("loop"), QString::fromStdString(path("loop").string()));
        const std::filesystem::path refused = path(name.constData());
        const auto isTheReason = [reason](const std::error_code &problem) {
            return problem.value() == reason;
        };
        std::error_code problem;
        QCOMPARE(files::kindOf(refused, problem), files::Kind::Missing);
        QVERIFY(isTheReason(problem));
        QCOMPARE(files::kindOfItself(refused), files::Kind::Missing);
        QVERIFY(!files::exists(refused) && !files::isFile(refused) && !files::isFolder(refused) &&
                !files::isSame(refused, path("full")));
        QCOMPARE(files::absolute(refused), refused);
        QCOMPARE(files::realPath(refused, problem), refused);
        QVERIFY(isTheReason(problem));
        for (const auto &ask : {std::function([&] { files::sizeOf(refused, problem); }),
                                std::function([&] { files::namesIn(refused, problem); }),
                                std::function([&] { files::lastWritten(refused, problem); }),
                                std::function([&] { files::makeFolders(refused, problem); }),
                                std::function([&] { files::remove(refused, problem); }),
                                std::function([&] { files::diskSpace(refused, problem); }),
                                std::function([&] { files::rename(path("full/a"), refused, problem); })}) {
            problem.clear();
            ask();
            QVERIFY2(isTheReason(problem), problem.message().c_str());
        }
        files::removeAll(refused);
    }

    void aWorkingDirectoryThatIsGone()
    {
        const QByteArray before = QDir::currentPath().toUtf8();
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("gone")));
        QVERIFY(::chdir(path("gone").c_str()) == 0 && ::rmdir(path("gone").c_str()) == 0);
        const auto absolute = files::absolute("some.odo"), real = files::realPath("some.odo");
        const bool exists = files::exists("some.odo");
        QVERIFY(::chdir(before.constData()) == 0);
        QCOMPARE(absolute, std::filesystem::path("some.odo"));
        QCOMPARE(real, std::filesystem::path("some.odo"));
        QVERIFY(!exists);
    }

    void filesBelowAFolder()
    {
        std::vector<std::string> seen;
        std::error_code problem;
        const auto visit = [&seen](const std::filesystem::path &file) {
            seen.push_back(file.filename().string());
            return true;
        };
        files::eachFileBelow(path("full"), visit, problem);
        QVERIFY(!problem);
        QCOMPARE(sorted(seen), (std::vector<std::string>{".hidden", "a", "deep", "Übung ♥"}));
        seen.clear();
        files::eachFileBelow(
            path("full"), [&](const std::filesystem::path &file) { return visit(file) && false; }, problem);
        QCOMPARE(seen.size(), std::size_t(1));
        files::eachFileBelow(path("missing"), visit, problem);
        QVERIFY(problem == std::errc::no_such_file_or_directory);
    }

    void removingAllLeavesWhatLinksLeadTo()
    {
        std::error_code problem;
        QVERIFY(files::makeFolders(path("work/a/b"), problem) && !problem);
        QVERIFY(!files::makeFolders(path("work/a/b"), problem) && !problem);
        QVERIFY(QFile::link(QString::fromStdString(path("full").string()),
                            QString::fromStdString(path("work/a/full").string())));
        files::removeAll(path("work"));
        QVERIFY(!files::exists(path("work")) && files::isFile(path("full/a")));
        files::removeAll(path("work"));
    }

    /// std::filesystem's iterators end the program there.
    void memoryThatIsRefusedIsThrown()
    {
        const std::filesystem::path folder = path("full");
        std::error_code problem;
        std::uint64_t requests = 0;
        {
            const FailingRequest none(Scarce::Memory, 0);
            files::namesIn(folder, problem);
            requests = none.requests();
        }
        QVERIFY(requests > 0);
        for (std::uint64_t nth = 1; nth <= requests; ++nth) {
            const FailingRequest one(Scarce::Memory, nth);
            QVERIFY_THROWS_EXCEPTION(std::bad_alloc, files::namesIn(folder, problem));
        }
    }
};

ODOGRAPH_TEST(TestFileSystem, QCoreApplication)
#include "tst_file_system.moc"
