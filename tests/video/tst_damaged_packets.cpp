// SPDX-License-Identifier: GPL-3.0-or-later
// Small videos with each of their packets, and everything between them, damaged by a byte or cut off there:
// what is sound is read as before, what is not is named, nothing takes long.
#include "core/video/video_input.h"
#include "core/video/video_reader.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QTemporaryDir>
#include <QTest>
#include <ctime>
#include <fstream>
#include <map>
#include <random>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int count = 24;

/// Where the data of a packet lie in their file, behind what the container writes before them.
struct Place
{
    std::size_t begin, size;
};

std::vector<Place> packetsOf(const std::filesystem::path &file, const std::string &bytes)
{
    std::vector<Place> places;
    const auto input = VideoInput::open(file);
    const libav::PacketPtr packet(av_packet_alloc());
    while (input && (*input)->read(*packet) >= 0) {
        const std::string_view data(reinterpret_cast<const char *>(packet->data),
                                    static_cast<std::size_t>(packet->size));
        places.push_back({bytes.find(data, static_cast<std::size_t>(packet->pos)), data.size()});
    }
    return places;
}

/// What a reader gave, each frame by its time.
struct Readout
{
    std::optional<Error> refused;
    VideoInfo info;
    std::map<std::int64_t, std::uint64_t> frames; ///< fingerprint by nanoseconds
    int damaged = 0;
};

Readout readAll(const std::filesystem::path &file)
{
    Readout out;
    const auto reader = VideoReader::open(file);
    if (!reader) {
        out.refused = reader.error();
        return out;
    }
    out.info = (*reader)->info();
    for (std::size_t i = 0; i < out.info.frameTimes.size(); ++i) {
        const auto frame = (*reader)->next();
        if (!frame)
            ++out.damaged;
        else if (*frame)
            out.frames[(*frame)->time.count()] = fingerprint(**frame);
    }
    for (const std::size_t part : {3U, 1U, 2U}) // and by seeking
        if (const auto frame =
                (*reader)->frameAt(static_cast<std::int64_t>(part * (out.info.frameTimes.size() - 1) / 3));
            !frame && frame.error().code != ErrorCode::InvalidInput)
            out.refused = frame.error();
    return out;
}

} // namespace

class TestDamagedPackets : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        const int all = qEnvironmentVariableIntValue("ODOGRAPH_ALL_DAMAGES");
        m_offsets = all > 0 ? 100 : 3;
        m_elsewhere = all > 0 ? 5000 : 120;
    }
    void flipped_data() { kinds(); }
    void flipped();
    void cutOff_data() { kinds(); }
    void cutOff();
    void betweenThePackets_data() { kinds(); }
    void betweenThePackets();

private:
    static void kinds();
    void make();
    Readout readout(const std::string &bytes);
    QString problemOf(const Readout &found, std::optional<std::size_t> packet) const;

    QTemporaryDir m_folder;
    const std::filesystem::path m_file = std::filesystem::path(m_folder.path().toStdString()) / "whole";
    std::filesystem::path m_damagedFile;
    std::string m_bytes;
    std::vector<Place> m_packets;
    Readout m_whole;
    bool m_eachByItself = false; ///< no packet needs another one
    int m_offsets = 0, m_elsewhere = 0;
    double m_longestS = 0; ///< processor's time
};

void TestDamagedPackets::kinds()
{
    QTest::addColumn<QByteArray>("ending");
    QTest::addColumn<int>("codec");
    QTest::addColumn<int>("bFrames");
    QTest::newRow("MKV of H.264") << QByteArray(".mkv") << int(VideoCodec::H264) << 0;
    QTest::newRow("MP4 of H.264") << QByteArray(".mp4") << int(VideoCodec::H264) << 2;
    QTest::newRow("MKV of MJPEG") << QByteArray(".mkv") << int(VideoCodec::Mjpeg) << 0;
    QTest::newRow("MKV of FFV1") << QByteArray(".mkv") << int(VideoCodec::Ffv1) << 0;
}

void TestDamagedPackets::make()
{
    QFETCH(QByteArray, ending);
    QFETCH(int, codec);
    QFETCH(int, bFrames);
    VideoWriterOptions options;
    options.codec = static_cast<VideoCodec>(codec);
    options.maxBFrames = bFrames;
    options.bitRate = 500'000;
    auto file = m_file;
    file += ending.toStdString();
    m_damagedFile = file.parent_path() / ("damaged" + ending.toStdString());
    QCOMPARE(writeCoded(file, evenTimes(count, 30), options), QString());
    std::ifstream in(file, std::ios::binary);
    m_bytes.assign(std::istreambuf_iterator<char>(in), {});
    m_packets = packetsOf(file, m_bytes);
    m_eachByItself = options.codec != VideoCodec::H264;
    m_longestS = 0;
    QCOMPARE(m_packets.size(), std::size_t(count));
    for (const Place &place : m_packets)
        QVERIFY(place.begin + place.size <= m_bytes.size());
    m_whole = readAll(file);
    QVERIFY(!m_whole.refused && m_whole.damaged == 0);
    QCOMPARE(m_whole.frames.size(), std::size_t(count));
}

Readout TestDamagedPackets::readout(const std::string &bytes)
{
    std::ofstream(m_damagedFile, std::ios::binary) << bytes;
    const std::clock_t begin = std::clock();
    Readout found = readAll(m_damagedFile);
    m_longestS = std::max(m_longestS, double(std::clock() - begin) / CLOCKS_PER_SEC);
    return found;
}

