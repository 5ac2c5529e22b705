// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/lens/board_search.h"

#include <QObject>
#include <atomic>
#include <deque>
#include <optional>

namespace odo {

class VideoReader;

/// The part of BoardSearch that lives on its thread. It does one picture at a time and then lets orders come through.
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
    void acknowledge() { --m_onTheirWay; }

Q_SIGNALS:
    void searched(const odo::SearchedPicture &picture);
    void stateChanged(const odo::SearchState &state);
    void troubled(const QString &message);

private:
    void goOn();
    void step();
    void lookAtCamera();
    void lookAtFile();
    void lookAtVideo();
    void took(const Frame &frame, const QString &name, const PictureAnswer &answer, bool chosen);
    void tellState();

    BoardCollector m_collector{BoardSpec()};
    SearchState m_state;
    struct Removed
    {
        int index;
        KeptPicture picture;
    };
    std::vector<Removed> m_removed;
    std::deque<QString> m_files;
    std::unique_ptr<VideoReader> m_video;
    QString m_videoName;
    int m_fromVideo = 0;
    std::shared_ptr<WatchedCamera> m_camera;
    bool m_takeNow = false, m_going = false;
    std::atomic<int> m_onTheirWay{0};
};

} // namespace odo

Q_DECLARE_METATYPE(odo::SearchState)
