// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/report/annotated_video.h"

#include <QDialog>
#include <QString>

class QComboBox;
class QWidget;

namespace odo {

class Project;

/// Asks for a robot (where there are several), a format and a file, and writes the trial's newest track
/// there. Gives what there is to say; an empty text when the person thought better of it.
Result<QString> exportTrial(Project &project, const QString &trial, QWidget &window);

/// Asks at which speed, in which size and in which theme annotated videos are made.
class VideoDialog : public QDialog
{
    Q_OBJECT
public:
    /// isDark: what is offered first.
    VideoDialog(const QString &title, bool isDark, QWidget *parent = nullptr);
    /// Without a file.
    AnnotatedVideoSettings settings() const;

private:
    QComboBox *m_speed, *m_size, *m_theme;
};

} // namespace odo
