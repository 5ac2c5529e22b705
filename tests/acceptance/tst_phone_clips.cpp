// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_turn.h"
#include "core/video/video_reader.h"
#include "tests/support/demo_lesson.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/video/foreign_files.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <memory>
extern "C" {
#include <libavutil/frame.h>
#include <libswscale/swscale.h>
}

using namespace odo;
using namespace odo::test;

namespace {

/// Of the run's beginning: its fastest moment is well inside, and it ends where the robot is slow.
constexpr int framesTaken = 44, ticksPerSecond = 30, framesCut = 10;

/// How a phone, an action camera or an editor writes what a camera saw.
struct PhoneForm
{
    const char *name;
    RawVideo video; ///< all but its frames
    const char *ending = "mp4";
    int orientation = 1; ///< in which its file says that it is to be turned
    int every = 1;       ///< a frame of two fields is made of so many
    int hidden = 0;      ///< frames before the first that an edit list shows
    const char *options = "";
    double sigmas = 2; ///< that figures may be from those of the untouched clip
    int rotationDeg = 0, bitDepth = 8;
    bool isVariable = false;
    bool isOfSample = false; ///< measured unless all forms are asked for
};

RawVideo coded(const char *encoder, const char *pixels, int range = 1)
{
    RawVideo video;
    video.encoder = encoder;
    video.pixelFormat = pixels;
    video.width = 1280;
    video.height = 720;
    video.frames = framesTaken;
    video.ticksPerSecond = ticksPerSecond;
    video.range = range;
    if (video.encoder == "libx264" || video.encoder == "libx265")
        video.coding = {{"crf", "16"}, {"preset", "ultrafast"}, {"x265-params", "log-level=none"}};
    if (video.encoder == "mjpeg")
        video.coding = {{"global_quality", "354"}, {"flags", "qscale"}};
    if (video.encoder == "libvpx-vp9")
        video.coding = {{"crf", "20"}, {"b", "0"}, {"deadline", "realtime"}, {"cpu-used", "8"}};
    return video;
}

RawVideo phone()
{
    return coded("libx264", "yuv420p");
}

PhoneForm turnedForm(const char *name, int orientation, const std::array<int, 4> &matrix, int rotationDeg)
{
    PhoneForm form{name, phone(), "mov", orientation};
    form.video.turn = matrix;
    if (orientation > 4)
        std::swap(form.video.width, form.video.height);
    form.rotationDeg = rotationDeg;
    return form;
}

std::vector<PhoneForm> phoneForms()
{
    std::vector<PhoneForm> forms;
    const auto add = [&forms](const char *name, RawVideo video, const char *ending,
                              int bitDepth = 8) -> PhoneForm & {
        forms.push_back({name, std::move(video), ending});
        forms.back().bitDepth = bitDepth;
        return forms.back();
    };
    forms.push_back(turnedForm("turned by 180°", 3, {-1, 0, 0, -1}, 180));
    forms.push_back(turnedForm("turned by 90°", 6, {0, 1, -1, 0}, 90));
    forms.push_back(turnedForm("turned by 270°", 8, {0, -1, 1, 0}, 270));
    add("HEVC", coded("libx265", "yuv420p"), "mov");
    add("HEVC, 10 bits", coded("libx265", "yuv420p10le"), "mov", 10);
    auto &hlg = add("HEVC, 10 bits, HLG, BT.2020", coded("libx265", "yuv420p10le"), "mov", 10).video;
    hlg.matrix = 9;
    hlg.transfer = 18;
    add("full range", coded("libx264", "yuvj420p", 2), "mp4");
    add("4:2:2, 10 bits", coded("libx264", "yuv422p10le"), "mkv", 10);
    add("4:4:4", coded("libx264", "yuv444p"), "mkv");
    add("RGB", coded("libx264rgb", "bgr24", 2), "mkv");
    add("VP9", coded("libvpx-vp9", "yuv420p"), "webm");
    add("ProRes", coded("prores_ks", "yuv422p10le"), "mov", 10);
    add("MJPEG in AVI", coded("mjpeg", "yuvj420p", 2), "avi");
    add("B frames", phone(), "mp4").video.coding = {{"crf", "16"}, {"preset", "veryfast"}, {"bf", "4"}};
    add("fragmented", phone(), "mp4").video.muxing = {{"movflags", "frag_keyframe+empty_moov"}};
    auto &wide = add("anamorphic", phone(), "mp4");
    wide.video.width = 960;
    wide.video.aspectWidth = 4;
    wide.video.aspectHeight = 3;
    wide.sigmas = 3;
    auto &fields = add("interlaced", phone(), "mp4");
    fields.video.coding = {{"crf", "16"}, {"preset", "veryfast"}};
    fields.video.isInterlaced = true;
    fields.video.frames = framesTaken / 2;
    fields.video.interval = fields.every = 2;
    fields.sigmas = 3;
    auto &uneven = add("every seventh frame missing", phone(), "mp4");
    uneven.video.ticks.clear();
    for (int i = 0; i < framesTaken; ++i)
        if (i % 7 != 0)
            uneven.video.ticks.push_back(i);
    uneven.video.frames = int(uneven.video.ticks.size());
    uneven.isVariable = true;
    auto &slow = add("slow motion", phone(), "mp4");
    slow.video.interval = 8;
    slow.options = "--rate 30";
    auto &cut = add("trimmed by an edit list", phone(), "mp4");
    cut.hidden = framesCut;
    cut.video.coding.emplace_back("g", "300");
    cut.video.muxing = {{"avoid_negative_ts", "disabled"}, {"use_editlist", "1"}};
    for (int i = 0; i < framesTaken; ++i)
        cut.video.ticks.push_back(i - cut.hidden);
    for (const char *name :
         {"turned by 90°", "HEVC, 10 bits, HLG, BT.2020", "RGB", "anamorphic", "interlaced",
          "every seventh frame missing", "slow motion", "trimmed by an edit list"})
        std::ranges::find(forms, std::string_view(name), &PhoneForm::name)->isOfSample = true;
    return forms;
}

/// Copies a frame into libav's, in its pixel format, size, range and matrix.
void convert(const Frame &frame, const RawVideo &video, AVFrame &image)
{
    const auto from = std::array{frame.y.data, frame.u.data, frame.v.data};
    const int strides[] = {int(frame.y.stride), int(frame.u.stride), int(frame.v.stride)};
    const std::unique_ptr<SwsContext, void (*)(SwsContext *)> scaler(
        sws_getContext(frame.y.width, frame.y.height, AV_PIX_FMT_YUV420P, image.width, image.height,
                       static_cast<AVPixelFormat>(image.format), SWS_BICUBIC | SWS_ACCURATE_RND, nullptr,
                       nullptr, nullptr),
        &sws_freeContext);
    constexpr int one = 1 << 16;
    sws_setColorspaceDetails(scaler.get(), sws_getCoefficients(SWS_CS_ITU601), frame.format.fullRange,
                             sws_getCoefficients(video.matrix == 9 ? SWS_CS_BT2020 : SWS_CS_ITU601),
                             video.range == 2, 0, one, one);
    sws_scale(scaler.get(), from.data(), strides, 0, frame.y.height, image.data, image.linesize);
}

/// The bottom field of a 4:2:0 frame from a later one.
void takeBottomField(const AVFrame &later, AVFrame &image)
{
    for (int plane = 0; plane < 3; ++plane)
        for (int y = 1; y < (plane > 0 ? image.height / 2 : image.height); y += 2)
            std::copy_n(later.data[plane] + std::ptrdiff_t(y) * later.linesize[plane],
                        plane > 0 ? image.width / 2 : image.width,
                        image.data[plane] + std::ptrdiff_t(y) * image.linesize[plane]);
}

struct Figure
{
    double value = 0, sigma = 0;
};
using Figures = std::map<QString, Figure>;

} // namespace

