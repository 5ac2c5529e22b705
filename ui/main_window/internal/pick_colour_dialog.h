// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma.h"
#include "ui/models/background_task.h"
#include "ui/views/image/frame_fetcher.h"

#include <QDialog>
#include <QImage>
#include <QList>
#include <QRect>
#include <QWidget>
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
    int orientation = 1; ///< by which its frames are turned
};

class Project;
/// The recordings of the newest trials, each with its view.
QList<PickableVideo> newestRecordings(Project &project);

/// Picks a robot's colour from a recording: the user chooses a frame and draws a box round the robot; the
/// dialog shows the colour, or why it found none. Decodes and analyses on other threads.
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
    void search();
    void present(const Result<PickedColour> &picked);
    void sayNothingYet();

    QList<PickableVideo> m_videos;
    QComboBox *m_choice;
    BoxCanvas *m_canvas;
    QSlider *m_frame;
    QLabel *m_frameText, *m_swatch, *m_words;
    QDialogButtonBox *m_buttons;
    FrameFetcher m_fetcher;
    BackgroundTask m_searching, m_opening;
    bool m_searchAgain = false; ///< the box changed during the analysis
    std::optional<RgbColour> m_colour;
};

/// An image on which one box is drawn, with the mouse or by keys: the arrows move it, with Shift they move
/// its lower right corner, with Ctrl either by larger steps. The first key press puts a box in the middle.
class BoxCanvas : public QWidget
{
    Q_OBJECT
public:
    explicit BoxCanvas(QWidget *parent = nullptr);
    /// size: of the image in whose pixels the box is given. Another size clears the box.
    void setSourceSize(QSize size);
    QSize sourceSize() const { return m_size; }
    void setImage(const QImage &image);
    void setEmptyText(const QString &text);
    /// In image pixels; empty: none yet.
    QRect box() const { return m_box; }
    /// Where the image is shown, in the widget.
    QRectF imageRect() const;

    QSize sizeHint() const override { return {800, 450}; }
    QSize minimumSizeHint() const override { return {320, 180}; }

Q_SIGNALS:
    void boxChanged(const QRect &box); ///< finished, not while it is drawn
    void resized();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QPoint toPixel(const QPointF &position) const;
    QRectF positionOf(const QRect &box) const;

    QImage m_image;
    QSize m_size;
    QRect m_box, m_boxBefore;
    QPoint m_corner; ///< where the drawing began
    bool m_drawing = false;
    QString m_emptyText;
};

} // namespace odo
