// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson's recordings, one after the other, through the whole window: what the program holds (memory,
// files, threads) does not grow from trial to trial. ODOGRAPH_SOAK_TRIALS: how many, by default a few short
// ones; ODOGRAPH_SOAK_MINUTES: how long they take together, half of it recorded.
#include "core/base/platform/process.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/circle_lesson.h"
#include "tests/ui/support/driven_window.h"
#include "ui/main_window/main_window.h"
#include "ui/models/shown_message.h"
#include "ui/record/record_page.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>
#include <QThread>
#include <algorithm>
#include <filesystem>
#include <malloc.h>

using namespace odo;

namespace {

constexpr int longestMs = 300'000; // to wait, on a busy machine with a slow disk
constexpr double imageMb = 2.5;    // one picture of the two cameras may still be held, or not

/// What this process holds.
struct Held
{
    double usedMb = 0;     ///< asked of the C library and not given back yet
    double residentMb = 0; ///< of the system, without what is a file's (which it takes back when it likes)
    qsizetype files = 0;
    qsizetype threads = 0;
};

qsizetype entries(const QString &folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot).size();
}

Held held()
{
    Held now;
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return now;
    const auto lines = status.readAll().split('\n');
    for (const QByteArray &line : lines) {
        if (line.startsWith("RssAnon:"))
            now.residentMb = line.mid(8).trimmed().split(' ').front().toDouble() / 1024;
    }
    const struct mallinfo2 used = mallinfo2();
    now.usedMb = double(used.uordblks + used.hblkhd) / (1 << 20);
    now.files = entries(QStringLiteral("/proc/self/fd"));
    now.threads = entries(QStringLiteral("/proc/self/task"));
    return now;
}

int asked(const char *name, int otherwise)
{
    const int given = qEnvironmentVariableIntValue(name);
    return given > 0 ? given : otherwise;
}

} // namespace

class TestRecordSoak : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { shareMemoryPools(); } // as main() does
    void init();
    void cleanup();
    void whatIsHeldStaysAsItIs();

private:
    void recordTrial(int number, double seconds);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<Project> m_project; ///< to look into what the window records
};

void TestRecordSoak::init()
{
    test::beginWithoutSettings();
    m_folder = std::make_unique<QTemporaryDir>();
    const std::filesystem::path file = m_folder->filePath(QStringLiteral("lesson.odo")).toStdString();
    {
        const auto project = Project::create(file, "Lesson");
        QVERIFY(project);
        test::addCircleLesson(**project);
    }
    m_window = std::make_unique<MainWindow>();
    QVERIFY(m_window->openProject(file));
    m_window->show();
    m_window->showMode(WindowMode::Record);
    test::waitFor(*m_window);
    m_project = std::move(*Project::openAgain(file, Project::Access::ReadOnly));
}

void TestRecordSoak::cleanup()
{
    m_project.reset();
    m_window.reset();
}

/// As a teacher does: record, stop, look at the result in Review, and come back for the next team.
void TestRecordSoak::recordTrial(int number, double seconds)
{
    m_window->showMode(WindowMode::Record);
    auto *page = m_window->findChild<RecordPage *>();
    QString failure; // ends the waiting
    const QObject here;
    connect(page, &RecordPage::failed, &here, [&](const Error &error) { failure = errorLine(error); });
    auto *button = page->findChild<QPushButton *>(QStringLiteral("recordButton"));
    QTRY_VERIFY_WITH_TIMEOUT(button->isEnabled(), longestMs);
    button->click();
    QTRY_VERIFY_WITH_TIMEOUT(page->isRecording(), longestMs);
    const auto recorded = [&] { // the newest comes first
        const auto trials = m_project->trials().all();
        return trials && trials->size() == std::size_t(number) && trials->front().durationS > seconds;
    };
    QTRY_VERIFY_WITH_TIMEOUT(recorded() || !failure.isEmpty(), longestMs + int(2000 * seconds));
    QVERIFY2(failure.isEmpty(), qPrintable(failure));
    button->click();
    const auto measured = [&] {
        const auto metrics = m_project->analyses().currentMetrics(m_project->trials().all()->front().id);
        return metrics && metrics->size() == 1;
    };
    const auto ended = [&] { return !page->isRecording() && measured(); };
    QTRY_VERIFY_WITH_TIMEOUT(ended() || !failure.isEmpty(), longestMs);
    QVERIFY2(failure.isEmpty(), qPrintable(failure));
    m_window->showMode(WindowMode::Review);
    test::waitFor(*m_window);
}

void TestRecordSoak::whatIsHeldStaysAsItIs()
{
    const int trials = asked("ODOGRAPH_SOAK_TRIALS", 6);
    const double turnS = 60.0 * asked("ODOGRAPH_SOAK_MINUTES", 0) / trials;
    const double seconds = std::max(1.5, turnS / 2);
    std::vector<Held> after;
    for (int number = 1; number <= trials; ++number) {
        QElapsedTimer turn;
        turn.start();
        recordTrial(number, seconds);
        if (QTest::currentTestFailed())
            return;
        after.push_back(held()); // in Review, where no picture is under way
        m_window->showMode(WindowMode::Record);
        QTRY_VERIFY_WITH_TIMEOUT(turn.elapsed() >= qint64(1000 * turnS), int(1000 * turnS) + longestMs);
        QTextStream(stdout) << QStringLiteral("trial %1: %2 MB used of %3, %4 files, %5 threads\n")
                                   .arg(number)
                                   .arg(after.back().usedMb, 0, 'f', 1)
                                   .arg(after.back().residentMb, 0, 'f', 1)
                                   .arg(after.back().files)
                                   .arg(after.back().threads);
    }

    // The first third fills caches; the last third is held against the middle one. Each by the least it held:
    // what is held for a moment only (a thread that waits for more work, say) does not count.
    const std::size_t third = after.size() / 3;
    const auto least = [&](std::size_t from, auto part) {
        double value = after[from].*part;
        for (std::size_t i = from; i < from + third; ++i)
            value = std::min<double>(value, after[i].*part);
        return value;
    };
    const std::size_t middle = third, last = after.size() - third;
    // One file may be opened for good at some trial or other; what is forgotten at each trial makes more.
    QCOMPARE_LE(least(last, &Held::files), least(middle, &Held::files) + 1);
    // OpenCV's pool starts a worker for each further core when it first needs one, at some trial or other.
    QCOMPARE_LE(least(last, &Held::threads), least(middle, &Held::threads) + QThread::idealThreadCount() - 1);
    QCOMPARE_LE(least(last, &Held::usedMb), least(middle, &Held::usedMb) + imageMb);
    // What lies between the blocks in use comes to rest after some ten trials only: 5 % is what is asked of a
    // long session.
    if (trials >= 30)
        QCOMPARE_LE(least(last, &Held::residentMb), 1.05 * least(middle, &Held::residentMb));
}

ODOGRAPH_TEST(TestRecordSoak, QApplication)
#include "tst_record_soak.moc"
