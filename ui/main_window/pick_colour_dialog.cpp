// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/pick_colour_dialog.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "core/workflow/picture_source.h"
#include "ui/main_window/box_canvas.h"
#include "ui/models/error_words.h"
#include "ui/views/path_field.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <memory>

namespace odo {
namespace {
constexpr int swatchSide = 32;
}

PickColourDialog::PickColourDialog(QList<PickableVideo> videos, QWidget *parent)
    : QDialog(parent), m_videos(std::move(videos)), m_choice(new QComboBox), m_canvas(new BoxCanvas),
      m_frame(new QSlider(Qt::Horizontal)), m_frameText(new QLabel), m_swatch(new QLabel),
      m_words(new QLabel), m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Robot's colour from a picture"));
    auto *file = new QPushButton(tr("Another &video…"));
    auto *label = new QLabel(tr("&Recording"));
    label->setBuddy(m_choice);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto *top = new QHBoxLayout;
    top->addWidget(label);
    top->addWidget(m_choice, 1);
    top->addWidget(file);
    auto *frameLabel = new QLabel(tr("&Frame"));
    frameLabel->setBuddy(m_frame);
    auto *frames = new QHBoxLayout;
    frames->addWidget(frameLabel);
    frames->addWidget(m_frame, 1);
    frames->addWidget(m_frameText);
    m_swatch->setFixedSize(swatchSide, swatchSide);
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_canvas->setEmptyText(tr("Choose a video in which the robot is seen."));
    auto *found = new QHBoxLayout;
    found->addWidget(m_swatch);
    found->addWidget(m_words, 1);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_canvas, 1);
    layout->addLayout(frames);
    layout->addLayout(found);
    layout->addWidget(m_buttons);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Take this colour"));

    for (const PickableVideo &video : std::as_const(m_videos))
        m_choice->addItem(video.name);
    connect(file, &QPushButton::clicked, this, &PickColourDialog::chooseFile);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &PickColourDialog::showVideo);
    connect(m_frame, &QSlider::valueChanged, this, [this] {
        showFrame();
        look();
    });
    connect(m_canvas, &BoxCanvas::boxChanged, this, &PickColourDialog::look);
    connect(m_canvas, &BoxCanvas::resized, this, &PickColourDialog::showFrame);
    connect(&m_fetcher, &FrameFetcher::frameReady, this,
            [this](qint64, const QImage &picture) { m_canvas->setPicture(picture); });
    connect(&m_fetcher, &FrameFetcher::failed, this,
            [this](qint64, const QString &message) { m_words->setText(message); });
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    sayNothingYet();
    showVideo(m_choice->currentIndex());
    m_canvas->setFocus();
}

void PickColourDialog::chooseFile()
{
    const QString chosen =
        QFileDialog::getOpenFileName(this, tr("Video in which the robot is seen"), {},
                                     tr("Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;All files (*)"));
    if (!chosen.isEmpty())
        addFile(pathOf(chosen));
}

void PickColourDialog::addFile(const std::filesystem::path &file)
{
    const auto opened = std::make_shared<PickableVideo>(PickableVideo{textOf(file.filename()), file, {}, 0});
    const bool started = m_opening.start([opened](const JobControl &) -> Result<void> {
        const auto reader = VideoReader::open(opened->file);
        if (!reader)
            return tl::unexpected(reader.error());
        const VideoInfo &info = (*reader)->info();
        opened->size = {info.format.width, info.format.height};
        opened->frames = static_cast<qint64>(info.frameTimes.size());
        return {};
    });
    if (!started)
        return;
    connect(
        &m_opening, &BackgroundTask::finished, this,
        [this, opened](const std::optional<Error> &error) {
            if (error) {
                m_words->setText(errorInWords(*error));
                return;
            }
            m_videos.append(*opened);
            m_choice->addItem(opened->name);
            m_choice->setCurrentIndex(m_choice->count() - 1);
        },
        Qt::SingleShotConnection);
}

