// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/floor_wizard.h"

#include "core/base/units.h"
#include "core/calibration/intrinsics_influence.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/marker_canvas.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

enum Page { SourcePage, MarkersPage };

std::optional<Intrinsics> intrinsicsOf(const std::vector<FloorCamera> &cameras, const QString &name)
{
    const auto found = std::ranges::find(cameras, name, &FloorCamera::name);
    if (found == cameras.end() || !found->intrinsics)
        return std::nullopt;
    return found->intrinsics->calibration.intrinsics;
}

} // namespace

FloorWizard::FloorWizard(std::vector<FloorCamera> cameras, const QString &current,
                         std::vector<LayoutRecord> layouts, const LiveCameras &live, KeepImage keep,
                         QWidget *parent)
    : StepDialog(tr("Register camera to the floor"), tr("&Save"), parent), m_cameras(std::move(cameras)),
      m_layouts(std::move(layouts)), m_source(new FloorSourcePage(m_cameras, current, m_layouts, live)),
      m_markers(new MarkerPage), m_keep(std::move(keep))
{
    addStep(tr("The camera and its markers"), m_source);
    addStep(tr("The markers in the image"), m_markers);
    resize(1120, 680);
    connect(m_source, &FloorSourcePage::completeChanged, this, &FloorWizard::updateButtons);
    connect(m_markers, &MarkerPage::completeChanged, this, &FloorWizard::updateButtons);
    connect(&m_task, &BackgroundTask::finished, this, &FloorWizard::showImage);
    turnTo(SourcePage);
}

FloorWizard::~FloorWizard() = default;

QString FloorWizard::camera() const
{
    return m_source->camera();
}

bool FloorWizard::isComplete(int step) const
{
    return step == SourcePage ? m_source->isComplete() && !m_task.isRunning()
                              : m_markers->registration().has_value() && !isSaving();
}

void FloorWizard::next()
{
    if (step() == MarkersPage)
        return saveAndAccept([keep = m_keep, name = camera(), frame = m_image->frame](const JobControl &) {
            return keep(name, frame);
        });
    turnTo(MarkersPage);
    beginMarkers();
}

void FloorWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void FloorWizard::showNotSaved(const Error &error)
{
    m_markers->showNotSaved(error);
}

void FloorWizard::beginMarkers()
{
    m_markers->wait(tr("Detecting the markers…"));
    m_image = std::make_shared<StillImage>();
    m_task.start([image = m_image, origin = m_source->origin(),
                  layout = m_layouts.at(std::size_t(m_source->layout())).layout,
                  intrinsics = intrinsicsOf(m_cameras, camera())](const JobControl &control) -> Result<void> {
        *image = ODO_TRY(takeStillImage(origin, layout, intrinsics, control));
        return {};
    });
}

void FloorWizard::showImage(const std::optional<Error> &error)
{
    if (step() == MarkersPage) {
        if (error)
            m_markers->showFailure(*error);
        else
            m_markers->begin(m_image, m_layouts.at(std::size_t(m_source->layout())).layout,
                             intrinsicsOf(m_cameras, camera()));
    }
    updateButtons();
}

RegistrationRecord FloorWizard::result() const
{
    RegistrationRecord record;
    record.layout = m_layouts.at(std::size_t(m_source->layout())).id;
    const auto found = std::ranges::find(m_cameras, camera(), &FloorCamera::name);
    if (found != m_cameras.end() && found->intrinsics)
        record.intrinsics = found->intrinsics->id;
    record.pixels = m_markers->pixels();
    record.registration = *m_markers->registration();
    record.assumedIntrinsics = record.registration.intrinsics;
    return record;
}

void FloorWizard::done(int result)
{
    m_task.cancel();
    StepDialog::done(result);
}

