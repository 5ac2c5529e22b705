// SPDX-License-Identifier: GPL-3.0-or-later
// Each use case that writes, and tracking, where this computer has no more memory, threads or open files for
// its first, second, ... request: it does what it should all the same, or ends with an error in words; the
// project is as it was.
#include "core/base/shortage.h"
#include "core/project/project.h"
#include "core/workflow/track/track_job.h"
#include "tests/fault/folder_content.h"
#include "tests/fault/scarce_attempt.h"
#include "tests/fault/stored_rows.h"
#include "tests/fault/writing_use_cases.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>
#include <set>

using namespace odo;
using namespace odo::test;

namespace fs = std::filesystem;

namespace {

/// The numbers of requests to refuse, spread over all.
std::set<std::uint64_t> chosen(std::uint64_t requests, std::uint64_t most)
{
    std::set<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < std::min(requests, most); ++i)
        numbers.insert(1 + i * (requests - 1) / std::max<std::uint64_t>(std::min(requests, most) - 1, 1));
    return numbers;
}

UseCase tracking()
{
    const auto prepare = [](const fs::path &folder) {
        if (const auto made = storeExample(folder, {12, 320, 180}); !made)
            qFatal("%s", made.error().message().c_str());
    };
    return {QStringLiteral("track"), prepare,
            [](const fs::path &folder, const Acknowledge &acknowledge) -> Result<void> {
                const auto project = Project::open(folder / "example.odo", Project::Access::ReadWrite);
                if (!project)
                    return tl::unexpected(project.error());
                TrackJob job("Trial 1", {});
                if (auto done = runToEnd(job, **project, {}); !done)
                    return done;
                acknowledge();
                return {};
            }};
}

} // namespace

class TestScarcity : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void memory_data() { useCases(); }
    void memory();
    void memoryOfVideos_data() { useCases(); }
    void memoryOfVideos();
    void threads_data() { useCases(); }
    void threads();
    void files_data() { useCases(); }
    void files();

private:
    static void useCases();
    void prepare();
    QString problemOf(const ScarceAttempt &tried) const;
    void sweep(Scarce what, std::uint64_t most);
    std::function<Result<void>()> work() const
    {
        QFETCH(UseCase, useCase);
        return [this, useCase]() -> Result<void> { // as the command line calls it
            return orShortage(ODO_TEXT("test.use_case", "the use case"),
                              [&] { return useCase.work(m_work, [] {}); });
        };
    }

    const bool m_all = isWholeSweep();
    QTemporaryDir m_place{quickFolder()};
    const fs::path m_base = fs::path(m_place.path().toStdString()) / "base";
    const fs::path m_work = fs::path(m_place.path().toStdString()) / "work";
    FolderContent m_before, m_after;
};

void TestScarcity::useCases()
{
    QTest::addColumn<UseCase>("useCase");
    for (const UseCase &useCase : writingUseCases())
        QTest::addRow("%s", qPrintable(useCase.name)) << useCase;
    QTest::addRow("track") << tracking();
}

/// What is there before, and after all went well.
void TestScarcity::prepare()
{
    QFETCH(UseCase, useCase);
    fs::remove_all(m_base);
    fs::create_directories(m_base);
    useCase.prepare(m_base);
    copyFolder(m_base, m_work);
    m_before = contentOf(m_work);
    const auto done = work()();
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    m_after = contentOf(m_work);
}

/// A project that is changed in steps may stand at any of them; all else is as before or as after.
QString TestScarcity::problemOf(const ScarceAttempt &tried) const
{
    if (tried.signal != 0)
        return tried.signal < 0 ? QStringLiteral("ended by an exception")
                                : QStringLiteral("ended by signal %1").arg(tried.signal);
    if (tried.error && (tried.error->what.english().empty() || tried.error->why.english().empty() ||
                        tried.error->advice.english().empty()))
        return QStringLiteral("the error does not say what, why and what to do");
    const bool hasSteps = qstrcmp(QTest::currentDataTag(), "change things") == 0 ||
                          qstrcmp(QTest::currentDataTag(), "empty the bin") == 0;
    const FolderContent found = contentOf(m_work);
    for (auto file = found.begin(); file != found.end(); ++file) {
        const bool isProject = file.key().endsWith(QStringLiteral(".odo"));
        if (!m_before.contains(file.key()) && !m_after.contains(file.key()) && !isInTheMaking(file.key()))
            return QStringLiteral("'%1' is left").arg(file.key());
        if (isProject && !Project::open(m_work / file.key().toStdString(), Project::Access::ReadWrite))
            return QStringLiteral("'%1' does not open").arg(file.key());
        if (isInTheMaking(file.key()))
            continue;
        const bool isAsItMay =
            file.value() == m_before.value(file.key()) || file.value() == m_after.value(file.key());
        // which takes its time, and stores it
        const bool isTracked = qstrcmp(QTest::currentDataTag(), "track") == 0;
        // Of a video that libav reads only in part there are fewer pictures, which a warning tells.
        const bool isPart = qstrcmp(QTest::currentTestFunction(), "memoryOfVideos") == 0;
        if (!isAsItMay && !(isProject && (hasSteps || ((isTracked || isPart) && !tried.error))))
            return QStringLiteral("'%1' is neither as before nor as after: %2")
                .arg(file.key(), firstDifference(m_before.value(file.key()), file.value()));
    }
    for (auto file = m_before.begin(); file != m_before.end(); ++file) {
        if (!found.contains(file.key()) && m_after.contains(file.key()))
            return QStringLiteral("'%1' is gone").arg(file.key());
    }
    return {};
}

void TestScarcity::sweep(Scarce what, std::uint64_t most)
{
    prepare();
    copyFolder(m_base, m_work);
    const ScarceAttempt counted = attemptWithout(what, 0, work());
    QVERIFY2(counted.signal == 0 && !counted.error, qPrintable(counted.words()));
    QStringList problems;
    int told = 0;
    const auto numbers = chosen(counted.requests, m_all ? 20 * most : most);
    for (const std::uint64_t n : numbers) {
        copyFolder(m_base, m_work);
        const ScarceAttempt tried = attemptWithout(what, n, work());
        told += tried.error.has_value();
        if (const QString problem = problemOf(tried); !problem.isEmpty())
            problems << QStringLiteral("request %1 refused: %2 (%3)").arg(n).arg(problem, tried.words());
    }
    qInfo("%zu of %zu requests refused, %d errors", numbers.size(), std::size_t(counted.requests), told);
    QVERIFY2(problems.isEmpty(), qPrintable(problems.mid(0, 10).join(u'\n')));
    if (what == Scarce::Memory)
        QVERIFY(told > 0);
}

void TestScarcity::memory()
{
    sweep(Scarce::Memory, 12);
}

void TestScarcity::memoryOfVideos()
{
    sweep(Scarce::VideoMemory, 12);
}

void TestScarcity::threads()
{
    sweep(Scarce::Threads, 12);
}

void TestScarcity::files()
{
    prepare();
    QStringList problems;
    int told = 0;
    for (unsigned more = 0; more < 24; more += m_all ? 1 : 4) {
        copyFolder(m_base, m_work);
        const ScarceAttempt tried = attemptWithFiles(more, work());
        told += tried.error.has_value();
        if (const QString problem = problemOf(tried); !problem.isEmpty())
            problems
                << QStringLiteral("%1 files may be opened: %2 (%3)").arg(more).arg(problem, tried.words());
    }
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join(u'\n')));
    QVERIFY(told > 0);
}

ODOGRAPH_TEST(TestScarcity, QCoreApplication)
#include "tst_scarcity.moc"
