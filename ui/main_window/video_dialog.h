// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/annotated_video.h"

#include <QDialog>

class QComboBox;

namespace odo {

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
