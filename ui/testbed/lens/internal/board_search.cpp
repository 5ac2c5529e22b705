// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/board_search.h"

#include "core/base/shortage.h"
#include "core/capture/camera_source.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/form_fields.h"

#include <QFileInfo>
#include <QObject>
#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <optional>

namespace odo {

/// A camera that one thread opens and reads while another may stop it at any moment.
class WatchedCamera
{
public:
    explicit WatchedCamera(OpenCamera open);

    /// Opens the camera at the first call. Errors: those of opening and of CameraSource::next(). One thread.
    Result<CapturedFrame> next();
    /// Wakes who waits in next(). Any thread.
    void stop();

private:
    Result<std::shared_ptr<CameraSource>> camera();

    const OpenCamera m_open;
    std::mutex m_mutex; ///< guards what follows
    std::shared_ptr<CameraSource> m_camera;
    bool m_stopped = false;
};

WatchedCamera::WatchedCamera(OpenCamera open) : m_open(std::move(open)) {}

Result<std::shared_ptr<CameraSource>> WatchedCamera::camera()
{
    if (m_camera)
        return m_camera;
    auto opened = m_open(); // without the lock: it may take seconds
    if (!opened)
        return opened;
    const std::lock_guard lock(m_mutex);
    m_camera = *opened;
    if (m_stopped)
        m_camera->stop();
    return m_camera;
}

Result<CapturedFrame> WatchedCamera::next()
{
    const auto opened = camera();
    return opened ? (*opened)->next() : tl::unexpected(opened.error());
}

void WatchedCamera::stop()
{
    const std::lock_guard lock(m_mutex);
    m_stopped = true;
    if (m_camera)
        m_camera->stop();
}

class VideoReader;

/// The part of BoardSearch that lives on its thread. It handles one image, then pending orders.
class BoardSearchWorker : public QObject
{
    Q_OBJECT
public:
    BoardSearchWorker();
    ~BoardSearchWorker() override;

    void begin(const BoardSpec &spec);
    void addFiles(const QStringList &files);
    void watch(std::shared_ptr<WatchedCamera> camera);
    void takeNow() { m_takeNow = true; }
    void remove(int index);
    void undoRemove();
    void stop();
    /// The screen has painted what it was sent. Any thread.
    void acknowledge() { --m_pending; }

Q_SIGNALS:
    void searched(const odo::SearchedImage &image);
    void stateChanged(const odo::SearchState &state);
    void troubled(const QString &message);

private:
    void goOn();
    void step();
    void lookAtCamera();
    void lookAtFile();
    void lookAtVideo();
    void took(const Frame &frame, const QString &name, const ImageVerdict &answer, bool chosen);
    void showState();

    BoardCollector m_collector{BoardSpec()};
    SearchState m_state;
    struct Removed
    {
        int index;
        KeptImage image;
    };
    std::vector<Removed> m_removed;
    std::deque<QString> m_files;
    std::unique_ptr<VideoReader> m_video;
    QString m_videoName;
    int m_fromVideo = 0;
    std::shared_ptr<WatchedCamera> m_camera;
    bool m_takeNow = false, m_going = false;
    std::atomic<int> m_pending{0};
};

} // namespace odo

Q_DECLARE_METATYPE(odo::SearchState)

