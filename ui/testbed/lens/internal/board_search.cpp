// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/board_search.h"

#include "core/base/shortage.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/lens/internal/board_search_worker.h"
#include "ui/testbed/lens/internal/watched_camera.h"

namespace odo {

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
