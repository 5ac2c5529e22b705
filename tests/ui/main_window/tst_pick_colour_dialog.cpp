// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"
#include "ui/main_window/internal/pick_colour_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

/// A person draws a box round a red robot on a simulated floor, by mouse and by keys.
class TestPickColourDialog : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    PickableVideo m_video;
    QPointF m_robotPx;

    static QPushButton *okOf(const QDialog &dialog)
    {
        return dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    }
    static QString wordsOf(const QDialog &dialog)
    {
        QStringList words;
        for (const QLabel *label : dialog.findChildren<QLabel *>())
            words << label->text();
        return words.join(u'|');
    }
    static void showWithImage(PickColourDialog &dialog)
    {
        dialog.resize(900, 700);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    }
    /// Draws until the picture has come: before that there is nothing to draw on.
    void draw(PickColourDialog &dialog, const QPointF &middlePx, double reachPx) const
    {
        auto *canvas = dialog.findChild<BoxCanvas *>();
        QSignalSpy drawn(canvas, &BoxCanvas::boxChanged);
        const auto place = [&](const QPointF &px) {
            const QRectF image = canvas->imageRect();
            return (image.topLeft() + px * image.width() / canvas->sourceSize().width()).toPoint();
        };
        QTRY_VERIFY_WITH_TIMEOUT(
            ([&] {
                QTest::mousePress(canvas, Qt::LeftButton, {}, place(middlePx - QPointF(reachPx, reachPx)));
                QTest::mouseMove(canvas, place(middlePx));
                QTest::mouseRelease(canvas, Qt::LeftButton, {}, place(middlePx + QPointF(reachPx, reachPx)));
                return drawn.size() > 0;
            }()),
            20000);
    }

private Q_SLOTS:
    void initTestCase()
    {
        SimulatedScene scene = demoTestbed(6);
        scene.durationS = 0.2;
        SimulatedRobot robot;
        robot.name = std::string("Red");
        robot.colour = {215, 35, 40};
        robot.motion = makeLineMotion({1.5, 1.1}, {1.6, 1.1}, 0, 5);
        scene.robots.push_back(robot);
        m_video.name = QStringLiteral("run, camera A");
        m_video.file = m_folder.filePath(QStringLiteral("a.mkv")).toStdString();
        m_video.size = {1280, 720};
        m_video.frames = frameCount(scene, 0);
        QVERIFY(renderVideo(scene, 0, m_video.file, {}, {}).has_value());
        const auto pixel = scene.cameras[0].view.pixelFromWorld({1.5, 1.1, 0.03});
        m_robotPx = {pixel->x(), pixel->y()};
    }

    void aBoxRoundTheRobotGivesItsColour()
    {
        PickColourDialog dialog({m_video});
        showWithImage(dialog);
        QVERIFY(!okOf(dialog)->isEnabled() && !dialog.colour());
        QVERIFY(wordsOf(dialog).contains(QStringLiteral("Draw a tight box round the robot")));
        draw(dialog, m_robotPx, 45);
        QTRY_VERIFY_WITH_TIMEOUT(okOf(dialog)->isEnabled(), 20000);
        QVERIFY(dialog.colour() && dialog.colour()->red > 170 && dialog.colour()->green < 60 &&
                dialog.colour()->blue < 60);
        QVERIFY(wordsOf(dialog).contains(QString::fromStdString(dialog.colour()->toString())));

        // Moved away by keys it holds the floor alone.
        auto *canvas = dialog.findChild<BoxCanvas *>();
        const QRect before = canvas->box();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(canvas, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(canvas->box().size(), before.size());
        QVERIFY(!dialog.colour()); // at once: what was found is of another box
        QTRY_VERIFY_WITH_TIMEOUT(wordsOf(dialog).contains(QStringLiteral(
                                     "it contains no colour that differs from the floor around it")),
                                 20000);
        QVERIFY(!okOf(dialog)->isEnabled());
    }

    void keysAloneDrawABox()
    {
        PickColourDialog dialog({m_video});
        showWithImage(dialog);
        auto *canvas = dialog.findChild<BoxCanvas *>();
        const auto pressed = [canvas] { // until the picture has come
            if (canvas->box().isEmpty())
                QTest::keyClick(canvas, Qt::Key_Up);
            return !canvas->box().isEmpty();
        };
        QTRY_VERIFY_WITH_TIMEOUT(pressed(), 20000);
        const QRect first = canvas->box();
        QVERIFY((first.center() - QPoint(640, 360)).manhattanLength() <= 4); // in the middle, to rounding
        QTest::keyClick(canvas, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(canvas->box().topLeft(), first.topLeft());
        QVERIFY(canvas->box().width() > first.width());
        for (int i = 0; i < 500; ++i)
            QTest::keyClick(canvas, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(canvas->box().width() >= 3); // never turned inside out
        for (int i = 0; i < 60; ++i)
            QTest::keyClick(canvas, Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(canvas->box().left(), 0); // nor out of the picture
    }

    void aVideoThatIsGoneIsSaid()
    {
        PickableVideo gone = m_video;
        gone.file = m_folder.filePath(QStringLiteral("gone.mkv")).toStdString();
        PickColourDialog dialog({gone});
        showWithImage(dialog);
        QTRY_VERIFY_WITH_TIMEOUT(wordsOf(dialog).contains(QStringLiteral("gone.mkv")), 20000);
        QVERIFY(!okOf(dialog)->isEnabled());
    }

    void withoutARecordingItAsksForAVideo()
    {
        PickColourDialog dialog({});
        showWithImage(dialog);
        QVERIFY(!dialog.findChild<QSlider *>()->isEnabled());
        QVERIFY(!dialog.findChild<QComboBox *>()->isEnabled());
        QTest::keyClick(dialog.findChild<BoxCanvas *>(), Qt::Key_Up); // nothing to draw on
        QVERIFY(dialog.findChild<BoxCanvas *>()->box().isEmpty());
    }
};

ODOGRAPH_TEST(TestPickColourDialog, QApplication)
#include "tst_pick_colour_dialog.moc"
