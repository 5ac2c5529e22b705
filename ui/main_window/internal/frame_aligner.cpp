// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/frame_aligner.h"

#include "core/base/units.h"
#include "core/workflow/trial_sources.h"
#include "ui/models/number_text.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace odo {

/// Paints an image as large as it fits, or a word in its place.
class FramePicture : public QWidget
{
    Q_OBJECT
public:
    using QWidget::QWidget;
    void setProportions(QSize size) { m_size = size; }
    void setImage(const QImage &image, const QString &problem = {})
    {
        m_image = image;
        m_problem = problem;
        update();
    }
    /// In device pixels.
    QSize wantedSize() const
    {
        return m_size.isEmpty() ? QSize() : m_size.scaled(size() * devicePixelRatioF(), Qt::KeepAspectRatio);
    }
    QSize sizeHint() const override { return {320, 180}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QSize m_size;
    QImage m_image;
    QString m_problem;
};

void FramePicture::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.imageBackground);
    if (m_image.isNull()) {
        painter.setPen(colours.text);
        painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, m_problem);
        return;
    }
    QRect target(QPoint(), m_image.size().scaled(size(), Qt::KeepAspectRatio));
    target.moveCenter(rect().center());
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(target, m_image);
}

FramePanel::FramePanel(QWidget *parent)
    : QWidget(parent), m_picture(new FramePicture), m_slider(new QSlider(Qt::Horizontal)),
      m_words(new ElidedLabel)
{
    constexpr int framesAPage = 10;
    m_slider->setPageStep(framesAPage);
    m_words->setObjectName(QStringLiteral("quiet"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_picture, 1);
    layout->addWidget(m_slider);
    layout->addWidget(m_words);
    connect(m_slider, &QSlider::valueChanged, this, [this] {
        showFrame();
        Q_EMIT moved();
    });
    connect(&m_fetcher, &FrameFetcher::frameReady, this, [this](qint64 frame, const QImage &image) {
        if (frame == m_slider->value())
            m_picture->setImage(image);
    });
    connect(&m_fetcher, &FrameFetcher::failed, this,
            [this](qint64, const QString &problem) { m_picture->setImage({}, problem); });
}

void FramePanel::setRecording(const RecordingRecord &recording, const std::filesystem::path &file)
{
    m_recording = recording;
    const QString camera = QString::fromStdString(recording.cameraName);
    m_slider->setAccessibleName(tr("Frame of camera %1").arg(camera));
    m_picture->setAccessibleName(tr("Camera %1").arg(camera));
    m_picture->setProportions({recording.widthPx, recording.heightPx});
    m_picture->setImage({});
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(0, std::max(0, static_cast<int>(recording.frameTimes.size()) - 1));
    m_fetcher.setFile(file, knownRecording(recording));
    showFrame();
}

Nanoseconds FramePanel::time() const
{
    const auto frame = static_cast<std::size_t>(m_slider->value());
    return frame < m_recording.frameTimes.size() ? m_recording.frameTimes[frame] : Nanoseconds(0);
}

void FramePanel::setTime(Nanoseconds time)
{
    const auto &times = m_recording.frameTimes;
    if (times.empty())
        return;
    auto near = std::ranges::lower_bound(times, time);
    if (near == times.end() || (near != times.begin() && time - *(near - 1) < *near - time))
        --near;
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(static_cast<int>(near - times.begin()));
    showFrame();
}

void FramePanel::showFrame()
{
    m_words->setFullText(tr("%1: frame %2, %3")
                             .arg(QString::fromStdString(m_recording.cameraName))
                             .arg(m_slider->value() + 1)
                             .arg(secondsText(time())));
    if (const QSize size = m_picture->wantedSize(); !size.isEmpty() && !m_recording.frameTimes.empty())
        m_fetcher.request(m_slider->value(), size);
}

void FramePanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    showFrame();
}

FrameAligner::FrameAligner(QWidget *parent)
    : QWidget(parent), m_first(new FramePanel), m_other(new FramePanel),
      m_together(new QCheckBox(tr("&Move both frames together")))
{
    m_together->setChecked(true);
    auto *words = new QLabel(
        tr("Together they show what is now taken for the same moment. Remove the tick, and move one "
           "frame until both show the same moment, such as a wheel that begins to turn."));
    showAsWords(*words);
    auto *frames = new QHBoxLayout;
    frames->addWidget(m_first);
    frames->addWidget(m_other);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(frames, 1);
    layout->addWidget(m_together);
    layout->addWidget(words);
    connect(m_first, &FramePanel::moved, this, [this] { follow(true); });
    connect(m_other, &FramePanel::moved, this, [this] { follow(false); });
}

void FrameAligner::setFirst(const RecordingRecord &recording, const std::filesystem::path &file)
{
    m_first->setRecording(recording, file);
}

void FrameAligner::setOther(const RecordingRecord &recording, const std::filesystem::path &file)
{
    m_other->setRecording(recording, file);
    setOffset(m_offsetS);
}

void FrameAligner::setOffset(double offsetS)
{
    if (std::exchange(m_offsetS, offsetS) != offsetS || m_together->isChecked())
        m_other->setTime(m_first->time() - fromSeconds(offsetS));
}

void FrameAligner::follow(bool isFirst)
{
    const Nanoseconds offset = fromSeconds(m_offsetS);
    if (!m_together->isChecked()) {
        m_offsetS = toSeconds(m_first->time() - m_other->time());
        Q_EMIT offsetChosen(m_offsetS);
    } else if (isFirst) {
        m_other->setTime(m_first->time() - offset);
    } else {
        m_first->setTime(m_other->time() + offset);
    }
}

} // namespace odo

#include "frame_aligner.moc"
