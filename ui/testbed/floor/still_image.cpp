// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/still_image.h"

#include "core/capture/camera_source.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "ui/models/shown_message.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/image_file_filter.h"

#include <QHBoxLayout>
#include <QRadioButton>
#include <QRegularExpression>
#include <QVBoxLayout>

namespace odo {

namespace {

constexpr int videoStep = 15, mostImages = 8;

Result<void> searchIn(const Frame &frame, const MarkerLayout &layout,
                      const std::optional<Intrinsics> &intrinsics, StillImage &best)
{
    if (intrinsics &&
        (intrinsics->widthPx != frame.format.width || intrinsics->heightPx != frame.format.height))
        return tl::unexpected(imageOfOtherSize(frame, *intrinsics));
    if (layout.markers.empty()) {
        best.frame = frame;
        return {};
    }
    MarkerSearch search;
    search.camera = cameraOf(intrinsics, frame.format.width, frame.format.height);
    search.intrinsicsKnown = intrinsics.has_value();
    const auto markers = findMarkers(frame, layout, search);
    const bool first = best.frame.format.width == 0;
    if (!first && (!markers || markers->size() <= best.markers.size()))
        return {};
    best.frame = frame;
    best.markers = markers.value_or(std::vector<MarkerPixel>());
    best.notFound = markers ? std::nullopt : std::optional<Error>(markers.error());
    return {};
}

Result<StillImage> fromCamera(const std::string &uri, const MarkerLayout &layout,
                              const std::optional<Intrinsics> &intrinsics, const JobControl &control)
{
    auto camera = ODO_TRY(openCamera(uri));
    const auto frame = ODO_TRY(settledFrame(*camera, control));
    StillImage image;
    ODO_TRY(searchIn(frame, layout, intrinsics, image));
    return image;
}

} // namespace

Error imageOfOtherSize(const Frame &image, const Intrinsics &calibrated)
{
    return {ErrorCode::InvalidInput, imageSubject(),
            ODO_TEXT("ui.lens_of_other_size", "its size is %1×%2, but the lens was calibrated at %3×%4")(
                image.format.width, image.format.height, calibrated.widthPx, calibrated.heightPx),
            ODO_TEXT("ui.take_at_that_resolution", "use that resolution, or calibrate the lens again")};
}

CameraModel cameraOf(const std::optional<Intrinsics> &intrinsics, int widthPx, int heightPx)
{
    if (intrinsics)
        if (auto camera = CameraModel::create(*intrinsics))
            return *camera;
    return CameraModel::assumed(widthPx, heightPx);
}

Result<StillImage> takeStillImage(const ImageOrigin &origin, const MarkerLayout &layout,
                                  const std::optional<Intrinsics> &intrinsics, const JobControl &control)
{
    Result<StillImage> image = StillImage();
    if (!origin.liveUri.isEmpty()) {
        image = fromCamera(origin.liveUri.toStdString(), layout, intrinsics, control);
    } else {
        int looked = 0;
        Result<void> problem;
        const auto visited = visitImages(
            pathOf(origin.file), videoStep,
            [&](const Frame &frame, const std::string &name) {
                control.report(double(looked) / mostImages, detectingMarkersIn(name));
                problem = searchIn(frame, layout, intrinsics, *image);
                return problem && image->markers.size() < layout.markers.size() && ++looked < mostImages &&
                       !control.isCancelled();
            },
            control.cancel);
        if (!problem)
            return tl::unexpected(problem.error());
        if (!visited && image->frame.format.width == 0)
            return tl::unexpected(visited.error());
    }
    if (control.isCancelled())
        return cancelled(imageSubject());
    if (image)
        image->image = toImage(toScreen(image->frame, image->frame.format.width, image->frame.format.height));
    return image;
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

ImageChoice::ImageChoice(const LiveCameras &live, const QString &fileName, QWidget *parent)
    : QWidget(parent), m_fromRecording(new QRadioButton(tr("The camera's ne&west recording"))),
      m_fromLive(new QRadioButton(tr("The current image of a &connected camera"))),
      m_fromFile(new QRadioButton(tr("An image or a &video"))), m_live(new LiveCameraBox(live)),
      m_file(new PathField(fileName, imageFileFilter()))
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
        connect(choice, &QRadioButton::toggled, this, &ImageChoice::updateChoices);
    connect(m_live, &QComboBox::currentIndexChanged, this, &ImageChoice::updateChoices);
    connect(m_file, &PathField::changed, this, &ImageChoice::changed);
    updateChoices();
}

void ImageChoice::removeKeys()
{
    static const QRegularExpression key(QStringLiteral("\\(&\\w\\)|&")); // some languages have it in brackets
    for (QRadioButton *choice : {m_fromRecording, m_fromLive, m_fromFile})
        choice->setText(choice->text().remove(key));
}

void ImageChoice::setRecording(const std::optional<std::filesystem::path> &file)
{
    m_recording = file;
    if (m_recording && m_fromFile->isChecked() && m_file->path().empty())
        m_fromRecording->setChecked(true);
    updateChoices();
}

void ImageChoice::updateChoices()
{
    m_fromRecording->setEnabled(m_recording.has_value());
    m_fromLive->setEnabled(!m_live->uri().isEmpty() || m_fromLive->isChecked());
    if (!m_recording && m_fromRecording->isChecked())
        m_fromFile->setChecked(true);
    m_live->setEnabled(m_fromLive->isChecked());
    m_file->setEnabled(m_fromFile->isChecked());
    Q_EMIT changed();
}

ImageOrigin ImageChoice::origin() const
{
    if (m_fromLive->isChecked())
        return {{}, m_live->uri()};
    if (m_fromFile->isChecked())
        return {textOf(m_file->path()), {}};
    return {m_recording ? textOf(*m_recording) : QString(), {}};
}

void ImageChoice::setFile(const QString &file)
{
    m_fromFile->setChecked(true);
    m_file->setPath(file);
}

bool ImageChoice::isComplete() const
{
    const ImageOrigin from = origin();
    return !from.file.isEmpty() || !from.liveUri.isEmpty();
}

} // namespace odo
