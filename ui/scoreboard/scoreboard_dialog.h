// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/scoreboard/scoreboard.h"

#include <QDialog>
#include <filesystem>

class QComboBox;
class QLabel;
class QPushButton;

namespace odo {

class Project;
class QrWidget;

/// Serves the standings of a project as a web page as long as it is open: chooses class, task and who can see
/// it, and shows the page's address, also as a QR code. The page is served from a thread of its own. The
/// window must have the project open meanwhile. GUI thread.
class ScoreboardDialog : public QDialog
{
    Q_OBJECT
public:
    explicit ScoreboardDialog(Project &project, QWidget *parent = nullptr);
    ~ScoreboardDialog() override;

private:
    void offer(Project &project);
    ScoreboardSettings settings() const;
    void restart();
    void begin();
    void showAddress(const QString &url, bool isForNetwork);
    void finish(const std::optional<Error> &error);

    const std::filesystem::path m_file;
    QComboBox *m_class, *m_task, *m_audience;
    QrWidget *m_code;
    QLabel *m_address, *m_words;
    QPushButton *m_copy, *m_open;
    QString m_url;
    bool m_isWanted = false;  ///< with other settings, when the page served now has ended
    BackgroundTask m_serving; ///< last, so that it ends first
};

} // namespace odo
