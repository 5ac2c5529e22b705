// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"
#include "core/project/records.h"
#include "ui/models/background_task.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/step_dialog.h"

#include <QWidget>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QTableWidget;

namespace odo {

class FloorSourcePage;
class LiveCameras;
class MarkerPage;

/// Registers a camera from an image of the markers: choose camera, layout and image, then detect or click the
/// markers, with the result at once. The caller stores it once it is accepted. Closing it at any page leaves
/// nothing behind.
class FloorWizard : public StepDialog
{
    Q_OBJECT
public:
    FloorWizard(std::vector<FloorCamera> cameras, const QString &current, std::vector<LayoutRecord> layouts,
                const LiveCameras &live, KeepImage keep, QWidget *parent = nullptr);
    ~FloorWizard() override;

    FloorSourcePage &source() { return *m_source; }
    MarkerPage &markers() { return *m_markers; }
    QString camera() const;
    /// Once accepted: everything but the camera's number, the date, and the path of the image.
    RegistrationRecord result() const;

    void done(int result) override;

protected:
    bool isComplete(int step) const override;
    void next() override;
    void back() override;
    void showNotSaved(const Error &error) override;

private:
    void beginMarkers();
    void showImage(const std::optional<Error> &error);

    std::vector<FloorCamera> m_cameras;
    std::vector<LayoutRecord> m_layouts;
    FloorSourcePage *m_source;
    MarkerPage *m_markers;
    std::shared_ptr<StillImage> m_image; ///< that is being got
    const KeepImage m_keep;
    BackgroundTask m_task;
};

class BadgeLabel;
class ImageChoice;

/// First page of the floor wizard: camera, layout, and the image that shows the markers.
class FloorSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it.
    FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                    const std::vector<LayoutRecord> &layouts, const LiveCameras &live,
                    QWidget *parent = nullptr);

    QString camera() const;
    int layout() const; ///< its row in the list
    ImageOrigin origin() const;
    void setFile(const QString &file);
    bool isComplete() const;

Q_SIGNALS:
    void completeChanged();

private:
    void showCamera();
    const FloorCamera *known() const;

    const std::vector<FloorCamera> m_cameras;
    QComboBox *m_camera, *m_layout;
    ImageChoice *m_image;
    QLabel *m_intrinsics;
    BadgeLabel *m_badge;
};

class MarkerCanvas;
class RegistrationVerdict;

/// Second page of the floor wizard: the markers in the image, detected or clicked, and at once the camera
/// position, how well each marker fits, and any problem.
class MarkerPage : public QWidget
{
    Q_OBJECT
public:
    explicit MarkerPage(QWidget *parent = nullptr);

    /// While the image is loading.
    void wait(const QString &words);
    void begin(std::shared_ptr<const StillImage> image, const MarkerLayout &layout,
               const std::optional<Intrinsics> &intrinsics);
    void showFailure(const Error &error);
    /// Keeps the markers: the user can try again.
    void showNotSaved(const Error &error);

    /// What the markers say now; none where they do not determine it.
    const std::optional<FloorRegistration> &registration() const { return m_registration; }
    const std::vector<MarkerPixel> &pixels() const { return m_pixels; }
    MarkerCanvas &canvas() { return *m_canvas; }

Q_SIGNALS:
    void completeChanged();

private:
    QWidget *makeSide();
    QString currentLabel() const;
    void position(const QString &label, const Eigen::Vector2d &pixel, bool snap);
    void removeCurrent();
    void undo();
    void remember();
    void evaluate();
    void showTable();

    std::shared_ptr<const StillImage> m_image;
    MarkerLayout m_layout;
    std::optional<Intrinsics> m_intrinsics;
    std::vector<MarkerPixel> m_pixels;
    std::vector<std::pair<std::string, QString>> m_kinds; ///< label and the kind of feature it snapped to
    std::vector<std::vector<MarkerPixel>> m_before;       ///< for undo
    std::optional<FloorRegistration> m_registration;
    MarkerCanvas *m_canvas;
    QTableWidget *m_table;
    RegistrationVerdict *m_verdict;
    QAction *m_remove, *m_undo;
};

/// Describes the camera position by the current fit, or why it is unknown and what to do. GUI thread.
class RegistrationVerdict : public Card
{
    Q_OBJECT
public:
    explicit RegistrationVerdict(QWidget *parent = nullptr);
    void showVerdict(const FloorRegistration &registration);
    void showVerdict(const QString &verdict, const QString &advice);
    /// It could not be stored; the verdict stays.
    void reportNotSaved(const Error &error);

private:
    QLabel *m_verdict, *m_advice;
};

} // namespace odo
