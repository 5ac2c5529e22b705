// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "ui/testbed/lens/internal/board_search.h"
#include "ui/testbed/lens/internal/calibration_result_page.h"
#include "ui/views/widgets/step_dialog.h"

#include <QStringList>
#include <QWidget>
#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QRadioButton;

namespace odo {

class BoardImagesPage;
class CalibrationResultPage;
class CalibrationSourcePage;
class LiveCameras;

/// What the wizard ends with.
struct StoredIntrinsics
{
    QString camera;
    BoardSpec board; ///< as it was found out
    IntrinsicCalibration calibration;
    std::vector<BoardImage> images; ///< of the calibration
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
        std::function<Result<void>(const StoredIntrinsics &, const JobControl &)> keepImages;
    };

    /// live must outlive it.
    LensWizard(const QStringList &cameras, const QString &current, const LiveCameras &live,
               Callbacks callbacks, QWidget *parent = nullptr);
    ~LensWizard() override;

    CalibrationSourcePage &source() { return *m_source; }
    /// Once accepted.
    StoredIntrinsics result() const;

    void done(int result) override;

protected:
    QString missing(int step) const override;
    bool isBusy(int step) const override;
    QString unsaved() const override;
    void next() override;
    void back() override;
    void showNotSaved(const Error &error) override;

private:
    enum Page { Source, Images, Result_ };
    void beginImages();

    void save();

    const Callbacks m_callbacks;
    BoardSearch m_search;
    CalibrationSourcePage *m_source;
    BoardImagesPage *m_images;
    CalibrationResultPage *m_result;
};

class LiveCameraBox;

/// First page of the lens wizard: camera, board, and the source of the images.
class CalibrationSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it.
    CalibrationSourcePage(const QStringList &cameras, const QString &current, const LiveCameras &live,
                          QWidget *parent = nullptr);

    QString camera() const;
    double squareM() const;
    bool isLive() const;
    QString liveUri() const; ///< of the camera that is to be watched
    QStringList files() const;
    void addFiles(const QStringList &files);
    QString missing() const; ///< as a sentence; empty: nothing

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
