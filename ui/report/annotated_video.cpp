// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/annotated_video.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/files/file_words.h"
#include "core/project/project.h"
#include "core/video/frame_stream.h"
#include "core/video/image.h"
#include "core/video/video_writer.h"
#include "core/workflow/trial_sources.h"
#include "ui/report/internal/annotated_frame.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QGuiApplication>
#include <algorithm>

namespace odo {
namespace {

/// Reads one view from its beginning to its end, a few frames ahead on a thread of its own.
class ViewFilm
{
public:
    static Result<ViewFilm> open(const SceneView &view, QSize sizePx, const CancelToken &cancel)
    {
        constexpr std::size_t ahead = 4;
        auto stream = ODO_TRY(FrameStream::open(view.file, ahead, cancel, knownRecording(view.recording)));
        return ViewFilm(std::move(stream), sizePx);
    }
    /// The image of a frame at or after the one before; null where it is damaged or the file has ended.
    QImage imageOf(std::int64_t frame)
    {
        while (!m_hasEnded && (!m_last || m_last->index < frame)) {
            auto next = m_stream->pop();
            m_hasEnded = !next || !*next;
            if (!m_hasEnded) {
                m_last = std::move(**next);
                m_image = {};
            }
        }
        if (!m_last || m_last->index != frame)
            return {};
        if (m_image.isNull())
            m_image = toImage(toScreen(*m_last, m_sizePx.width(), m_sizePx.height()));
        return m_image;
    }

private:
    ViewFilm(std::unique_ptr<FrameStream> stream, QSize sizePx)
        : m_stream(std::move(stream)), m_sizePx(sizePx)
    {
    }

