// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/video_reader.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <filesystem>
#include <memory>

namespace odo {

/// Decodes images of one recording on a thread of its own, at the size of the widget that shows them.
/// Requests never wait: it serves only the newest and drops older ones that were not started. Signals come on
/// the fetcher's thread (that of the GUI). The destructor waits for the frame in work.
class FrameFetcher : public QObject
{
    Q_OBJECT
public:
    explicit FrameFetcher(QObject *parent = nullptr);
    ~FrameFetcher() override;

    /// Another recording; forgets the requests and images of the one before. An empty path closes. known: as
    /// the project has it (VideoReader::open).
    void setFile(const std::filesystem::path &file, const KnownRecording &known = {});
    /// Asks for a frame at a size in device pixels; the image fills the size, so keep its proportions.
    void request(qint64 frame, QSize sizePx);
    /// True when every request was answered or dropped.
    bool isIdle() const;

Q_SIGNALS:
    void frameReady(qint64 frame, const QImage &image);
    /// The file cannot be shown; sent once per file, or for a damaged frame.
    void failed(qint64 frame, const QString &message);

private:
    struct Worker;
    std::unique_ptr<Worker> m_worker;
};

} // namespace odo
