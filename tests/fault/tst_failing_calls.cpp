// SPDX-License-Identifier: GPL-3.0-or-later
// Each use case that writes, with its first, second, ... nth call on the disk failing, or the process killed
// at it: what was acknowledged is there, what is there is whole, nothing half written has a final name, and
// it can be done again.
#include "core/project/project.h"
#include "tests/fault/folder_content.h"
#include "tests/fault/stored_rows.h"
#include "tests/fault/writing_use_cases.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

using namespace odo;
using namespace odo::test;

namespace fs = std::filesystem;

class TestFailingCalls : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QVERIFY(m_place.isValid()); }
    void nothingAcknowledgedIsLost_data();
    void nothingAcknowledgedIsLost();

private:
    QString problemAfter(const UseCase &useCase, const Attempt &attempt);
    QString problemOfProjects() const;
    QString problemOfFiles(const FolderContent &found, const Attempt &attempt) const;
    QString problemOfBackups() const;
    QString problemOfSecondTry(const UseCase &useCase) const;
    QString problemOfError(const Attempt &attempt) const;
    QStringList problemsOf(const UseCase &useCase, const Fault &fault);

    QTemporaryDir m_place{quickFolder()};
    const fs::path m_base = fs::path(m_place.path().toStdString()) / "base";
    const fs::path m_work = fs::path(m_place.path().toStdString()) / "work";
    std::vector<FolderContent> m_steps; ///< what is there before, and after each step
    int m_attempts = 0, m_arrived = 0;
};

namespace {

bool isProject(const fs::path &file)
{
    return file.extension() == ".odo" && !isInTheMaking(QString::fromStdString(file.string()));
}

} // namespace

void TestFailingCalls::nothingAcknowledgedIsLost_data()
{
    QTest::addColumn<UseCase>("useCase");
    for (const UseCase &useCase : writingUseCases())
        QTest::addRow("%s", qPrintable(useCase.name)) << useCase;
    for (int format = 1; format <= 10; ++format) {
        if (isWholeSweep() || format == 1 || format == 10)
            QTest::addRow("migrate format %d", format) << migration(format);
    }
}

void TestFailingCalls::nothingAcknowledgedIsLost()
{
    QFETCH(UseCase, useCase);
    fs::remove_all(m_base);
    fs::create_directories(m_base);
    useCase.prepare(m_base);
    copyFolder(m_base, m_work);
    m_steps = {contentOf(m_work)};
    const auto done = useCase.work(m_work, [this] { m_steps.push_back(contentOf(m_work)); });
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    QVERIFY(m_steps.size() > 1);
    m_steps.back() = contentOf(m_work);
    m_attempts = m_arrived = 0;
    QStringList problems;
    for (const Fault &fault : allFaults())
        problems << problemsOf(useCase, fault);
    qInfo("%s: %d attempts", qPrintable(useCase.name), m_attempts);
    QVERIFY2(problems.isEmpty(), qPrintable(QStringLiteral("%1 problems:\n").arg(problems.size()) +
                                            problems.mid(0, 12).join(u'\n')));
}

QStringList TestFailingCalls::problemsOf(const UseCase &useCase, const Fault &fault)
{
    constexpr int sampled = 3;
    copyFolder(m_base, m_work);
    const Attempt counted = attempt(m_work, fault, 0, useCase.work);
    QStringList problems;
    if (counted.died() || counted.error)
        return {QStringLiteral("without a fault: ") + counted.words()};
    if (counted.calls == 0)
        return {QStringLiteral("no call was counted: the calls are not caught")};
    for (const int nth : spreadCalls(counted.calls, isWholeSweep() ? counted.calls : sampled)) {
        copyFolder(m_base, m_work);
        const Attempt tried = attempt(m_work, fault, nth, useCase.work);
        ++m_attempts;
        if (const QString problem = problemAfter(useCase, tried); !problem.isEmpty())
            problems << problem + QStringLiteral(" after ") + tried.words();
    }
    return problems;
}

QString TestFailingCalls::problemAfter(const UseCase &useCase, const Attempt &attempt)
{
    const bool wasKilled = attempt.fault.kills() && attempt.reached;
    if (attempt.signal != (wasKilled ? SIGKILL : 0))
        return QStringLiteral("ended by signal %1").arg(attempt.signal);
    const auto steps = static_cast<int>(m_steps.size()) - 1;
    if (!attempt.died() && !attempt.error && attempt.acknowledged != steps)
        return QStringLiteral("neither done nor an error");
    for (const QString &problem :
         {problemOfError(attempt), problemOfProjects(), problemOfFiles(contentOf(m_work), attempt),
          problemOfBackups(), attempt.acknowledged == steps ? QString() : problemOfSecondTry(useCase)}) {
        if (!problem.isEmpty())
            return problem;
    }
    return {};
}

