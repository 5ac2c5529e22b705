// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/run_recorder.h"

#include "core/project/project.h"

#include <QMetaObject>

namespace odo {
namespace {

constexpr int appendEachMs = 1000;

} // namespace

RunRecorder::RunRecorder(Project &project, QObject *parent) : QObject(parent), m_project(project)
{
    m_timer.setInterval(appendEachMs);
    connect(&m_timer, &QTimer::timeout, this, &RunRecorder::append);
}

RunRecorder::~RunRecorder()
{
    if (!m_trial)
        return;
    end();
    m_thread.join();
    complete(m_ended);
}

Result<void> RunRecorder::begin(const NextRun &run, const std::vector<std::string> &cameras,
                                std::shared_ptr<CaptureSession> session, Nanoseconds preRoll)
{
    Q_ASSERT(!m_trial && session);
    auto record = trialOf(m_project, run);
    if (!record)
        return tl::unexpected(record.error());
    auto trial = LiveTrial::begin(m_project, std::move(*record), cameras, *session, preRoll);
    if (!trial)
        return tl::unexpected(trial.error());
    m_session = std::move(session);
    m_trial = std::move(*trial);
    m_timer.start();
    return {};
}

/// What cannot be stored now is stored with the next, or at the end.
void RunRecorder::append()
{
    if (const Result<void> stored = m_trial->append(m_project); !stored)
        Q_EMIT failed(stored.error());
}

void RunRecorder::end()
{
    if (!isRecording())
        return;
    m_timer.stop();
    m_ending = true;
    m_ended = m_trial->prepare(m_project);
    m_thread = std::thread([this] {
        if (m_ended)
            m_ended = m_trial->run({});
        QMetaObject::invokeMethod(
            this,
            [this] {
                m_thread.join();
                complete(m_ended);
            },
            Qt::QueuedConnection);
    });
}

void RunRecorder::complete(const Result<void> &ended)
{
    const std::shared_ptr<LiveTrial> trial = std::move(m_trial);
    m_trial.reset();
    const Result<void> committed = ended ? trial->commit(m_project) : ended;
    m_session.reset();
    m_ending = false;
    if (!committed) {
        Q_EMIT failed(committed.error());
        return;
    }
    QStringList warnings;
    for (const std::string &warning : trial->warnings())
        warnings << QString::fromStdString(warning);
    Q_EMIT recorded(QString::fromStdString(trial->trial().name), warnings);
}

} // namespace odo
