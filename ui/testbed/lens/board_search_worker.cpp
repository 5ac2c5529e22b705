// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/board_search_worker.h"

#include "core/video/picture.h"
#include "core/video/picture_reader.h"
#include "core/video/picture_writer.h"
#include "core/video/video_reader.h"
#include "core/workflow/call_later.h"
#include "core/workflow/picture_source.h"
#include "ui/models/core_words.h"
#include "ui/models/error_words.h"
#include "ui/testbed/lens/watched_camera.h"
#include "ui/views/path_field.h"
#include "ui/views/screen_image.h"

#include <QFileInfo>
#include <algorithm>

namespace odo {
namespace {

constexpr int widestOnScreenPx = 1280, mostOnTheirWay = 2;
constexpr int enoughOfAVideo = 40, videoStep = 5;

QImage forScreen(const Frame &frame)
{
    const double scale = std::min(1.0, double(widestOnScreenPx) / frame.format.width);
    return toImage(toScreen(frame, qRound(scale * frame.format.width), qRound(scale * frame.format.height)));
}

} // namespace

BoardSearchWorker::BoardSearchWorker() = default;
BoardSearchWorker::~BoardSearchWorker() = default;

void BoardSearchWorker::begin(const BoardSpec &spec)
{
    m_collector = BoardCollector(spec);
    m_state = {};
    m_removed.clear();
    tellState();
}

void BoardSearchWorker::addFiles(const QStringList &files)
{
    m_files.insert(m_files.end(), files.begin(), files.end());
    tellState();
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
    tellState();
}

/// One picture, then the orders that have come meanwhile, then the next.
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
    const QString name = tr("picture %1").arg(m_state.kept.size() + m_removed.size() + 1);
    const PictureAnswer answer = chosen ? m_collector.offer(captured->frame, name.toStdString())
                                        : m_collector.watch(captured->frame, name.toStdString());
    took(captured->frame, name, answer, chosen);
}

void BoardSearchWorker::lookAtFile()
{
    const QString file = m_files.front();
    m_files.pop_front();
    const QString name = QFileInfo(file).fileName();
    if (isStillPicture(pathOf(file))) {
        if (const auto picture = readPicture(pathOf(file)))
            took(*picture, name, m_collector.offer(*picture, name.toStdString()), true);
        else
            m_state.refused.emplace_back(name, shownWords(picture.error().why));
    } else if (auto video = VideoReader::open(pathOf(file))) {
        m_video = std::move(*video);
        m_videoName = name;
        m_fromVideo = 0;
    } else {
        m_state.refused.emplace_back(name, shownWords(video.error().why));
    }
    tellState();
}

void BoardSearchWorker::lookAtVideo()
{
    const auto frame = m_video->next();
    if (frame && !*frame) {
        if (m_fromVideo == 0)
            m_state.refused.emplace_back(m_videoName, tr("in none of its pictures is a board that is still, sharp and new"));
        m_video.reset();
        tellState();
        return;
    }
    if (!frame || (*frame)->index % videoStep != 0) // one damaged picture must not cost the others
        return;
    const QString name = QStringLiteral("%1@%2").arg(m_videoName).arg((*frame)->index);
    const PictureAnswer answer = m_collector.watch(**frame, name.toStdString());
    took(**frame, name, answer, false);
    if (answer.kept && ++m_fromVideo >= enoughOfAVideo)
        m_video.reset();
}

void BoardSearchWorker::took(const Frame &frame, const QString &name, const PictureAnswer &answer, bool chosen)
{
    // The screen may miss pictures that change nothing; it must not fall behind.
    if (answer.kept || chosen || m_onTheirWay < mostOnTheirWay) {
        SearchedPicture searchedPicture{name, forScreen(frame), {frame.format.width, frame.format.height}, answer, {}};
        if (m_collector.spec().columns > 0) {
            std::vector<BoardPlacement> taken;
            for (const CollectedPicture &picture : m_collector.pictures())
                taken.push_back(picture.placement);
            searchedPicture.wanted = wantedPose(taken, m_collector.spec().columns, m_collector.spec().rows,
                                                m_collector.widthPx(), m_collector.heightPx());
        }
        if (answer.kept)
            m_state.kept.push_back({name, searchedPicture.image, *answer.picture, greyPng(frame).value_or(std::vector<unsigned char>())});
        ++m_onTheirWay;
        Q_EMIT searched(searchedPicture);
    }
    if (chosen && answer.refusal)
        m_state.refused.emplace_back(name, shownWords(answer.refusal->why));
    if (chosen || answer.kept)
        tellState();
}

void BoardSearchWorker::remove(int index)
{
    if (index < 0 || index >= int(m_state.kept.size()))
        return;
    m_collector.remove(std::size_t(index));
    m_removed.push_back({index, std::move(m_state.kept[std::size_t(index)])});
    m_state.kept.erase(m_state.kept.begin() + index);
    tellState();
}

void BoardSearchWorker::undoRemove()
{
    if (m_removed.empty())
        return;
    Removed removed = std::move(m_removed.back());
    m_removed.pop_back();
    m_collector.insert(std::size_t(removed.index), removed.picture.board);
    const auto at = std::min(removed.index, int(m_state.kept.size()));
    m_state.kept.insert(m_state.kept.begin() + at, std::move(removed.picture));
    tellState();
}

void BoardSearchWorker::tellState()
{
    m_state.coverage = m_collector.coverage();
    m_state.columns = m_collector.spec().columns;
    m_state.rows = m_collector.spec().rows;
    m_state.size = {m_collector.widthPx(), m_collector.heightPx()};
    m_state.canUndo = !m_removed.empty();
    m_state.waiting = int(m_files.size()) + (m_video ? 1 : 0);
    Q_EMIT stateChanged(m_state);
}

} // namespace odo
