// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/length_wizard.h"

#include "core/base/units.h"
#include "core/calibration/world_axes.h"
#include "core/workflow/calibrate/fitted_intrinsics.h"
#include "core/workflow/trial_sources.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/marker_canvas.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

enum Page { SourcePage, EndsPage };

/// The camera for images of this size.
Result<CheckCamera> cameraForImage(CheckCamera camera, const Frame &image)
{
    const Intrinsics lens = camera.view.camera().intrinsics();
    const int widthPx = image.format.width, heightPx = image.format.height;
    if (lens.widthPx == widthPx && lens.heightPx == heightPx)
        return camera;
    auto view = ODO_TRY(floorViewAt(camera.registration, lens, widthPx, heightPx));
    if (!view)
        return tl::unexpected(imageOfOtherSize(image, lens));
    camera.view = std::move(*view);
    return camera;
}

/// Empty where the lens serves as it is.
QString convertedWords(const CheckCamera &registered, const CheckCamera &asSeen)
{
    const Intrinsics &lens = registered.view.camera().intrinsics(), &now = asSeen.view.camera().intrinsics();
    if (lens.widthPx == now.widthPx && lens.heightPx == now.heightPx)
        return {};
    return shownWords(intrinsicsConverted(lens, now.widthPx, now.heightPx));
}

} // namespace

LengthWizard::LengthWizard(std::vector<CheckCamera> cameras, const QString &current, const LiveCameras &live,
                           QWidget *parent)
    : StepDialog(tr("Check a known length"), tr("&Done"), parent), m_cameras(std::move(cameras)),
      m_camera(new QComboBox), m_badge(new BadgeLabel({})),
      m_choice(new ImageChoice(live, tr("Image or video of the length"))), m_page(new LengthPage)
{
    addStep(tr("The camera and its image"), makeSource(current));
    addStep(tr("Both ends of the length"), m_page);
    resize(1120, 680);
    connect(m_choice, &ImageChoice::changed, this, &LengthWizard::updateButtons);
    connect(m_camera, &QComboBox::currentIndexChanged, this, &LengthWizard::showCamera);
    connect(&m_task, &BackgroundTask::finished, this, [this](const std::optional<Error> &error) {
        if (step() == EndsPage && error)
            m_page->showFailure(*error);
        else if (step() == EndsPage)
            m_page->begin(m_image, *m_asSeen, convertedWords(camera(), *m_asSeen));
        updateButtons();
    });
    turnTo(SourcePage);
}

LengthWizard::~LengthWizard() = default;

