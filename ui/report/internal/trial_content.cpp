// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/trial_content.h"

#include "core/base/file_system.h"
#include "core/base/job_control.h"
#include "core/base/shortage.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/image.h"
#include "core/video/video_reader.h"
#include "core/workflow/compare/trial_metrics.h"
#include "core/workflow/trial_sources.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/report_maker.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <functional>

namespace odo {

namespace {

constexpr int stillWidthPx = 560; // 180 to the inch in a column of the page

/// Of each view; null where it cannot be read. Opening takes longer than decoding an image: they are opened
/// in parallel.
using Readers = std::vector<std::unique_ptr<VideoReader>>;

void forEachView(const TrialScene &scene, const std::function<void(std::size_t view)> &work)
{
    sideBySide(scene.views.size(), work);
}

Readers openVideos(const TrialScene &scene, const CancelToken &cancel)
{
    Readers readers(scene.views.size());
    forEachView(scene, [&](std::size_t view) {
        const SceneView &seen = scene.views[view];
        if (auto reader = VideoReader::open(seen.file, cancel, knownRecording(seen.recording)))
            readers[view] = std::move(*reader);
    });
    return readers;
}

QImage imageOf(const SceneView &view, VideoReader *reader, std::int64_t frame, int widthPx)
{
    if (!reader || view.recording.widthPx <= 0)
        return {};
    const auto decoded = reader->frameAt(frame);
    if (!decoded)
        return {};
    return toImage(toScreen(*decoded, widthPx, widthPx * view.recording.heightPx / view.recording.widthPx));
}

std::vector<Still> takeStills(const TrialScene &scene, const Readers &readers, Nanoseconds time, int widthPx)
{
    std::vector<Still> stills(scene.views.size());
    forEachView(scene, [&](std::size_t view) {
        stills[view].isVideoThere = files::exists(scene.views[view].file);
        const auto frame = scene.frameAt(view, time);
        if (!frame)
            return;
        stills[view].frame = *frame;
        stills[view].image = imageOf(scene.views[view], readers[view].get(), *frame, widthPx);
    });
    return stills;
}

/// The time of the first view's last key frame up to a time; that time itself where its video cannot be read.
Nanoseconds keyFrameTime(const TrialScene &scene, const Readers &readers, Nanoseconds time)
{
    const auto frame = scene.views.empty() ? std::nullopt : scene.frameAt(0, time);
    return frame && readers.front() ? scene.timeOf(0, readers.front()->keyFrameBefore(*frame)) : time;
}

} // namespace

std::vector<Still> takeStills(const TrialScene &scene, Nanoseconds time, int widthPx)
{
    // of a report in the making; a window waits for its stills
    const CancelToken *cancel = CancelScope::current();
    return takeStills(scene, openVideos(scene, cancel ? *cancel : CancelToken()), time, widthPx);
}

Nanoseconds tellingMoment(const TrialScene &scene)
{
    const ProfilePoint *top = nullptr;
    Nanoseconds time{0};
    for (const SceneRobot &robot : scene.robots) {
        for (std::size_t i = 0; robot.analysis && i < robot.analysis->profile.points.size(); ++i) {
            const ProfilePoint &point = robot.analysis->profile.points[i];
            if (!point.valid || (top && point.speedMps <= top->speedMps))
                continue;
            top = &point;
            time = robot.analysis->profile.samples[i].time;
        }
    }
    const auto &times = scene.frameTimes();
    return top || times.empty() ? time : times[times.size() / 2];
}

Result<std::map<std::string, ClassMedian>> TrialContentReader::classMediansOf(const TrialScene &scene)
{
    const std::pair key(scene.trial.className, scene.trial.task);
    if (key.first.empty() || key.second.empty())
        return {};
    if (const auto known = m_classes.find(key); known != m_classes.end())
        return known->second;
    auto names = ODO_TRY(m_project.analyses().metricNames());
    if (!scene.scoring.empty())
        names.push_back(scoreMetric);
    auto medians = classMedians(m_project, key.first, key.second, names);
    if (medians)
        m_classes[key] = *medians;
    return medians;
}

Result<std::vector<std::optional<double>>> TrialContentReader::calibrationsOf(const TrialScene &scene)
{
    std::vector<std::optional<double>> lenses(scene.views.size());
    const auto analysed = std::ranges::find_if(
        scene.robots, [](const SceneRobot &robot) { return robot.analysis.has_value(); });
    if (analysed == scene.robots.end())
        return lenses;
    const std::vector<RecordId> &registrations = analysed->analysis->registrations;
    for (std::size_t view = 0; view < std::min(lenses.size(), registrations.size()); ++view) {
        if (registrations[view] == 0)
            continue;
        const auto registration = ODO_TRY(m_project.cameras().registration(registrations[view]));
        if (registration.intrinsics == 0)
            continue;
        const auto lens = ODO_TRY(m_project.cameras().intrinsics(registration.intrinsics));
        if (lens.calibration.rmsPx > 0)
            lenses[view] = lens.calibration.rmsPx;
    }
    return lenses;
}

Result<TrialContentPtr> TrialContentReader::read(const std::string &trial, const CancelToken &cancel)
{
    const auto scene = ODO_TRY(loadTrialScene(m_project, trial));
    auto content = std::make_shared<TrialContent>();
    content->scene = scene;
    content->classMedians = ODO_TRY(classMediansOf(*scene));
    content->calibrationRmsPx = ODO_TRY(calibrationsOf(*scene));
    content->stillTime = tellingMoment(*scene);
    content->isAtTopSpeed = m_moment == StillMoment::TopSpeed;
    if (m_moment == StillMoment::None)
        return content;
    const Readers readers = openVideos(*scene, cancel);
    if (!content->isAtTopSpeed)
        content->stillTime = keyFrameTime(*scene, readers, content->stillTime);
    content->stills = takeStills(*scene, readers, content->stillTime, stillWidthPx);
    if (cancel.isCancelled()) // its stills may be missing
        return cancelled(reportSubject());
    return content;
}

namespace {

constexpr std::size_t mostStills = 2;
constexpr double stillGap = 6;

class ReportStillsWords
{
    Q_DECLARE_TR_FUNCTIONS(ReportStills)
};

} // namespace

QRectF drawStill(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t view,
                 const Still &still)
{
    const RecordingRecord &recording = scene.views[view].recording;
    const ThemeColours colours = ThemeColours::of(reportPalette());
    const QSizeF size = QSizeF(std::max(1, recording.widthPx), std::max(1, recording.heightPx))
                            .scaled(rect.size(), Qt::KeepAspectRatio);
    const QRectF box(rect.topLeft(), size);
    painter.save();
    painter.setClipRect(box);
    if (still.image.isNull()) {
        painter.fillRect(box, colours.imageBackground);
        const QString why = still.isVideoThere ? ReportStillsWords::tr("no image: the video cannot be read")
                                               : ReportStillsWords::tr("no image: the video is missing");
        drawLine(painter, box, why, reportFont(smallSize), colours.muted, Qt::AlignCenter);
    } else {
        painter.drawImage(box, still.image);
        const double scale = box.width() / recording.widthPx;
        const ImageMap map = [&](const QPointF &pixel) {
            return box.topLeft() + (pixel + QPointF(0.5, 0.5)) * scale;
        };
        painter.setFont(reportFont(smallSize));
        painter.setRenderHint(QPainter::Antialiasing);
        const std::vector<int> positions = paletteIndices(scene);
        for (std::size_t robot = 0; robot < scene.robots.size(); ++robot) {
            if (scene.views[view].floorView)
                paintTrail(painter, scene, robot, *scene.views[view].floorView, map,
                           colourOnImage(positions[robot]));
            paintRobot(painter, scene, view, robot, still.frame, map);
        }
    }
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.border, 0.8));
    painter.drawRect(box);
    const QString name = literalName(scene.views[view].camera);
    const QFont font = reportFont(smallSize, QFont::DemiBold);
    const double width = std::min(box.width(), QFontMetricsF(font).horizontalAdvance(name) + 10);
    const QRectF sign(box.left(), box.top(), width, 14);
    painter.fillRect(sign, colours.card);
    drawLine(painter, sign.adjusted(4, 0, -2, 0), name, font, colours.text);
    return box;
}

void drawStills(QPainter &painter, const QRectF &rect, const TrialScene &scene,
                const std::vector<Still> &stills)
{
    const std::size_t count = std::min(mostStills, stills.size());
    double top = rect.top();
    for (std::size_t view = 0; view < count; ++view) {
        const double height = (rect.height() - stillGap * double(count - 1)) / double(count);
        const QRectF box =
            drawStill(painter, QRectF(rect.left(), top, rect.width(), height), scene, view, stills[view]);
        top = box.bottom() + stillGap;
    }
}

} // namespace odo
