// SPDX-License-Identifier: GPL-3.0-or-later
// What core says is found again by its patterns: core is made to say it here, so that a sentence that is
// changed there alone is noticed.
#include "core/base/shortage.h"
#include "core/base/units.h"
#include "core/calibration/accuracy_map.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/calibration/lens_influence.h"
#include "core/calibration/registration_checks.h"
#include "core/capture/setup_checks.h"
#include "core/exchange/roster_csv.h"
#include "core/project/project.h"
#include "core/trajectory/internal/spike_flags.h"
#include "core/trajectory/occlusions.h"
#include "core/video/video_reader.h"
#include "core/workflow/record/live_tracking.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_warnings.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/core_words.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <fstream>

using namespace odo;

namespace {

/// A language of a few words, and one in which each letter of a pattern is another: what stays Latin was not
/// known.
class Language : public QTranslator
{
public:
    explicit Language(bool isGerman) : m_isGerman(isGerman) { QCoreApplication::installTranslator(this); }
    ~Language() override { QCoreApplication::removeTranslator(this); }
    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        QString words = QString::fromUtf8(source);
        if (QByteArray(context) != "CoreWords")
            return words;
        if (!m_isGerman)
            return words.replace(QRegularExpression(QStringLiteral("[A-Za-z]")), QStringLiteral("ж"));
        static const QHash<QString, QString> german{
            {QStringLiteral("Good: %1"), QStringLiteral("Gut: %1")},
            {QStringLiteral("jump of %1 mm"), QStringLiteral("Sprung von %1 mm")},
            {QStringLiteral("one left out"), QStringLiteral("eine weggelassen")},
            {QStringLiteral("it foretells pictures held out to %1, the %2 one no better (%3)"),
             QStringLiteral("es sagt andere Bilder auf %1 voraus, %2 nicht besser (%3)")},
            {QStringLiteral("views disagree by %1 mm"), QStringLiteral("%1 mm Abweichung")},
            {QStringLiteral("in step to %1 ms"), QStringLiteral("synchron auf %1 ms")},
            {QStringLiteral("Not found again: %1"), QStringLiteral("Nicht gefunden: %1")},
            {QStringLiteral("%1 and %2"), QStringLiteral("%1 und %2")},
        };
        return german.value(words, words);
    }

private:
    bool m_isGerman;
};

/// What of core's words is still English: words of three letters or more that are no names.
QString leftEnglish(const std::string &words, const QStringList &names)
{
    QString shown = shownWords(words);
    for (const QString &name : names)
        shown.remove(name);
    const auto match = QRegularExpression(QStringLiteral("[A-Za-z]{3,}")).match(shown);
    return match.hasMatch() ? QString::fromStdString(words) + QStringLiteral(" → ") + shown : QString();
}

std::vector<std::string> setupWords()
{
    CheckedCamera usb{
        "Left", {.uri = "v4l2:/dev/video0", .kind = "v4l2", .name = "", .widthPx = 640, .heightPx = 480}};
    CheckedCamera net{"Hall",
                      {.uri = "aravis:x", .kind = "aravis", .name = "", .widthPx = 640, .heightPx = 480}};
    usb.usbBus = net.usbBus = "usb1";
    usb.usbMbps = 480;
    CheckedCamera free = net, lit = usb, off = usb;
    free.usbBus.clear();
    free.registeredWidthPx = 640, free.registeredHeightPx = 480;
    usb.registeredWidthPx = 320, usb.registeredHeightPx = 240;
    usb.health.notHeld = {"Gain", "Focus"};
    net.health.notHeld = {"Gain"};
    free.health.automaticsHeld = true;
    lit.controls = {
        {.id = "exposure_time", .name = "Exposure time", .value = 100, .choices = {}, .unit = "100 µs"}};
    off.controls = {{.id = "power_line",
                     .name = "Power",
                     .kind = CameraControl::Kind::Choice,
                     .value = 0,
                     .choices = {"Disabled"},
                     .unit = ""}};
    CheckedCamera odd = lit, filtered = off;
    odd.controls[0].value = 77;
    filtered.controls[0].choices = {"Hall"};
    PairHealth pairs;
    std::vector<SetupFinding> findings;
    const auto add = [&](const SetupFinding &finding) { findings.push_back(finding); };
    for (const auto &cameras : {std::vector{usb, net}, {usb}, {free}, {}})
        add(checkUsbBuses(cameras));
    net.usbMbps = usb.usbMbps = 0;
    add(checkUsbBuses({usb, net}));
    for (const auto &nodes : {std::vector<VideoNode>{}, {{"/dev/video0", false}}, {{"/dev/video0", true}}})
        add(checkPermissions(nodes));
    for (const auto bytes : {std::optional<std::int64_t>(), {1 << 20}, {1 << 24}}) {
        add(checkReceiveBuffer({free}, bytes));
        add(checkReceiveBuffer({usb}, bytes));
    }
    add(checkPacketSize({usb}, {}));
    add(checkPacketSize({free}, {}));
    add(checkPacketSize({free}, {{"Hall", 1500}}));
    for (const CheckedCamera &camera : {usb, net, free, lit, odd, off, filtered}) {
        add(checkFlicker(camera));
        add(checkAutomatics(camera));
        add(checkPictureSize(camera));
    }
    add(checkStep({usb}, pairs));
    add(checkStep({usb, net}, pairs));
    usb.health.framesPerSecond = 30, net.health.framesPerSecond = 15;
    add(checkStep({usb, net}, pairs));
    net.health.framesPerSecond = 30;
    add(checkStep({usb, net}, pairs));
    pairs.pairs = 9;
    add(checkStep({usb, net}, pairs));
    pairs.p95S = 0.03;
    add(checkStep({usb, net}, pairs));
    std::vector<std::string> words;
    for (const SetupFinding &finding : findings)
        for (const std::string &each : {finding.what, finding.words, finding.advice})
            words.push_back(each);
    return words;
}