FloorSourcePage::FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                                 const std::vector<LayoutRecord> &layouts, const LiveCameras &live,
                                 QWidget *parent)
    : QWidget(parent), m_cameras(cameras), m_camera(new QComboBox), m_layout(new QComboBox),
      m_image(new ImageChoice(live, tr("Image or video of the markers"))), m_intrinsics(new QLabel),
      m_badge(new BadgeLabel({}))
{
    m_camera->setEditable(true); // a camera that was never calibrated may be new here
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    m_camera->setCurrentText(current);
    for (const LayoutRecord &layout : layouts)
        m_layout->addItem(QString::fromStdString(layout.layout.name));
    m_intrinsics->setObjectName(QStringLiteral("quiet"));
    m_intrinsics->setWordWrap(true);
    auto *intro = new QLabel(tr("Markers with known floor positions determine the camera position. Four are "
                                "enough; a fifth checks them. Do not move the camera afterwards."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    form->addRow(QString(), m_badge);
    form->addRow(QString(), m_intrinsics);
    form->addRow(tr("Marker &layout"), m_layout);
    auto *where = new QLabel(tr("Image of the markers"));
    where->setStyleSheet(QStringLiteral("font-weight: 600"));
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addWidget(where);
    layout->addWidget(m_image);
    layout->addStretch(1);
    connect(m_camera, &QComboBox::editTextChanged, this, &FloorSourcePage::showCamera);
    connect(m_image, &ImageChoice::changed, this, &FloorSourcePage::completeChanged);
    showCamera();
}

const FloorCamera *FloorSourcePage::known() const
{
    const auto found = std::ranges::find(m_cameras, camera(), &FloorCamera::name);
    return found == m_cameras.end() ? nullptr : &*found;
}

void FloorSourcePage::showCamera()
{
    const FloorCamera *camera = known();
    m_badge->setBadge(camera ? camera->badge : Badge());
    m_image->setRecording(camera ? camera->newestRecording : std::nullopt);
    m_intrinsics->setText(
        camera && camera->intrinsics
            ? tr("Its lens is calibrated.")
            : tr("Its lens is not calibrated. Odograph assumes no distortion and estimates the "
                 "focal length from the markers if they determine it."));
    Q_EMIT completeChanged();
}

QString FloorSourcePage::camera() const
{
    return m_camera->currentText().trimmed();
}
int FloorSourcePage::layout() const
{
    return m_layout->currentIndex();
}

ImageOrigin FloorSourcePage::origin() const
{
    return m_image->origin();
}
void FloorSourcePage::setFile(const QString &file)
{
    m_image->setFile(file);
}
bool FloorSourcePage::isComplete() const
{
    return !camera().isEmpty() && layout() >= 0 && m_image->isComplete();
}

namespace {

constexpr int sideWidth = 380;
struct MarkerColumn
{
    enum { Label, Place, Seen, Error, Count };
};

} // namespace

MarkerPage::MarkerPage(QWidget *parent)
    : QWidget(parent), m_canvas(new MarkerCanvas), m_table(new QTableWidget(0, MarkerColumn::Count)),
      m_verdict(new RegistrationVerdict), m_remove(new QAction(tr("&Remove"), this)),
      m_undo(new QAction(tr("&Undo"), this))
{
    m_remove->setShortcut(QKeySequence::Delete);
    m_undo->setShortcut(QKeySequence::Undo);
    addActions({m_remove, m_undo});
    connect(m_remove, &QAction::triggered, this, &MarkerPage::removeCurrent);
    connect(m_undo, &QAction::triggered, this, &MarkerPage::undo);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_canvas, 1);
    layout->addWidget(makeSide());
    connect(m_canvas, &MarkerCanvas::markerSet, this, &MarkerPage::position);
    connect(m_canvas, &MarkerCanvas::picked, this, [this](const QString &label) {
        for (int row = 0; row < m_table->rowCount(); ++row)
            if (m_table->item(row, MarkerColumn::Label)->text() == label)
                m_table->selectRow(row);
    });
    connect(m_table, &QTableWidget::currentCellChanged, this, [this] {
        m_canvas->setCurrent(currentLabel());
        m_remove->setEnabled(std::ranges::find(m_pixels, currentLabel().toStdString(), &MarkerPixel::label) !=
                             m_pixels.end());
    });
}

QWidget *MarkerPage::makeSide()
{
    m_table->setHorizontalHeaderLabels({tr("Marker"), tr("Position, mm"), tr("Seen as"), tr("Error")});
    m_table->setAccessibleName(tr("Markers"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setStretchLastSection(true);
    auto *content = new QWidget;
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->addWidget(m_table, 1);
    auto *buttons = new QHBoxLayout;
    buttons->setContentsMargins(10, 4, 10, 8);
    buttons->addWidget(actionButton(m_remove, m_remove->text()));
    buttons->addWidget(actionButton(m_undo, m_undo->text()));
    buttons->addStretch(1);
    contentLayout->addLayout(buttons);
    auto *markers = new Card(tr("Markers"));
    markers->setContent(content);
    auto *side = new QWidget;
    side->setFixedWidth(sideWidth);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(markers, 3);
    layout->addWidget(m_verdict, 2);
    return side;
}

void MarkerPage::wait(const QString &words)
{
    m_image.reset();
    m_pixels.clear();
    m_layout = {};
    m_canvas->setImage({}, {});
    m_canvas->setEmptyText(words);
    evaluate();
    m_verdict->showVerdict(words, {});
}

void MarkerPage::showFailure(const Error &error)
{
    wait(shownWords(error.why));
    m_verdict->showVerdict(shownWords(error.why), shownWords(error.advice));
}

void MarkerPage::showNotSaved(const Error &error)
{
    m_verdict->reportNotSaved(error);
}

void MarkerPage::begin(std::shared_ptr<const StillImage> image, const MarkerLayout &layout,
                       const std::optional<Intrinsics> &intrinsics)
{
    m_image = std::move(image);
    m_layout = layout;
    m_intrinsics = intrinsics;
    m_pixels = m_image->markers;
    m_kinds.clear();
    for (const MarkerPixel &marker : m_pixels)
        m_kinds.emplace_back(marker.label, tr("found"));
    m_before.clear();
    m_canvas->setImage(m_image->image, {m_image->frame.format.width, m_image->frame.format.height});
    evaluate();
    m_table->selectRow(0);
    m_canvas->setFocus();
}

QString MarkerPage::currentLabel() const
{
    const QTableWidgetItem *item =
        m_table->currentRow() < 0 ? nullptr : m_table->item(m_table->currentRow(), MarkerColumn::Label);
    return item ? item->text() : QString();
}

void MarkerPage::remember()
{
    m_before.push_back(m_pixels);
}

void MarkerPage::position(const QString &label, const Eigen::Vector2d &pixel, bool snap)
{
    remember();
    const SnappedMarker seen =
        snap ? snapToMarker(m_image->frame, pixel) : SnappedMarker{SnappedMarker::Kind::None, pixel, 0};
    const std::string name = label.toStdString();
    std::erase_if(m_pixels, [&](const MarkerPixel &marker) { return marker.label == name; });
    std::erase_if(m_kinds, [&](const auto &kind) { return kind.first == name; });
    m_pixels.push_back({name, seen.pixel});
    m_kinds.emplace_back(name, snappedWords(seen.kind));
    evaluate();
    // The next one that is nowhere yet, so that a person clicks them one after the other.
    for (int row = 0; snap && row < m_table->rowCount(); ++row) {
        const std::string next = m_table->item(row, MarkerColumn::Label)->text().toStdString();
        if (std::ranges::find(m_pixels, next, &MarkerPixel::label) == m_pixels.end()) {
            m_table->selectRow(row);
            break;
        }
    }
}

void MarkerPage::removeCurrent()
{
    const std::string name = currentLabel().toStdString();
    remember();
    std::erase_if(m_pixels, [&](const MarkerPixel &marker) { return marker.label == name; });
    evaluate();
}

void MarkerPage::undo()
{
    if (m_before.empty())
        return;
    m_pixels = std::move(m_before.back());
    m_before.pop_back();
    evaluate();
}

void MarkerPage::evaluate()
{
    m_registration.reset();
    std::optional<FloorView> view;
    if (m_image) {
        const CameraModel camera =
            cameraOf(m_intrinsics, m_image->frame.format.width, m_image->frame.format.height);
        const auto registered =
            registerFloor(m_layout, m_pixels, camera, m_intrinsics.has_value(), {true, {}});
        if (registered) {
            m_registration = *registered;
            view = floorViewOf(*registered, *CameraModel::create(registered->intrinsics), m_pixels);
            m_verdict->showVerdict(*registered);
        } else {
            m_verdict->showVerdict(
                shownWords(registered.error().why),
                m_pixels.size() < 4
                    ? tr("Select a marker in the table and click its position. The click snaps "
                         "to what is near it, to a tenth of a pixel.")
                    : shownWords(registered.error().advice));
        }
    }
    m_canvas->setMarkers(m_pixels);
    m_canvas->setFloor(view, m_layout);
    m_undo->setEnabled(!m_before.empty());
    showTable();
    Q_EMIT completeChanged();
}

void MarkerPage::showTable()
{
    const int row = m_table->currentRow();
    const QSignalBlocker quiet(m_table);
    m_table->setRowCount(int(m_layout.markers.size()));
    QLocale locale; // two numbers beside one another: 3,000, 0 could be read as three
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const Marker &marker = m_layout.markers[std::size_t(i)];
        const bool seen = std::ranges::find(m_pixels, marker.label, &MarkerPixel::label) != m_pixels.end();
        const auto kind =
            std::ranges::find(m_kinds, marker.label, [](const auto &each) { return each.first; });
        QString error;
        if (m_registration) {
            const auto found = std::ranges::find(m_registration->markers, marker.label, &MarkerError::label);
            if (found != m_registration->markers.end())
                error = tr("%1 mm").arg(locale.toString(toMillimetres(found->errorM), 'f', 1));
        }
        const QString texts[] = {
            QString::fromStdString(marker.label),
            tr("%1, %2").arg(locale.toString(toMillimetres(marker.pointInWorld.x()), 'f', 0),
                             locale.toString(toMillimetres(marker.pointInWorld.y()), 'f', 0)),
            !seen                   ? tr("not visible")
            : kind == m_kinds.end() ? tr("found")
                                    : kind->second,
            error};
        for (int column = 0; column < MarkerColumn::Count; ++column)
            m_table->setItem(i, column, new QTableWidgetItem(texts[column]));
    }
    for (int column = 0; column + 1 < MarkerColumn::Count; ++column) // the last takes what is left
        m_table->resizeColumnToContents(column);
    if (row >= 0 && row < m_table->rowCount())
        m_table->selectRow(row);
    m_canvas->setCurrent(currentLabel());
    m_remove->setEnabled(std::ranges::find(m_pixels, currentLabel().toStdString(), &MarkerPixel::label) !=
                         m_pixels.end());
}

RegistrationVerdict::RegistrationVerdict(QWidget *parent)
    : Card(tr("Camera position"), parent), m_verdict(new QLabel), m_advice(new QLabel)
{
    showAsVerdict(*m_verdict, *m_advice);
    m_verdict->setAccessibleName(tr("Verdict"));
    auto *said = new QWidget;
    auto *layout = new QVBoxLayout(said);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->addWidget(m_verdict);
    layout->addWidget(m_advice);
    layout->addStretch(1);
    setContent(said);
}

void RegistrationVerdict::showVerdict(const FloorRegistration &registration)
{
    const Eigen::Vector3d &at = registration.worldFromCamera.translation;
    const QLocale locale;
    showVerdict(shownWords(registration.verdict),
                tr("Camera position: x %1 m, y %2 m, %3 m above the floor.")
                    .arg(locale.toString(at.x(), 'f', 2), locale.toString(at.y(), 'f', 2),
                         locale.toString(at.z(), 'f', 2)));
}

void RegistrationVerdict::showVerdict(const QString &verdict, const QString &advice)
{
    m_verdict->setText(verdict);
    m_advice->setText(advice);
}

void RegistrationVerdict::reportNotSaved(const Error &error)
{
    m_advice->setText(tr("The registration was not stored. %1").arg(errorLine(error)));
}

} // namespace odo
