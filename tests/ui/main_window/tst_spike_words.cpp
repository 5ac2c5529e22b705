// SPDX-License-Identifier: GPL-3.0-or-later
// A person's word on a sample, in the window: by key, stored, analysed again, and taken back.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"

#include <QAction>
#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestSpikeWords : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aKeyMarksASpikeAndUndoTakesItBack()
    {
        test::beginWithoutSettings();
        QTemporaryDir folder;
        const auto made = storeExample(folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        MainWindow window;
        window.show();
        QVERIFY(window.openProject(*made));
        QVERIFY(window.showTrial("Trial 1"));
        QTRY_VERIFY(!window.workspace().isBusy() && window.isSettled());
        auto *review = window.findChild<ReviewPage *>();
        const auto flags = [review] {
            const auto &samples = review->scene()->robots.front().analysis->profile.samples;
            return std::ranges::find(samples, std::int64_t(12), &Sample::frame)->flags;
        };
        review->timeline().setCurrentFrame(12);
        QVERIFY(!isRejected(flags()));
        review->setFocus();
        QTest::keyClick(review, Qt::Key_X);
        QTRY_VERIFY(!window.workspace().isBusy() && window.isSettled());
        QTRY_VERIFY(hasFlag(flags(), SampleFlag::ByHand) && isRejected(flags()));
        QCOMPARE(review->timeline().currentFrame(), 12); // one looks at what one has done
        const QString told = window.findChild<MessageBar *>()->text();
        QVERIFY2(told.startsWith(QStringLiteral("The sample at")) &&
                     told.contains(QStringLiteral("is not used")),
                 qPrintable(told));
        const auto trial = window.workspace().project()->trials().find("Trial 1");
        QVERIFY(trial);
        QTest::keyClick(review, Qt::Key_Z, Qt::ControlModifier); // nobody has opened the menu yet
        QTRY_VERIFY(window.isSettled() && !hasFlag(flags(), SampleFlag::ByHand));
        window.findChild<QAction *>(QStringLiteral("redo"))->trigger();
        QTRY_VERIFY(window.isSettled() && hasFlag(flags(), SampleFlag::ByHand));
        QTest::keyClick(review, Qt::Key_Backspace);
        QTRY_VERIFY(!window.workspace().isBusy() && window.isSettled() &&
                    !hasFlag(flags(), SampleFlag::ByHand));
    }
};

ODOGRAPH_TEST(TestSpikeWords, QApplication)
#include "tst_spike_words.moc"
