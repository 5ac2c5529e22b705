// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/accuracy_dialog.h"

#include "core/base/units.h"
#include "core/calibration/accuracy_map.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/check/floor_sketch.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWidget>
#include <cmath>

class QComboBox;
class QDoubleSpinBox;

namespace odo {

/// A planned camera in numbers: position, height, aim point, field of view and image size.
class PlannedCameraForm : public QWidget
{
    Q_OBJECT
public:
    explicit PlannedCameraForm(QWidget *parent = nullptr);
    void setCamera(const PlannedCamera &camera);
    const PlannedCamera &camera() const { return m_camera; }

Q_SIGNALS:
    void edited(); ///< by a person

private:
    QDoubleSpinBox *makeNumber(const QString &name, double least, double most, double step,
                               const QString &unit);
    void read();

    PlannedCamera m_camera;
    QDoubleSpinBox *m_x, *m_y, *m_height, *m_aimX, *m_aimY, *m_direction, *m_angle;
    QComboBox *m_size;
};

namespace {

constexpr double farMm = 100'000;
const QSize sizes[] = {{640, 480}, {1280, 720}, {1920, 1080}, {3840, 2160}};

QHBoxLayout *beside(QWidget *one, QWidget *other)
{
    auto *row = new QHBoxLayout;
    row->addWidget(one, 1);
    row->addWidget(other, 1);
    return row;
}

} // namespace

PlannedCameraForm::PlannedCameraForm(QWidget *parent)
    : QWidget(parent), m_x(makeNumber(tr("Position x"), -farMm, farMm, 50, tr(" mm"))),
      m_y(makeNumber(tr("Position y"), -farMm, farMm, 50, tr(" mm"))),
      m_height(makeNumber(tr("Height of the camera"), 50, 20'000, 50, tr(" mm"))),
      m_aimX(makeNumber(tr("Looks at x"), -farMm, farMm, 50, tr(" mm"))),
      m_aimY(makeNumber(tr("Looks at y"), -farMm, farMm, 50, tr(" mm"))),
      m_direction(makeNumber(tr("Viewing direction"), -180, 180, 5, tr("°"))),
      m_angle(makeNumber(tr("Field of view"), 10, 150, 1, tr("°"))), m_size(new QComboBox)
{
    m_direction->setWrapping(true);
    m_direction->setToolTip(
        tr("0° is along X, 90° along Y; the point that the camera looks at turns with it"));
    m_angle->setToolTip(tr("Across the image width: a webcam has about 60° to 80°, a phone 65°"));
    for (const QSize &size : sizes)
        m_size->addItem(QStringLiteral("%1×%2").arg(size.width()).arg(size.height()), size);
    m_size->setAccessibleName(tr("Image size"));
    auto *form = new QFormLayout(this);
    form->setContentsMargins(12, 6, 12, 8);
    const auto row = [form](const QString &text, QWidget *first, auto *field) {
        auto *label = new QLabel(text);
        label->setBuddy(first);
        form->addRow(label, field);
    };
    row(tr("Po&sition x, y"), m_x, beside(m_x, m_y));
    row(tr("&Height"), m_height, m_height);
    row(tr("&Looks at x, y"), m_aimX, beside(m_aimX, m_aimY));
    row(tr("D&irection"), m_direction, m_direction);
    row(tr("&Field of view"), m_angle, beside(m_angle, m_size));
    connect(m_size, &QComboBox::currentIndexChanged, this, &PlannedCameraForm::read);
    setCamera({});
}

QDoubleSpinBox *PlannedCameraForm::makeNumber(const QString &name, double least, double most, double step,
                                              const QString &unit)
{
    auto *number = new NumberBox;
    number->setRange(least, most);
    number->setDecimals(0);
    number->setSingleStep(step);
    number->setSuffix(unit);
    number->setAccessibleName(name);
    number->setKeyboardTracking(false);
    connect(number, &QDoubleSpinBox::valueChanged, this, &PlannedCameraForm::read);
    return number;
}

void PlannedCameraForm::setCamera(const PlannedCamera &camera)
{
    m_camera = camera;
    const Eigen::Vector2d foot = camera.footM();
    double direction = camera.directionDegrees + 180; // from the camera, not to it
    direction -= 360 * std::round(direction / 360);
    const std::pair<QDoubleSpinBox *, double> values[] = {{m_x, toMillimetres(foot.x())},
                                                          {m_y, toMillimetres(foot.y())},
                                                          {m_height, toMillimetres(camera.heightM)},
                                                          {m_aimX, toMillimetres(camera.aimM.x())},
                                                          {m_aimY, toMillimetres(camera.aimM.y())},
                                                          {m_direction, direction},
                                                          {m_angle, camera.fieldOfViewDegrees}};
    for (const auto &[number, value] : values) {
        const QSignalBlocker quiet(number);
        number->setValue(value);
    }
    const QSignalBlocker quiet(m_size);
    m_size->setCurrentIndex(std::max(0, m_size->findData(QSize(camera.widthPx, camera.heightPx))));
}

void PlannedCameraForm::read()
{
    const Eigen::Vector2d foot = fromMillimetres(1) * Eigen::Vector2d(m_x->value(), m_y->value());
    m_camera.aimM = fromMillimetres(1) * Eigen::Vector2d(m_aimX->value(), m_aimY->value());
    if (sender() == m_direction) {
        const double angle = m_direction->value() * EIGEN_PI / 180;
        m_camera.aimM = foot + m_camera.distanceM * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    m_camera.moveCameraTo(foot);
    m_camera.heightM = fromMillimetres(m_height->value());
    m_camera.fieldOfViewDegrees = m_angle->value();
    const QSize size = m_size->currentData().toSize();
    m_camera.widthPx = size.width();
    m_camera.heightPx = size.height();
    setCamera(PlannedCamera(m_camera));
    Q_EMIT edited();
}

namespace {

constexpr int mapSideWidth = 400;
constexpr double nearestPlannedM = 1, farthestPlannedM = 6; // from the floor, to begin with
enum Show { Together, Alone };

/// The same, with its position as the sketch shows it.
SketchedCamera sketched(const QString &name, const MappedCamera &camera)
{
    if (const auto *planned = std::get_if<PlannedCamera>(&camera)) {
        const Eigen::Vector2d foot = planned->footM();
        return {name, {foot.x(), foot.y(), planned->heightM}, planned->aimM, true};
    }
    const FloorView &view = std::get<FloorView>(camera);
    const Intrinsics &intrinsics = view.camera().intrinsics();
    const Eigen::Vector3d position = view.cameraInWorld();
    const auto aim = view.floorFromPixel({intrinsics.widthPx / 2.0, intrinsics.heightPx / 2.0}, 0);
    return {name, position, aim.value_or(Eigen::Vector2d(position.head<2>())), false};
}

} // namespace

AccuracyDialog::AccuracyDialog(const MarkerLayout &layout, const std::vector<CheckCamera> &cameras,
                               double robotHeightM, QWidget *parent)
    : QDialog(parent), m_layout(layout), m_sketch(new FloorSketch), m_list(new QListWidget),
      m_form(new PlannedCameraForm), m_show(new QComboBox), m_robotHeight(new NumberBox),
      m_reach(new NumberBox), m_above(new QCheckBox(tr("may hang &over the floor"))),
      m_add(plainButton(tr("&Plan a camera"))), m_remove(plainButton(tr("&Remove"))),
      m_best(plainButton(tr("Find &best position"))), m_summary(new QLabel), m_problem(new QLabel)
{
    setWindowTitle(tr("Expected accuracy"));
    for (const CheckCamera &camera : cameras)
        m_entries.push_back({camera.name, camera.view, camera.badge.text});
    for (QLabel *label : {m_summary, m_problem})
        showAsWords(*label);
    m_summary->setStyleSheet(QStringLiteral("font-weight: 600"));
    m_summary->setAccessibleName(tr("Expected accuracy in words"));
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setAccessibleName(tr("Problems"));
    QPushButton *close = plainButton(tr("Close"));
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(close);
    auto *row = new QHBoxLayout;
    row->addWidget(m_sketch, 1);
    row->addWidget(makeSide());
    auto *layoutOfAll = new QVBoxLayout(this);
    layoutOfAll->addLayout(row, 1);
    layoutOfAll->addWidget(m_summary);
    layoutOfAll->addWidget(m_problem);
    layoutOfAll->addLayout(buttons);
    resize(1160, 740);
    m_robotHeight->setValue(toMillimetres(robotHeightM));
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_add, &QPushButton::clicked, this, &AccuracyDialog::addPlanned);
    connect(m_remove, &QPushButton::clicked, this, &AccuracyDialog::removePlanned);
    connect(m_best, &QPushButton::clicked, this, &AccuracyDialog::findBestPosition);
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        showChosen();
        recompute();
    });
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem *item) {
        m_entries[std::size_t(m_list->row(item))].isCounted = item->checkState() == Qt::Checked;
        recompute();
    });
    connect(m_form, &PlannedCameraForm::edited, this, [this] {
        if (PlannedCamera *planned = currentPlanned())
            *planned = m_form->camera();
        recompute();
    });
    connect(m_show, &QComboBox::currentIndexChanged, this, &AccuracyDialog::recompute);
    connect(m_robotHeight, &QDoubleSpinBox::valueChanged, this, &AccuracyDialog::recompute);
    connect(m_sketch, &FloorSketch::picked, m_list,
            [this](int camera) { m_list->setCurrentRow(int(counted().at(std::size_t(camera)))); });
    connect(m_sketch, &FloorSketch::cameraDragged, this,
            [this](int camera, const Eigen::Vector2d &position) { drag(camera, position, false); });
    connect(m_sketch, &FloorSketch::aimDragged, this,
            [this](int camera, const Eigen::Vector2d &position) { drag(camera, position, true); });
    connect(&m_maker, &AccuracyMaker::ready, this, &AccuracyDialog::showAccuracy);
    connect(&m_search, &BackgroundTask::finished, this, &AccuracyDialog::positionFound);
    showList();
    if (m_entries.empty())
        addPlanned();
}

