// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report_settings.h"

#include <QWidget>

class QFormLayout;
class QLabel;
class QLineEdit;

namespace odo {

class PathField;

/// What a school has on all of its reports: its name, logo and a line at the foot. Kept in the settings at once.
class ReportsPage : public QWidget
{
    Q_OBJECT
public:
    explicit ReportsPage(QWidget *parent = nullptr);

private:
    QLineEdit *addLine(QFormLayout &form, const QString &label, const QString &text);
    void store();
    void showLogo();

    ReportSettings m_settings;
    QLineEdit *m_school, *m_remark;
    PathField *m_logo;
    QLabel *m_picture;
};

} // namespace odo
