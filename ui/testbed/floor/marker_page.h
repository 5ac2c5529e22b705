// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"
#include "core/geometry/camera_model.h"
#include "ui/models/background_task.h"
#include "ui/views/widgets/card.h"

#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QAction;
class QLabel;
class QTableWidget;

namespace odo {

struct StillImage;
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
    void findOthers();
    void takeOthers();
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
    BackgroundTask m_search;             ///< for the other markers, once some are marked by hand
    std::vector<MarkerPixel> m_searched; ///< those that it began with
    std::shared_ptr<std::vector<MarkerPixel>> m_others;
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
