// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/together/joint_dialogs.h"

#include "core/base/units.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double usualTapeMm = 2;

QTableWidget *makeTable(const QStringList &headers, const QString &name)
{
    auto *table = new QTableWidget(0, int(headers.size()));
    table->setHorizontalHeaderLabels(headers);
    table->setAccessibleName(name);
    showAsList(*table);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(int(headers.size()) - 1, QHeaderView::Stretch);
    return table;
}

void setRow(QTableWidget &table, int row, const QStringList &texts)
{
    for (int column = 0; column < texts.size(); ++column)
        table.setItem(row, column, new QTableWidgetItem(texts[column]));
}

QString millimetres(double metres)
{
    return QLocale().toString(toMillimetres(metres), 'f', 1);
}

} // namespace

JointDialog::JointDialog(const QString &layout, Prepare prepare, QWidget *parent)
    : QDialog(parent), m_prepare(std::move(prepare)), m_tape(new NumberBox),
      m_cameras(makeTable({tr("Camera"), tr("Uncertainty before"), tr("Uncertainty, joint"), tr("Moves by")},
                          tr("Cameras"))),
      m_markers(makeTable({tr("Marker"), tr("Cameras"), tr("Off by, mm"), tr("Verdict")}, tr("Markers"))),
      m_verdict(new QLabel), m_advice(new QLabel)
{
    setWindowTitle(tr("Register all cameras (joint)"));
    resize(980, 520);
    auto *intro = new QLabel(
        tr("This fits all cameras of layout %1 jointly to the markers they were registered with. Cameras "
           "that see the same markers then agree better, and wrongly measured markers show up.")
            .arg(breakable(layout)));
    intro->setWordWrap(true);
    intro->setTextFormat(Qt::PlainText);
    m_tape->setRange(0.1, 100);
    m_tape->setDecimals(1);
    m_tape->setValue(usualTapeMm);
    m_tape->setSuffix(tr(" mm"));
    m_tape->setAccessibleName(tr("Uncertainty of the tape measure"));
    auto *form = new QFormLayout;
    form->addRow(tr("Marker positions &measured to"), m_tape);
    showAsVerdict(*m_verdict, *m_advice);
    m_verdict->setAccessibleName(tr("Verdict"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    m_save = buttons->button(QDialogButtonBox::Save);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *page = new QVBoxLayout(this);
    page->addWidget(intro);
    page->addLayout(form);
    page->addWidget(makeTables(), 1);
    page->addWidget(m_verdict);
    page->addWidget(m_advice);
    page->addWidget(buttons);
    connect(m_tape, &QDoubleSpinBox::valueChanged, this, &JointDialog::fit);
    connect(&m_task, &BackgroundTask::finished, this, &JointDialog::show);
    fit();
}

JointDialog::~JointDialog() = default;

QWidget *JointDialog::makeTables()
{
    auto *both = new QWidget;
    auto *layout = new QHBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const auto &[title, table] :
         {std::pair(tr("Cameras"), m_cameras), std::pair(tr("Markers"), m_markers)}) {
        auto *card = new Card(title);
        card->setContent(table);
        layout->addWidget(card, 1);
    }
    return both;
}

void JointDialog::fit()
{
    m_save->setEnabled(false);
    m_fitAgain = m_task.isRunning();
    if (m_fitAgain)
        return;
    auto prepared = m_prepare(fromMillimetres(m_tape->value()));
    if (!prepared)
        return show(prepared.error());
    m_job = std::move(*prepared);
    m_verdict->setText(tr("Fitting the cameras jointly…"));
    m_advice->clear();
    m_task.start([job = m_job](const JobControl &control) { return job->run(control); });
}

void JointDialog::show(const std::optional<Error> &error)
{
    if (m_fitAgain)
        return fit();
    m_save->setEnabled(!error);
    if (error) {
        m_cameras->setRowCount(0);
        m_markers->setRowCount(0);
        m_verdict->setText(breakable(shownWords(error->why)));
        m_advice->setText(breakable(shownWords(error->advice)));
        return;
    }
    m_verdict->setText(breakable(shownWords(m_job->joint().verdict)));
    m_advice->setText(tr("The joint uncertainty assumes marker positions measured to %1 mm; registering a "
                         "single camera assumes them exact. Nothing changes until you save; trials keep the "
                         "registration they were analysed with.")
                          .arg(QLocale().toString(m_tape->value(), 'f', 1)));
    showCameras();
    showMarkers();
}

void JointDialog::showCameras()
{
    const auto &joint = m_job->joint();
    m_cameras->setRowCount(int(joint.registrations.size()));
    for (std::size_t i = 0; i < joint.registrations.size(); ++i) {
        const FloorRegistration &before = m_job->before()[i].registration, &after = joint.registrations[i];
        const double movedM = (after.worldFromCamera.translation - before.worldFromCamera.translation).norm();
        setRow(*m_cameras, int(i),
               {QString::fromStdString(m_job->cameras()[i]),
                tr("±%1 mm").arg(millimetres(before.floorSigmaM)),
                tr("±%1 mm").arg(millimetres(after.floorSigmaM)), tr("%1 mm").arg(millimetres(movedM))});
    }
}

void JointDialog::showMarkers()
{
    const auto &markers = m_job->joint().markers;
    m_markers->setRowCount(int(markers.size()));
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const JointMarker &marker = markers[i];
        setRow(*m_markers, int(i),
               {QString::fromStdString(marker.label), QLocale().toString(marker.cameras),
                tr("%1 ± %2").arg(millimetres(marker.offM.norm()),
                                  millimetres(std::sqrt(marker.covariance.trace()))),
                marker.isSuspicious ? tr("check its position") : tr("fits")});
    }
}