std::vector<std::string> healthSentences()
{
    std::vector<std::string> words;
    ViewHealth view;
    words.push_back(healthWords(view));
    view.state = ViewHealth::State::Delivering;
    for (const bool slow : {false, true})
        for (const auto &[wire, us, hasWire] :
             {std::tuple(0, 0, true), {2, 0, true}, {0, 3, true}, {2, 3, true}, {2, 0, false}}) {
            view.slow = slow ? std::optional<Trouble>(Trouble{}) : std::nullopt;
            view.lostOnWire = std::uint64_t(wire), view.lostByUs = std::uint64_t(us), view.hasWire = hasWire;
            words.push_back(healthWords(view));
        }
    for (const double seconds : {50.0, 500.0, 50000.0})
        words.push_back(roomWords({.secondsLeft = seconds, .trouble = {}}));
    words.push_back(inStepWords(0.0012));
    words.push_back(liveWords({.tracked = 9, .dropped = 0, .latencyMedianS = 0.04, .latencyP99S = 0.05}));
    words.push_back(liveWords({.tracked = 9, .dropped = 3, .latencyMedianS = 0.04, .latencyP99S = 0.05}));
    return words;
}

std::vector<std::string> spikeReasons()
{
    FusedTrack track;
    std::vector<ProfilePoint> points(12);
    const SampleFlags flags[] = {flagBit(SampleFlag::ByHand) | flagBit(SampleFlag::Jump),
                                 flagBit(SampleFlag::ViewsDisagree),
                                 flagBit(SampleFlag::ViewsDisagree) | flagBit(SampleFlag::Jump),
                                 flagBit(SampleFlag::Jump),
                                 flagBit(SampleFlag::Jump) | flagBit(SampleFlag::SpeedLimit),
                                 flagBit(SampleFlag::AccelerationLimit),
                                 flagBit(SampleFlag::LowScore),
                                 flagBit(SampleFlag::LowScore)};
    for (std::size_t i = 0; i < std::size(flags); ++i) {
        Sample sample;
        sample.time = Nanoseconds(33'000'000 * std::int64_t(i));
        sample.position = Eigen::Vector2d(0.01 * double(i) + (i == 4 ? 1.0 : 0.0), 0);
        sample.covariance = 1e-6 * Eigen::Matrix2d::Identity();
        sample.viewDisagreementM = 0.0842;
        sample.flags = flags[i];
        track.samples.push_back(sample);
        track.evidence.push_back({{}, 0.31, i == 6});
        points[i].valid = i != 3;
        points[i].position = Eigen::Vector2d(0, 0);
    }
    points.resize(track.samples.size());
    std::vector<std::string> words;
    for (const Spike &spike : describeSpikes(track, points, Nanoseconds(1'000'000'000)))
        words.push_back(spike.reason);
    return words;
}

std::vector<std::string> occlusionReasons()
{
    std::vector<std::string> words;
    for (int cause = 0; cause <= int(OcclusionCause::OutlineTooLarge); ++cause)
        words.push_back(occlusionWords({{}, OcclusionCause(cause), "Hall", "Left"}));
    return words;
}

std::vector<std::string> analysisSentences()
{
    std::vector<std::string> words;
    for (const std::vector<std::string> &others : {std::vector<std::string>{}, {"Left"}, {"Left", "Hall 2"}})
        for (const int count : {1, 3}) {
            AnalysisRecord analysis;
            analysis.robotName = "Hall";
            analysis.doubtfulNames.assign(
                std::size_t(count), {Nanoseconds(3'204'000'000), Nanoseconds(3'898'000'000), {}, others});
            analysis.views = {"A", "B"}; // which have it far apart, or contradict one another
            Sample apart;
            apart.flags = flagBit(SampleFlag::ViewsDisagree);
            analysis.profile.samples.assign(12, apart);
            for (const double apartM : {1.5, 0.0213}) {
                for (Sample &sample : analysis.profile.samples)
                    sample.viewDisagreementM = apartM;
                for (const std::string &warning : analysisWarnings(analysis, "Left"))
                    words.push_back(warning);
            }
        }
    return words;
}

std::vector<std::string> lensVerdicts()
{
    IntrinsicCalibration calibration;
    calibration.intrinsics.widthPx = 640, calibration.intrinsics.heightPx = 480,
    calibration.intrinsics.fxPx = 600;
    calibration.rmsPx = 0.3;
    calibration.lensReason =
        "it foretells pictures held out to 0.31 px, the rational one no better (0.32 px)";
    for (const double rms : {0.3, 0.3, 3.0}) {
        CalibrationPicture picture;
        picture.view.source = "left02.jpg";
        picture.rmsPx = rms;
        calibration.pictures.push_back(picture);
    }
    std::vector<std::string> words{calibrationVerdict(calibration, 0.001)};
    for (const char *where : {"in the far left corner", "at the near edge", "at the right edge", "inside"}) {
        calibration.onFloor = FloorExpectation{0.0012, 0.0123, where};
        words.push_back(calibrationVerdict(calibration, 0.001));
    }
    calibration.crossValidationPx = 0.4;
    calibration.lensReason = "told";
    calibration.disagreeingPart = 0.01;
    calibration.pictures[0].outliers = {1, 2, 3};
    calibration.pictures[0].leftOut = {1};
    words.push_back(calibrationVerdict(calibration, 0.1));
    calibration.halvesApart = FloorExpectation{0.001, 0.002, "inside"};
    calibration.disagreeingPart = 0.2;
    calibration.lensReason = "no other model fits";
    words.push_back(calibrationVerdict(calibration, 0.1));
    return words;
}

/// What is said of markers whose labels were given in another order.
std::vector<std::string> orderWords(const MarkerLayout &layout, const FloorView &view)
{
    std::vector<PointPair> pairs;
    for (const Marker &marker : layout.markers)
        if (const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
            pixel && pairs.size() < 4)
            pairs.push_back({marker.pointInWorld.head<2>(), *pixel, marker.label});
    std::vector<std::string> words{
        betterOrder(pairs, view.camera(), FocalLength::Known, 1e6)}; // many that fit so badly
    const Eigen::Vector2d first = pairs[0].target;
    for (std::size_t i = 0; i < 3; ++i)
        pairs[i].target = i < 2 ? pairs[i + 1].target : first;
    words.push_back(betterOrder(pairs, view.camera(), FocalLength::Known, 1));
    return words;
}

std::vector<std::string> floorWords()
{
    const TrialScenePtr scene = exampleScene({});
    const FloorView &view = *scene->views.front().floorView;
    std::vector<MarkerPixel> pixels, shifted;
    for (const Marker &marker : scene->layout->markers)
        if (const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0}))
            pixels.push_back({marker.label, *pixel});
    std::vector<std::string> words;
    for (const std::string &order : orderWords(*scene->layout, view))
        words.push_back(order);
    for (const bool isKnown : {true, false})
        if (const auto registered = registerFloor(*scene->layout, pixels, view.camera(), isKnown))
            words.push_back(registered->verdict);
    for (const auto &[first, all] : {std::pair(0.0, 0.0), {30.0, 0.0}, {30.0, 30.0}}) {
        shifted = pixels;
        for (std::size_t i = 0; i < shifted.size(); ++i)
            shifted[i].pixel.x() += i == 0 ? first : all;
        words.push_back(checkMoved("Left", view, pixels, shifted, 0.3)->words);
        if (shifted.size() > 3) {
            shifted.pop_back();
            words.push_back(checkMoved("Left", view, pixels, shifted, 0.3)->words);
        }
    }
    const SeenLength seen{&view, "Left", pixels[0].pixel, pixels[1].pixel};
    for (const auto told : {std::optional<double>(), {0.5}, {99.0}})
        words.push_back(checkLength(std::span(&seen, 1), told)->words);
    const FloorGrid grid = gridOver(*scene->layout, 0, 9);
    std::vector<double> sigma(grid.index(0, grid.rows), 0.002);
    words.push_back(summariseAccuracy(grid, sigma, *scene->layout).words);
    sigma.front() = 0.01;
    words.push_back(summariseAccuracy(grid, sigma, *scene->layout).words);
    for (double &each : sigma)
        each = &each == &sigma.front() ? each : NAN;
    words.push_back(summariseAccuracy(grid, sigma, *scene->layout).words);
    sigma.front() = NAN;
    words.push_back(summariseAccuracy(grid, sigma, *scene->layout).words);
    const Profile &profile = scene->robots.front().analysis->profile;
    Profile other = profile;
    other.spikes.clear();
    for (ProfilePoint &point : other.points)
        point.position.x() += 0.01;
    words.push_back(changeBetween(profile, other).words);
    words.push_back(changeBetween(profile, {}).words);
    return words;
}

/// What a person meets first: a file, a roster, markers, a length.
std::vector<std::string> errorSentences()
{
    const TrialScenePtr scene = exampleScene({});
    const FloorView &view = *scene->views.front().floorView;
    std::vector<Error> errors{machineSleptError(std::chrono::minutes(5)), slowCameraError("Left", 12, 30),
                              noThread("the cameras")};
    const auto add = [&](const auto &result) {
        if (!result)
            errors.push_back(result.error());
    };
    add(orShortage(cannotDoThis, []() -> Result<void> { throw std::bad_alloc(); }));
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("Hall.csv")).toStdString();
    add(Project::open(file, Project::Access::ReadWrite));
    add(readRosterCsv(file));
    add(VideoReader::open(file));
    std::ofstream(file).close();
    add(Project::open(file, Project::Access::ReadWrite));
    add(readRosterCsv(file));
    add(VideoReader::open(file));
    std::ofstream(file) << std::string(5000, '-');
    add(Project::open(file, Project::Access::ReadWrite));
    add(readRosterCsv(file));
    add(VideoReader::open(file));
    add(VideoReader::open(file.parent_path()));
    add(registerFloor(*scene->layout, {}, view.camera(), true));
    add(checkMoved("Left", view, {{"O", {1, 1}}, {"U", {1, 1}}}, {}, 0.3));
    add(checkLength({}, std::nullopt));
    add(parseLengthM("Hall"));
    std::vector<std::string> words;
    for (const Error &error : errors)
        words.insert(words.end(), {error.what, error.why, error.advice, error.message()});
    if (errors.size() < 15)
        words.push_back("only these errors: " + std::to_string(errors.size()));
    for (std::string &each : words)
        each = QString::fromStdString(each).replace(folder.path(), QStringLiteral("Hall")).toStdString();
    return words;
}

} // namespace

