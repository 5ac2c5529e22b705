// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/coverage_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>

namespace odo {
namespace {

constexpr int whole = 100;
constexpr double wantedPart = 0.5; // of the fields, as BoardCoverage::isEnough asks

} // namespace

CoveragePanel::CoveragePanel(QWidget *parent) : QWidget(parent), m_count(new QLabel)
{
    const QString names[] = {tr("Across"), tr("Up and down"), tr("Near"), tr("Tilted"), tr("Covered")};
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(12, 10, 12, 10);
    grid->setVerticalSpacing(8);
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        auto *name = new QLabel(names[i]);
        m_bars[i] = new QProgressBar;
        m_bars[i]->setRange(0, whole);
        m_bars[i]->setTextVisible(false);
        m_bars[i]->setFixedHeight(10);
        m_bars[i]->setAccessibleName(names[i]);
        m_marks[i] = new QLabel;
        m_marks[i]->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("✓")) + 2);
        grid->addWidget(name, int(i), 0);
        grid->addWidget(m_bars[i], int(i), 1);
        grid->addWidget(m_marks[i], int(i), 2);
    }
    grid->addWidget(m_count, int(m_bars.size()), 0, 1, 3);
    setCoverage({});
}

void CoveragePanel::setCoverage(const BoardCoverage &coverage)
{
    const double parts[] = {coverage.x, coverage.y, coverage.size, coverage.skew,
                            std::min(1.0, coverage.coveredPart() / wantedPart)};
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        m_bars[i]->setValue(int(parts[i] * whole));
        m_marks[i]->setText(parts[i] >= 1 ? QStringLiteral("✓") : QString());
    }
    m_count->setText(coverage.isEnough() ? tr("%1 pictures: enough. More do no harm.").arg(coverage.pictures)
                     : coverage.pictures == 1 ? tr("1 picture; ten or more are wanted.")
                                              : tr("%1 pictures; ten or more are wanted.").arg(coverage.pictures));
}

} // namespace odo