/// Copies of a recorded run as phones, action cameras and editors write clips: each imports without a word
/// about its form (an interlaced one says what it is) and gives the path and the speeds of the untouched one.
/// Prints the table of docs/formats.md.
class TestPhoneClips : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void theSameIsMeasured_data();
    void theSameIsMeasured();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    bool writeView(const PhoneForm &form, int view, const QString &file, int first = 0) const;
    Figures measured(const PhoneForm &form, const QStringList &files, QJsonObject *view = nullptr,
                     QByteArray *words = nullptr);
    QStringList written(const PhoneForm &form, int first = 0) const;

    QTemporaryDir m_folder;
    std::vector<PhoneForm> m_forms = phoneForms();
    std::array<std::vector<Frame>, 2> m_frames; ///< of both views
    std::map<int, Figures> m_untouched;         ///< by the first frame that is shown
};

void TestPhoneClips::initTestCase()
{
    QCOMPARE(provideDemoLesson(m_folder.path()), QString());
    for (int view = 0; view < 2; ++view) {
        const QString file = path(QStringLiteral("demo.media/figure-eight_%1.mkv").arg(QChar(u'A' + view)));
        const auto reader = VideoReader::open(file.toStdString());
        QVERIFY(reader);
        for (int i = 0; i < framesTaken + 1; ++i)
            m_frames[std::size_t(view)].push_back((*reader)->frameAt(i).value());
    }
    PhoneForm plain{"untouched", phone()};
    m_untouched[0] = measured(plain, written(plain));
    plain.name = "untouched, later";
    plain.video.frames -= framesCut;
    m_untouched[framesCut] = measured(plain, written(plain, framesCut));
    QVERIFY(m_untouched[0].size() == 3 && m_untouched[framesCut].size() == 3);
}