class TestCoreWords : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { QLocale::setDefault(QLocale::c()); }
    void figuresAndNamesGoOver();
    void whatIsNotKnownStays();
    void inEnglishNothingChanges();
    void eachPatternIsFoundByItself();
    void whatCoreSaysIsKnown_data();
    void whatCoreSaysIsKnown();
    void errorsAreSentences();
};

void TestCoreWords::figuresAndNamesGoOver()
{
    const Language german(true);
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(shownWords(std::string("jump of 212 mm")), QStringLiteral("Sprung von 212 mm"));
    QCOMPARE(shownWords(std::string("views disagree by 84 mm; one left out")),
             QStringLiteral("84 mm Abweichung; eine weggelassen"));
    QCOMPARE(shownWords(std::string("in step to 1.2 ms")), QStringLiteral("synchron auf 1,2 ms"));
    QCOMPARE(shownWords(std::string(
                 "it foretells pictures held out to 0.055 px, the fisheye one no better (0.059 px)")),
             QStringLiteral("es sagt andere Bilder auf 0,055 px voraus, fisheye nicht besser (0,059 px)"));
    QCOMPARE(shownWords(std::string("Not found again: O, U and V.")),
             QStringLiteral("Nicht gefunden: O, U und V."));
    QCOMPARE(shownWords(std::string("Good: jump of 3 mm.")), QStringLiteral("Gut: Sprung von 3 mm."));
    QCOMPARE(shownWords(std::string("Not found again: %1 and 100%2.")),
             QStringLiteral("Nicht gefunden: %1 und 100%2."));
}