void PickColourDialog::showVideo(int index)
{
    const bool there = index >= 0;
    m_choice->setEnabled(there);
    m_frame->setEnabled(there);
    if (!there)
        return;
    const PickableVideo &video = m_videos[index];
    m_canvas->setSourceSize(video.size);
    m_fetcher.setFile(video.file);
    m_frame->setRange(0, static_cast<int>(std::max<qint64>(video.frames, 1) - 1));
    m_frame->setValue(0);
    showFrame();
    look();
}

void PickColourDialog::showFrame()
{
    if (m_choice->currentIndex() < 0)
        return;
    m_frameText->setText(
        tr("%1 of %2")
            .arg(QLocale().toString(m_frame->value() + 1), QLocale().toString(m_frame->maximum() + 1)));
    m_fetcher.request(m_frame->value(), (m_canvas->pictureRect().size() * devicePixelRatioF()).toSize());
}

void PickColourDialog::look()
{
    const QRect box = m_canvas->box();
    if (box.isEmpty() || m_choice->currentIndex() < 0) {
        sayNothingYet();
        return;
    }
    const auto found = std::make_shared<std::optional<Result<PickedColour>>>();
    const bool started =
        m_looking.start([found, box, frame = m_frame->value(),
                         file = m_videos[m_choice->currentIndex()].file](const JobControl &) {
            const auto picture = pictureOf(file, frame);
            *found = picture
                         ? pickColour(*picture, {box.left(), box.top(), box.right() + 1, box.bottom() + 1})
                         : Result<PickedColour>(tl::unexpected(picture.error()));
            return Result<void>();
        });
    m_lookAgain = !started;
    m_colour.reset();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    if (!started)
        return;
    connect(
        &m_looking, &BackgroundTask::finished, this,
        [this, found] {
            if (std::exchange(m_lookAgain, false))
                look();
            else if (*found)
                present(**found);
        },
        Qt::SingleShotConnection);
}

void PickColourDialog::present(const Result<PickedColour> &picked)
{
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(picked.has_value());
    m_swatch->setVisible(picked.has_value());
    if (!picked) {
        m_words->setText(errorInWords(picked.error()));
        return;
    }
    m_colour = picked->colour;
    QPixmap swatch(swatchSide, swatchSide);
    swatch.fill(QColor(m_colour->red, m_colour->green, m_colour->blue));
    m_swatch->setPixmap(swatch);
    m_words->setText(tr("The robot's colour here: %1. It fills %2 % of the box.")
                         .arg(QString::fromStdString(m_colour->toString()))
                         .arg(std::lround(100 * picked->share)));
}

void PickColourDialog::sayNothingYet()
{
    m_colour.reset();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    m_swatch->hide();
    m_words->setText(tr("Draw a box closely round the robot with the mouse; or with the arrow keys, which "
                        "move the box, and with Shift "
                        "make it larger or smaller."));
}

QList<PickableVideo> newestRecordings(Project &project)
{
    constexpr std::size_t mostTrials = 12;
    QList<PickableVideo> videos;
    const auto trials = project.trials().page(nullptr, static_cast<int>(mostTrials));
    for (std::size_t i = 0; trials && i < std::min(mostTrials, trials->size()); ++i) {
        const auto recordings = project.trials().recordings((*trials)[i].id);
        for (std::size_t v = 0; recordings && v < recordings->size(); ++v) {
            const RecordingRecord &recording = (*recordings)[v];
            videos.append({PickColourDialog::tr("%1, camera %2")
                               .arg(QString::fromStdString((*trials)[i].name),
                                    QString::fromStdString(recording.cameraName)),
                           project.resolve(recording), QSize(recording.widthPx, recording.heightPx),
                           static_cast<qint64>(recording.frameTimes.size())});
        }
    }
    return videos;
}

} // namespace odo
