// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/registration_checks.h"
#include "ui/models/background_task.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/step_dialog.h"

#include <QWidget>
#include <array>
#include <memory>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QTableWidget;

namespace odo {

class BadgeLabel;
class LengthPage;
class LiveCameras;
class ImageChoice;

/// Checks a registered camera by a known length: camera and image first, then both ends in the image. An
/// image of another size is taken where the lens is converted to it without a choice (floorViewAt). Stores
/// nothing.
class LengthWizard : public StepDialog
{
    Q_OBJECT
public:
    /// cameras: one at least. current: name of the one to begin with. live must outlive it.
    LengthWizard(std::vector<CheckCamera> cameras, const QString &current, const LiveCameras &live,
                 QWidget *parent = nullptr);
    ~LengthWizard() override;

    ImageChoice &image() { return *m_choice; }
    LengthPage &page() { return *m_page; }

    void done(int result) override;

protected:
    QString missing(int step) const override;
    bool isBusy(int step) const override;
    void next() override;
    void back() override;

private:
    QWidget *makeSource(const QString &current);
    const CheckCamera &camera() const;
    void showCamera();
    void takeFrame();

    const std::vector<CheckCamera> m_cameras;
    QComboBox *m_camera;
    BadgeLabel *m_badge;
    ImageChoice *m_choice;
    LengthPage *m_page;
    std::shared_ptr<StillImage> m_image;   ///< that is being got
    std::shared_ptr<CheckCamera> m_asSeen; ///< the camera for images of that size
    BackgroundTask m_task;
};

class MarkerCanvas;

/// Second page of the length wizard: both ends of a known length in the image, its true length, and at once
/// how well the camera measures it.
class LengthPage : public QWidget
{
    Q_OBJECT
public:
    explicit LengthPage(QWidget *parent = nullptr);

    /// While the image is loading.
    void wait(const QString &words);
    void showFailure(const Error &error);
    /// camera: for images of this size. converted: a sentence where its lens was calibrated at another one.
    void begin(std::shared_ptr<const StillImage> image, const CheckCamera &camera, const QString &converted);

    MarkerCanvas &canvas() { return *m_canvas; }
    /// What was measured; nullopt until both ends are put.
    const std::optional<LengthCheck> &check() const { return m_check; }

private:
    struct End
    {
        Eigen::Vector2d pixel;
        double sigmaPx;
        QString seenAs;
    };

    QWidget *makeSide();
    QWidget *makeQuestions();
    int currentEnd() const;
    void position(const QString &label, const Eigen::Vector2d &pixel, bool snap);
    void evaluate();
    void showEnds();
    std::optional<double> givenM() const;

    std::shared_ptr<const StillImage> m_image;
    std::optional<CheckCamera> m_camera;
    QString m_converted;
    std::array<std::optional<End>, 2> m_ends;
    std::optional<LengthCheck> m_check;
    MarkerCanvas *m_canvas;
    QTableWidget *m_table;
    QDoubleSpinBox *m_givenLength, *m_height;
    QComboBox *m_unit;
    QCheckBox *m_snap;
    QLabel *m_length, *m_words;
    BadgeLabel *m_badge;
};

} // namespace odo
