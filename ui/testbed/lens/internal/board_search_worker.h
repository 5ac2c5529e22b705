// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_collector.h"
#include "ui/testbed/lens/internal/board_search.h"

#include <QObject>
#include <QStringList>
#include <atomic>
#include <deque>
#include <memory>
#include <vector>

namespace odo {

class VideoReader;
class WatchedCamera;

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
    void took(const Frame &frame, const QString &name, const ImageVerdict &answer, bool chosen,
              const QString &file = {});
    /// An image that does not count, as it can be read again.
    struct Refused
    {
        QString name, reason;
        QString file;                   ///< a still; or
        std::vector<unsigned char> png; ///< a frame; neither: there is nothing to search again
        int searchedAt = 0;             ///< changes() of the collector then
    };
    static bool canBeRead(const Refused &one) { return !one.file.isEmpty() || !one.png.empty(); }
    bool isToBeSearched(const Refused &one) const { return one.searchedAt != m_changes && canBeRead(one); }
    void follow();
    bool lookAgain();
    void showState();

    BoardCollector m_collector{BoardSpec()};
    SearchState m_state;
    struct Removed
    {
        int index;
        KeptImage image;
    };
    std::vector<Removed> m_removed;
    std::vector<Refused> m_refused;
    int m_changes = 0; ///< of the collector, that m_state.kept follows
    int m_shots = 0;   ///< of a camera, that have a name
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