/// packet: the one that was damaged; all others give what they gave before, where they need no other.
QString TestDamagedPackets::problemOf(const Readout &found, std::optional<std::size_t> packet) const
{
    if (found.refused) {
        const bool isTold =
            found.refused->code == ErrorCode::InvalidInput && !found.refused->advice.english().empty();
        if (packet && m_eachByItself)
            return QStringLiteral("refused for one packet: ") +
                   QString::fromStdString(found.refused->message());
        return isTold ? QString() : QString::fromStdString(found.refused->message());
    }
    if (!packet)
        return {};
    int lost = 0;
    for (const auto &[time, print] : m_whole.frames) {
        const bool isAfter = time >= m_whole.info.frameTimes[*packet].count();
        if (isAfter && !m_eachByItself)
            continue;
        const auto same = found.frames.find(time);
        if (same == found.frames.end() || same->second != print)
            ++lost;
    }
    const int allowed = m_eachByItself ? 1 : 2; // B frames are coded after what they lie before
    return lost > allowed ? QStringLiteral("%1 sound frames lost").arg(lost - allowed) : QString();
}

void TestDamagedPackets::flipped()
{
    make();
    QStringList problems;
    for (std::size_t packet = 0; packet < m_packets.size(); ++packet) {
        const Place &place = m_packets[packet];
        for (int i = 0; i < m_offsets; ++i) {
            const std::size_t at =
                place.begin + place.size * static_cast<std::size_t>(i) / static_cast<std::size_t>(m_offsets);
            std::string bytes = m_bytes;
            bytes[at] = static_cast<char>(bytes[at] ^ 0x5a);
            if (const QString problem = problemOf(readout(bytes), packet); !problem.isEmpty())
                problems << QStringLiteral("byte %1 of packet %2: ").arg(at - place.begin).arg(packet) +
                                problem;
        }
    }
    QVERIFY2(problems.isEmpty(), qPrintable(problems.mid(0, 10).join(u'\n')));
    QVERIFY2(m_longestS < 1 * slowness, qPrintable(QString::number(m_longestS)));
}

void TestDamagedPackets::cutOff()
{
    QFETCH(int, bFrames);
    make();
    QStringList problems;
    std::size_t framesBefore = 0;
    for (std::size_t packet = 1; packet < m_packets.size(); ++packet) {
        const Place &place = m_packets[packet];
        for (int i = 0; i < m_offsets; ++i) {
            const std::size_t at =
                place.begin + place.size * static_cast<std::size_t>(i) / static_cast<std::size_t>(m_offsets);
            const Readout found = readout(m_bytes.substr(0, at));
            QString problem = problemOf(found, std::nullopt);
            const std::size_t frames = found.info.frameTimes.size();
            // The frame behind B frames is written before them: what is there may last longer than it has
            // frames.
            if (!found.refused && frames + std::size_t(bFrames) < count * 9 / 10 &&
                found.info.warning.english().find("ends early at ") == std::string::npos)
                problem = QStringLiteral("it does not say where it ends");
            if (frames < framesBefore)
                problem = QStringLiteral("fewer frames than of a shorter file");
            for (const auto &[time, print] : found.frames)
                if (!m_whole.frames.contains(time) ||
                    (m_whole.frames.at(time) != print && time < found.info.frameTimes.back().count()))
                    problem = QStringLiteral("another picture at %1 ns").arg(time);
            framesBefore = std::max(framesBefore, frames);
            if (!problem.isEmpty())
                problems
                    << QStringLiteral("cut at byte %1 of packet %2: ").arg(at - place.begin).arg(packet) +
                           problem;
        }
    }
    QVERIFY2(problems.isEmpty(), qPrintable(problems.mid(0, 10).join(u'\n')));
    QVERIFY(framesBefore >= count * 9 / 10);
    QVERIFY2(m_longestS < 1 * slowness, qPrintable(QString::number(m_longestS)));
}

/// Headers, sizes, time stamps, the index: there a byte may make any file of it, which is read or refused in
/// words.
void TestDamagedPackets::betweenThePackets()
{
    make();
    std::vector<std::size_t> elsewhere;
    std::vector<bool> isPacket(m_bytes.size(), false);
    for (const Place &place : m_packets)
        std::fill_n(isPacket.begin() + static_cast<std::ptrdiff_t>(place.begin), place.size, true);
    for (std::size_t at = 0; at < m_bytes.size(); ++at)
        if (!isPacket[at])
            elsewhere.push_back(at);
    QVERIFY(elsewhere.size() > 300);
    std::mt19937 random(5);
    QStringList problems;
    int read = 0;
    for (int i = 0; i < m_elsewhere; ++i) {
        const std::size_t at = elsewhere[random() % elsewhere.size()];
        std::string bytes = m_bytes;
        bytes[at] = static_cast<char>(random());
        const Readout found = readout(bytes);
        read += !found.refused;
        if (const QString problem = problemOf(found, std::nullopt); !problem.isEmpty())
            problems << QStringLiteral("byte %1 of the file as %2: ").arg(at).arg(int(bytes[at])) + problem;
    }
    QVERIFY2(problems.isEmpty(), qPrintable(problems.mid(0, 10).join(u'\n')));
    QVERIFY2(read > m_elsewhere / 2, qPrintable(QString::number(read))); // most bytes say little
    QVERIFY2(m_longestS < 1 * slowness, qPrintable(QString::number(m_longestS)));
}

ODOGRAPH_TEST(TestDamagedPackets, QCoreApplication)
#include "tst_damaged_packets.moc"
