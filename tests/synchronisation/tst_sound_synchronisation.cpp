// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/clip_evidence.h"
#include "tests/support/registered_test.h"
#include "tests/synchronisation/synthetic_sound.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// Draws of each kind: a few, or as many as the environment says.
std::uint32_t draws()
{
    const int asked = qEnvironmentVariableIntValue("ODOGRAPH_SOUND_PAIRS");
    return asked > 0 ? std::uint32_t(asked) : 2;
}

Result<ClipOffset> offsetOf(const HeardPair &pair, const SoundDelay &delay = {0, 0.001})
{
    return estimateSoundOffset(soundCourseOf(pair.first), soundCourseOf(pair.second), delay);
}

/// A world with some sounds in it, as two cameras hear it that begin at 0 and at offsetS.
struct Room
{
    explicit Room(double theLengthS) : lengthS(theLengthS), world(SoundMaker::at(theLengthS)) {}

    void clap(double timeS, double level = 0.8) { SoundMaker::add(world, maker.clap(), timeS, level); }
    HeardPair heard(double offsetS, double drift = 0)
    {
        SoundMaker::add(world, maker.roomNoise(world.size()), 0, 0.0005);
        return {
            SoundMaker::track(world, 0),
            SoundMaker::track(SoundMaker::recorded(world, offsetS, lengthS - std::abs(offsetS), drift), 0),
            offsetS};
    }

    SoundMaker maker{5};
    double lengthS;
    Sound world;
};

} // namespace

/// The offset between two clips from a clap, a knock or a whistle that both heard.
class TestSoundSynchronisation : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void findsIt_data();
    void findsIt();
    void refuses_data();
    void refuses();
    void fastClocks();
    void farApart();
    void clapsThatFitAlike();
    void saysWhyNot_data();
    void saysWhyNot();
    void theWayOfSound();
    void soundDecidesWhereNothingElseDoes();
    void theMostPreciseWins();
    void onlyWhatIsAllowed();
};

void TestSoundSynchronisation::findsIt_data()
{
    QTest::addColumn<HeardKind>("kind");
    QTest::addColumn<double>("leastAnswered");
    QTest::newRow("clap") << HeardKind::Clap << 0.9;
    QTest::newRow("double clap") << HeardKind::DoubleClap << 0.9;
    QTest::newRow("whistle") << HeardKind::Whistle << 0.5;
    QTest::newRow("knock") << HeardKind::Knock << 0.9;
    QTest::newRow("clap over speech") << HeardKind::ClapOverSpeech << 0.9;
}

void TestSoundSynchronisation::findsIt()
{
    QFETCH(HeardKind, kind);
    QFETCH(double, leastAnswered);
    double squares = 0, worstS = 0;
    int answered = 0, within = 0;
    const std::uint32_t count = draws();
    for (std::uint32_t seed = 1; seed <= count; ++seed) {
        const HeardPair pair = hear(kind, seed);
        const auto found = offsetOf(pair);
        if (!found)
            continue;
        const double errorS = found->offsetS - pair.offsetS;
        ++answered;
        within += std::abs(errorS) < 2 * found->sigmaS ? 1 : 0;
        squares += errorS * errorS;
        worstS = std::max(worstS, std::abs(errorS));
        QVERIFY(found->score > 0.3 && found->sigmaS < 0.005);
    }
    const QString told = QStringLiteral("%1 of %2 answered, %3 ms RMS, at most %4 ms, %5 within 2 sigma")
                             .arg(answered)
                             .arg(count)
                             .arg(1e3 * std::sqrt(squares / std::max(1, answered)), 0, 'f', 2)
                             .arg(1e3 * worstS, 0, 'f', 2)
                             .arg(within);
    qInfo().noquote() << told;
    QVERIFY2(answered >= leastAnswered * count && within >= 0.9 * answered, qPrintable(told));
    QVERIFY2(std::sqrt(squares / answered) < 0.001 && worstS < 0.005, qPrintable(told));
}

void TestSoundSynchronisation::refuses_data()
{
    QTest::addColumn<HeardKind>("kind");
    QTest::addColumn<bool>("related");
    QTest::newRow("hum") << HeardKind::Hum << true;
    QTest::newRow("music") << HeardKind::Music << true;
    QTest::newRow("drums") << HeardKind::Drums << true;
    QTest::newRow("other claps") << HeardKind::Clap << false;
    QTest::newRow("other double claps") << HeardKind::DoubleClap << false;
    QTest::newRow("other whistles") << HeardKind::Whistle << false;
    QTest::newRow("other knocks") << HeardKind::Knock << false;
    QTest::newRow("other claps and speech") << HeardKind::ClapOverSpeech << false;
    QTest::newRow("other drums") << HeardKind::Drums << false;
}

