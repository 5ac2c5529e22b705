// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/chart_view.h"
#include "ui/views/curves/comparison_curves.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/dock_desk.h"

#include <QStringList>
#include <memory>
#include <vector>

class QComboBox;

namespace odo {

class Card;
class CameraView;
class CompareMap;
class DistanceChart;
class Timeline;

/// The left part of Compare; the user can arrange it: an image of each of the first two runs with the ghost
/// of the other, the map, and the charts over distance in docks.
class CompareDesk : public DockDesk
{
    Q_OBJECT
public:
    explicit CompareDesk(Timeline &timeline, QWidget *parent = nullptr);
    ~CompareDesk() override;

    void setScene(ComparisonScenePtr scene);
    CompareMap &map() const { return *m_map; }
    DistanceChart &speed() const { return *m_speed; }
    DistanceChart &difference() const { return *m_difference; }
    const std::vector<CameraView *> &cameraViews() const { return m_cameraViews; }
    bool isSettled() const;

Q_SIGNALS:
    void gatesMoved(const std::vector<odo::PathGate> &gates);
    void settled();

private:
    void followTime();
    void showViews();

    Timeline &m_timeline;
    ComparisonScenePtr m_scene;
    std::vector<Timeline *> m_clocks; ///< of the runs with an image, synchronised with the shared one
    std::vector<CameraView *> m_cameraViews;
    std::vector<QComboBox *> m_viewLists;
    Card *m_mapCard;
    CompareMap *m_map;
    AxisSpan *m_span; ///< of the distance
    DistanceChart *m_speed, *m_difference;
};

class ChartBubbles;
class SeriesKey;

/// The plot of one quantity of all runs, a group each, over distance; inside DistanceChart. The cursor shows
/// the first run at the shared time; a click, a drag or the arrow keys move it.
class DistanceArea : public ChartView
{
    Q_OBJECT
public:
    /// span: of the distance in metres, shared with other charts; must outlive this.
    DistanceArea(Timeline &timeline, AxisSpan &span, Compared what, QWidget *parent = nullptr);

    void setScene(ComparisonScenePtr scene);

protected:
    void paintOver(QPainter &painter) override;
    void goTo(double distanceM) override;

private:
    Timeline &m_timeline;
    Compared m_what;
    ChartBubbles *m_bubbles;
    ComparisonScenePtr m_scene;
};

/// One quantity of all runs over distance along the common path, with 95 % bands.
class DistanceChart : public Card
{
    Q_OBJECT
public:
    /// span: of the distance in metres, shared with other charts; must outlive this.
    DistanceChart(Timeline &timeline, AxisSpan &span, Compared what, QWidget *parent = nullptr);
    void setScene(ComparisonScenePtr scene);
    DistanceArea &area() const { return *m_area; }

Q_SIGNALS:
    void runToggled(int run, bool isShown); ///< in the key

private:
    Compared m_what;
    DistanceArea *m_area;
    QStringList m_names; ///< of the runs
    SeriesKey *m_key;    ///< of the speed alone; the other chart is below it
};

} // namespace odo
