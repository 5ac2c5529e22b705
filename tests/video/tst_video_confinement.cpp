// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a video file says, reading it opens that file and no other, and no connection.
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <cstdarg>
#include <dlfcn.h>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <set>
#include <sys/socket.h>

using namespace odo;
using namespace odo::test;

namespace {

/// What the program opens while it is watched; a connection is noted as "socket".
class Opened
{
public:
    static void note(const char *what)
    {
        const std::lock_guard lock(s_mutex);
        if (s_watches && what)
            s_names.insert(what);
    }
    static void watch()
    {
        const std::lock_guard lock(s_mutex);
        s_names.clear();
        s_watches = true;
    }
    static std::set<std::string> seen()
    {
        const std::lock_guard lock(s_mutex);
        s_watches = false;
        return s_names;
    }

private:
    static inline std::mutex s_mutex;
    static inline bool s_watches = false;
    static inline std::set<std::string> s_names;
};

template <class Function>
Function next(const char *name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// The mode that stands behind the flags of a call that may make a file.
mode_t modeOf(int flags, va_list arguments)
{
    return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

} // namespace

// They stand before the system's own, for this program and its libraries.
#undef open
#undef open64
#undef openat
extern "C" {
int open(const char *name, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    Opened::note(name);
    return next<int (*)(const char *, int, mode_t)>("open")(name, flags, mode);
}
int open64(const char *name, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    Opened::note(name);
    return next<int (*)(const char *, int, mode_t)>("open64")(name, flags, mode);
}
int openat(int folder, const char *name, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    Opened::note(name);
    return next<int (*)(int, const char *, int, mode_t)>("openat")(folder, name, flags, mode);
}
int socket(int domain, int type, int protocol) noexcept
{
    Opened::note("socket");
    return next<int (*)(int, int, int)>("socket")(domain, type, protocol);
}
}

class TestVideoConfinement : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(writeCoded(path("other.mkv"), evenTimes(5, 30), {}), QString());
        QVERIFY(QDir::setCurrent(m_folder.path())); // relative names would lead to the other file from here
    }

    /// Else the test sees nothing.
    void theFileItselfIsSeen()
    {
        Opened::watch();
        QVERIFY(VideoReader::open(path("other.mkv")));
        const auto seen = Opened::seen();
        QVERIFY(seen.count(path("other.mkv").string()) == 1);
    }

    void nothingElseIsOpened_data()
    {
        QTest::addColumn<QByteArray>("content");
        const auto row = [](const char *name, const char *content) {
            QTest::newRow(name) << QByteArray(content);
        };
        row("HLS", "#EXTM3U\n#EXT-X-VERSION:3\n#EXT-X-TARGETDURATION:2\n#EXT-X-MEDIA-SEQUENCE:0\n#EXTINF:2.0,"
                   "\nother.mkv\n#EXT-X-ENDLIST\n");
        row("HLS from the network",
            "#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXTINF:2.0,\nhttp://127.0.0.1:9/a.ts\n#EXT-X-ENDLIST\n");
        row("HLS with a key", "#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXT-X-KEY:METHOD=AES-128,URI=\"file:///etc/"
                              "passwd\"\n#EXTINF:2.0,\nother.mkv\n#EXT-X-ENDLIST\n");
        row("concat", "ffconcat version 1.0\nfile 'other.mkv'\n");
        row("concat without its header", "file 'other.mkv'\nfile '/etc/passwd'\n");
        row("SDP", "v=0\r\no=- 0 0 IN IP4 127.0.0.1\r\ns=x\r\nc=IN IP4 127.0.0.1\r\nt=0 0\r\nm=video 5004 "
                   "RTP/AVP 96\r\na=rtpmap:96 H264/90000\r\n");
        row("DASH",
            "<?xml version=\"1.0\"?>\n<MPD xmlns=\"urn:mpeg:dash:schema:mpd:2011\" "
            "type=\"static\"><Period><AdaptationSet>"
            "<Representation "
            "id=\"1\"><BaseURL>other.mkv</BaseURL></Representation></AdaptationSet></Period></MPD>\n");
        row("a list of pictures", "other%03d.png\n");
        row("RTSP of RealMedia", "rtsp://127.0.0.1:9/a\n");
        row("an SVG with a picture",
            "<svg xmlns=\"http://www.w3.org/2000/svg\"><image href=\"file:///etc/passwd\"/></svg>\n");
    }
    void nothingElseIsOpened()
    {
        QFETCH(QByteArray, content);
        for (const char *name : {"a.mkv", "a.mp4", "a.m3u8", "a.txt", "a.sdp", "a%03d.png", "a.png"}) {
            std::ofstream(path(name), std::ios::binary) << content.toStdString();
            Opened::watch();
            const bool isVideo = VideoReader::open(path(name)).has_value();
            const bool isImage = readImage(path(name)).has_value();
            auto seen = Opened::seen();
            seen.erase(path(name).string());
            QVERIFY(!isVideo && !isImage);
            QVERIFY2(seen.empty(), seen.empty() ? "" : seen.begin()->c_str());
        }
    }

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestVideoConfinement, QCoreApplication)
#include "tst_video_confinement.moc"
