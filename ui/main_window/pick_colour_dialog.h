// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/picked_colour.h"
#include "ui/models/background_task.h"
#include "ui/views/frame_fetcher.h"

#include <QDialog>
#include <QList>
#include <QRect>
#include <filesystem>
#include <optional>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QSlider;

namespace odo {

class BoxCanvas;

/// A video in which a robot may be seen.
struct PickableVideo
{
    QString name;
    std::filesystem::path file;
    QSize size;
    qint64 frames = 0;
};

class Project;
/// The recordings of the newest trials, each with its view.
QList<PickableVideo> newestRecordings(Project &project);

/// Takes a robot's colour from a picture: a frame of a recording is chosen, a box drawn round the robot, and
/// what was found in it shown, or said why nothing was. Decodes and looks on other threads.
class PickColourDialog : public QDialog
{
    Q_OBJECT
public:
    explicit PickColourDialog(QList<PickableVideo> videos, QWidget *parent = nullptr);
    /// What the box holds; set when the dialog was accepted.
    std::optional<RgbColour> colour() const { return m_colour; }

private:
    void chooseFile();
    void addFile(const std::filesystem::path &file);
    void showVideo(int index);
    void showFrame();
    void look();
    void present(const Result<PickedColour> &picked);
    void sayNothingYet();

    QList<PickableVideo> m_videos;
    QComboBox *m_choice;
    BoxCanvas *m_canvas;
    QSlider *m_frame;
    QLabel *m_frameText, *m_swatch, *m_words;
    QDialogButtonBox *m_buttons;
    FrameFetcher m_fetcher;
    BackgroundTask m_looking, m_opening;
    bool m_lookAgain = false; ///< the box was changed while it was being looked at
    std::optional<RgbColour> m_colour;
};

} // namespace odo
