// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/calibration/world_axes.h"
#include "core/files/output_file.h"

#include <QDialog>
#include <QStringList>
#include <QWidget>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace odo {

class LayoutDrawing;

/// Makes a marker layout, or a new one out of a stored one: a table and a drawing of the same markers, the
/// axes, CSV in and out. Stores nothing: that is up to whoever opened it, once it is accepted.
class LayoutDialog : public QDialog
{
    Q_OBJECT
public:
    /// taken: names of layouts that are there.
    LayoutDialog(const MarkerLayout &start, const QStringList &taken, QWidget *parent = nullptr);

    MarkerLayout layout() const { return m_layout; }
    /// Its first problem, in a sentence; empty: none.
    QString problem() const;
    Result<void> importCsv(const QString &file);
    Result<void> exportCsv(const OutputTarget &target) const;
    /// Shows in the dialog why a file is refused.
    void changeAxes(const AxesChange &change);

private:
    QWidget *makeTable();
    QWidget *makeTools();
    void showMarkers();
    void readRow(int row);
    void addMarker();
    void removeMarker();
    void showOutcome(const Result<void> &outcome);
    void check();

    MarkerLayout m_layout;
    const QStringList m_taken;
    bool m_showing = false;
    QLineEdit *m_name;
    QTableWidget *m_table;
    LayoutDrawing *m_drawing;
    QLabel *m_message;
    QPushButton *m_save = nullptr;
};

/// The markers from above, to scale, with the world's axes; they can be dragged, in steps of a centimetre.
class LayoutDrawing : public QWidget
{
    Q_OBJECT
public:
    explicit LayoutDrawing(QWidget *parent = nullptr);
    void setLayout(const MarkerLayout &layout, int current);
    QSize sizeHint() const override { return {420, 360}; }
    QSize minimumSizeHint() const override { return {240, 200}; }

Q_SIGNALS:
    void picked(int marker);
    void moved(int marker, const Eigen::Vector2d &pointInWorld);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();
    QPointF toScreen(const Eigen::Vector2d &point) const;
    Eigen::Vector2d toWorld(const QPointF &position) const;

    MarkerLayout m_layout;
    int m_current = -1;
    bool m_dragging = false;
    Eigen::Vector2d m_middle = Eigen::Vector2d::Zero();
    double m_pixelsPerMetre = 100;
};

} // namespace odo
