// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "ui/models/trial_scene.h"

#include <QAbstractTableModel>
#include <QString>
#include <optional>
#include <vector>

namespace odo {

/// A column of samples: what a robot's profile is at each of them.
enum class SampleColumn {
    Time,
    Frame,
    PositionX,
    SigmaX,
    PositionY,
    SigmaY,
    VelocityX,
    VelocityY,
    Speed,
    SigmaSpeed,
    AccelerationX,
    AccelerationY,
    Acceleration,
    SigmaAcceleration,
    Heading,
    SigmaHeading,
    TurnRate,
    SigmaTurnRate,
    Distance,
    MeasuredX,
    MeasuredY,
    Views,
    Flags,
    Count
};

/// "speed": of a column, for the settings.
QString sampleColumnWord(SampleColumn column);

/// Every sample of a robot's run in the range that counts: smoothed values with their σ, and what was
/// measured, in the units that are shown. GUI thread.
class SampleModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;
    /// Null: nothing.
    void setRun(TrialScenePtr scene, std::size_t robot);
    const Profile *profile() const;
    /// The last one at or before a time; -1: none.
    int rowAt(Nanoseconds time) const;
    std::optional<Nanoseconds> timeAt(int row) const;
    /// Rows and columns with headings for a spreadsheet: cells parted by tabs, numbers in all digits.
    QString tabbed(const std::vector<int> &rows, const std::vector<int> &columns) const;
    static QString headingOf(SampleColumn column); ///< "Speed (m/s)"

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    int rows() const;
    std::optional<double> number(int row, SampleColumn column) const;
    QString words(int row, SampleColumn column) const;
    const std::optional<Heading> &headingAt(std::size_t row) const;
    double distanceAt(std::size_t row) const;

    TrialScenePtr m_scene;
    std::size_t m_robot = 0;
    // Computed when a column is shown that needs them; as many as samples, or none yet.
    mutable std::vector<std::optional<Heading>> m_headings;
    mutable std::vector<double> m_distances; ///< travelled since the first, metres
};

} // namespace odo
