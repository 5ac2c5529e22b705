// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/speed_rounds.h"

#include "core/tracking/internal/blob_finder.h"
#include "core/tracking/internal/colour_model.h"
#include "core/tracking/internal/tracked_frame.h"
#include "core/video/video_reader.h"
#include "tests/benchmark/cpu_clock.h"
#include "tests/benchmark/libav_decoding.h"
#include "tests/benchmark/opencv_tracking.h"

#include <array>

namespace odo::test {

namespace {

constexpr std::array<std::size_t, 2> robotNumbers{1, 3};

/// All that is run in a round, each over the whole clip. The arrays: one robot, three robots.
struct Round
{
    PureDecoding h264, mjpeg;
    std::array<TrackedClip, 2> h264Tracked, mjpegShown, mjpegNotShown;
    std::array<OpencvTrackedClip, 2> opencv;
    double searchPerFrameS = 0;
};

/// The search for a robot in the whole picture, as a tracker does that has lost it.
double searchPerFrame(const BenchmarkClip &clip)
{
    const auto reader = VideoReader::open(clip.file);
    BlobFinder finder;
    double seconds = 0;
    int searches = 0;
    while (reader) {
        const auto frame = (*reader)->next();
        if (!frame || !*frame)
            break;
        TrackedFrame tracked(**frame);
        const ChromaDensity background = tracked.backgroundWithout({});
        const ColourModel model(chromaOf(clip.scene.robots[0].colour, (*frame)->format));
        const ChromaTable table = model.givenColourTable(&background);
        const double begin = threadCpuS();
        finder.find(tracked.grid(), table, tracked.grid().bounds(), tracked.searchStep());
        seconds += workS(begin, threadCpuS());
        ++searches;
    }
    return seconds / std::max(searches, 1);
}

Round runRound(const BenchmarkClips &clips)
{
    Round round;
    for (std::size_t i = 0; i < robotNumbers.size(); ++i) {
        round.h264Tracked[i] = trackClip(clips.h264, robotNumbers[i], true);
        round.opencv[i] = trackByOpencv(clips.h264, robotNumbers[i]);
    }
    round.h264 = decodeByLibavcodec(clips.h264.file);
    round.mjpeg = decodeByLibavcodec(clips.mjpeg.file);
    for (std::size_t i = 0; i < robotNumbers.size(); ++i) {
        round.mjpegShown[i] = trackClip(clips.mjpeg, robotNumbers[i], true);
        round.mjpegNotShown[i] = trackClip(clips.mjpeg, robotNumbers[i], false);
    }
    round.searchPerFrameS = searchPerFrame(clips.h264);
    return round;
}

/// The medians over the rounds.
class Rounds
{
public:
    void add(Round round) { m_rounds.push_back(std::move(round)); }
    template <class Function>
    double median(Function of) const
    {
        std::vector<double> values;
        for (const Round &round : m_rounds)
            values.push_back(of(round));
        return odo::test::median(std::move(values));
    }
    /// In milliseconds a frame, as text.
    template <class Function>
    QString ms(Function of) const
    {
        return QString::number(1000 * median([&](const Round &r) { return of(r) / double(r.h264.frames); }),
                               'f', 3);
    }

private:
    std::vector<Round> m_rounds;
};

QString robotsText(std::size_t i)
{
    return robotNumbers[i] == 1 ? QStringLiteral("1 robot")
                                : QStringLiteral("%1 robots").arg(robotNumbers[i]);
}

void addH264(const Rounds &rounds, std::size_t i, std::vector<Measurement> &metrics)
{
    const auto decode = [i](const Round &r) { return r.h264Tracked[i].decodeS; };
    const auto after = [i](const Round &r) { return r.h264Tracked[i].afterS; };
    const auto pure = [](const Round &r) { return r.h264.seconds; };
    const auto opencv = [i](const Round &r) { return r.opencv[i].tracked.afterS; };
    const auto toBgr = [i](const Round &r) { return r.opencv[i].toBgrS; };
    const std::array<double, 2> leastShare{0.97, 0.94};
    metrics.push_back({QStringLiteral("H.264: decode / (decode + track), ") + robotsText(i),
                       rounds.median([&](const Round &r) { return decode(r) / (decode(r) + after(r)); }),
                       leastShare[i],
                       {},
                       {},
                       QStringLiteral("decode %1 ms, track %2 ms").arg(rounds.ms(decode), rounds.ms(after))});
    metrics.push_back({QStringLiteral("H.264: pure libavcodec / (read + track), ") + robotsText(i),
                       rounds.median([&](const Round &r) { return pure(r) / (decode(r) + after(r)); }),
                       {},
                       {},
                       {},
                       QStringLiteral("pure libavcodec %1 ms").arg(rounds.ms(pure))});
    const QString parts = QStringLiteral("HSV, back projection and CamShift %1 ms; to BGR %2 ms")
                              .arg(rounds.ms(opencv), rounds.ms(toBgr));
    metrics.push_back({QStringLiteral("OpenCV's loop / work after decoding, ") + robotsText(i),
                       rounds.median([&](const Round &r) { return opencv(r) / after(r); }),
                       i == 0 ? 60.0 : 30.0,
                       {},
                       {},
                       parts});
    metrics.push_back({QStringLiteral("the same with the way to BGR, ") + robotsText(i),
                       rounds.median([&](const Round &r) { return (toBgr(r) + opencv(r)) / after(r); }),
                       {},
                       {},
                       {},
                       QString()});
}

void addMjpeg(const Rounds &rounds, std::size_t i, std::vector<Measurement> &metrics)
{
    const auto pure = [](const Round &r) { return r.mjpeg.seconds; };
    const auto add = [&](const char *name, std::optional<double> atLeast, auto of) {
        metrics.push_back(
            {QStringLiteral("MJPEG, ") + QString::fromLatin1(name) +
                 QStringLiteral(": tracked / pure libavcodec, ") + robotsText(i),
             rounds.median([&](const Round &r) { return pure(r) / of(r).seconds(); }),
             atLeast,
             {},
             {},
             QStringLiteral("decode %1 ms, track %2 ms, pure libavcodec %3 ms")
                 .arg(rounds.ms([&](const Round &r) { return of(r).decodeS; }),
                      rounds.ms([&](const Round &r) { return of(r).afterS; }), rounds.ms(pure))});
    };
    add("shown", 1.15, [i](const Round &r) -> const TrackedClip & { return r.mjpegShown[i]; });
    add("not shown", i == 0 ? std::optional(2.5) : std::nullopt,
        [i](const Round &r) -> const TrackedClip & { return r.mjpegNotShown[i]; });
}

void addCentres(const QString &name, const CentreErrors &errors, bool ours, std::vector<Measurement> &metrics)
{
    const QString detail =
        QStringLiteral("%1 positions, %2 not found").arg(errors.places).arg(errors.notFound);
    const QString px = QStringLiteral(" px");
    metrics.push_back({name + QStringLiteral(", mean"),
                       errors.meanPx,
                       {},
                       ours ? std::optional(0.10) : std::nullopt,
                       px,
                       detail});
    metrics.push_back({name + QStringLiteral(", 95th percentile"),
                       errors.p95Px,
                       {},
                       ours ? std::optional(0.25) : std::nullopt,
                       px,
                       QString()});
}

} // namespace

std::vector<Measurement> measureSpeed(const BenchmarkClips &clips, int rounds)
{
    const Round warm = runRound(clips);
    if (warm.h264.frames == 0 || warm.h264.frames != warm.h264Tracked[0].frames ||
        warm.mjpeg.frames != warm.mjpegNotShown[0].frames || warm.mjpeg.frames != warm.h264.frames)
        return {};
    Rounds all;
    for (int i = 0; i < rounds; ++i)
        all.add(runRound(clips));
    std::vector<Measurement> metrics;
    for (std::size_t i = 0; i < robotNumbers.size(); ++i)
        addH264(all, i, metrics);
    for (std::size_t i = 0; i < robotNumbers.size(); ++i)
        addMjpeg(all, i, metrics);
    const auto projection = [](const Round &r) { return r.opencv[0].backProjectionS; };
    const auto search = [](const Round &r) { return r.searchPerFrameS * double(r.h264.frames); };
    metrics.push_back(
        {QStringLiteral("calcBackProject / search of the whole frame"),
         all.median([&](const Round &r) { return projection(r) / search(r); }),
         10.0,
         {},
         {},
         QStringLiteral("back projection %1 ms, search %2 ms").arg(all.ms(projection), all.ms(search))});
    return metrics;
}

std::vector<Measurement> measureCentres(const BenchmarkClips &clips)
{
    std::vector<Measurement> metrics;
    constexpr std::size_t robots = 3;
    addCentres(QStringLiteral("centre, H.264"), centreErrors(clips.h264, trackClip(clips.h264, robots, true)),
               true, metrics);
    addCentres(QStringLiteral("centre, MJPEG, not shown"),
               centreErrors(clips.mjpeg, trackClip(clips.mjpeg, robots, false)), true, metrics);
    addCentres(QStringLiteral("centre, H.264, CamShift"),
               centreErrors(clips.h264, trackByOpencv(clips.h264, robots).tracked), false, metrics);
    addCentres(QStringLiteral("centre, MJPEG, CamShift"),
               centreErrors(clips.mjpeg, trackByOpencv(clips.mjpeg, robots).tracked), false, metrics);
    return metrics;
}

Measurement measureColdSearch(const BenchmarkClip &clip)
{
    const auto reader = VideoReader::open(clip.file);
    constexpr std::size_t robots = 3;
    int found = 0, looked = 0;
    for (std::int64_t i = 0; reader && i < clip.frames(); ++i) {
        const auto frame = (*reader)->next();
        if (!frame || !*frame || i % 10 != 0)
            continue;
        const auto tracker = ColourTracker::create(clip.targets(robots));
        const std::vector<Observation> seen = (*tracker)->track(**frame);
        for (std::size_t robot = 0; robot < robots; ++robot, ++looked)
            found +=
                seen[robot].found && (seen[robot].ellipse.centrePx - clip.trueCentre(robot, i)).norm() < 3;
    }
    return {QStringLiteral("robots found at once in a frame never seen before"),
            static_cast<double>(found) / std::max(looked, 1),
            1.0,
            {},
            {},
            QStringLiteral("%1 of %2").arg(found).arg(looked)};
}

} // namespace odo::test