    std::unique_ptr<FrameStream> m_stream;
    QSize m_sizePx;
    std::optional<Frame> m_last;
    QImage m_image; ///< of m_last; null: not made yet
    bool m_hasEnded = false;
};

} // namespace

std::vector<Nanoseconds> shownTimes(const std::vector<Nanoseconds> &frameTimes, double speed)
{
    constexpr double mostFramesPerS = 60; // players and screens show no more
    constexpr double jitter = 0.9;        // frames of a camera are not exactly equally far apart
    const Nanoseconds least = fromSeconds(jitter * speed / mostFramesPerS);
    std::vector<Nanoseconds> shown;
    for (const Nanoseconds time : frameTimes) {
        if (shown.empty() || time - shown.back() >= least)
            shown.push_back(time);
    }
    return shown;
}

bool AnnotatedVideoSettings::isSpeed(double speed)
{
    return speed >= 0.1 && speed <= 1;
}

bool AnnotatedVideoSettings::isSize(QSize sizePx)
{
    const auto isLength = [](int px, int least, int most) {
        return px >= least && px <= most && px % 2 == 0;
    };
    return isLength(sizePx.width(), 320, 3840) && isLength(sizePx.height(), 180, 2160);
}

AnnotatedVideoJob::AnnotatedVideoJob(std::string trial, AnnotatedVideoSettings settings)
    : m_trial(std::move(trial)), m_settings(std::move(settings))
{
}

Message AnnotatedVideoJob::what() const
{
    return ODO_TEXT("ui.annotated_video", "annotated video of '%1'")(Named::trial(m_trial));
}

Result<void> AnnotatedVideoJob::prepare(Project &project)
{
    const QSize size = m_settings.sizePx;
    if (!AnnotatedVideoSettings::isSize(size))
        return fail(
            ErrorCode::InvalidInput, what(),
            ODO_TEXT(
                "ui.video_size_wrong",
                "its size of %1x%2 has an odd number of pixels, or is not between 320x180 and 3840x2160")(
                size.width(), size.height()),
            ODO_TEXT("ui.choose_video_size", "choose another, such as 1920x1080"));
    if (!AnnotatedVideoSettings::isSpeed(m_settings.speed))
        return fail(ErrorCode::InvalidInput, what(),
                    ODO_TEXT("ui.video_speed_wrong", "its speed is not between 0.1 and 1"),
                    ODO_TEXT("ui.choose_video_speed", "choose another, such as 0.25"));
    m_scene = ODO_TRY(loadTrialScene(project, m_trial));
    if (m_scene->frameTimes().empty())
        return fail(ErrorCode::NotFound, what(),
                    ODO_TEXT("ui.trial_without_recording", "the trial has no recording"),
                    ODO_TEXT("ui.choose_recorded", "choose one that was recorded"));
    for (const SceneView &view : m_scene->views) {
        std::error_code problem;
        if (files::kindOf(view.file, problem) == files::Kind::Missing && !problem)
            return fail(ErrorCode::NotFound, what(),
                        ODO_TEXT("ui.recording_not_there", "the recording of camera %1 is not at '%2'")(
                            Named::camera(view.camera), Named::file(view.file)),
                        ODO_TEXT("ui.bring_file_back", "move the file back there"));
        if (problem)
            return fail(ErrorCode::Io, quotedFileSubject(view.file), cannotBeRead(problem.message()),
                        checkFileMayBeRead());
        m_inputs.add(view.file);
    }
    m_font = QGuiApplication::font();
    return checkOutput(m_settings.target, videoKind(m_settings.target.file)).map([](const OutputLocation &) {
    });
}

Result<void> AnnotatedVideoJob::run(const JobControl &control)
{
    constexpr double floorPart = 0.05;
    control.report(0, ODO_TEXT("ui.painting_floor", "drawing the floor"));
    AnnotatedFrame painter(m_scene, {m_settings.sizePx, m_settings.isDark ? darkPalette() : lightPalette(),
                                     m_font, m_settings.speed});
    if (const int side = painter.floorSidePx(); side > 0)
        painter.setFloor(makeFloorImage(*m_scene, painter.floorExtent(), side, control.cancel));
    const JobControl rest{control.cancel, [&](double fraction, const Message &text) {
                              control.report(floorPart + (1 - floorPart) * fraction, text);
                          }};
    return writeImages(rest, painter);
}

Result<void> AnnotatedVideoJob::writeImages(const JobControl &control, AnnotatedFrame &painter)
{
    std::vector<Nanoseconds> ofRange = m_scene->frameTimes();
    if (const auto &range = m_scene->trial.range;
        range && std::ranges::any_of(ofRange, [&](Nanoseconds time) { return range->contains(time); }))
        std::erase_if(ofRange, [&](Nanoseconds time) { return !range->contains(time); });
    const std::vector<Nanoseconds> times = shownTimes(ofRange, m_settings.speed);
    const double spanS = toSeconds(times.back() - times.front()) / m_settings.speed;
    VideoWriterOptions options;
    options.nominalFramesPerSecond = spanS > 0 ? double(times.size() - 1) / spanS : 1;
    options.threads = 0;
    std::vector<ViewFilm> films;
    for (std::size_t view = 0; view < m_scene->views.size(); ++view) {
        films.push_back(
            ODO_TRY(ViewFilm::open(m_scene->views[view], painter.viewSizePx(view), control.cancel)));
    }
    FrameFormat format;
    format.width = m_settings.sizePx.width();
    format.height = m_settings.sizePx.height();
    format.siting = ChromaSiting::Center;
    auto writer = ODO_TRY(VideoWriter::create(m_settings.target, format, options));
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (control.isCancelled())
            return cancelled(what());
        std::vector<ViewMoment> moments;
        for (std::size_t view = 0; view < films.size(); ++view) {
            const auto frame = m_scene->frameAt(view, times[i]);
            moments.push_back(frame ? ViewMoment{films[view].imageOf(*frame), *frame} : ViewMoment());
        }
        const QImage image = painter.paint(times[i], moments);
        const Nanoseconds at = fromSeconds(toSeconds(times[i] - times.front()) / m_settings.speed);
        const Frame frame = fromScreen(reinterpret_cast<const std::uint32_t *>(image.constBits()),
                                       image.width(), image.height(), image.bytesPerLine(), at);
        ODO_TRY(writer->write(frame));
        control.report(double(i + 1) / double(times.size()),
                       ODO_TEXT("ui.picture_of", "frame %1 of %2")(i + 1, times.size()));
    }
    m_frameCount = static_cast<int>(times.size());
    m_durationS = double(times.size()) / options.nominalFramesPerSecond;
    return writer->finish();
}

} // namespace odo
