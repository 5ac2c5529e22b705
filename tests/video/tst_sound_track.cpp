// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_system.h"
#include "core/video/sound_track.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/sound_clips.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;

/// The sound of a file and when it is heard, by the clock of the file's frames.
class TestSoundTrack : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void clicksAreHeardInTime_data();
    void clicksAreHeardInTime();
    void aGapIsSilent_data();
    void aGapIsSilent();
    void noSound();
    void damagedSound();
    void cancelled();

private:
    std::filesystem::path path(const QString &name) const { return m_folder.filePath(name).toStdString(); }
    QTemporaryDir m_folder;
};

namespace {

/// The loudest moment about a time, by the frames' clock.
double clickNear(const SoundTrack &track, double timeS)
{
    double atS = -1;
    int most = 0;
    for (std::size_t i = 0; i < track.samples.size(); ++i) {
        const double sampleS = track.firstS + double(i) / SoundTrack::rate;
        if (std::abs(sampleS - timeS) < 0.2 && std::abs(int(track.samples[i])) > most) {
            most = std::abs(int(track.samples[i]));
            atS = sampleS;
        }
    }
    return most > 3000 ? atS : -1;
}

} // namespace

void TestSoundTrack::clicksAreHeardInTime_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("codec");
    QTest::addColumn<int>("rate");
    QTest::addColumn<int>("channels");
    QTest::addColumn<double>("lateS");
    const auto row = [](const char *title, const char *name, const char *codec, int rate, int channels,
                        double lateS) {
        QTest::newRow(title) << QString::fromLatin1(name) << QString::fromLatin1(codec) << rate << channels
                             << lateS;
    };
    row("MP4: priming and an edit list", "a.mp4", "aac", 48'000, 1, 0);
    row("MOV", "a.mov", "aac", 44'100, 2, 0);
    row("late sound", "late.mp4", "aac", 48'000, 1, 0.3137);
    row("sound first", "first.mp4", "aac", 44'100, 1, -0.2143);
    row("Matroska", "a.mkv", "aac", 48'000, 1, 0.1);
    row("Opus", "o.mp4", "libopus", 48'000, 1, 0);
    row("MPEG-TS", "a.ts", "aac", 48'000, 1, 0.05);
    row("AVI, PCM", "a.avi", "pcm_s16le", 44'100, 2, 0);
    row("MOV, PCM, late", "p.mov", "pcm_s16le", 48'000, 1, 0.25);
}

void TestSoundTrack::clicksAreHeardInTime()
{
    QFETCH(QString, name);
    QFETCH(QString, codec);
    QFETCH(int, rate);
    QFETCH(int, channels);
    QFETCH(double, lateS);
    SoundClip clip;
    const std::vector<double> clicksS{0.7, 1.3001, 2.4507};
    clip.codec = codec.toStdString();
    clip.soundRate = rate;
    clip.channels = channels;
    clip.soundLateS = lateS;
    clip.sound = clicksAt(clicksS, clip.lengthS, rate);
    QVERIFY(writeSoundClip(path(name), clip));
    const auto track = readSound(path(name), {});
    QVERIFY2(track, track ? "" : track.error().message().c_str());
    QVERIFY(std::abs(track->durationS() - clip.lengthS) < 0.1);
    for (const double clickS : clicksS) {
        const double heardS = clickNear(*track, clickS + lateS);
        QVERIFY2(std::abs(heardS - clickS - lateS) < 0.001,
                 qPrintable(QStringLiteral("%1 ms late").arg(1e3 * (heardS - clickS - lateS))));
    }
}

void TestSoundTrack::aGapIsSilent_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("gapS");
    QTest::newRow("packets") << QStringLiteral("gap.mkv") << 0.5;
    QTest::newRow("one packet") << QStringLiteral("one.mkv") << 0.021;
}

void TestSoundTrack::aGapIsSilent()
{
    QFETCH(QString, name);
    QFETCH(double, gapS);
    SoundClip clip;
    clip.gapAtS = 1;
    clip.gapS = gapS;
    clip.sound = clicksAt({0.5, 2.0}, clip.lengthS, clip.soundRate);
    QVERIFY(writeSoundClip(path(name), clip));
    const auto track = readSound(path(name), {});
    QVERIFY2(track, track ? "" : track.error().message().c_str());
    QVERIFY(std::abs(clickNear(*track, 0.5) - 0.5) < 0.001);
    QVERIFY2(std::abs(clickNear(*track, 2) - 2) < 0.002, qPrintable(QString::number(clickNear(*track, 2))));
}

void TestSoundTrack::noSound()
{
    QVERIFY(writeSoundClip(path(QStringLiteral("mute.mp4")), {}));
    const auto track = readSound(path(QStringLiteral("mute.mp4")), {});
    QVERIFY(!track && track.error().code == ErrorCode::NotFound);
    QCOMPARE(QString::fromStdString(track.error().message()),
             QStringLiteral("cannot read the sound of %1: it has no sound; switch the camera's sound on")
                 .arg(m_folder.filePath(QStringLiteral("mute.mp4"))));
    QVERIFY(!readSound(path(QStringLiteral("nothing.mp4")), {}));
}

void TestSoundTrack::damagedSound()
{
    SoundClip clip;
    clip.sound = clicksAt({0.5, 2.5}, clip.lengthS, clip.soundRate);
    const QString name = QStringLiteral("damaged.mkv");
    QVERIFY(writeSoundClip(path(name), clip));
    QFile file(m_folder.filePath(name));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray bytes = file.readAll();
    for (qsizetype i = bytes.size() * 2 / 5; i < bytes.size() * 3 / 5; i += 7)
        bytes[i] = char(bytes[i] ^ 0x5a);
    file.seek(0);
    file.write(bytes);
    file.close();
    const auto track = readSound(path(name), {});
    for (const double clickS : {0.5, 2.5}) { // what is left of it is where it was
        const double heardS = track ? clickNear(*track, clickS) : -1;
        QVERIFY2(heardS < 0 || std::abs(heardS - clickS) < 0.001, qPrintable(QString::number(heardS)));
    }
    QVERIFY(writeSoundClip(path(name), clip));
    QVERIFY(QFile::resize(m_folder.filePath(name), bytes.size() * 3 / 4));
    const auto half = readSound(path(name), {});
    QVERIFY2(half, half ? "" : half.error().message().c_str());
    QVERIFY2(half->durationS() < 2.8 && std::abs(clickNear(*half, 0.5) - 0.5) < 0.001,
             qPrintable(QStringLiteral("%1 %2").arg(half->durationS()).arg(clickNear(*half, 0.5))));
}

void TestSoundTrack::cancelled()
{
    SoundClip clip;
    clip.sound = clicksAt({0.5}, clip.lengthS, clip.soundRate);
    QVERIFY(writeSoundClip(path(QStringLiteral("c.mp4")), clip));
    CancelToken cancel;
    cancel.cancel();
    const auto track = readSound(path(QStringLiteral("c.mp4")), cancel);
    QVERIFY(!track && track.error().code == ErrorCode::Cancelled);
}

ODOGRAPH_TEST(TestSoundTrack, QCoreApplication)
#include "tst_sound_track.moc"