AccuracyDialog::~AccuracyDialog() = default;

QWidget *AccuracyDialog::makeSide()
{
    auto *side = new QWidget;
    side->setFixedWidth(mapSideWidth);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(makeCameraCard(), 1);
    layout->addWidget(makePlanCard());
    return side;
}

QWidget *AccuracyDialog::makeCameraCard()
{
    m_list->setAccessibleName(tr("Cameras included"));
    m_show->addItems({tr("All ticked cameras (joint)"), tr("The chosen camera alone")});
    m_robotHeight->setRange(0, 3000);
    m_robotHeight->setDecimals(0);
    m_robotHeight->setSingleStep(10);
    m_robotHeight->setSuffix(tr(" mm"));
    auto *form = new QFormLayout;
    form->setContentsMargins(12, 4, 12, 8);
    form->addRow(tr("Sho&w"), m_show);
    form->addRow(tr("Height of the robo&t"), m_robotHeight);
    auto *buttons = new QHBoxLayout;
    buttons->setContentsMargins(12, 6, 12, 2);
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    buttons->addStretch(1);
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);
    layout->addLayout(form);
    auto *card = new Card(tr("Cameras"));
    card->setContent(content);
    return card;
}

QWidget *AccuracyDialog::makePlanCard()
{
    m_reach->setRange(0, 50);
    m_reach->setDecimals(1);
    m_reach->setSingleStep(0.5);
    m_reach->setSuffix(tr(" m"));
    m_reach->setValue(1.5);
    m_above->setToolTip(tr("On a ceiling, for example; a tripod would be in the robots' way"));
    m_best->setToolTip(tr("Moves the camera to where it, together with the other ticked cameras, minimises "
                          "the largest uncertainty on the floor"));
    auto *best = new QHBoxLayout;
    best->addWidget(m_best);
    best->addWidget(m_above);
    best->addStretch(1);
    auto *form = new QFormLayout;
    form->setContentsMargins(12, 0, 12, 10);
    form->addRow(tr("Margin beyond the &markers"), m_reach);
    form->addRow(best);
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_form);
    layout->addLayout(form);
    auto *card = new Card(tr("Planned camera"));
    card->setContent(content);
    m_planCard = card;
    return card;
}

