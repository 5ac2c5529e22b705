// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/view_synchronisation.h"
#include "ui/main_window/internal/sound_chart.h"
#include "ui/models/background_task.h"

#include <QDialog>
#include <filesystem>
#include <memory>
#include <vector>

class QLabel;
class QTabWidget;

namespace odo {

class FrameAligner;
class ViewSteps;

/// Asks how the views of a stored trial are to be synchronised with the first; shows how they are now, and
/// two frames side by side and the sound of both views, each of which can be moved against the other.
class SynchroniseDialog : public QDialog
{
    Q_OBJECT
public:
    /// views: of the trial, in order; files: of each.
    SynchroniseDialog(const QString &trial, const std::vector<RecordingRecord> &views,
                      const std::vector<std::filesystem::path> &files, QWidget *parent = nullptr);
    std::vector<ViewStep> steps() const; ///< of the views but the first

private:
    QWidget *makeSteps(const std::vector<RecordingRecord> &views);
    void readSounds(const std::vector<std::filesystem::path> &files);
    void showView(std::size_t view);
    void showSounds(std::size_t view);
    void showFrames(std::size_t view);

    ViewSteps *m_steps;
    std::vector<RecordingRecord> m_views;
    std::vector<std::filesystem::path> m_files; ///< of each
    FrameAligner *m_frames;
    SoundChart *m_chart;
    QLabel *m_soundWords;             ///< how the chart is used, or why there is none
    std::vector<SoundPeaks> m_sounds; ///< of each view; without peaks: none
    std::size_t m_shownView = 0;      ///< whose sound is on show; 0: none yet
    std::size_t m_shownFrames = 0;    ///< the same of frames
    BackgroundTask m_reading;
};

} // namespace odo