void TestSoundSynchronisation::refuses()
{
    QFETCH(HeardKind, kind);
    QFETCH(bool, related);
    for (std::uint32_t seed = 1; seed <= draws(); ++seed) {
        const auto found = offsetOf(hear(kind, seed, related));
        QVERIFY2(!found, qPrintable(QStringLiteral("draw %1").arg(seed)));
        QVERIFY(found.error().code == ErrorCode::Undetermined);
    }
}

void TestSoundSynchronisation::fastClocks()
{
    Room room(130);
    for (const double timeS : {4.0, 4.5, 61.0, 61.7, 122.0, 122.4})
        room.clap(timeS);
    const auto found = offsetOf(room.heard(1.75, 100e-6));
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY2(std::abs(found->offsetS - 1.75) < 0.0005, qPrintable(QString::number(found->offsetS, 'f', 5)));
    QVERIFY2(std::abs(found->rate - 100e-6) < 5e-6, qPrintable(QString::number(found->rate)));
}

void TestSoundSynchronisation::farApart()
{
    Room room(60);
    room.clap(45);
    room.clap(45.41);
    const auto found = offsetOf(room.heard(33.3));
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(std::abs(found->offsetS - 33.3) < 0.001);
}

void TestSoundSynchronisation::clapsThatFitAlike()
{
    Room room(30);
    const Sound clap = room.maker.clap();
    for (const double timeS : {10.0, 11.0, 12.0, 13.0})
        SoundMaker::add(room.world, clap, timeS, 0.8);
    HeardPair pair = room.heard(0);
    // the second began in the midst of them
    pair.second = SoundMaker::track(SoundMaker::recorded(room.world, 11.5, 10, 0), 0);
    const auto found = offsetOf(pair);
    QVERIFY(!found);
    QVERIFY2(found.error().message().find("fit equally well at time offsets of") != std::string::npos,
             found.error().message().c_str());
}

void TestSoundSynchronisation::saysWhyNot_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("why");
    QTest::newRow("silence") << 0 << "no clap, knock or whistle is heard clearly in both clips";
    QTest::newRow("applause") << 1 << "the sound is full of beats that are alike, as in music";
    QTest::newRow("others") << 2 << "the loud sounds of the clips do not match";
    QTest::newRow("nothing at all") << 3 << "no clap, knock or whistle is heard clearly in both clips";
}

void TestSoundSynchronisation::saysWhyNot()
{
    QFETCH(int, kind);
    QFETCH(QString, why);
    Room room(20), other(20);
    for (int i = 0; kind == 1 && i < 20; ++i)
        room.clap(3 + 0.41 * i, 0.5);
    if (kind == 2) {
        room.clap(9);
        other.maker = SoundMaker(77);
        other.clap(12);
    }
    HeardPair pair = room.heard(0);
    if (kind == 2)
        pair.second = other.heard(0).second;
    if (kind == 3)
        pair.second = SoundTrack();
    const auto found = offsetOf(pair);
    QVERIFY(!found);
    QCOMPARE(
        QString::fromStdString(found.error().message()),
        QStringLiteral("synchronisation of the clips: %1; clap twice near the middle of the floor while both "
                       "cameras record, or give --sync SECONDS")
            .arg(why));
}

void TestSoundSynchronisation::theWayOfSound()
{
    MicrophonePosition near, far;
    near.camera = {0, -1.2, 0.5};
    far.camera = {0, 4.8, 2.0};
    near.floorRadiusM = far.floorRadiusM = 1;
    const SoundDelay delay = soundDelay(near, far);
    QCOMPARE(delay.delayS, (5.2 - 1.3) / 343);
    // sounds from anywhere on the disc reach them with these delays
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    double sum = 0, squares = 0;
    int count = 0;
    while (count < 20'000) {
        const Eigen::Vector3d from(anywhere(random), anywhere(random), 0);
        if (from.norm() > 1)
            continue;
        const double lateS = ((far.camera - from).norm() - (near.camera - from).norm()) / 343;
        sum += lateS;
        squares += lateS * lateS;
        ++count;
    }
    const double sigmaS = std::sqrt(squares / count - std::pow(sum / count, 2));
    QVERIFY2(std::abs(sigmaS / delay.sigmaS - 1) < 0.15, qPrintable(QString::number(sigmaS / delay.sigmaS)));
    QVERIFY(std::abs(soundDelay(near, std::nullopt).sigmaS - 0.0044) < 1e-4);
    // it is taken off
    Room room(12);
    room.clap(5);
    room.clap(5.5);
    const HeardPair pair = room.heard(0.5);
    const auto found = offsetOf(pair, {0.0114, 0.001});
    QVERIFY(found && std::abs(found->offsetS - 0.5114) < 1e-4);
}

