// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/pick_colour_dialog.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/trial_sources.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <utility>

namespace odo {

namespace {
constexpr int swatchSide = 32;
}

PickColourDialog::PickColourDialog(QList<PickableVideo> videos, QWidget *parent)
    : QDialog(parent), m_videos(std::move(videos)), m_choice(new QComboBox), m_canvas(new BoxCanvas),
      m_frame(new QSlider(Qt::Horizontal)), m_frameText(new QLabel), m_swatch(new QLabel),
      m_words(new QLabel), m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Pick the robot's colour"));
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
    m_canvas->setEmptyText(tr("Choose a video that shows the robot."));
    auto *found = new QHBoxLayout;
    found->addWidget(m_swatch);
    found->addWidget(m_words, 1);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_canvas, 1);
    layout->addLayout(frames);
    layout->addLayout(found);
    layout->addWidget(m_buttons);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Use this colour"));

    for (const PickableVideo &video : std::as_const(m_videos))
        m_choice->addItem(video.name);
    connect(file, &QPushButton::clicked, this, &PickColourDialog::chooseFile);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &PickColourDialog::showVideo);
    connect(m_frame, &QSlider::valueChanged, this, [this] {
        showFrame();
        search();
    });
    connect(m_canvas, &BoxCanvas::boxChanged, this, &PickColourDialog::search);
    connect(m_canvas, &BoxCanvas::resized, this, &PickColourDialog::showFrame);
    connect(&m_fetcher, &FrameFetcher::frameReady, this,
            [this](qint64, const QImage &image) { m_canvas->setImage(image); });
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
        QFileDialog::getOpenFileName(this, tr("Video that shows the robot"), {},
                                     tr("Videos (*.mp4 *.mov *.mkv *.avi *.m4v);;All files (*)"));
    if (!chosen.isEmpty())
        addFile(pathOf(chosen));
}

void PickColourDialog::addFile(const std::filesystem::path &file)
{
    const auto opened =
        std::make_shared<PickableVideo>(PickableVideo{textOf(file.filename()), file, {}, 0, 1});
    const bool started = m_opening.start([opened](const JobControl &) -> Result<void> {
        const auto reader = ODO_TRY(VideoReader::open(opened->file));
        const VideoInfo &info = reader->info();
        opened->size = {info.format.width, info.format.height};
        opened->frames = static_cast<qint64>(info.frameTimes.size());
        opened->orientation = info.orientation;
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
    m_fetcher.setFile(video.file, {static_cast<std::size_t>(video.frames), video.orientation});
    m_frame->setRange(0, static_cast<int>(std::max<qint64>(video.frames, 1) - 1));
    m_frame->setValue(0);
    showFrame();
    search();
}

void PickColourDialog::showFrame()
{
    if (m_choice->currentIndex() < 0)
        return;
    m_frameText->setText(
        tr("%1 of %2")
            .arg(QLocale().toString(m_frame->value() + 1), QLocale().toString(m_frame->maximum() + 1)));
    m_fetcher.request(m_frame->value(), (m_canvas->imageRect().size() * devicePixelRatioF()).toSize());
}

void PickColourDialog::search()
{
    const QRect box = m_canvas->box();
    if (box.isEmpty() || m_choice->currentIndex() < 0) {
        sayNothingYet();
        return;
    }
    const auto found = std::make_shared<std::optional<Result<PickedColour>>>();
    const bool started =
        m_searching.start([found, box, frame = m_frame->value(),
                           file = m_videos[m_choice->currentIndex()].file](const JobControl &) {
            const auto image = imageOf(file, frame);
            *found = image ? pickColour(*image, {box.left(), box.top(), box.right() + 1, box.bottom() + 1})
                           : Result<PickedColour>(tl::unexpected(image.error()));
            return Result<void>();
        });
    m_searchAgain = !started;
    m_colour.reset();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    if (!started)
        return;
    connect(
        &m_searching, &BackgroundTask::finished, this,
        [this, found] {
            if (std::exchange(m_searchAgain, false))
                search();
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
    m_words->setText(tr("Draw a tight box round the robot with the mouse, or use the keyboard: arrow keys "
                        "move the box, Shift + arrow keys resize it."));
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
                           static_cast<qint64>(recording.frameTimes.size()),
                           knownRecording(recording).orientation.value_or(1)});
        }
    }
    return videos;
}

namespace {

const QColor boxColour(240, 228, 66);
constexpr int leastSidePx = 3; // in image pixels; less is a click
constexpr int stepsAcross = 160, leapsAcross = 20, boxesAcross = 8;

} // namespace

