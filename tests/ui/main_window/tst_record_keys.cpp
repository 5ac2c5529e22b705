// SPDX-License-Identifier: GPL-3.0-or-later
// Recording by F9 through the whole window, wherever the focus is.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "ui/main_window/main_window.h"
#include "ui/record/internal/run_card.h"
#include "ui/record/record_page.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QWindow>
#include <algorithm>

using namespace odo;

namespace {

constexpr int startMs = 20000, runMs = 30000; // longest waits, on a busy machine

} // namespace

class TestRecordKeys : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void f9RecordsAndStopsWithTheFocusInTheTeamsCard();
};

void TestRecordKeys::f9RecordsAndStopsWithTheFocusInTheTeamsCard()
{
    test::beginWithoutSettings();
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("lesson.odo")).toStdString();
    {
        const auto project = Project::create(file, "Lesson");
        CameraRecord camera;
        camera.name = "A";
        camera.deviceUri = "sim:A";
        QVERIFY((*project)->cameras().add(camera));
        for (const char *team : {"Falcon", "Otter"})
            QVERIFY((*project)->teams().add({0, team, "9A"}));
    }
    MainWindow window;
    QVERIFY(window.openProject(file));
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
    auto *page = window.findChild<RecordPage *>();
    QVERIFY(page->isVisible());
    const auto *record = page->findChild<QPushButton *>(QStringLiteral("recordButton"));
    QTRY_VERIFY_WITH_TIMEOUT(record->isEnabled(), startMs);

    const auto boxes = page->findChild<RunCard *>()->findChildren<QComboBox *>();
    const auto shown = std::ranges::find_if(boxes, [](const QComboBox *box) { return box->isVisible(); });
    QVERIFY(shown != boxes.end());
    QComboBox *team = *shown; // a single class has no box
    team->setFocus();
    QCOMPARE(QApplication::focusWidget(), team);
    QTest::keyClick(window.windowHandle(), Qt::Key_F9);
    QVERIFY(page->isRecording());
    QVERIFY(!team->isEnabled());
    QTRY_COMPARE_WITH_TIMEOUT(record->text(), QStringLiteral("Stop"), startMs);
    const auto *clock = page->findChild<QLabel *>(QStringLiteral("recordClock"));
    QTRY_VERIFY_WITH_TIMEOUT(clock->text() > QStringLiteral("00:01"), runMs);
    QTest::keyClick(window.windowHandle(), Qt::Key_F9);
    QCOMPARE(record->text(), QStringLiteral("Record"));
    QTRY_VERIFY_WITH_TIMEOUT(!page->isRecording(), runMs);
}

ODOGRAPH_TEST(TestRecordKeys, QApplication)
#include "tst_record_keys.moc"
