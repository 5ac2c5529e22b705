// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/workflow/calibrate/calibration_pictures.h"
#include "ui/testbed/lens/internal/board_search.h"
#include "ui/testbed/lens/internal/lens_result_page.h"
#include "ui/views/widgets/step_dialog.h"

#include <QStringList>
#include <QWidget>
#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QRadioButton;

namespace odo {

class LensPicturesPage;
class LensResultPage;
class LensSourcePage;
class LiveCameras;

/// What the wizard ends with.
struct MeasuredLens
{
    QString camera;
    BoardSpec board; ///< as it was found out
    IntrinsicCalibration calibration;
    std::vector<BoardPicture> pictures; ///< of the calibration
};

/// Computes a camera's intrinsics with a board: choose board and camera, collect images, check the result.
/// The caller stores it once it is accepted. Closing it at any page leaves nothing behind.
class LensWizard : public StepDialog
{
    Q_OBJECT
public:
    /// What it needs from outside. Both are called on threads of their own.
    struct Callbacks
    {
        /// Opens a connected camera, by address, so that a board before it is seen.
        std::function<Result<std::shared_ptr<CameraSource>>(const QString &uri)> open;
        /// Writes to the disk what takes long; the wizard closes when it is done, and stays open when it
        /// fails.
        std::function<Result<void>(const MeasuredLens &, const JobControl &)> keepPictures;
    };

    /// live must outlive it.
    LensWizard(const QStringList &cameras, const QString &current, const LiveCameras &live,
               Callbacks callbacks, QWidget *parent = nullptr);
    ~LensWizard() override;

    LensSourcePage &source() { return *m_source; }
    /// Once accepted.
    MeasuredLens result() const;

    void done(int result) override;

protected:
    bool isComplete(int step) const override;
    void next() override;
    void back() override;
    void showNotSaved(const Error &error) override;

private:
    enum Page { Source, Pictures, Result_ };
    void beginPictures();

    void save();

    const Callbacks m_callbacks;
    BoardSearch m_search;
    LensSourcePage *m_source;
    LensPicturesPage *m_pictures;
    LensResultPage *m_result;
};

class LiveCameraBox;

/// First page of the lens wizard: camera, board, and the source of the images.
class LensSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it.
    LensSourcePage(const QStringList &cameras, const QString &current, const LiveCameras &live,
                   QWidget *parent = nullptr);

    QString camera() const;
    double squareM() const;
    bool isLive() const;
    QString liveUri() const; ///< of the camera that is to be watched
    QStringList files() const;
    void addFiles(const QStringList &files);
    bool isComplete() const;

Q_SIGNALS:
    void completeChanged();

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    QWidget *makeFiles();
    void updateChoices();

    QComboBox *m_camera;
    LiveCameraBox *m_live;
    QDoubleSpinBox *m_square;
    QRadioButton *m_fromLive, *m_fromFiles;
    QListWidget *m_files;
    QWidget *m_fileBox;
};

} // namespace odo
