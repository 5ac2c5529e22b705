// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/still_picture.h"

#include "core/capture/camera_source.h"
#include "core/video/picture.h"
#include "core/workflow/calibrate/calibration_pictures.h"
#include "ui/models/shown_message.h"
#include "ui/views/picture/picture_painting.h"
#include "ui/views/widgets/form_fields.h"

#include <QHBoxLayout>
#include <QRadioButton>
#include <QVBoxLayout>

namespace odo {

namespace {

constexpr int videoStep = 15, mostPictures = 8;

Result<void> lookIn(const Frame &frame, const MarkerLayout &layout, const std::optional<Intrinsics> &lens,
                    StillPicture &best)
{
    if (lens && (lens->widthPx != frame.format.width || lens->heightPx != frame.format.height))
        return fail(
            ErrorCode::InvalidInput, pictureSubject(),
            ODO_TEXT("ui.lens_of_other_size", "its size is %1×%2, but the lens was calibrated at %3×%4")(
                frame.format.width, frame.format.height, lens->widthPx, lens->heightPx),
            ODO_TEXT("ui.take_at_that_resolution", "use that resolution, or calibrate the lens again"));
    if (layout.markers.empty()) {
        best.frame = frame;
        return {};
    }
    MarkerSearch search;
    search.camera = cameraOf(lens, frame.format.width, frame.format.height);
    search.intrinsicsKnown = lens.has_value();
    const auto markers = findMarkers(frame, layout, search);
    const bool first = best.frame.format.width == 0;
    if (!first && (!markers || markers->size() <= best.markers.size()))
        return {};
    best.frame = frame;
    best.markers = markers.value_or(std::vector<MarkerPixel>());
    best.notFound = markers ? std::nullopt : std::optional<Error>(markers.error());
    return {};
}

Result<StillPicture> fromCamera(const std::string &uri, const MarkerLayout &layout,
                                const std::optional<Intrinsics> &lens, const JobControl &control)
{
    auto camera = ODO_TRY(openCamera(uri));
    const auto frame = ODO_TRY(settledPicture(*camera, control));
    StillPicture picture;
    ODO_TRY(lookIn(frame, layout, lens, picture));
    return picture;
}

} // namespace

CameraModel cameraOf(const std::optional<Intrinsics> &lens, int widthPx, int heightPx)
{
    if (lens)
        if (auto camera = CameraModel::create(*lens))
            return *camera;
    return CameraModel::assumed(widthPx, heightPx);
}

Result<StillPicture> takeStillPicture(const PictureOrigin &origin, const MarkerLayout &layout,
                                      const std::optional<Intrinsics> &lens, const JobControl &control)
{
    Result<StillPicture> picture = StillPicture();
    if (!origin.liveUri.isEmpty()) {
        picture = fromCamera(origin.liveUri.toStdString(), layout, lens, control);
    } else {
        int looked = 0;
        Result<void> problem;
        const auto visited = visitPictures(
            pathOf(origin.file), videoStep,
            [&](const Frame &frame, const std::string &name) {
                control.report(double(looked) / mostPictures, lookingForMarkersIn(name));
                problem = lookIn(frame, layout, lens, *picture);
                return problem && picture->markers.size() < layout.markers.size() &&
                       ++looked < mostPictures && !control.isCancelled();
            },
            control.cancel);
        if (!problem)
            return tl::unexpected(problem.error());
        if (!visited && picture->frame.format.width == 0)
            return tl::unexpected(visited.error());
    }
    if (control.isCancelled())
        return cancelled(pictureSubject());
    if (picture)
        picture->image =
            toImage(toScreen(picture->frame, picture->frame.format.width, picture->frame.format.height));
    return picture;
}

namespace {

constexpr int indent = 24;

QHBoxLayout *indented(QWidget *widget, bool stretched)
{
    auto *row = new QHBoxLayout;
    row->setContentsMargins(indent, 0, 0, 0);
    row->addWidget(widget, stretched ? 1 : 0);
    if (!stretched)
        row->addStretch(1);
    return row;
}

} // namespace

PictureChoice::PictureChoice(const LiveCameras &live, const QString &fileName, QWidget *parent)
    : QWidget(parent), m_fromRecording(new QRadioButton(tr("The camera's &newest recording"))),
      m_fromLive(new QRadioButton(tr("The current image of a &connected camera"))),
      m_fromFile(new QRadioButton(tr("An image or a &video"))), m_live(new LiveCameraBox(live)),
      m_file(new PathField(fileName, tr("Images and videos (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.mp4 "
                                        "*.mkv *.avi *.mov *.webm);;All files (*)")))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_fromRecording);
    layout->addWidget(m_fromLive);
    layout->addLayout(indented(m_live, false));
    layout->addWidget(m_fromFile);
    layout->addLayout(indented(m_file, true));
    setFocusProxy(m_fromRecording);
    m_fromFile->setChecked(true);
    for (QRadioButton *choice : {m_fromRecording, m_fromLive, m_fromFile})
        connect(choice, &QRadioButton::toggled, this, &PictureChoice::updateChoices);
    connect(m_live, &QComboBox::currentIndexChanged, this, &PictureChoice::updateChoices);
    connect(m_file, &PathField::changed, this, &PictureChoice::changed);
    updateChoices();
}

void PictureChoice::setRecording(const std::optional<std::filesystem::path> &file)
{
    m_recording = file;
    if (m_recording && m_fromFile->isChecked() && m_file->path().empty())
        m_fromRecording->setChecked(true);
    updateChoices();
}

void PictureChoice::updateChoices()
{
    m_fromRecording->setEnabled(m_recording.has_value());
    m_fromLive->setEnabled(!m_live->uri().isEmpty() || m_fromLive->isChecked());
    if (!m_recording && m_fromRecording->isChecked())
        m_fromFile->setChecked(true);
    m_live->setEnabled(m_fromLive->isChecked());
    m_file->setEnabled(m_fromFile->isChecked());
    Q_EMIT changed();
}

PictureOrigin PictureChoice::origin() const
{
    if (m_fromLive->isChecked())
        return {{}, m_live->uri()};
    if (m_fromFile->isChecked())
        return {textOf(m_file->path()), {}};
    return {m_recording ? textOf(*m_recording) : QString(), {}};
}

void PictureChoice::setFile(const QString &file)
{
    m_fromFile->setChecked(true);
    m_file->setPath(file);
}

bool PictureChoice::isComplete() const
{
    const PictureOrigin from = origin();
    return !from.file.isEmpty() || !from.liveUri.isEmpty();
}

} // namespace odo