int AccuracyDialog::currentRow() const
{
    return m_list->currentRow();
}

std::optional<PlannedCamera> AccuracyDialog::planned(int row) const
{
    const auto *planned = std::get_if<PlannedCamera>(&m_entries.at(std::size_t(row)).camera);
    return planned ? std::optional(*planned) : std::nullopt;
}

PlannedCamera *AccuracyDialog::currentPlanned()
{
    return currentRow() < 0 ? nullptr
                            : std::get_if<PlannedCamera>(&m_entries.at(std::size_t(currentRow())).camera);
}

void AccuracyDialog::showList()
{
    const int row = currentRow();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const Entry &entry : m_entries) {
        const bool isPlanned = std::holds_alternative<PlannedCamera>(entry.camera);
        auto *item = new QListWidgetItem(
            isPlanned ? entry.name : tr("%1, registered %2").arg(entry.name, entry.remark), m_list);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(entry.isCounted ? Qt::Checked : Qt::Unchecked);
    }
    m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    showChosen();
    recompute();
}

void AccuracyDialog::showChosen()
{
    const PlannedCamera *planned = currentPlanned();
    m_remove->setEnabled(planned != nullptr);
    m_planCard->setEnabled(planned != nullptr && !m_search.isRunning());
    if (planned)
        m_form->setCamera(*planned);
}

