// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"
#include "ui/main_window/internal/done_work.h"
#include "ui/report/annotated_video.h"

#include <QDialog>
#include <QString>
#include <optional>

class QComboBox;
class QWidget;

namespace odo {

class Project;

/// Asks how (ExportDialog) and for a file, and writes the trial's newest track there. selection: of the time
/// line, a part that can be exported alone. Gives what there is to say; no words when the person thought
/// better of it.
Result<DoneWork> exportTrial(Project &project, const QString &trial, const std::optional<TimeSpan> &selection,
                             QWidget &window);

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