/// One line: what, why, and what to do.
QString TestFailingCalls::problemOfError(const Attempt &attempt) const
{
    if (!attempt.error)
        return {};
    if (attempt.error->what.english().empty() || attempt.error->why.english().empty() ||
        attempt.error->advice.english().empty())
        return QStringLiteral("the error does not say what, why and what to do");
    if (attempt.error->code == ErrorCode::Internal)
        return QStringLiteral("the error is called one of the program");
    // SQLite itself takes some pages that cannot be read for damaged
    const bool isDisksWord = attempt.fault.reads;
    if (!isDisksWord && attempt.error->why.english().find("damaged") != std::string::npos)
        return QStringLiteral("a sound file is called damaged");
    return {};
}

/// Each project opens, to be changed.
QString TestFailingCalls::problemOfProjects() const
{
    std::vector<fs::path> projects;
    for (const auto &file : fs::directory_iterator(m_work)) {
        if (isProject(file.path()))
            projects.push_back(file.path());
    }
    for (const fs::path &file : projects) {
        const auto project = Project::open(file, Project::Access::ReadWrite);
        if (!project)
            return QStringLiteral("does not open: ") + QString::fromStdString(project.error().message());
    }
    return {};
}

/// Whatever is there is as it was after the acknowledged steps, or after the next one, which may have arrived
/// without a word.
QString TestFailingCalls::problemOfFiles(const FolderContent &found, const Attempt &attempt) const
{
    const FolderContent &sure = m_steps[static_cast<std::size_t>(attempt.acknowledged)];
    const FolderContent &next =
        m_steps[std::min(m_steps.size() - 1, static_cast<std::size_t>(attempt.acknowledged) + 1)];
    for (auto file = found.begin(); file != found.end(); ++file) {
        const QString &name = file.key();
        if (!sure.contains(name) && !next.contains(name)) {
            const bool cannotRemove =
                attempt.fault.how == FailingCalls::How::FromThenOn && attempt.fault.error != ENOSPC;
            const bool mayStay =
                attempt.died() || cannotRemove || attempt.failedCall.startsWith(QStringLiteral("unlink"));
            const bool isBackup = name.contains(QStringLiteral(".odo.bak-"));
            const bool wasThere = m_steps.front().value(name) == file.value();
            if (!isBackup && !(mayStay && (isInTheMaking(name) || wasThere)))
                return QStringLiteral("'%1' is left").arg(name);
        } else if (file.value() != sure.value(name) && file.value() != next.value(name)) {
            if (name == QStringLiteral("old.odo") && file.value() == m_steps.back().value(name))
                continue; // opening it has brought it up to date
            return QStringLiteral("'%1' is neither as before nor as after (%2)")
                .arg(name, firstDifference(next.value(name), file.value()));
        }
    }
    for (auto file = sure.begin(); file != sure.end(); ++file) {
        if (!found.contains(file.key()) && next.contains(file.key()))
            return QStringLiteral("'%1' is gone").arg(file.key());
    }
    return {};
}

/// Restored under another name, each has everything.
QString TestFailingCalls::problemOfBackups() const
{
    for (const auto &file : fs::directory_iterator(m_work)) {
        const std::string name = file.path().filename().string();
        const auto end = name.find(".odo.bak-");
        if (end == std::string::npos || isInTheMaking(QString::fromStdString(name)))
            continue;
        const fs::path place = m_work / "restored";
        fs::create_directory(place);
        fs::copy_file(file.path(), place / "restored.odo");
        {
            const auto project = Project::open(place / "restored.odo", Project::Access::ReadWrite);
            if (!project)
                return QString::fromStdString(name + " cannot be restored: " + project.error().message());
        }
        const QString difference =
            firstDifference(m_steps.back().value(QString::fromStdString(name.substr(0, end) + ".odo")),
                            storedRows(place / "restored.odo"));
        fs::remove_all(place);
        if (!difference.isEmpty())
            return QString::fromStdString(name + " restored differs: ") + difference;
    }
    return {};
}

/// With the disk in order again, by another process.
QString TestFailingCalls::problemOfSecondTry(const UseCase &useCase) const
{
    const Attempt again = attempt(m_work, {}, 0, useCase.work);
    if (again.died())
        return QStringLiteral("the second try ended by signal %1").arg(again.signal);
    const bool arrivedBefore = again.error && (again.error->code == ErrorCode::AlreadyExists ||
                                               again.error->code == ErrorCode::InvalidInput);
    if (again.error && !arrivedBefore)
        return QStringLiteral("the second try fails: ") + QString::fromStdString(again.error->message());
    if (again.error)
        return {}; // a part was there, whole: it says so
    const FolderContent found = contentOf(m_work);
    for (auto file = m_steps.back().begin(); file != m_steps.back().end(); ++file) {
        if (!found.contains(file.key()))
            return QStringLiteral("'%1' is not there after the second try").arg(file.key());
        if (!isProject(file.key().toStdString()) && file.value() != found.value(file.key()))
            return QStringLiteral("'%1' is not whole after the second try").arg(file.key());
    }
    return {};
}

ODOGRAPH_TEST(TestFailingCalls, QCoreApplication)
#include "tst_failing_calls.moc"
