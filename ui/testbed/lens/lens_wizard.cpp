// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/lens_wizard.h"

#include "core/base/units.h"
#include "ui/testbed/lens/internal/board_images_page.h"
#include "ui/testbed/lens/internal/calibration_result_page.h"
#include "ui/testbed/targets/target_dialog.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/image_file_filter.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace odo {

namespace {

constexpr int fewestImages = 3;

} // namespace

LensWizard::LensWizard(const QStringList &cameras, const QString &current, const LiveCameras &live,
                       Callbacks callbacks, QWidget *parent)
    : StepDialog(tr("Calibrate camera"), tr("&Save"), parent), m_callbacks(std::move(callbacks)),
      m_source(new CalibrationSourcePage(cameras, current, live)), m_images(new BoardImagesPage(m_search)),
      m_result(new CalibrationResultPage)
{
    addStep(tr("The camera and the board"), m_source);
    addStep(tr("Images of the board"), m_images);
    addStep(tr("The lens"), m_result);
    resize(1120, 760);
    connect(m_source, &CalibrationSourcePage::completeChanged, this, &LensWizard::updateButtons);
    connect(m_result, &CalibrationResultPage::completeChanged, this, &LensWizard::updateButtons);
    connect(&m_search, &BoardSearch::changed, this, &LensWizard::updateButtons);
    connect(m_images, &BoardImagesPage::filesDropped, &m_search, &BoardSearch::addFiles);
    turnTo(Source);
}

LensWizard::~LensWizard() = default;

QString LensWizard::missing(int step) const
{
    switch (step) {
    case Source:
        return m_source->missing();
    case Images: {
        const int kept = int(m_search.state().kept.size());
        return kept >= fewestImages
                   ? QString()
                   : tr("At least %1 images that show the board are needed; so far there are %2.")
                         .arg(fewestImages)
                         .arg(kept);
    }
    default:
        return m_result->calibration() ? QString() : tr("There is no lens calibration to save yet.");
    }
}

bool LensWizard::isBusy(int step) const
{
    switch (step) {
    case Source:
        return false;
    case Images:
        return m_search.state().waiting > 0;
    default:
        return isSaving();
    }
}

QString LensWizard::unsaved() const
{
    const int kept = int(m_search.state().kept.size());
    return kept > 0 ? tr("%n image(s) of the board", nullptr, kept) : QString();
}

void LensWizard::beginImages()
{
    BoardSpec board;
    board.squareM = m_source->squareM();
    m_search.begin(board);
    m_images->begin(m_source->isLive());
    if (!m_source->isLive()) {
        m_search.addFiles(m_source->files());
        return;
    }
    m_search.watch([open = m_callbacks.open, uri = m_source->liveUri()] { return open(uri); });
}

void LensWizard::next()
{
    switch (step()) {
    case Source:
        turnTo(Images);
        beginImages();
        break;
    case Images:
        m_search.stop();
        m_result->begin(m_search.state());
        turnTo(Result_);
        break;
    default:
        save();
    }
}

void LensWizard::save()
{
    m_result->showSaving();
    saveAndAccept([lens = result(), keep = m_callbacks.keepImages](const JobControl &control) {
        return keep(lens, control);
    });
}

void LensWizard::back()
{
    if (step() == Result_) {
        m_result->cancel();
        turnTo(Images);
        return;
    }
    m_search.stop();
    turnTo(Source);
}

void LensWizard::showNotSaved(const Error &error)
{
    m_result->showNotSaved(error);
}

void LensWizard::done(int result)
{
    m_search.stop();
    m_result->cancel();
    StepDialog::done(result);
}

StoredIntrinsics LensWizard::result() const
{
    StoredIntrinsics lens{
        m_source->camera(), {}, m_result->calibration().value_or(IntrinsicCalibration()), {}};
    lens.board.squareM = m_source->squareM();
    for (const KeptImage &image : m_result->images()) {
        const BoardView &view = image.board.view;
        lens.board.pattern = view.pattern;
        lens.board.columns = view.columns;
        lens.board.rows = view.rows;
        lens.images.push_back({view.source, image.png});
    }
    return lens;
}

namespace {

constexpr double usualSquareMm = 25;
constexpr int indent = 24;

} // namespace

