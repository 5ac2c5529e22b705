// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/accuracy_map.h"
#include "ui/models/background_task.h"

#include <QFontMetrics>
#include <QObject>
#include <QPalette>
#include <QPointF>
#include <QRect>
#include <QSize>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

class QPainter;

namespace odo {

/// σ over the floor as it is painted: one value a grid cell, NaN where no camera sees it. Metres.
struct SketchedAccuracy
{
    FloorGrid grid;
    std::vector<double> sigmaM;
};

/// World metres to widget pixels.
using ToScreen = std::function<QPointF(const Eigen::Vector2d &)>;

/// Lines of equal σ: of 1, 2, 5, 10... mm, those that lie within the map.
std::vector<double> accuracyLevelsM(const SketchedAccuracy &accuracy);

/// Paints σ in the colours of cividis (the darker the better known), hatched where nothing is seen, with
/// lines of equal σ and their millimetres.
void drawAccuracy(QPainter &painter, const SketchedAccuracy &accuracy, const ToScreen &toScreen,
                  const QPalette &palette);

/// How large the key is.
QSize accuracyKeySize(const QFontMetrics &metrics);

/// What the colours mean, as a bar in the lower left corner of the area.
void drawAccuracyKey(QPainter &painter, const SketchedAccuracy &accuracy, const QRect &area,
                     const QPalette &palette);

/// A camera of a map: registered, or planned.
using MappedCamera = std::variant<FloorView, PlannedCamera>;

/// What is to be mapped.
struct AccuracyRequest
{
    MarkerLayout layout;
    std::vector<MappedCamera> cameras;
    std::optional<std::size_t> alone; ///< the map of this camera; nullopt: of all (joint)
    double robotHeightM = 0;
};

struct ExpectedAccuracy
{
    SketchedAccuracy map;
    AccuracySummary summary;
    std::vector<std::optional<Error>> problems; ///< one a camera: why it is not counted
};

/// σ of a followed robot over the markers and a margin about them, of the cameras that can be there. Pure,
/// any thread.
ExpectedAccuracy expectedAccuracy(const AccuracyRequest &request);

/// Makes maps on a thread of its own; of the requests that come while one is made only the newest is made
/// next. GUI thread.
class AccuracyMaker : public QObject
{
    Q_OBJECT
public:
    explicit AccuracyMaker(QObject *parent = nullptr);
    void make(AccuracyRequest request);
    bool isRunning() const { return m_task.isRunning(); }

Q_SIGNALS:
    void ready(const odo::ExpectedAccuracy &accuracy);

private:
    void begin(AccuracyRequest request);

    std::shared_ptr<ExpectedAccuracy> m_made;
    std::optional<AccuracyRequest> m_next;
    BackgroundTask m_task;
};

} // namespace odo