namespace {

ClipEvidence evidenceOf(const SoundTrack &track)
{
    ClipEvidence evidence;
    evidence.whyNoTracks = ODO_TEXT("test.no_robot", "there is no robot");
    evidence.sound = std::make_shared<SoundCourse>(soundCourseOf(track));
    return evidence;
}

/// A lamp that goes on at a time of a view, of 30 frames a second.
LightCourse lampAt(double timeS)
{
    LightCourse light;
    light.edges = {{timeS, 0.007, true, 0.5}};
    light.durationS = 20;
    light.frameS = 1.0 / 30;
    return light;
}

} // namespace

void TestSoundSynchronisation::soundDecidesWhereNothingElseDoes()
{
    Room room(20);
    room.clap(7);
    room.clap(7.4);
    const HeardPair pair = room.heard(1.25);
    const auto found =
        findClipOffset(evidenceOf(pair.first), evidenceOf(pair.second), {0, 10}, OffsetSource::Any);
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(found->from == OffsetSource::Sound && std::abs(found->clock.offsetS - 1.25) < 0.001);
    QCOMPARE(found->remarks.size(), std::size_t(1));
    QCOMPARE(found->remarks.front().english(),
             std::string("measured by the sound to only ±5.2 ms, because there is no robot"));
}

void TestSoundSynchronisation::theMostPreciseWins()
{
    Room room(20);
    room.clap(7);
    room.clap(7.4);
    const HeardPair pair = room.heard(1.25);
    ClipEvidence first = evidenceOf(pair.first), second = evidenceOf(pair.second);
    first.light = lampAt(9);
    second.light = lampAt(7.75);
    auto found = findClipOffset(first, second, {0, 10});
    QVERIFY(found && found->from == OffsetSource::Sound);
    QCOMPARE(found->remarks.size(), std::size_t(1)); // how well it is known
    second.light = lampAt(7.65);
    found = findClipOffset(first, second, {0, 10});
    QVERIFY(found && found->from == OffsetSource::Sound);
    QCOMPARE(found->remarks.front().english(),
             std::string(
                 "the time offsets found disagree: 1.250 s ±0.005 s by the sound and 1.350 s ±0.011 s by the "
                 "flash of light; the first was used"));
}

void TestSoundSynchronisation::onlyWhatIsAllowed()
{
    Room room(20);
    room.clap(7);
    room.clap(7.4);
    const HeardPair pair = room.heard(1.25);
    ClipEvidence first = evidenceOf(pair.first), second = evidenceOf(pair.second);
    first.light = lampAt(9);
    second.light = lampAt(7.65);
    const auto flash = findClipOffset(first, second, {0, 10}, OffsetSource::Flash);
    QVERIFY(flash && flash->from == OffsetSource::Flash && flash->remarks.empty());
    const auto sound = findClipOffset(first, second, {0, 10}, OffsetSource::Sound);
    QVERIFY(sound && sound->from == OffsetSource::Sound && sound->remarks.empty());
    const auto motion = findClipOffset(first, second, {0, 10}, OffsetSource::Motion);
    QVERIFY(!motion);
    QCOMPARE(motion.error().why.english(), std::string("there is no robot"));
    second.sound = nullptr;
    second.whyNoSound = ODO_TEXT("test.no_sound", "view 'B' has no sound");
    const auto none = findClipOffset(first, second, {0, 10}, OffsetSource::Sound);
    QVERIFY(!none);
    QCOMPARE(
        none.error().message(),
        std::string("synchronisation of the clips: view 'B' has no sound; clap twice near the middle of the "
                    "floor while both cameras record, or give --sync SECONDS"));
    second.light = {};
    const auto nothing = findClipOffset(first, second, {0, 10});
    QVERIFY(!nothing);
    QCOMPARE(nothing.error().message(),
             std::string(
                 "synchronisation of the clips: there is no robot, only one of the views shows a flash of "
                 "light, and view 'B' has no sound; flash the room lights or clap twice while both cameras "
                 "record, or give --sync SECONDS"));
}

ODOGRAPH_TEST(TestSoundSynchronisation, QCoreApplication)
#include "tst_sound_synchronisation.moc"