BoxCanvas::BoxCanvas(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName(
        tr("Video frame; arrow keys move the box round the robot, Shift + arrow keys resize it"));
}

void BoxCanvas::setSourceSize(QSize size)
{
    if (size == m_size)
        return;
    m_size = size;
    m_image = {};
    m_box = {};
    update();
}

void BoxCanvas::setImage(const QImage &image)
{
    m_image = image;
    update();
}

void BoxCanvas::setEmptyText(const QString &text)
{
    m_emptyText = text;
    update();
}

QRectF BoxCanvas::imageRect() const
{
    const QSizeF room = QSizeF(m_size).scaled(size(), Qt::KeepAspectRatio);
    return {QPointF(0.5 * (width() - room.width()), 0.5 * (height() - room.height())), room};
}

QPoint BoxCanvas::toPixel(const QPointF &position) const
{
    const QRectF image = imageRect();
    const auto inside = [](double part, int size) {
        return std::clamp(static_cast<int>(part * size), 0, size - 1);
    };
    return {inside((position.x() - image.x()) / image.width(), m_size.width()),
            inside((position.y() - image.y()) / image.height(), m_size.height())};
}

QRectF BoxCanvas::positionOf(const QRect &box) const
{
    const QRectF image = imageRect();
    const double scale = image.width() / m_size.width();
    return {image.topLeft() + QPointF(box.topLeft()) * scale, QSizeF(box.size()) * scale};
}

void BoxCanvas::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.imageBackground);
    if (m_image.isNull()) {
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    } else {
        painter.drawImage(imageRect(), m_image);
    }
    if (!m_box.isEmpty() && !m_image.isNull()) {
        for (const auto &[colour, width] :
             {std::pair(QColor(0, 0, 0, 180), 4.0), std::pair(boxColour, 2.0)}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
            painter.drawRect(positionOf(m_box));
        }
    }
    if (hasFocus()) {
        painter.setPen(QPen(colours.accent, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void BoxCanvas::resizeEvent(QResizeEvent *)
{
    Q_EMIT resized();
}

void BoxCanvas::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || m_image.isNull())
        return;
    m_drawing = true;
    m_boxBefore = m_box;
    m_corner = toPixel(event->position());
    m_box = {};
    update();
}

void BoxCanvas::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_drawing)
        return;
    m_box = QRect(m_corner, toPixel(event->position())).normalized();
    update();
}

void BoxCanvas::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !std::exchange(m_drawing, false))
        return;
    const QRect drawn = QRect(m_corner, toPixel(event->position())).normalized();
    const bool isBox = drawn.width() >= leastSidePx && drawn.height() >= leastSidePx;
    m_box = isBox ? drawn : m_boxBefore;
    update();
    if (isBox)
        Q_EMIT boxChanged(m_box);
}

void BoxCanvas::keyPressEvent(QKeyEvent *event)
{
    const int step =
        std::max(1, m_size.width() / (event->modifiers() & Qt::ControlModifier ? leapsAcross : stepsAcross));
    QPoint by;
    switch (event->key()) {
    case Qt::Key_Left:
        by.setX(-step);
        break;
    case Qt::Key_Right:
        by.setX(step);
        break;
    case Qt::Key_Up:
        by.setY(-step);
        break;
    case Qt::Key_Down:
        by.setY(step);
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    if (m_image.isNull())
        return;
    const QRect image(QPoint(0, 0), m_size);
    if (m_box.isEmpty()) {
        const QSize side(m_size.width() / boxesAcross, m_size.height() / boxesAcross);
        m_box = QRect(image.center() - QPoint(side.width() / 2, side.height() / 2), side);
    } else if (event->modifiers() & Qt::ShiftModifier) {
        const QPoint least = m_box.topLeft() + QPoint(leastSidePx, leastSidePx),
                     wanted = m_box.bottomRight() + by;
        m_box.setBottomRight({std::clamp(wanted.x(), std::min(least.x(), image.right()), image.right()),
                              std::clamp(wanted.y(), std::min(least.y(), image.bottom()), image.bottom())});
    } else {
        m_box.moveTo(std::clamp(m_box.x() + by.x(), 0, std::max(0, m_size.width() - m_box.width())),
                     std::clamp(m_box.y() + by.y(), 0, std::max(0, m_size.height() - m_box.height())));
    }
    update();
    Q_EMIT boxChanged(m_box);
}

} // namespace odo
