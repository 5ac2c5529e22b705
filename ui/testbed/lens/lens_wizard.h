// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/workflow/calibration_media.h"
#include "ui/testbed/lens/board_search.h"
#include "ui/testbed/lens/lens_solver.h"
#include "ui/views/step_dialog.h"

#include <functional>

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

/// Leads from a board to a camera's intrinsics: which board and camera, its pictures, the result. The project is up to
/// whoever opened it, once it is accepted. Closing it at any page leaves nothing behind.
class LensWizard : public StepDialog
{
    Q_OBJECT
public:
    /// What it needs from outside. Both are called on threads of their own.
    struct Callbacks
    {
        /// Opens a connected camera, by address, so that a board before it is seen.
        std::function<Result<std::shared_ptr<CameraSource>>(const QString &uri)> open;
        /// Writes to the disk what takes long; the wizard closes when it is done, and stays open when it fails.
        std::function<Result<void>(const MeasuredLens &, const JobControl &)> keepPictures;
    };

    /// live must outlive it.
    LensWizard(const QStringList &cameras, const QString &current, const LiveCameras &live, Callbacks callbacks,
               QWidget *parent = nullptr);
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

} // namespace odo