bool TestPhoneClips::writeView(const PhoneForm &form, int view, const QString &file, int first) const
{
    RawVideo video = form.video;
    const std::vector<Frame> &frames = m_frames[std::size_t(view)];
    const bool hasMissing = form.isVariable;
    video.fill = [&](AVFrame &image, int number) {
        const int taken =
            first + (hasMissing ? int(form.video.ticks[std::size_t(number)]) : number * form.every);
        // stored so that the file's turn makes it upright: the opposite of a quarter turn, else the same
        const int stored = form.orientation == 6 ? 8 : form.orientation == 8 ? 6 : form.orientation;
        convert(turned(frames[std::size_t(taken)], stored), video, image);
        if (video.isInterlaced) {
            const std::unique_ptr<AVFrame, void (*)(AVFrame *)> later(
                av_frame_alloc(), [](AVFrame *frame) { av_frame_free(&frame); });
            later->format = image.format;
            later->width = image.width;
            later->height = image.height;
            av_frame_get_buffer(later.get(), 0);
            convert(frames[std::size_t(taken) + 1], video, *later);
            takeBottomField(*later, image);
        }
    };
    return writeRaw(file.toStdString(), video);
}

QStringList TestPhoneClips::written(const PhoneForm &form, int first) const
{
    QStringList files;
    for (int view = 0; view < 2; ++view) {
        files << path(QStringLiteral("%1.%2").arg(QChar(u'A' + view)).arg(QString::fromLatin1(form.ending)));
        if (!writeView(form, view, files.back(), first))
            return {};
    }
    return files;
}

