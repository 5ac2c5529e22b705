// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_coverage.h"

#include <QWidget>
#include <array>

class QLabel;
class QProgressBar;

namespace odo {

/// The four bars that tell what the pictures still lack, and how many there are.
class CoveragePanel : public QWidget
{
    Q_OBJECT
public:
    explicit CoveragePanel(QWidget *parent = nullptr);
    void setCoverage(const BoardCoverage &coverage);

private:
    std::array<QProgressBar *, 5> m_bars{};
    std::array<QLabel *, 5> m_marks{};
    QLabel *m_count;
};

} // namespace odo
