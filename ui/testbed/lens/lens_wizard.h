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

/// What the wizard ends with.
struct MeasuredLens
{
    QString camera;
    BoardSpec board; ///< as it was found out
    IntrinsicCalibration calibration;
    std::vector<BoardPicture> pictures; ///< of the calibration
};

/// Leads from a board to a camera's intrinsics: which board and camera, its pictures, the result. Stores nothing: that
/// is up to whoever opened it, once it is accepted. Closing it at any page leaves nothing behind.
class LensWizard : public StepDialog
{
    Q_OBJECT
public:
    /// Opens a connected camera, by address, so that a board before it is seen.
    using OpenCamera = std::function<Result<std::shared_ptr<CameraSource>>(const QString &uri)>;

    LensWizard(const QStringList &cameras, const QString &current, const std::vector<CameraDescription> &live,
               OpenCamera open, QWidget *parent = nullptr);
    ~LensWizard() override;

    LensSourcePage &source() { return *m_source; }
    /// Once accepted.
    MeasuredLens result() const;

    void done(int result) override;

protected:
    bool isComplete(int step) const override;
    void next() override;
    void back() override;

private:
    enum Page { Source, Pictures, Result_ };
    void beginPictures();

    OpenCamera m_open;
    BoardSearch m_search;
    LensSourcePage *m_source;
    LensPicturesPage *m_pictures;
    LensResultPage *m_result;
};

} // namespace odo
