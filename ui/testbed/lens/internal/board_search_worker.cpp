// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/board_search_worker.h"

#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/lens/internal/watched_camera.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/form_fields.h"

#include <QFileInfo>
#include <algorithm>

namespace odo {

namespace {

constexpr int widestOnScreenPx = 1280, mostPending = 2;
constexpr int enoughOfAVideo = 40, videoStep = 5;

QImage forScreen(const Frame &frame)
{
    const double scale = std::min(1.0, double(widestOnScreenPx) / frame.format.width);
    return toImage(toScreen(frame, qRound(scale * frame.format.width), qRound(scale * frame.format.height)));
}

Result<Frame> greyFrame(const std::vector<unsigned char> &png)
{
    const QImage image =
        QImage::fromData(png.data(), int(png.size())).convertToFormat(QImage::Format_Grayscale8);
    FrameFormat format;
    format.width = image.width();
    format.height = image.height();
    format.fullRange = true;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int row = 0; row < image.height(); ++row)
        std::copy_n(image.constScanLine(row), image.width(), buffer->yRow(row));
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

} // namespace

BoardSearchWorker::BoardSearchWorker() = default;
BoardSearchWorker::~BoardSearchWorker() = default;

void BoardSearchWorker::begin(const BoardSpec &spec)
{
    m_collector = BoardCollector(spec);
    m_state = {};
    m_removed.clear();
    m_refused.clear();
    m_changes = m_shots = 0;
    showState();
}

void BoardSearchWorker::addFiles(const QStringList &files)
{
    m_files.insert(m_files.end(), files.begin(), files.end());
    showState();
    goOn();
}

void BoardSearchWorker::watch(std::shared_ptr<WatchedCamera> camera)
{
    m_camera = std::move(camera);
    goOn();
}

void BoardSearchWorker::stop()
{
    m_camera.reset();
    m_files.clear();
    m_video.reset();
    m_takeNow = false;
    showState();
}

/// One image, then the pending orders, then the next image.
void BoardSearchWorker::goOn()
{
    if (std::exchange(m_going, true))
        return;
    callLater(this, [this] { step(); });
}

void BoardSearchWorker::step()
{
    m_going = false;
    if (m_video)
        lookAtVideo();
    else if (!m_files.empty())
        lookAtFile();
    else if (lookAgain())
        ; // one of them, and then the pending orders
    else if (m_camera)
        lookAtCamera();
    else
        return;
    goOn();
}

void BoardSearchWorker::lookAtCamera()
{
    const auto captured = m_camera->next();
    if (!captured) {
        if (captured.error().code != ErrorCode::Unavailable)
            m_camera.reset();
        if (captured.error().code != ErrorCode::Cancelled)
            Q_EMIT troubled(errorLine(captured.error()));
        return;
    }
    const bool chosen = std::exchange(m_takeNow, false);
    const QString name = tr("image %1").arg(m_shots + 1);
    const ImageVerdict answer = chosen ? m_collector.offer(captured->frame, name.toStdString())
                                       : m_collector.watch(captured->frame, name.toStdString());
    took(captured->frame, name, answer, chosen);
    if (answer.kept || answer.isOther || chosen)
        ++m_shots;
}

void BoardSearchWorker::lookAtFile()
{
    const QString file = m_files.front();
    m_files.pop_front();
    const QString name = QFileInfo(file).fileName();
    if (isStillImage(pathOf(file))) {
        if (const auto image = readImage(pathOf(file)))
            took(*image, name, m_collector.offer(*image, name.toStdString()), true, file);
        else
            m_refused.push_back({name, shownWords(image.error().why), {}, {}, 0});
    } else if (auto video = VideoReader::open(pathOf(file))) {
        m_video = std::move(*video);
        m_videoName = name;
        m_fromVideo = 0;
    } else {
        m_refused.push_back({name, shownWords(video.error().why), {}, {}, 0});
    }
    showState();
}

void BoardSearchWorker::lookAtVideo()
{
    const auto frame = m_video->next();
    if (frame && !*frame) {
        if (m_fromVideo == 0)
            m_refused.push_back(
                {m_videoName,
                 tr("none of its images shows a board that is still, sharp and in a new position"),
                 {},
                 {},
                 0});
        m_video.reset();
        showState();
        return;
    }
    if (!frame || (*frame)->index % videoStep != 0) // one damaged image must not cost the others
        return;
    const QString name = QStringLiteral("%1@%2").arg(m_videoName).arg((*frame)->index);
    const ImageVerdict answer = m_collector.watch(**frame, name.toStdString());
    took(**frame, name, answer, false);
    if ((answer.kept || answer.isOther) && ++m_fromVideo >= enoughOfAVideo)
        m_video.reset();
}

void BoardSearchWorker::took(const Frame &frame, const QString &name, const ImageVerdict &answer, bool chosen,
                             const QString &file)
{
    const bool matters = answer.kept || answer.isOther || chosen;
    follow();
    // The screen may skip images that change nothing; it must not fall behind.
    if (matters || m_pending < mostPending) {
        SearchedImage searchedImage{
            name, forScreen(frame), {frame.format.width, frame.format.height}, answer, {}};
        if (m_collector.spec().columns > 0) {
            std::vector<BoardPlacement> taken;
            for (const CollectedImage &image : m_collector.images())
                taken.push_back(image.placement);
            searchedImage.wanted = wantedPose(taken, m_collector.spec().columns, m_collector.spec().rows,
                                              m_collector.widthPx(), m_collector.heightPx());
        }
        if (answer.kept)
            m_state.kept.push_back({name, searchedImage.image, *answer.image,
                                    greyPng(frame).value_or(std::vector<unsigned char>()), file});
        ++m_pending;
        Q_EMIT searched(searchedImage);
    }
    if (matters && answer.refusal) {
        std::vector<unsigned char> png;
        if (file.isEmpty())
            png = greyPng(frame).value_or(png);
        m_refused.push_back({name, shownWords(answer.refusal->why), file, std::move(png), m_changes});
    }
    if (matters)
        showState();
}

/// Where the collector dropped its images, for most show another board: they are to be searched for that.
void BoardSearchWorker::follow()
{
    if (m_changes == m_collector.changes())
        return;
    for (KeptImage &image : m_state.kept)
        m_refused.push_back({image.name, {}, image.file, std::move(image.png), m_changes});
    m_changes = m_collector.changes();
    m_state.kept.clear();
    m_removed.clear();
}

/// Searches one image that does not count for the board that most show, where it was not yet; false where
/// none is left.
bool BoardSearchWorker::lookAgain()
{
    const auto next =
        std::ranges::find_if(m_refused, [&](const Refused &one) { return isToBeSearched(one); });
    if (next == m_refused.end())
        return false;
    Refused again = std::move(*next);
    m_refused.erase(next);
    const std::string name = again.name.toStdString();
    if (const auto frame = again.file.isEmpty() ? greyFrame(again.png) : readImage(pathOf(again.file))) {
        took(*frame, again.name, m_collector.offerAgain(*frame, name), true, again.file);
        return true;
    }
    again.searchedAt = m_changes;
    again.reason = tr("it cannot be read any more");
    m_refused.push_back(std::move(again));
    showState();
    return true;
}

void BoardSearchWorker::remove(int index)
{
    if (index < 0 || index >= int(m_state.kept.size()))
        return;
    m_collector.remove(std::size_t(index));
    m_removed.push_back({index, std::move(m_state.kept[std::size_t(index)])});
    m_state.kept.erase(m_state.kept.begin() + index);
    showState();
}

void BoardSearchWorker::undoRemove()
{
    if (m_removed.empty())
        return;
    Removed removed = std::move(m_removed.back());
    m_removed.pop_back();
    m_collector.insert(std::size_t(removed.index), removed.image.board);
    const auto at = std::min(removed.index, int(m_state.kept.size()));
    m_state.kept.insert(m_state.kept.begin() + at, std::move(removed.image));
    showState();
}

void BoardSearchWorker::showState()
{
    m_state.coverage = m_collector.coverage();
    m_state.columns = m_collector.spec().columns;
    m_state.rows = m_collector.spec().rows;
    m_state.size = {m_collector.widthPx(), m_collector.heightPx()};
    m_state.canUndo = !m_removed.empty();
    m_state.waiting = int(m_files.size()) + (m_video ? 1 : 0);
    m_state.refused.clear();
    for (const Refused &one : m_refused) {
        m_state.waiting += isToBeSearched(one) ? 1 : 0;
        if (!one.reason.isEmpty())
            m_state.refused.emplace_back(one.name, one.reason);
    }
    Q_EMIT stateChanged(m_state);
}

} // namespace odo
