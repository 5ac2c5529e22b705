// SPDX-License-Identifier: GPL-3.0-or-later
// Videos that are cut, filled with noise, or no videos at all: each is imported with what there is of it, or
// refused by a line, and a refused one leaves the project and its media folder as they were.
#include "core/video/video_reader.h"
#include "core/video/video_writer.h"
#include "tests/attack/attacked.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;

class TestCraftedVideos : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(runProgram({QStringLiteral("new"), path("p.odo")}).exitStatus, 0);
        writeClip("h264.mp4", VideoCodec::H264);
        writeClip("mjpeg.mkv", VideoCodec::Mjpeg);
        writeClip("ffv1.mkv", VideoCodec::Ffv1);
    }

    void isImportedOrRefused_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("content");
        m_number = 0;
        for (const char *clip : {"h264.mp4", "mjpeg.mkv", "ffv1.mkv"}) {
            const QByteArray whole = content(clip);
            const QString ending = QString::fromLatin1(clip).section(u'.', 1);
            for (const double share : {0.0, 0.001, 0.02, 0.3, 0.7, 0.99})
                add(QStringLiteral("%1 cut at %2").arg(QLatin1String(clip)).arg(share), ending,
                    whole.left(qsizetype(share * double(whole.size()))));
            for (int seed = 0; seed < 8; ++seed)
                add(QStringLiteral("%1 damaged %2").arg(QLatin1String(clip)).arg(seed), ending,
                    damaged(whole, seed));
            add(QStringLiteral("%1 without its beginning").arg(QLatin1String(clip)), ending, whole.mid(100));
            add(QStringLiteral("%1 twice").arg(QLatin1String(clip)), ending, whole + whole);
            add(QStringLiteral("%1 behind noise").arg(QLatin1String(clip)), ending,
                damaged(QByteArray(5000, 'x'), 1) + whole);
        }
        const QByteArray project = content("p.odo");
        for (const char *ending : {"mp4", "mkv", "avi", "txt"}) {
            const QString of = QString::fromLatin1(ending);
            add(QStringLiteral("a project called .") + of, of, project);
            add(QStringLiteral("a playlist called .") + of, of,
                "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\n/etc/passwd\n#EXT-X-ENDLIST\n");
            add(QStringLiteral("a list of files called .") + of, of,
                "ffconcat version 1.0\nfile /etc/passwd\n");
            add(QStringLiteral("zeros called .") + of, of, QByteArray(200'000, '\0'));
        }
        QVERIFY2(m_number >= 60, qPrintable(QString::number(m_number)));
    }
    void isImportedOrRefused()
    {
        QFETCH(QString, ending);
        QFETCH(QByteArray, content);
        const QString video = path("crafted.") + ending;
        store(video, content);
        const QByteArray before = fileHash(path("p.odo"));
        const QStringList media = QDir(path("p.media")).entryList(QDir::Files | QDir::Hidden);
        static int trial = 0;
        const AttackedRun run =
            attacked({QStringLiteral("import"), path("p.odo"), QStringLiteral("--trial"),
                      QString::number(++trial), QStringLiteral("--video"), QStringLiteral("A=") + video});
        QVERIFY2(faultOf(run).isEmpty(), qPrintable(faultOf(run)));
        if (run.exitStatus != 0) {
            QCOMPARE(fileHash(path("p.odo")), before);
            QCOMPARE(QDir(path("p.media")).entryList(QDir::Files | QDir::Hidden), media);
        }
        const AttackedRun read =
            attacked({QStringLiteral("calibrate"), path("p.odo"), QStringLiteral("A"), video});
        QVERIFY2(faultOf(read).isEmpty(), qPrintable(faultOf(read)));
        const AttackedRun check = attacked({QStringLiteral("check"), path("p.odo")});
        QVERIFY2(check.exitStatus == 0, check.out.constData());
    }

private:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    void add(const QString &name, const QString &ending, const QByteArray &content)
    {
        constexpr int sample = 8;
        if (isWanted(++m_number, sample))
            QTest::addRow("%d %s", m_number, qPrintable(name)) << ending << content;
    }

    void writeClip(const char *name, VideoCodec codec) const
    {
        constexpr int frames = 60, framesPerSecond = 30;
        const FrameFormat format{
            160, 96, 1, 1, ChromaSiting::Center, YuvMatrix::Bt601, codec == VideoCodec::Mjpeg};
        const auto writer = VideoWriter::create(path(name).toStdString(), format, {.codec = codec});
        QVERIFY2(writer, writer ? "" : writer.error().message().c_str());
        for (int i = 0; i < frames; ++i) {
            const auto buffer = std::make_shared<FrameBuffer>(format);
            for (int y = 0; y < format.height; ++y)
                for (int x = 0; x < format.width; ++x)
                    buffer->yRow(y)[x] = static_cast<std::uint8_t>(x + y + 3 * i);
            QVERIFY(
                (*writer)->write(FrameBuffer::toFrame(buffer, i, fromSeconds(i / double(framesPerSecond)))));
        }
        QVERIFY((*writer)->finish());
    }

    static QByteArray damaged(QByteArray bytes, int seed)
    {
        std::mt19937 random(static_cast<unsigned>(seed));
        for (qsizetype i = 0; i < bytes.size() / 200 + 3; ++i)
            bytes[qsizetype(random() % std::size_t(bytes.size()))] = char(random());
        return bytes;
    }

    QByteArray content(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void store(const QString &name, const QByteArray &content)
    {
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(name));
    }

    QTemporaryDir m_folder;
    int m_number = 0;
};

ODOGRAPH_TEST(TestCraftedVideos, QCoreApplication)
#include "tst_crafted_videos.moc"
