// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/chained_registration.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_image.h"

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

class QAction;
class QLabel;
class QTableWidget;

namespace odo {

class MarkerCanvas;
class RegistrationVerdict;

/// The images of two cameras in which the user marks the same floor points.
struct ImagePair
{
    StillImage camera, reference;
};

/// Second page of registering a camera via another one: the same points in both images, and at once the
/// camera position. Markers of the registered camera's layout that both see are set from the start.
class SharedPointsPage : public QWidget
{
    Q_OBJECT
public:
    explicit SharedPointsPage(QWidget *parent = nullptr);

    /// While the images are loading.
    void wait(const QString &words);
    void showFailure(const Error &error);
    /// Keeps the points: the user can try again.
    void showNotSaved(const Error &error);
    void begin(std::shared_ptr<const ImagePair> images, const FloorCamera &camera,
               const CheckCamera &reference);

    MarkerCanvas &canvas() { return *m_canvas; }
    MarkerCanvas &referenceCanvas() { return *m_referenceCanvas; }
    /// The points that are set in both images.
    std::vector<SharedPoint> points() const;
    /// What they say now; none where they do not determine it.
    const std::optional<ChainedRegistration> &registration() const { return m_registration; }

Q_SIGNALS:
    void completeChanged();

private:
    struct Point
    {
        QString label;
        std::optional<Eigen::Vector2d> pixel, referencePixel;
    };

    QWidget *makeSide();
    QWidget *makeTable();
    void position(std::optional<Eigen::Vector2d> Point::*where, const Frame &frame, const QString &label,
                  const Eigen::Vector2d &pixel, bool snap);
    void goOnFrom(int row);
    void removeCurrent();
    void undo();
    void addEmptyPoint();
    void evaluate();
    void showPoints();
    QString currentLabel() const;
    void select(const QString &label);

    std::shared_ptr<const ImagePair> m_images;
    FloorCamera m_camera;
    std::optional<CheckCamera> m_reference;
    std::vector<Point> m_points;
    std::vector<std::vector<Point>> m_before; ///< for undo
    std::optional<ChainedRegistration> m_registration;
    MarkerCanvas *m_canvas, *m_referenceCanvas;
    QLabel *m_name, *m_referenceName;
    QTableWidget *m_table;
    RegistrationVerdict *m_verdict;
    QAction *m_remove, *m_undo;
};

} // namespace odo
