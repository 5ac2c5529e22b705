// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/report/report_settings.h"

#include <QWidget>
#include <memory>
#include <optional>

class QFormLayout;
class QImage;
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
    void takeLogo(const std::optional<Error> &error);

    ReportSettings m_settings;
    QLineEdit *m_school, *m_remark;
    PathField *m_logo;
    QLabel *m_picture;
    BackgroundTask m_reading;       ///< of the logo: a large one takes a while
    std::shared_ptr<QImage> m_read; ///< by it
    bool m_isOther = false;         ///< another logo was chosen meanwhile
};

} // namespace odo