CalibrationSourcePage::CalibrationSourcePage(const QStringList &cameras, const QString &current,
                                             const LiveCameras &live, QWidget *parent)
    : QWidget(parent), m_camera(new QComboBox), m_live(new LiveCameraBox(live)), m_square(new NumberBox),
      m_fromLive(new QRadioButton(tr("&From the camera: hold up the board, Odograph takes the images"))),
      m_fromFiles(new QRadioButton(tr("From existing images or a &video"))), m_files(new QListWidget),
      m_fileBox(makeFiles())
{
    setAcceptDrops(true);
    m_camera->setEditable(true);
    m_camera->addItems(cameras);
    m_camera->setCurrentText(current);
    m_square->setRange(1, 1000);
    m_square->setDecimals(2);
    m_square->setSuffix(tr(" mm"));
    m_square->setValue(usualSquareMm);
    auto *print = plainButton(tr("Prin&t a board…"));
    connect(print, &QPushButton::clicked, this,
            [this] { TargetDialog(TargetKind::Checkerboard, {}, this).exec(); });
    auto *square = new QHBoxLayout;
    square->addWidget(m_square);
    square->addWidget(print);
    square->addStretch(1);
    auto *intro =
        new QLabel(tr("Show a flat calibration board from many sides to calibrate the lens. Odograph "
                      "recognises checkerboard and ChArUco boards of any size. Measure one square on the "
                      "paper: every later length depends on it. Do not refocus or zoom afterwards."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Camera"), m_camera);
    auto *squareLabel = new QLabel(tr("Side of a &square, measured"));
    squareLabel->setBuddy(m_square);
    form->addRow(squareLabel, square);
    auto *where = new QLabel(tr("Source of the board images"));
    where->setStyleSheet(QStringLiteral("font-weight: 600"));
    auto *liveRow = new QHBoxLayout;
    liveRow->setContentsMargins(indent, 0, 0, 0);
    liveRow->addWidget(m_live);
    liveRow->addStretch(1);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addWidget(where);
    layout->addWidget(m_fromLive);
    layout->addLayout(liveRow);
    layout->addWidget(m_fromFiles);
    layout->addWidget(m_fileBox, 1);
    m_fromFiles->setChecked(true);
    for (QRadioButton *choice : {m_fromLive, m_fromFiles})
        connect(choice, &QRadioButton::toggled, this, &CalibrationSourcePage::updateChoices);
    connect(m_live, &QComboBox::currentIndexChanged, this, &CalibrationSourcePage::updateChoices);
    connect(m_camera, &QComboBox::editTextChanged, this, &CalibrationSourcePage::completeChanged);
    updateChoices();
}

QWidget *CalibrationSourcePage::makeFiles()
{
    m_files->setAccessibleName(tr("Images and videos of the board"));
    m_files->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_files->setTextElideMode(Qt::ElideMiddle);
    auto *add = plainButton(tr("&Add…")), *remove = plainButton(tr("&Remove"));
    connect(add, &QPushButton::clicked, this, [this] {
        addFiles(
            QFileDialog::getOpenFileNames(this, tr("Images and videos of the board"), {}, imageFileFilter()));
    });
    connect(remove, &QPushButton::clicked, this, [this] {
        qDeleteAll(m_files->selectedItems());
        Q_EMIT completeChanged();
    });
    auto *hint = new QLabel(tr("You can also drop files here."));
    hint->setObjectName(QStringLiteral("quiet"));
    auto *buttons = new QVBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove);
    buttons->addStretch(1);
    auto *row = new QHBoxLayout;
    row->addWidget(m_files, 1);
    row->addLayout(buttons);
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(indent, 0, 0, 0);
    layout->addLayout(row, 1);
    layout->addWidget(hint);
    return box;
}

void CalibrationSourcePage::updateChoices()
{
    m_fromLive->setEnabled(!m_live->uri().isEmpty() || m_fromLive->isChecked());
    m_live->setEnabled(m_fromLive->isChecked());
    m_fileBox->setEnabled(m_fromFiles->isChecked());
    Q_EMIT completeChanged();
}

QString CalibrationSourcePage::camera() const
{
    return m_camera->currentText().trimmed();
}
double CalibrationSourcePage::squareM() const
{
    return fromMillimetres(m_square->value());
}
bool CalibrationSourcePage::isLive() const
{
    return m_fromLive->isChecked();
}
QString CalibrationSourcePage::liveUri() const
{
    return m_live->uri();
}

QStringList CalibrationSourcePage::files() const
{
    QStringList files;
    for (int i = 0; i < m_files->count(); ++i)
        files << m_files->item(i)->text();
    return files;
}

void CalibrationSourcePage::addFiles(const QStringList &files)
{
    for (const QString &file : files)
        if (m_files->findItems(file, Qt::MatchExactly).isEmpty())
            m_files->addItem(file);
    if (!files.isEmpty())
        m_fromFiles->setChecked(true);
    Q_EMIT completeChanged();
}

QString CalibrationSourcePage::missing() const
{
    if (camera().isEmpty())
        return tr("Name the camera, such as A.");
    if (isLive())
        return liveUri().isEmpty() ? tr("Connect a camera, or choose existing images.") : QString();
    return m_files->count() > 0 ? QString() : tr("Add images or a video of the board.");
}

void CalibrationSourcePage::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void CalibrationSourcePage::dropEvent(QDropEvent *event)
{
    addFiles(localFiles(*event->mimeData()));
}

} // namespace odo