void JointDialog::done(int result)
{
    m_fitAgain = false;
    m_task.cancel();
    QDialog::done(result);
}

ReferenceCameraPage::ReferenceCameraPage(const std::vector<FloorCamera> &cameras, const QString &current,
                                         const std::vector<CheckCamera> &registered, const LiveCameras &live,
                                         QWidget *parent)
    : QWidget(parent), m_cameras(cameras), m_registered(registered), m_camera(new QComboBox),
      m_reference(new QComboBox),
      m_image(new ImageChoice(live, tr("Image or video of the camera to register"))),
      m_referenceImage(new ImageChoice(live, tr("Image or video of the registered camera")))
{
    for (ImageChoice *choice : {m_image, m_referenceImage})
        choice->removeKeys();
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    for (const CheckCamera &camera : m_registered)
        m_reference->addItem(camera.name);
    m_camera->setCurrentIndex(std::max(0, m_camera->findText(current)));
    if (m_reference->currentText() == m_camera->currentText() && m_reference->count() > 1)
        m_reference->setCurrentIndex(1);
    m_camera->setAccessibleName(tr("Camera to register"));
    m_reference->setAccessibleName(tr("Registered camera"));
    auto *intro =
        new QLabel(tr("Register a camera that sees no markers by floor points that a registered camera also "
                      "sees: corners of tiles, ends of tape, screws. Four are enough; six or more, spread "
                      "over the common area, are better. Do not move either camera afterwards."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera to register"), m_camera);
    form->addRow(tr("&Via camera"), m_reference);
    auto *images = new QHBoxLayout;
    for (const auto &[title, choice] : {std::pair(tr("Its image"), m_image),
                                        std::pair(tr("The registered camera's image"), m_referenceImage)}) {
        auto *box = new QGroupBox(title);
        auto *boxLayout = new QVBoxLayout(box);
        boxLayout->addWidget(choice);
        images->addWidget(box, 1);
    }
    setFocusProxy(m_camera);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addLayout(images);
    layout->addStretch(1);
    for (QComboBox *box : {m_camera, m_reference})
        connect(box, &QComboBox::currentIndexChanged, this, &ReferenceCameraPage::showCameras);
    for (ImageChoice *choice : {m_image, m_referenceImage})
        connect(choice, &ImageChoice::changed, this, &ReferenceCameraPage::completeChanged);
    showCameras();
}

const FloorCamera &ReferenceCameraPage::camera() const
{
    return m_cameras.at(std::size_t(m_camera->currentIndex()));
}
const CheckCamera &ReferenceCameraPage::reference() const
{
    return m_registered.at(std::size_t(m_reference->currentIndex()));
}

void ReferenceCameraPage::showCameras()
{
    m_image->setRecording(camera().newestRecording);
    m_referenceImage->setRecording(reference().newestRecording);
    Q_EMIT completeChanged();
}

QString ReferenceCameraPage::missing() const
{
    if (camera().name == reference().name)
        return tr("A camera cannot be registered via itself: choose two different ones.");
    return m_image->isComplete() && m_referenceImage->isComplete() ? QString()
                                                                   : tr("Choose an image for each camera.");
}

namespace {

enum Page { SourcePage, PointsPage };

} // namespace

RegisterViaCameraWizard::RegisterViaCameraWizard(const std::vector<FloorCamera> &cameras,
                                                 const QString &current,
                                                 const std::vector<CheckCamera> &registered,
                                                 const LiveCameras &live, KeepImage keep, QWidget *parent)
    : StepDialog(tr("Register via another camera"), tr("&Save"), parent),
      m_source(new ReferenceCameraPage(cameras, current, registered, live)), m_page(new SharedPointsPage),
      m_keep(std::move(keep))
{
    addStep(tr("Two cameras and their images"), m_source);
    addStep(tr("The same points in both images"), m_page);
    resize(1180, 760);
    connect(m_source, &ReferenceCameraPage::completeChanged, this, &RegisterViaCameraWizard::updateButtons);
    connect(m_page, &SharedPointsPage::completeChanged, this, &RegisterViaCameraWizard::updateButtons);
    connect(&m_task, &BackgroundTask::finished, this, [this](const std::optional<Error> &error) {
        if (step() == PointsPage && error)
            m_page->showFailure(*error);
        else if (step() == PointsPage)
            m_page->begin(m_images, m_source->camera(), m_source->reference());
        updateButtons();
    });
    turnTo(SourcePage);
}

RegisterViaCameraWizard::~RegisterViaCameraWizard() = default;

QString RegisterViaCameraWizard::missing(int step) const
{
    if (step == SourcePage)
        return m_source->missing();
    return m_page->registration() ? QString() : tr("There is no registration to save yet.");
}

bool RegisterViaCameraWizard::isBusy(int step) const
{
    return isSaving() || (step == SourcePage && m_task.isRunning());
}

QString RegisterViaCameraWizard::unsaved() const
{
    return step() != SourcePage && m_page->registration() ? tr("the registration") : QString();
}

void RegisterViaCameraWizard::next()
{
    if (step() == PointsPage)
        return saveAndAccept([keep = m_keep, name = camera(), frame = m_images->camera.frame](
                                 const JobControl &) { return keep(name, frame); });
    turnTo(PointsPage);
    takeFrames();
}

void RegisterViaCameraWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void RegisterViaCameraWizard::showNotSaved(const Error &error)
{
    m_page->showNotSaved(error);
}

void RegisterViaCameraWizard::takeFrames()
{
    m_page->wait(tr("Loading the images…"));
    m_images = std::make_shared<ImagePair>();
    const auto &intrinsics = m_source->camera().intrinsics;
    const std::optional<Intrinsics> lens =
        intrinsics ? std::optional(intrinsics->calibration.intrinsics) : std::nullopt;
    m_task.start([images = m_images, lens, origin = m_source->image().origin(),
                  referenceOrigin = m_source->referenceImage().origin(),
                  referenceIntrinsics = m_source->reference().view.camera().intrinsics(),
                  layout = m_source->reference().layout](const JobControl &control) -> Result<void> {
        auto taken = ODO_TRY(takeStillImage(origin, layout, lens, control));
        auto referenceTaken = ODO_TRY(takeStillImage(referenceOrigin, layout, referenceIntrinsics, control));
        *images = {std::move(taken), std::move(referenceTaken)};
        return {};
    });
}

void RegisterViaCameraWizard::done(int result)
{
    m_task.cancel();
    StepDialog::done(result);
}

} // namespace odo
