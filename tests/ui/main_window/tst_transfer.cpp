// SPDX-License-Identifier: GPL-3.0-or-later
// A project is packed, unpacked elsewhere, and its lost videos are found again, all by the window.
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace odo;

namespace {

Answer pressButton(const QString &words)
{
    return [words](QDialog &dialog) {
        const auto buttons = dialog.findChildren<QPushButton *>();
        for (QPushButton *button : buttons)
            if (button->text().remove(u'&') == words && button->isEnabled())
                return button->click();
        qWarning("no button '%s'", qPrintable(words));
    };
}

} // namespace

class TestTransfer : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void isPackedAndOpenedElsewhere();
    void whatIsNoPackedProjectIsRefused();
    void lostVideosAreFound();
    void strayFilesBecomeTrialsOrGo();
    void theNextYearBeginsWithTheSetUp();
    void aProjectIsNeverReplaced_data();
    void aProjectIsNeverReplaced();

private:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    QString message() const { return m_window->findChild<MessageBar *>()->text(); }
    void run(const char *action, const QList<Answer> &answers)
    {
        test::run(*m_window, test::actionOf(*m_window, action), answers);
    }
    /// What was found is asked about when the search has ended; returns when what was chosen is done.
    void answerStrays(const Answer &answer)
    {
        const Person person({answer});
        test::actionOf(*m_window, "Find stray files…")->trigger();
        QTRY_VERIFY(person.isDone());
        QTRY_VERIFY(!m_window->workspace().isBusy());
    }
    std::size_t lostVideos() const;

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestTransfer::initTestCase()
{
    test::beginWithoutSettings();
    QVERIFY(QDir().mkpath(path("school")) && QDir().mkpath(path("home")) && QDir().mkpath(path("empty")));
    const auto made = storeExample(path("school").toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    m_window = std::make_unique<MainWindow>();
    QVERIFY(m_window->openProject(*made));
}

void TestTransfer::aProjectIsNeverReplaced_data()
{
    QTest::addColumn<QString>("action");
    for (const char *action : {"Save a copy as…", "New project…", "New project from this one…"})
        QTest::newRow(action) << QString::fromUtf8(action);
}

/// So nobody is asked whether it shall be: the refusal comes at once, with its name.
void TestTransfer::aProjectIsNeverReplaced()
{
    QFETCH(QString, action);
    QFile taken(path("home/taken.odo"));
    QVERIFY(taken.open(QIODevice::WriteOnly | QIODevice::Truncate) && taken.write("precious") == 8);
    taken.close();
    bool isAsked = false;
    QTimer watch;
    connect(&watch, &QTimer::timeout, this, [&isAsked] {
        auto *const modal = qobject_cast<QDialog *>(QApplication::activeModalWidget());
        isAsked = isAsked || qobject_cast<QMessageBox *>(modal);
        if (isAsked && modal)
            modal->reject();
    });
    watch.start(std::chrono::milliseconds(20));
    run(action.toUtf8().constData(), {chooseFile(taken.fileName())});
    QVERIFY(!isAsked);
    QTRY_VERIFY2(message().contains(QStringLiteral("taken.odo")) &&
                     message().contains(QStringLiteral("a file of that name already exists")),
                 qPrintable(message()));
    QVERIFY(taken.open(QIODevice::ReadOnly));
    QCOMPARE(taken.readAll(), QByteArray("precious"));
}

void TestTransfer::theNextYearBeginsWithTheSetUp()
{
    QVERIFY(!m_window->workspace().project()->teams().all()->empty());
    const std::size_t cameras = m_window->workspace().project()->cameras().all()->size();
    run("New project from this one…", {chooseFile(path("next year"))});
    QTRY_COMPARE(QString::fromStdString(m_window->workspace().project()->file().string()),
                 path("next year.odo"));
    QCOMPARE(m_window->workspace().project()->title().value(), std::string("next year"));
    QCOMPARE(m_window->workspace().project()->cameras().all()->size(), cameras);
    QVERIFY(m_window->workspace().project()->teams().all()->empty());
    QVERIFY(!m_window->workspace().isReadOnly());
}

std::size_t TestTransfer::lostVideos() const
{
    std::size_t lost = 0;
    Project &project = *m_window->workspace().project();
    const auto trials = project.trials().all().value();
    for (const TrialRecord &trial : trials) {
        const auto recordings = project.trials().recordings(trial.id).value();
        for (const RecordingRecord &recording : recordings)
            lost += !std::filesystem::exists(project.resolve(recording));
    }
    return lost;
}

void TestTransfer::isPackedAndOpenedElsewhere()
{
    const std::size_t lost = lostVideos(); // the example's third trial never had any
    run("Pack into one file…", {chooseFile(path("lesson"))});
    QVERIFY2(message().startsWith(QLatin1String("Project packed into ")), qPrintable(message()));
    QVERIFY2(message().contains(QLatin1String("Note: the video of camera A in trial 'Trial 3' is lost")),
             qPrintable(message()));
    QVERIFY(QFile::exists(path("lesson.zip")));
    run("Unpack a packed project…", {chooseFile(path("lesson.zip")), chooseFile(path("home"))});
    QCOMPARE(QString::fromStdString(m_window->workspace().project()->file().string()),
             path("home/lesson/example.odo"));
    QVERIFY(m_window->showTrial("Trial 2"));
    QCOMPARE(lostVideos(), lost);
    QVERIFY(!m_window->workspace().isReadOnly());
}

void TestTransfer::whatIsNoPackedProjectIsRefused()
{
    QFile bad(path("bad.zip"));
    QVERIFY(bad.open(QIODevice::WriteOnly) && bad.write("no archive") > 0);
    bad.close();
    run("Unpack a packed project…", {chooseFile(path("bad.zip")), chooseFile(path("home"))});
    QVERIFY2(message().contains(QLatin1String("choose a file that Odograph has packed"), Qt::CaseInsensitive),
             qPrintable(message()));
    QVERIFY(!QFile::exists(path("home/bad")));
    QVERIFY(m_window->showTrial("Trial 1")); // the one before is still open
}

void TestTransfer::lostVideosAreFound()
{
    // The example's videos have no hash; one that was imported has.
    QFile clip(path("home/clip.mkv"));
    QVERIFY(clip.open(QIODevice::WriteOnly) && clip.write("pictures") > 0);
    clip.close();
    Project &project = *m_window->workspace().project();
    RecordingRecord recording;
    recording.camera = project.cameras().find("A")->id;
    recording.path = path("home/clip.mkv").toStdString();
    recording.sha256 = *fileSha256(recording.path, {});
    recording.bytes = clip.size();
    recording.frameTimes = {Nanoseconds(0)};
    TrialRecord trial;
    trial.name = "Imported";
    QVERIFY(project.trials().add(trial, {recording}));
    const std::size_t lost = lostVideos();

    QVERIFY(QFile::rename(path("home/clip.mkv"), path("other name")));
    QCOMPARE(lostVideos(), lost + 1);
    run("Find lost videos…", {chooseFile(path("empty"))});
    QVERIFY2(message().contains(QLatin1String("lost videos is in this folder")), qPrintable(message()));
    run("Find lost videos…", {chooseFile(m_folder.path())});
    QVERIFY2(message().startsWith(QLatin1String("Found 1 of ")) &&
                 message().endsWith(QLatin1String(" lost videos by their content.")),
             qPrintable(message()));
    QCOMPARE(lostVideos(), lost);
}

void TestTransfer::strayFilesBecomeTrialsOrGo()
{
    run("Find stray files…", {});
    QCOMPARE(message(), QStringLiteral("Every file in the media folder belongs to a trial, a lens "
                                       "calibration or a floor registration."));
    Project &project = *m_window->workspace().project();
    const QDir media(QString::fromStdString(project.mediaFolder().string()));
    const QStringList videos = media.entryList({QStringLiteral("*.mkv")});
    QVERIFY(!videos.isEmpty());
    QVERIFY(QFile::copy(media.filePath(videos.first()), media.filePath(QStringLiteral("lap_A.mkv"))));
    QFile notes(media.filePath(QStringLiteral("notes.txt")));
    QVERIFY(notes.open(QIODevice::WriteOnly) && notes.write("a teacher's") > 0);
    notes.close();
    QVERIFY(notes.copy(media.filePath(QStringLiteral("broken_A.mkv"))));
    answerStrays([](QDialog &dialog) {
        const auto &box = static_cast<QMessageBox &>(dialog);
        QVERIFY2(box.detailedText().contains(QStringLiteral("lap_A.mkv")) &&
                     box.detailedText().contains(QStringLiteral("notes.txt")),
                 qPrintable(box.detailedText()));
        pressButton(QStringLiteral("Add videos as trials"))(dialog);
    });
    QVERIFY2(project.trials().find("recovered: lap").has_value(), qPrintable(message()));
    QVERIFY2(message().startsWith(QStringLiteral("1 trial")), qPrintable(message()));
    answerStrays(pressButton(QStringLiteral("Remove files")));
    QVERIFY2(!media.exists(QStringLiteral("broken_A.mkv")), qPrintable(message()));
    QVERIFY(notes.exists());
    QVERIFY(media.exists(QStringLiteral("lap_A.mkv")));
}

ODOGRAPH_TEST(TestTransfer, QApplication)
#include "tst_transfer.moc"
