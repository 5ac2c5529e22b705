// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder_names.h"

#include "tests/fault/scarce.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <new>

using namespace odo;
using namespace odo::test;

class TestFolderNames : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::filesystem::path path(const char *name) const { return m_folder.filePath(QString::fromUtf8(name)).toStdString(); }
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
        QCOMPARE(sorted(namesIn(path("full"), problem)), (std::vector<std::string>{".hidden", "a", "below", "link", "Übung ♥"}));
        QVERIFY(!problem);
        QVERIFY(namesIn(path("empty"), problem).empty());
        QVERIFY(!problem);
    }

    void whatIsNoFolderIsTold()
    {
        std::error_code problem;
        QVERIFY(namesIn(path("missing"), problem).empty());
        QVERIFY(problem == std::errc::no_such_file_or_directory);
        QVERIFY(namesIn(path("full/a"), problem).empty());
        QVERIFY(problem == std::errc::not_a_directory);
    }

    /// std::filesystem's iterators end the program there.
    void memoryThatIsRefusedIsThrown()
    {
        const std::filesystem::path folder = path("full");
        std::error_code problem;
        std::uint64_t requests = 0;
        {
            const FailingRequest none(Scarce::Memory, 0);
            namesIn(folder, problem);
            requests = none.requests();
        }
        QVERIFY(requests > 0);
        for (std::uint64_t nth = 1; nth <= requests; ++nth) {
            const FailingRequest one(Scarce::Memory, nth);
            QVERIFY_THROWS_EXCEPTION(std::bad_alloc, namesIn(folder, problem));
        }
    }
};

QTEST_APPLESS_MAIN(TestFolderNames)
#include "tst_folder_names.moc"
