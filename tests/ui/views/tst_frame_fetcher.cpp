// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/views/image/frame_fetcher.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestFrameFetcher : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    TrialScenePtr m_scene;

    std::filesystem::path file() const { return m_scene->views[0].file; }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_scene = exampleScene(
            {.frames = 40, .widthPx = 320, .heightPx = 180, .videoFolder = m_folder.path().toStdString()});
    }
    void rapidRequestsEndWithTheLast()
    {
        FrameFetcher fetcher;
        fetcher.setFile(file());
        QSignalSpy ready(&fetcher, &FrameFetcher::frameReady);
        QElapsedTimer clock;
        clock.start();
        for (int i = 0; i < 400; ++i)
            fetcher.request((i * 7) % 40, {160, 90});
        fetcher.request(33, {160, 90});
        QVERIFY2(clock.elapsed() < 1000, "a request must not wait for the decoder");
        QTRY_VERIFY(fetcher.isIdle());
        QCOMPARE(ready.last().at(0).toLongLong(), 33);
        QVERIFY2(ready.count() < 300, "what was overtaken is not decoded");
        QCOMPARE(ready.last().at(1).value<QImage>().size(), QSize(160, 90));
    }
    void steppingBackGivesTheRightPictures()
    {
        FrameFetcher fetcher;
        fetcher.setFile(file());
        QHash<qint64, QImage> forwards;
        for (qint64 frame = 0; frame < 40; ++frame)
            forwards[frame] = imageOf(fetcher, frame);
        FrameFetcher other;
        other.setFile(file());
        for (qint64 frame = 39; frame >= 0; --frame)
            QCOMPARE(imageOf(other, frame), forwards[frame]);
        QVERIFY(forwards[5] != forwards[35]);
    }
    void aMissingFileIsTold()
    {
        FrameFetcher fetcher;
        QSignalSpy failed(&fetcher, &FrameFetcher::failed);
        fetcher.setFile(std::filesystem::path(m_folder.path().toStdString()) / "gone.mkv");
        fetcher.request(0, {160, 90});
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed[0].at(1).toString().contains(QStringLiteral("gone.mkv")));
        fetcher.request(1, {160, 90});
        QTRY_VERIFY(fetcher.isIdle());
        QCOMPARE(failed.count(), 1); // once is enough
    }
    void aChangeOfFileForgetsTheOld()
    {
        FrameFetcher fetcher;
        fetcher.setFile(m_scene->views[1].file);
        fetcher.request(3, {160, 90});
        fetcher.setFile(file());
        QSignalSpy ready(&fetcher, &FrameFetcher::frameReady);
        fetcher.request(4, {160, 90});
        QTRY_VERIFY(fetcher.isIdle());
        QCOMPARE(ready.count(), 1);
        QCOMPARE(ready[0].at(0).toLongLong(), 4);
    }
    void nothingToDoIsNothing()
    {
        FrameFetcher fetcher;
        fetcher.request(0, {160, 90}); // no file
        QVERIFY(fetcher.isIdle());
        fetcher.setFile(file());
        fetcher.request(0, {}); // no size
        QVERIFY(fetcher.isIdle());
    }

private:
    static QImage imageOf(FrameFetcher &fetcher, qint64 frame)
    {
        QImage picture;
        const auto link = QObject::connect(
            &fetcher, &FrameFetcher::frameReady, &fetcher,
            [&](qint64 got, const QImage &image) { picture = got == frame ? image : picture; });
        fetcher.request(frame, {80, 45});
        [&] { QTRY_VERIFY(!picture.isNull()); }();
        QObject::disconnect(link);
        return picture.copy();
    }
};

ODOGRAPH_TEST(TestFrameFetcher, QApplication)
#include "tst_frame_fetcher.moc"
