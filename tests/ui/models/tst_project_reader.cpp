// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "ui/models/background_task.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>
#include <semaphore>
#include <thread>

using namespace odo;

class TestProjectReader : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        m_file = m_folder.filePath(QStringLiteral("p.odo")).toStdString();
        m_project = std::move(*Project::create(m_file, "Year 9"));
    }

    void readsOnAThreadOfItsOwn()
    {
        ProjectReader reader(m_file);
        QVERIFY(!reader.isRunning());
        std::thread::id there;
        std::optional<Result<std::string>> title;
        reader.read<std::string>(
            [&](Project &project) -> Result<std::string> {
                there = std::this_thread::get_id();
                return project.title();
            },
            [&](Result<std::string> read) { title = std::move(read); });
        QVERIFY(reader.isRunning());
        QTRY_VERIFY(title);
        QVERIFY(*title);
        QCOMPARE(**title, std::string("Year 9"));
        QVERIFY(there != std::this_thread::get_id());
        QVERIFY(!reader.isRunning());
    }

    void onlyReads()
    {
        const auto changed = read<bool>([](Project &project) -> Result<bool> {
            const auto set = project.setTitle("Another");
            return set ? Result<bool>(true) : tl::unexpected(set.error());
        });
        QVERIFY(!changed);
        QCOMPARE(changed.error().code, ErrorCode::ReadOnly);
        QCOMPARE(m_project->title().value(), std::string("Year 9"));
    }

    void tellsWhatWentWrong()
    {
        const auto failed = read<int>([](Project &) -> Result<int> {
            return test::saidFailure(ErrorCode::Undetermined, "what", "why", "advice");
        });
        QCOMPARE(failed.error().code, ErrorCode::Undetermined);
    }

    void tellsOfAFileThatIsGone()
    {
        ProjectReader reader(m_folder.filePath(QStringLiteral("gone.odo")).toStdString());
        std::optional<Result<int>> told;
        reader.read<int>([](Project &) -> Result<int> { return 1; }, [&](Result<int> read) { told = read; });
        QTRY_VERIFY(told);
        QVERIFY(!*told);
    }

    void ofRequestsMadeTogetherOnlyTheLastIsBegun()
    {
        ProjectReader reader(m_file);
        QList<int> begun, told;
        for (const int number : {1, 2, 3})
            reader.read<int>(
                [&begun, number](Project &) -> Result<int> {
                    begun << number;
                    return number;
                },
                [&told](Result<int> read) { told << *read; });
        QTRY_VERIFY(!reader.isRunning());
        QCOMPARE(begun, QList<int>({3}));
        QCOMPARE(told, QList<int>({3}));
    }

    void whatIsOvertakenIsNotTold()
    {
        ProjectReader reader(m_file);
        std::binary_semaphore begun(0), goOn(0);
        QList<int> told;
        const auto take = [&told](Result<int> read) { told << *read; };
        reader.read<int>(
            [&](Project &) -> Result<int> {
                begun.release();
                goOn.acquire();
                return 1;
            },
            take);
        QCoreApplication::sendPostedEvents();
        begun.acquire();
        reader.read<int>([](Project &) -> Result<int> { return 2; }, take);
        goOn.release();
        QTRY_VERIFY(!reader.isRunning());
        QCOMPARE(told, QList<int>({2}));
    }

private:
    template <class Value>
    Result<Value> read(std::function<Result<Value>(Project &)> what)
    {
        ProjectReader reader(m_file);
        std::optional<Result<Value>> told;
        reader.read<Value>(std::move(what), [&](Result<Value> value) { told = std::move(value); });
        if (!QTest::qWaitFor([&] { return told.has_value(); }))
            return test::saidFailure(ErrorCode::Internal, "test", "nothing was told", "");
        return *told;
    }

    QTemporaryDir m_folder;
    std::filesystem::path m_file;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestProjectReader, QCoreApplication)
#include "tst_project_reader.moc"
