// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_collector.h"
#include "ui/testbed/lens/internal/watched_camera.h"

#include <QImage>
#include <QObject>
#include <QStringList>
#include <QThread>
#include <functional>
#include <memory>
#include <vector>

namespace odo {

class BoardSearchWorker;

/// A searched image, small enough for the screen.
struct SearchedImage
{
    QString name;
    QImage image;
    QSize size; ///< of the original image
    ImageVerdict answer;
    std::optional<WantedPose> wanted; ///< what would add most now; once the board is known
};

/// An accepted image.
struct KeptImage
{
    QString name;
    QImage image;
    CollectedImage board;
    std::vector<unsigned char> png; ///< as taken, grey: to be kept with the calibration
    QString file;                   ///< a still; empty: a frame of a video or of a camera
};

/// What has been gathered.
struct SearchState
{
    std::vector<KeptImage> kept;
    std::vector<std::pair<QString, QString>>
        refused; ///< name and reason of rejected images that the user chose
    BoardCoverage coverage;
    int columns = 0, rows = 0; ///< of the board; 0: not found out yet
    QSize size;                ///< of the images
    bool canUndo = false;
    int waiting = 0; ///< files not searched yet
};

/// Searches for a board in images, videos or a live camera, on a thread of its own; collects the accepted
/// images. Once another board than before is the one that most images show, it searches the images that do
/// not count again, for that board. Signals come on the object's thread. The destructor stops and waits.
class BoardSearch : public QObject
{
    Q_OBJECT
public:
    explicit BoardSearch(QObject *parent = nullptr);
    ~BoardSearch() override;

    /// Restarts with this board.
    void begin(const BoardSpec &spec);
    /// Images and videos, one after the other.
    void addFiles(const QStringList &files);
    /// Takes images automatically until stop(). open: called on the search's thread, for it may take long.
    void watch(OpenCamera open);
    /// Treats the camera's next image as chosen by the user.
    void takeNow();
    void remove(int index);
    void undoRemove();
    /// Stops watching and drops the files not searched yet.
    void stop();

    const SearchState &state() const { return m_state; }

Q_SIGNALS:
    void searched(const odo::SearchedImage &image);
    void changed();                        ///< state() is new
    void troubled(const QString &message); ///< the camera is lost, or delivers no image for the moment

private:
    void ask(std::function<void(BoardSearchWorker &)> what);

    QThread m_thread;
    BoardSearchWorker *m_worker;
    SearchState m_state;
    std::shared_ptr<WatchedCamera> m_camera;
};

} // namespace odo

Q_DECLARE_METATYPE(odo::SearchedImage)