Figures TestPhoneClips::measured(const PhoneForm &form, const QStringList &files, QJsonObject *view,
                                 QByteArray *words)
{
    const QString project = path(QStringLiteral("demo.odo")), trial = QString::fromUtf8(form.name);
    QStringList call{QStringLiteral("import"), project, QStringLiteral("--trial"), trial};
    call << QStringLiteral("--video") << QStringLiteral("A=") + files.value(0) << QStringLiteral("--video")
         << QStringLiteral("B=") + files.value(1) << QStringLiteral("--sync") << QStringLiteral("0.007")
         << QStringLiteral("--robot") << QStringLiteral("Green 3") << QStringLiteral("--json");
    call << QString::fromLatin1(form.options).split(u' ', Qt::SkipEmptyParts);
    const ProgramRun imported = runProgram(call);
    const ProgramRun tracked = runProgram({QStringLiteral("track"), project, trial});
    const ProgramRun shown = runProgram({QStringLiteral("show"), project, trial, QStringLiteral("--json")});
    if (imported.exitStatus != 0 || tracked.exitStatus != 0 || shown.exitStatus != 0) {
        qWarning("%s%s%s", imported.err.constData(), tracked.err.constData(), shown.err.constData());
        return {};
    }
    if (words)
        *words = imported.err;
    if (view)
        *view =
            QJsonDocument::fromJson(imported.out)[QStringLiteral("views")][QStringLiteral("A")].toObject();
    Figures figures;
    const QJsonArray metrics =
        QJsonDocument::fromJson(
            shown.out)[QStringLiteral("robots")][QStringLiteral("Green 3")][QStringLiteral("metrics")]
            .toArray();
    for (const QJsonValue &metric : metrics) {
        const QString name = metric[QStringLiteral("name")].toString();
        if (name == QStringLiteral("path_length") || name == QStringLiteral("mean_speed") ||
            name == QStringLiteral("max_speed"))
            figures[name] = {metric[QStringLiteral("value")].toDouble(),
                             metric[QStringLiteral("sigma")].toDouble()};
    }
    return figures;
}

void TestPhoneClips::theSameIsMeasured_data()
{
    QTest::addColumn<int>("number");
    const bool takesAll = qEnvironmentVariableIsSet("ODOGRAPH_ALL_FORMS");
    for (std::size_t i = 0; i < m_forms.size(); ++i) {
        if (takesAll || m_forms[i].isOfSample)
            QTest::newRow(m_forms[i].name) << int(i);
    }
}

void TestPhoneClips::theSameIsMeasured()
{
    QFETCH(int, number);
    const PhoneForm &form = m_forms[std::size_t(number)];
    const QStringList files = written(form);
    QCOMPARE(files.size(), 2);
    QJsonObject view;
    QByteArray words;
    const Figures figures = measured(form, files, &view, &words);
    QCOMPARE(figures.size(), std::size_t(3));
    QCOMPARE(words.isEmpty(), !form.video.isInterlaced);
    QCOMPARE(view[QStringLiteral("rotation_deg")].toInt(), form.rotationDeg);
    QCOMPARE(view[QStringLiteral("bit_depth")].toInt(), form.bitDepth);
    QCOMPARE(view[QStringLiteral("variable_rate")].toBool(), form.isVariable);
    QString row =
        QStringLiteral("| %1 | %2 |").arg(QString::fromUtf8(form.name), QFileInfo(files[0]).suffix());
    bool isSame = true;
    for (const auto &[name, is] : figures) {
        const Figure &was = m_untouched[form.hidden][name];
        const double off = (is.value - was.value) / std::hypot(is.sigma, was.sigma) * std::sqrt(2.0);
        isSame = isSame && std::abs(off) <= form.sigmas && is.sigma < 2 * was.sigma;
        row += QStringLiteral(" %1 ± %2 (%3 σ) |")
                   .arg(is.value, 0, 'f', 4)
                   .arg(is.sigma, 0, 'f', 4)
                   .arg(off, 0, 'f', 1);
    }
    qInfo("%s", qUtf8Printable(row));
    QVERIFY2(isSame, qPrintable(row));
}

ODOGRAPH_TEST(TestPhoneClips, QCoreApplication)
#include "tst_phone_clips.moc"