void AccuracyDialog::addPlanned()
{
    // Before the middle of the floor's lower edge, as a person would put the first one, as far away as it
    // must be.
    Eigen::AlignedBox2d floor;
    for (const Marker &marker : m_layout.markers)
        floor.extend(marker.pointInWorld);
    PlannedCamera camera;
    camera.aimM = floor.center();
    double awayM = nearestPlannedM;
    do {
        camera.moveCameraTo({floor.center().x(), floor.min().y() - awayM});
        awayM += 0.25;
    } while (!plannedView(camera, m_layout) && awayM < farthestPlannedM);
    m_entries.push_back({tr("Planned %1").arg(++m_plannedSoFar), camera, {}});
    showList();
    m_list->setCurrentRow(m_list->count() - 1);
}

void AccuracyDialog::removePlanned()
{
    if (!currentPlanned() || m_search.isRunning())
        return;
    m_entries.erase(m_entries.begin() + currentRow());
    showList();
}

std::vector<std::size_t> AccuracyDialog::counted() const
{
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        if (m_entries[i].isCounted || (m_show->currentIndex() == Alone && int(i) == currentRow()))
            rows.push_back(i);
    return rows;
}

void AccuracyDialog::recompute()
{
    AccuracyRequest request{m_layout, {}, std::nullopt, fromMillimetres(m_robotHeight->value())};
    std::vector<SketchedCamera> cameras;
    for (const std::size_t row : counted()) {
        if (m_show->currentIndex() == Alone && int(row) == currentRow())
            request.alone = request.cameras.size();
        request.cameras.push_back(m_entries[row].camera);
        cameras.push_back(sketched(m_entries[row].name, m_entries[row].camera));
    }
    m_sketch->setTestbed(m_layout, std::move(cameras));
    m_maker.make(std::move(request));
}

void AccuracyDialog::showAccuracy(const ExpectedAccuracy &accuracy)
{
    m_sketch->setAccuracy(accuracy.map);
    m_summary->setText(shownWords(accuracy.summary.words));
    QStringList problems;
    const auto rows = counted();
    for (std::size_t i = 0; i < accuracy.problems.size() && i < rows.size(); ++i)
        if (accuracy.problems[i])
            problems << tr("%1: %2; %3.")
                            .arg(m_entries[rows[i]].name, shownWords(accuracy.problems[i]->why),
                                 shownWords(accuracy.problems[i]->advice));
    m_problem->setText(problems.join(QLatin1Char('\n')));
    m_problem->setHidden(problems.isEmpty());
}

void AccuracyDialog::drag(int camera, const Eigen::Vector2d &position, bool aim)
{
    auto *planned = std::get_if<PlannedCamera>(&m_entries.at(counted().at(std::size_t(camera))).camera);
    if (!planned)
        return;
    const Eigen::Vector2d foot = aim ? planned->footM() : position;
    planned->aimM = aim ? position : planned->aimM;
    planned->moveCameraTo(foot);
    showChosen();
    recompute();
}

void AccuracyDialog::findBestPosition()
{
    const PlannedCamera *planned = currentPlanned();
    if (!planned)
        return;
    m_foundRow = currentRow();
    m_found = std::make_shared<PlannedCamera>();
    std::vector<FloorView> others;
    for (const std::size_t row : counted()) {
        if (int(row) == m_foundRow || (m_show->currentIndex() == Alone))
            continue;
        const auto *other = std::get_if<PlannedCamera>(&m_entries[row].camera);
        if (const auto view = other ? plannedView(*other, m_layout)
                                    : Result<FloorView>(std::get<FloorView>(m_entries[row].camera)))
            others.push_back(*view);
    }
    const CameraPositionSearch search{m_reach->value(), m_above->isChecked(),
                                      fromMillimetres(m_robotHeight->value())};
    m_search.start([found = m_found, like = *planned, layout = m_layout, others = std::move(others),
                    search](const JobControl &control) -> Result<void> {
        *found = ODO_TRY(bestCameraPosition(like, layout, others, search, control));
        return {};
    });
    m_summary->setText(tr("Searching for the best position…"));
    showChosen();
}

void AccuracyDialog::positionFound(const std::optional<Error> &error)
{
    if (error) {
        showChosen();
        m_summary->setText(errorLine(*error));
        return;
    }
    m_entries.at(std::size_t(m_foundRow)).camera = *m_found;
    showChosen();
    recompute();
}

void AccuracyDialog::done(int result)
{
    m_search.cancel();
    QDialog::done(result);
}

} // namespace odo

#include "accuracy_dialog.moc"
