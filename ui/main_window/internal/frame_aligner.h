// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/views/image/frame_fetcher.h"

#include <QImage>
#include <QWidget>
#include <filesystem>

class QCheckBox;
class QSlider;

namespace odo {

class ElidedLabel;
class FramePicture;

/// One frame of a recording and a slider through all of them; the arrow keys step by frames. Decodes on a
/// thread of its own. GUI thread.
class FramePanel : public QWidget
{
    Q_OBJECT
public:
    explicit FramePanel(QWidget *parent = nullptr);
    void setRecording(const RecordingRecord &recording, const std::filesystem::path &file);
    /// Of the frame on show, since the recording's first; 0 without frames.
    Nanoseconds time() const;
    /// Shows the nearest frame; emits nothing.
    void setTime(Nanoseconds time);
    bool isSettled() const { return m_fetcher.isIdle(); }

Q_SIGNALS:
    void moved(); ///< by a person

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void showFrame();

    RecordingRecord m_recording;
    FramePicture *m_picture;
    QSlider *m_slider;
    ElidedLabel *m_words; ///< a camera may have a long name
    FrameFetcher m_fetcher;
};

/// Frames of two views side by side: moved together they show what the present time offset takes for one
/// moment; moved one against the other they set it. GUI thread.
class FrameAligner : public QWidget
{
    Q_OBJECT
public:
    explicit FrameAligner(QWidget *parent = nullptr);
    void setFirst(const RecordingRecord &recording, const std::filesystem::path &file);
    void setOther(const RecordingRecord &recording, const std::filesystem::path &file);
    /// How much later the other view's first frame was taken, seconds; moves the other frame.
    void setOffset(double offsetS);
    bool isSettled() const { return m_first->isSettled() && m_other->isSettled(); }

Q_SIGNALS:
    void offsetChosen(double offsetS);

private:
    void follow(bool isFirst);

    FramePanel *m_first, *m_other;
    QCheckBox *m_together;
    double m_offsetS = 0;
};

} // namespace odo