void TestCoreWords::whatIsNotKnownStays()
{
    const Language german(true);
    QLocale::setDefault(QLocale(QLocale::German));
    for (const char *each : {"", "nobody says so 1.5", "jump of mm", "a jump of 212 mm", "C:\\x; y. z: 1.5",
                             ".", "; ", ". . . ", ": "})
        QCOMPARE(shownWords(std::string(each)), QString::fromUtf8(each));
    QCOMPARE(shownWords(std::string("nobody says so 1.5; jump of 3 mm")),
             QStringLiteral("nobody says so 1.5; Sprung von 3 mm"));
    const QString markup = QString(10'000, u'x') + QStringLiteral(". <b>%1</b>");
    QCOMPARE(shownWords(markup), markup);
}

void TestCoreWords::inEnglishNothingChanges()
{
    QLocale::setDefault(QLocale(QLocale::German)); // of dates and of numbers, not of words
    for (const auto &sentences : {setupWords(), healthSentences(), spikeReasons(), occlusionReasons(),
                                  analysisSentences(), lensVerdicts(), floorWords(), errorSentences()})
        for (const std::string &each : sentences)
            QCOMPARE(shownWords(each), QString::fromStdString(each));
    for (const CorePattern &pattern : corePatterns())
        QCOMPARE(shownWords(QString::fromUtf8(pattern.english)), QString::fromUtf8(pattern.english));
}

void TestCoreWords::eachPatternIsFoundByItself()
{
    QVERIFY(corePatterns().size() > 700);
    for (const CorePattern &pattern : corePatterns()) {
        QString sentence = QString::fromUtf8(pattern.english);
        QVERIFY2(!sentence.endsWith(u'.'), pattern.english);
        for (int i = 1; i <= 9; ++i)
            sentence.replace(QStringLiteral("%%1").arg(i), QStringLiteral("Q%1").arg(i));
        const CorePattern *found = corePatternOf(sentence);
        QVERIFY2(found != nullptr, pattern.english);
        QVERIFY2(QByteArray(found->english) == pattern.english,
                 qPrintable(sentence + QStringLiteral(" → ") + QString::fromUtf8(found->english)));
    }
}

void TestCoreWords::whatCoreSaysIsKnown_data()
{
    QTest::addColumn<std::vector<std::string>>("sentences");
    QTest::newRow("set-up doctor") << setupWords();
    QTest::newRow("health") << healthSentences();
    QTest::newRow("spikes") << spikeReasons();
    QTest::newRow("occlusions") << occlusionReasons();
    QTest::newRow("analyses") << analysisSentences();
    QTest::newRow("lenses") << lensVerdicts();
    QTest::newRow("floor") << floorWords();
    QTest::newRow("errors") << errorSentences();
}

void TestCoreWords::whatCoreSaysIsKnown()
{
    QFETCH(std::vector<std::string>, sentences);
    QVERIFY(sentences.size() > 5);
    const QStringList names{QStringLiteral("/Hall.csv"),
                            QStringLiteral("Hall.csv"),
                            QStringLiteral("min"),
                            QStringLiteral("class,team,pseudonym"),
                            QStringLiteral("class,team"),
                            QStringLiteral("class"),                                    // columns
                            QStringLiteral("Invalid data found when processing input"), // says libav
                            QStringLiteral("Left"),
                            QStringLiteral("Hall"),
                            QStringLiteral("Gain"),
                            QStringLiteral("Focus"),
                            QStringLiteral("Power"),
                            QStringLiteral("usb1"),
                            QStringLiteral("/dev/video0"),
                            QStringLiteral("left02.jpg")};
    const Language other(false);
    QStringList all;
    for (const std::string &each : sentences)
        if (const QString left = leftEnglish(each, names); !left.isEmpty())
            all << left;
    QVERIFY2(all.isEmpty(), qPrintable(all.join(u'\n')));
}

void TestCoreWords::errorsAreSentences()
{
    const Error error{ErrorCode::Io, "jump of 1.5 mm", "one left out", "nobody says so"};
    QCOMPARE(errorInWords(error), QStringLiteral("Jump of 1.5 mm: one left out. Nobody says so."));
    QCOMPARE(errorLine(error), QString::fromStdString(error.message()));
    const Language german(true);
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(errorInWords(error), QStringLiteral("Sprung von 1,5 mm: eine weggelassen. Nobody says so."));
    QCOMPARE(errorLine(error), QStringLiteral("Sprung von 1,5 mm: eine weggelassen; nobody says so"));
}

ODOGRAPH_TEST(TestCoreWords, QCoreApplication)
#include "tst_core_words.moc"
