// SPDX-License-Identifier: GPL-3.0-or-later
// Files that say that they have enormous pictures: refused by what they say, without asking for the memory.
#include "core/base/shortage.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

using namespace odo;
using namespace odo::test;
using namespace std::string_literals;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool canBeLimited = false; // a sanitizer ends the program where memory runs out
#else
constexpr bool canBeLimited = true;
#endif

/// While it lives, this program gets so much more memory and no more, where that can be.
class MemoryLimit
{
public:
    explicit MemoryLimit(rlim_t moreBytes)
    {
        getrlimit(RLIMIT_AS, &m_before);
        std::ifstream statm("/proc/self/statm");
        rlim_t pages = 0;
        statm >> pages;
        rlimit small = m_before;
        small.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + moreBytes;
        if (canBeLimited)
            setrlimit(RLIMIT_AS, &small);
    }
    ~MemoryLimit() { setrlimit(RLIMIT_AS, &m_before); }

private:
    rlimit m_before{};
};

// ten thousand times a picture of these files; the least of the said ones takes 300 MB
constexpr rlim_t enough = 100'000'000;

std::string bigEndian(unsigned value)
{
    return {static_cast<char>(value >> 8), static_cast<char>(value)};
}

} // namespace

class TestHugeImages : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// What is freed goes back to the system at once; else a picture may find room that an earlier one has
    /// left, whatever the limit.
    void initTestCase() { mallopt(M_MMAP_THRESHOLD, 128 * 1024); }

    void picturesAreRefusedByTheirHeader_data()
    {
        QTest::addColumn<QByteArray>("content");
        const auto row = [](const char *name, const std::string &content) {
            QTest::newRow(name) << QByteArray::fromStdString(content);
        };
        row("PNG 60000x60000", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xea\x60\0\0\xea\x60\x08\x02\0\0\0"s);
        row("PNG 60000x2000", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xea\x60\0\0\x07\xd0\x08\x02\0\0\0"s);
        row("JPEG 65000x65000", "\xff\xd8\xff\xe0\0\x04\0\0\xff\xc0\0\x11\x08\xfd\xe8\xfd\xe8\x03\0\0\0\0"s);
        row("PNM 8000x6300", "P6\n8000 6300 255\n"s);
        row("PNM 99999x99999", "P6\n99999 99999 255\n"s);
        row("PNM 32001x8", "P5 32001 8 255\n" + std::string(32001 * 8, 'x'));
        row("PNM 8x32001", "P5 8 32001 255\n" + std::string(32001 * 8, 'x'));
    }
    void picturesAreRefusedByTheirHeader()
    {
        QFETCH(QByteArray, content);
        store("huge.png", content.toStdString());
        const MemoryLimit limit(enough);
        const auto frame = readImage(path("huge.png"));
        QVERIFY(!frame);
        QCOMPARE(frame.error().code, ErrorCode::InvalidInput);
        QVERIFY2(frame.error().message().find(
                     "the limit is 50 megapixels and 32000 pixels a side; make it smaller") !=
                     std::string::npos,
                 frame.error().message().c_str());
    }

    /// The largest one that is read: its file, what is decoded and its planes are 3 bytes a pixel each, and
    /// two of them are enough at a time.
    void theLargestOneTakesLittleMemory()
    {
        if (!canBeLimited)
            QSKIP("a sanitizer takes memory of its own");
        constexpr int side = 7000;
        constexpr rlim_t planes = rlim_t{3} * side * side;
        {
            std::ofstream file(path("largest.ppm"), std::ios::binary);
            file << "P6\n" << side << ' ' << side << " 255\n";
            const std::string row(3 * side, 'x');
            for (int y = 0; y < side; ++y)
                file << row;
        }
        const MemoryLimit limit(2 * planes + 30'000'000);
        auto frame = readImage(path("largest.ppm"));
        QVERIFY2(frame, frame ? "" : frame.error().message().c_str());
        QCOMPARE(frame->y.width, side);
        QCOMPARE(frame->y.at(side - 1, side - 1), std::uint8_t('x'));
        QFile::remove(QString::fromStdString(path("largest.ppm").string()));
    }

    /// libav asks at once for what the worst image could take when packed, and uses little of it.
    void theLargestOneIsPackedInLittleMemory()
    {
        if (!canBeLimited)
            QSKIP("a sanitizer takes memory of its own");
        FrameFormat format{7000, 7000};
        auto buffer = std::make_shared<FrameBuffer>(format);
        const Frame frame = FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
        constexpr rlim_t rows = rlim_t{3} * 7000 * 7000;
        const MemoryLimit limit(2 * rows + 30'000'000);
        const auto png = orShortage(foreignWords("png"), [&] { return colourPng(frame); });
        QVERIFY2(png, png ? "" : png.error().message().c_str());
    }

    void theLongestSideIsRead()
    {
        store("long.pgm", "P5 32000 8 255\n" + std::string(32000 * 8, 'x'));
        const auto frame = readImage(path("long.pgm"));
        QVERIFY2(frame, frame ? "" : frame.error().message().c_str());
        QCOMPARE(frame->y.width, 32000);
    }

    void aVideoOfLongerSidesIsRefused_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<bool>("isRead");
        QTest::newRow("the longest") << 32000 << true;
        QTest::newRow("longer") << 32016 << false;
    }
    void aVideoOfLongerSidesIsRefused()
    {
        QFETCH(int, width);
        QFETCH(bool, isRead);
        FrameFormat format{width, 16};
        format.fullRange = true;
        VideoWriterOptions options;
        options.codec = VideoCodec::Mjpeg;
        QCOMPARE(writeCoded(path("long.mkv"), evenTimes(2, 30), options, format), QString());
        const auto reader = VideoReader::open(path("long.mkv"));
        QCOMPARE(reader.has_value(), isRead);
        if (!isRead)
            QCOMPARE(reader.error().message(), "cannot open the video " + path("long.mkv").string() +
                                                   ": its frames have more than 100 megapixels or 32000 "
                                                   "pixels a side; convert it to a smaller size");
    }

    /// The header of the file says 192x96, that of each picture something else.
    void picturesOfAVideoAreLeftOut_data()
    {
        QTest::addColumn<int>("side");
        QTest::newRow("16000x16000") << 16000; // libav itself refuses nothing below 17000
        QTest::newRow("60000x60000") << 60000;
    }
    void picturesOfAVideoAreLeftOut()
    {
        QFETCH(int, side);
        VideoWriterOptions options;
        options.codec = VideoCodec::Mjpeg;
        QCOMPARE(writeCoded(path("whole.mkv"), evenTimes(6, 30), options), QString());
        std::ifstream in(path("whole.mkv"), std::ios::binary);
        std::string bytes{std::istreambuf_iterator<char>(in), {}};
        const std::string frameHeader = "\xff\xc0\0\x11\x08"s + bigEndian(96) + bigEndian(192);
        int patched = 0;
        for (std::size_t at = bytes.find(frameHeader); at != std::string::npos;
             at = bytes.find(frameHeader, at + 1), ++patched)
            bytes.replace(at + 5, 4, bigEndian(unsigned(side)) + bigEndian(unsigned(side)));
        QCOMPARE(patched, 6);
        store("huge.mkv", bytes);
        const MemoryLimit limit(enough);
        const auto reader = VideoReader::open(path("huge.mkv"));
        if (!reader) {
            QCOMPARE(reader.error().code, ErrorCode::InvalidInput);
            return;
        }
        for (int i = 0; i < 6; ++i) {
            const auto frame = (*reader)->next();
            QVERIFY(!frame);
            QCOMPARE(frame.error().why.english(), std::string("its data are damaged"));
        }
    }

    /// What memory is really too little for is told, and can be tried again.
    void tooLittleMemoryIsSaid()
    {
        if (!canBeLimited)
            QSKIP("memory cannot be limited under a sanitizer");
        FrameFormat large{4000, 4000};
        large.fullRange = true;
        VideoWriterOptions options;
        options.codec = VideoCodec::Mjpeg;
        QCOMPARE(writeCoded(path("large.mkv"), evenTimes(2, 30), options, large), QString());
        const auto reader = VideoReader::open(path("large.mkv"));
        QVERIFY(reader);
        {
            const MemoryLimit limit(1'000'000);
            const auto frame = (*reader)->next();
            QVERIFY(!frame);
            QCOMPARE(frame.error().code, ErrorCode::Unavailable);
            QCOMPARE(frame.error().message(),
                     "cannot decode frame 0 of " + path("large.mkv").string() +
                         ": this computer does not have enough free memory for it; what was saved is safe; "
                         "close other programs and try again");
        }
        QVERIFY((*reader)->frameAt(0));
    }

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    void store(const std::string &name, const std::string &content) const
    {
        std::ofstream(path(name), std::ios::binary) << content;
    }
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestHugeImages, QCoreApplication)
#include "tst_huge_images.moc"
