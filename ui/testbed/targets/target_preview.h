// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/targets/target_sheet.h"

#include <QWidget>

namespace odo {

/// The sheets as they will come out of the printer, side by side, as large as there is room. Paper stays white in the
/// dark.
class TargetPreview : public QWidget
{
    Q_OBJECT
public:
    explicit TargetPreview(QWidget *parent = nullptr);
    void setSheets(const TargetSpec &spec, std::vector<TargetSheet> sheets);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    TargetSpec m_spec;
    std::vector<TargetSheet> m_sheets;
};

} // namespace odo