QWidget *LengthWizard::makeSource(const QString &current)
{
    for (const CheckCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    m_camera->setCurrentIndex(std::max(0, m_camera->findText(current)));
    showCamera();
    auto *intro = new QLabel(tr("Put an object of known length on the floor, away from the markers, to check "
                                "the camera's stated uncertainty. This changes nothing."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    form->addRow(QString(), m_badge);
    auto *where = new QLabel(tr("Image of the length"));
    where->setStyleSheet(QStringLiteral("font-weight: 600"));
    auto *page = new QWidget;
    page->setFocusProxy(m_camera);
    auto *layout = new QVBoxLayout(page);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addWidget(where);
    layout->addWidget(m_choice);
    layout->addStretch(1);
    return page;
}

void LengthWizard::showCamera()
{
    m_choice->setRecording(camera().newestRecording);
    m_badge->setBadge(camera().badge);
}

const CheckCamera &LengthWizard::camera() const
{
    return m_cameras.at(std::size_t(m_camera->currentIndex()));
}

QString LengthWizard::missing(int step) const
{
    return step == EndsPage || m_choice->isComplete() ? QString() : tr("Choose an image or a video.");
}

bool LengthWizard::isBusy(int step) const
{
    return isSaving() || (step != EndsPage && m_task.isRunning());
}

void LengthWizard::next()
{
    if (step() == EndsPage)
        return accept();
    turnTo(EndsPage);
    takeFrame();
}

void LengthWizard::back()
{
    m_task.cancel();
    turnTo(SourcePage);
}

void LengthWizard::takeFrame()
{
    m_page->wait(tr("Loading the image…"));
    m_image = std::make_shared<StillImage>();
    m_asSeen = std::make_shared<CheckCamera>(camera());
    m_task.start([image = m_image, origin = m_choice->origin(),
                  asSeen = m_asSeen](const JobControl &control) -> Result<void> {
        *image = ODO_TRY(takeStillImage(origin, {}, std::nullopt, control));
        *asSeen = ODO_TRY(cameraForImage(*asSeen, image->frame));
        return {};
    });
}

void LengthWizard::done(int result)
{
    m_task.cancel();
    StepDialog::done(result);
}

namespace {

constexpr int lengthSideWidth = 380;
constexpr double byHandPx = 0.5; // of one coordinate of an end that was put by hand
struct LengthColumn
{
    enum { End, Seen, Place, Count };
};

QString afterSpace(const QString &sentence)
{
    return sentence.isEmpty() ? sentence : QLatin1Char(' ') + sentence;
}

QString labelOf(int end)
{
    return QString::number(end + 1);
}

/// In mm, without grouping: two numbers such as "3,666, 548" could be read as three. 0 has no sign.
QString tenths(double metres)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double rounded = std::round(10 * toMillimetres(metres)) / 10;
    return locale.toString(rounded == 0 ? 0.0 : rounded, 'f', 1);
}

} // namespace

LengthPage::LengthPage(QWidget *parent)
    : QWidget(parent), m_canvas(new MarkerCanvas), m_table(new QTableWidget(2, LengthColumn::Count)),
      m_givenLength(new NumberBox), m_height(new NumberBox), m_unit(new QComboBox),
      m_snap(new QCheckBox(tr("S&nap to what is near a click"))), m_length(new QLabel), m_words(new QLabel),
      m_badge(new BadgeLabel({}))
{
    m_canvas->setAccessibleName(tr("Image with both ends; arrow keys move the selected one, Space snaps it"));
    m_canvas->setJoined(true);
    showAsWords(*m_words);
    m_words->setAccessibleName(tr("Verdict"));
    m_length->setStyleSheet(QStringLiteral("font-size: 18pt; font-weight: 600"));
    m_length->setAccessibleName(tr("Measured length"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_canvas, 1);
    layout->addWidget(makeSide());
    setFocusProxy(m_canvas);
    connect(m_canvas, &MarkerCanvas::markerSet, this, &LengthPage::position);
    connect(m_canvas, &MarkerCanvas::picked, this,
            [this](const QString &label) { m_table->selectRow(label.toInt() - 1); });
    connect(m_table, &QTableWidget::currentCellChanged, this,
            [this] { m_canvas->setCurrent(labelOf(currentEnd())); });
    connect(m_unit, &QComboBox::currentIndexChanged, this, &LengthPage::evaluate);
    for (QDoubleSpinBox *number : {m_givenLength, m_height})
        connect(number, &QDoubleSpinBox::valueChanged, this, &LengthPage::evaluate);
}

QWidget *LengthPage::makeQuestions()
{
    m_givenLength->setRange(0, 1e6);
    m_givenLength->setDecimals(1);
    m_givenLength->setSpecialValueText(tr("not known"));
    m_givenLength->setAccessibleName(tr("True length"));
    for (const char *unit : {"mm", "cm", "m", "inch"})
        m_unit->addItem(QString::fromLatin1(unit), lengthFactorFrom(unit).value_or(1));
    m_unit->setAccessibleName(tr("Unit of the true length"));
    m_height->setRange(0, 5000);
    m_height->setDecimals(0);
    m_height->setSuffix(tr(" mm"));
    m_height->setSpecialValueText(tr("on the floor"));
    m_snap->setChecked(true);
    auto *told = new QHBoxLayout;
    told->addWidget(m_givenLength, 1);
    told->addWidget(m_unit);
    auto *givenLabel = new QLabel(tr("&True length"));
    givenLabel->setBuddy(m_givenLength);
    auto *content = new QWidget;
    auto *form = new QFormLayout(content);
    form->setContentsMargins(12, 8, 12, 10);
    form->addRow(givenLabel, told);
    form->addRow(tr("H&eight"), m_height);
    form->addRow(m_snap);
    return content;
}

QWidget *LengthPage::makeSide()
{
    m_table->setHorizontalHeaderLabels({tr("End"), tr("Seen as"), tr("On the floor, mm")});
    m_table->setAccessibleName(tr("Ends of the length"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setStretchLastSection(true);
    auto *ends = new Card(tr("Both ends"));
    ends->setContent(m_table);
    auto *questions = new Card(tr("What it is"));
    questions->setContent(makeQuestions());
    auto *said = new QWidget;
    auto *saidLayout = new QVBoxLayout(said);
    saidLayout->setContentsMargins(12, 10, 12, 10);
    saidLayout->addWidget(m_length);
    saidLayout->addWidget(m_badge);
    saidLayout->addWidget(m_words);
    saidLayout->addStretch(1);
    auto *result = new Card(tr("Measured"));
    result->setContent(said);
    auto *side = new QWidget;
    side->setFixedWidth(lengthSideWidth);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(ends, 2);
    layout->addWidget(questions);
    layout->addWidget(result, 3);
    return side;
}

void LengthPage::wait(const QString &words)
{
    m_image.reset();
    m_ends = {};
    m_canvas->setImage({}, {});
    m_canvas->setEmptyText(words);
    m_canvas->setFloor(std::nullopt, {});
    evaluate();
    m_words->setText(words);
}

void LengthPage::showFailure(const Error &error)
{
    wait(shownWords(error.why));
    m_words->setText(errorLine(error));
}

void LengthPage::begin(std::shared_ptr<const StillImage> image, const CheckCamera &camera,
                       const QString &converted)
{
    m_converted = converted;
    m_image = std::move(image);
    m_camera = camera;
    m_canvas->setImage(m_image->image, {m_image->frame.format.width, m_image->frame.format.height});
    m_canvas->setFloor(camera.view, camera.layout);
    m_table->selectRow(0);
    evaluate();
    m_canvas->setFocus();
}

int LengthPage::currentEnd() const
{
    return std::max(0, m_table->currentRow());
}

void LengthPage::position(const QString &label, const Eigen::Vector2d &pixel, bool snap)
{
    const int end = std::clamp(label.toInt() - 1, 0, 1);
    SnappedMarker seen{SnappedMarker::Kind::None, pixel, byHandPx};
    if (snap && m_snap->isChecked())
        seen = snapToMarker(m_image->frame, pixel);
    const bool snapped = seen.kind != SnappedMarker::Kind::None;
    m_ends[std::size_t(end)] = End{seen.pixel, snapped ? seen.sigmaPx : byHandPx, snappedWords(seen.kind)};
    evaluate();
    if (snap && !m_ends[std::size_t(1 - end)]) // so that a person clicks one after the other
        m_table->selectRow(1 - end);
}

std::optional<double> LengthPage::givenM() const
{
    if (m_givenLength->value() <= 0)
        return std::nullopt;
    return fromMillimetres(m_givenLength->value() * m_unit->currentData().toDouble());
}

void LengthPage::evaluate()
{
    m_check.reset();
    m_length->clear();
    m_length->hide();
    m_badge->setBadge({});
    showEnds();
    if (!m_image)
        return m_words->clear();
    if (!m_ends[0] || !m_ends[1])
        return m_words->setText(tr("Put an object of known length anywhere on the floor, such as a metre "
                                   "stick or two markers at a known distance, and click both ends. Keys: "
                                   "arrows move an end (Ctrl: fast, Shift: one pixel), Space snaps it.") +
                                afterSpace(m_converted));
    const std::string name = m_camera->name.toStdString();
    const SeenLength seen{&m_camera->view,   name, m_ends[0]->pixel, m_ends[1]->pixel, m_ends[0]->sigmaPx,
                          m_ends[1]->sigmaPx};
    const auto check = checkLength({&seen, 1}, givenM(), fromMillimetres(m_height->value()));
    if (!check)
        return m_words->setText(errorLine(check.error()));
    m_check = *check;
    QLocale locale; // as the sentence below it has it
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    m_length->show();
    m_length->setText(tr("%1 ± %2 mm")
                          .arg(locale.toString(toMillimetres(check->lengthM), 'f', 1),
                               locale.toString(toMillimetres(check->sigmaM), 'f', 1)));
    if (check->differenceM)
        m_badge->setBadge(check->agrees ? Badge{tr("within uncertainty"), BadgeState::Good}
                                        : Badge{tr("outside uncertainty"), BadgeState::Bad});
    m_words->setText(shownWords(check->words) +
                     (check->differenceM ? QString() : tr(" Enter its true length to check the result.")) +
                     afterSpace(m_converted));
}

void LengthPage::showEnds()
{
    const double heightM = fromMillimetres(m_height->value());
    std::vector<MarkerPixel> shown;
    for (int end = 0; end < 2; ++end) {
        const auto &put = m_ends[std::size_t(end)];
        QString position;
        if (put) {
            shown.push_back({labelOf(end).toStdString(), put->pixel});
            if (const auto at = m_camera->view.floorFromPixel(put->pixel, heightM))
                position = tr("%1, %2").arg(tenths(at->x()), tenths(at->y()));
            else
                position = tr("beyond the horizon");
        }
        const QString texts[] = {labelOf(end), put ? put->seenAs : tr("not set yet"), position};
        for (int column = 0; column < LengthColumn::Count; ++column)
            m_table->setItem(end, column, new QTableWidgetItem(texts[column]));
    }
    for (int column = 0; column + 1 < LengthColumn::Count; ++column) // the last takes what is left
        m_table->resizeColumnToContents(column);
    m_canvas->setMarkers(std::move(shown));
    m_canvas->setCurrent(labelOf(currentEnd()));
}

} // namespace odo
