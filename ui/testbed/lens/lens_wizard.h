// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/workflow/calibration_media.h"
#include "ui/testbed/lens/board_search.h"
#include "ui/testbed/lens/lens_solver.h"

#include <QDialog>
#include <functional>

class QLabel;
class QPushButton;
class QStackedWidget;

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
class LensWizard : public QDialog
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

private:
    enum Page { Source, Pictures, Result_ };
    void turnTo(Page page);
    void next();
    void back();
    void updateButtons();
    void beginPictures();

    OpenCamera m_open;
    BoardSearch m_search;
    LensSourcePage *m_source;
    LensPicturesPage *m_pictures;
    LensResultPage *m_result;
    QStackedWidget *m_pages;
    QLabel *m_title, *m_steps;
    QPushButton *m_back, *m_next, *m_cancel;
};

} // namespace odo
