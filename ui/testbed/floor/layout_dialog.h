// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/marker_layout.h"
#include "core/calibration/world_axes.h"
#include "core/files/output_guard.h"

#include <QDialog>
#include <QStringList>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace odo {

class LayoutDrawing;

/// Makes a marker layout, or a new one out of a stored one: a table and a drawing of the same markers, the axes, CSV in
/// and out. Stores nothing: that is up to whoever opened it, once it is accepted.
class LayoutDialog : public QDialog
{
    Q_OBJECT
public:
    /// taken: names of layouts that are there.
    LayoutDialog(const MarkerLayout &start, const QStringList &taken, QWidget *parent = nullptr);

    MarkerLayout layout() const { return m_layout; }
    /// What is wrong with it as it stands, in a sentence; empty: nothing.
    QString problem() const;
    Result<void> importCsv(const QString &file);
    Result<void> exportCsv(const OutputTarget &target) const;
    /// Told in the dialog where it is refused.
    void changeAxes(const AxesChange &change);

private:
    QWidget *makeTable();
    QWidget *makeTools();
    void showMarkers();
    void readRow(int row);
    void addMarker();
    void removeMarker();
    void tell(const Result<void> &outcome);
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

} // namespace odo
