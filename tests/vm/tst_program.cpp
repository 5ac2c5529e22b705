// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in the emulated machine: the program itself, with a webcam that gives MJPEG and a camera that gives
// raw pictures.
#include "core/video/jpeg.h"
#include "core/video/video_reader.h"
#include "tests/support/program.h"
#include "tests/vm/played_cameras.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace odo;
using namespace odo::test;

class TestProgram : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        m_webcam = playedCamera(0, "Camera A", "A1");
        m_other = playedCamera(1, "Camera B", "B2");
        QVERIFY(m_webcam && m_other);
        QTRY_COMPARE(usbCameras().size(), std::size_t(2));
        QCOMPARE(run({QStringLiteral("new"), project()}).exitStatus, 0);
    }

    void listsTheCameras()
    {
        const QJsonArray cameras = run({QStringLiteral("cameras"), QStringLiteral("--json")})
                                       .json()
                                       .value(QStringLiteral("cameras"))
                                       .toArray();
        const auto webcam = std::ranges::find_if(cameras, [](const QJsonValue &one) {
            return one.toObject().value(QStringLiteral("serial")) == QStringLiteral("A1");
        });
        QVERIFY(webcam != cameras.end());
        const QJsonObject camera = webcam->toObject();
        QCOMPARE(camera.value(QStringLiteral("kind")).toString(), QStringLiteral("v4l2"));
        QVERIFY(camera.value(QStringLiteral("uri")).toString().startsWith(QStringLiteral("v4l2:/dev/video")));
        QVERIFY(camera.value(QStringLiteral("formats"))
                    .toArray()
                    .contains(QStringLiteral("MJPG 640×480 at 30 frames/s")));
        QCOMPARE(camera.value(QStringLiteral("busy")).toBool(true), false);
    }

    void namesOnlyTheBestFormatsToPeople()
    {
        const ProgramRun listed = run({QStringLiteral("cameras")});
        QVERIFY2(listed.out.contains("MJPG 640×480 at 30 frames/s; YUYV 640×480 at 30 frames/s; MJPG 320×240 "
                                     "at 30 frames/s; and 1 more (see --json)"),
                 listed.out);
    }

    void recordsBoth()
    {
        const ProgramRun recorded =
            run({QStringLiteral("record"), project(), QStringLiteral("--trial"), QStringLiteral("live"),
                 QStringLiteral("--seconds"), QStringLiteral("2"), QStringLiteral("--json"),
                 QStringLiteral("--camera"), QStringLiteral("A=") + QString::fromStdString(playedUri("A1")),
                 QStringLiteral("--camera"),
                 QStringLiteral("B=") + QString::fromStdString(playedUri("B2", "YUYV"))});
        QVERIFY2(recorded.exitStatus == 0, recorded.err);
        const QJsonObject answer = recorded.json();
        QVERIFY(answer.value(QStringLiteral("pairs")).toInt() > 0);
        for (const char *name : {"A", "B"}) {
            const QJsonObject view =
                answer.value(QStringLiteral("views")).toObject().value(QLatin1String(name)).toObject();
            const int frames = view.value(QStringLiteral("frames")).toInt(),
                      kept = view.value(QStringLiteral("recorded")).toInt();
            QVERIFY(frames > 5);
            QCOMPARE(kept + view.value(QStringLiteral("lost_by_us")).toInt(), frames);
            QCOMPARE(imagesIn(name), kept);
        }
    }

    /// What the webcam sent is what lies on the disk: decoded, it is the very picture.
    void mjpegIsRecordedAsItCame()
    {
        Frame sent;
        QCOMPARE(JpegDecoder(*jpegFormat(playedFrame())).decode(playedFrame(), std::nullopt, sent),
                 JpegDecoder::Outcome::Decoded);
        auto reader = VideoReader::open(video("A"));
        QVERIFY(reader);
        const auto frame = (*reader)->next();
        QVERIFY(frame && *frame);
        const Frame &kept = **frame;
        QCOMPARE(kept.format.chromaShiftY, 0);
        for (int y = 0; y < sent.y.height; ++y)
            QVERIFY(std::equal(sent.y.row(y), sent.y.row(y) + sent.y.width, kept.y.row(y)));
    }

    void aCameraThatIsNotThereIsToldInOneLine()
    {
        const ProgramRun failed =
            run({QStringLiteral("record"), project(), QStringLiteral("--trial"), QStringLiteral("none"),
                 QStringLiteral("--camera"), QStringLiteral("A=v4l2:/dev/video9")});
        QCOMPARE(failed.exitStatus, 1);
        QCOMPARE(failed.err.trimmed(),
                 QByteArray("odograph: camera v4l2:/dev/video9: it is not connected; plug it in, or choose a "
                            "camera that odograph cameras lists"));
    }

private:
    static ProgramRun run(const QStringList &arguments) { return runProgram(arguments); }
    QString project() const { return m_folder.filePath(QStringLiteral("p.odo")); }
    std::filesystem::path video(const char *view) const
    {
        return m_folder.filePath(QStringLiteral("p.media/live_%1.mkv").arg(QLatin1String(view)))
            .toStdString();
    }
    int imagesIn(const char *view) const
    {
        auto reader = VideoReader::open(video(view));
        int frames = 0;
        while (reader) {
            const auto frame = (*reader)->next();
            if (!frame || !*frame)
                break;
            ++frames;
        }
        return frames;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<UvcCamera> m_webcam, m_other;
};

QTEST_GUILESS_MAIN(TestProgram)
#include "tst_program.moc"