namespace odo {

namespace {

constexpr int widestOnScreenPx = 1280, mostPending = 2;
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
    const QString name = tr("image %1").arg(m_state.kept.size() + m_removed.size() + 1);
    const ImageVerdict answer = chosen ? m_collector.offer(captured->frame, name.toStdString())
                                       : m_collector.watch(captured->frame, name.toStdString());
    took(captured->frame, name, answer, chosen);
}

void BoardSearchWorker::lookAtFile()
{
    const QString file = m_files.front();
    m_files.pop_front();
    const QString name = QFileInfo(file).fileName();
    if (isStillImage(pathOf(file))) {
        if (const auto image = readImage(pathOf(file)))
            took(*image, name, m_collector.offer(*image, name.toStdString()), true);
        else
            m_state.refused.emplace_back(name, shownWords(image.error().why));
    } else if (auto video = VideoReader::open(pathOf(file))) {
        m_video = std::move(*video);
        m_videoName = name;
        m_fromVideo = 0;
    } else {
        m_state.refused.emplace_back(name, shownWords(video.error().why));
    }
    showState();
}

void BoardSearchWorker::lookAtVideo()
{
    const auto frame = m_video->next();
    if (frame && !*frame) {
        if (m_fromVideo == 0)
            m_state.refused.emplace_back(
                m_videoName,
                tr("none of its images shows a board that is still, sharp and in a new position"));
        m_video.reset();
        showState();
        return;
    }
    if (!frame || (*frame)->index % videoStep != 0) // one damaged image must not cost the others
        return;
    const QString name = QStringLiteral("%1@%2").arg(m_videoName).arg((*frame)->index);
    const ImageVerdict answer = m_collector.watch(**frame, name.toStdString());
    took(**frame, name, answer, false);
    if (answer.kept && ++m_fromVideo >= enoughOfAVideo)
        m_video.reset();
}

void BoardSearchWorker::took(const Frame &frame, const QString &name, const ImageVerdict &answer, bool chosen)
{
    // The screen may skip images that change nothing; it must not fall behind.
    if (answer.kept || chosen || m_pending < mostPending) {
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
                                    greyPng(frame).value_or(std::vector<unsigned char>())});
        ++m_pending;
        Q_EMIT searched(searchedImage);
    }
    if (chosen && answer.refusal)
        m_state.refused.emplace_back(name, shownWords(answer.refusal->why));
    if (chosen || answer.kept)
        showState();
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
    Q_EMIT stateChanged(m_state);
}

BoardSearch::BoardSearch(QObject *parent) : QObject(parent), m_worker(new BoardSearchWorker)
{
    qRegisterMetaType<SearchedImage>();
    qRegisterMetaType<SearchState>();
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_worker, &BoardSearchWorker::searched, this, [this](const SearchedImage &image) {
        m_worker->acknowledge();
        Q_EMIT searched(image);
    });
    connect(m_worker, &BoardSearchWorker::stateChanged, this, [this](const SearchState &state) {
        m_state = state;
        Q_EMIT changed();
    });
    connect(m_worker, &BoardSearchWorker::troubled, this, &BoardSearch::troubled);
    m_thread.setObjectName(QStringLiteral("board search"));
    m_thread.start();
}

BoardSearch::~BoardSearch()
{
    stop();
    m_thread.quit();
    m_thread.wait();
}

void BoardSearch::ask(std::function<void(BoardSearchWorker &)> what)
{
    if (!m_thread.isRunning())
        return callLater(this, [this] { Q_EMIT troubled(errorLine(noThread(imageSubject()))); });
    callLater(m_worker, [worker = m_worker, what = std::move(what)] { what(*worker); });
}

void BoardSearch::begin(const BoardSpec &spec)
{
    stop();
    ask([spec](BoardSearchWorker &worker) { worker.begin(spec); });
}

void BoardSearch::addFiles(const QStringList &files)
{
    ask([files](BoardSearchWorker &worker) { worker.addFiles(files); });
}

void BoardSearch::watch(OpenCamera open)
{
    stop();
    m_camera = std::make_shared<WatchedCamera>(std::move(open));
    ask([camera = m_camera](BoardSearchWorker &worker) { worker.watch(camera); });
}

void BoardSearch::takeNow()
{
    ask([](BoardSearchWorker &worker) { worker.takeNow(); });
}

void BoardSearch::remove(int index)
{
    ask([index](BoardSearchWorker &worker) { worker.remove(index); });
}

void BoardSearch::undoRemove()
{
    ask([](BoardSearchWorker &worker) { worker.undoRemove(); });
}

void BoardSearch::stop()
{
    if (m_camera)
        m_camera->stop(); // wakes the worker where it waits for an image
    m_camera.reset();
    ask([](BoardSearchWorker &worker) { worker.stop(); });
}

} // namespace odo

#include "board_search.moc"
