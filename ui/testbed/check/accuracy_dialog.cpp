// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/accuracy_dialog.h"

#include "core/base/units.h"
#include "core/calibration/accuracy_map.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/check/floor_sketch.h"
#include "ui/testbed/check/internal/planned_camera_form.h"
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

namespace odo {

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
                               const PlacementQuestion &question, QWidget *parent)
    : QDialog(parent), m_layout(layout), m_question(question), m_sketch(new FloorSketch),
      m_list(new QListWidget), m_form(new PlannedCameraForm), m_show(new QComboBox),
      m_robotHeight(new NumberBox), m_reach(new NumberBox),
      m_above(new QCheckBox(tr("may hang &over the floor"))), m_add(plainButton(tr("&Plan a camera"))),
      m_remove(plainButton(tr("&Remove"))), m_advise(plainButton(tr("&Advice"))),
      m_best(plainButton(tr("Find &best position"))), m_advice(new QLabel), m_summary(new QLabel),
      m_problem(new QLabel)
{
    setWindowTitle(tr("Expected accuracy"));
    for (const CheckCamera &camera : cameras)
        m_entries.push_back({camera.name, camera.view, camera.badge.text});
    for (QLabel *label : {m_summary, m_problem, m_advice})
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
    m_robotHeight->setValue(toMillimetres(question.robotHeightM));
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_add, &QPushButton::clicked, this, &AccuracyDialog::addPlanned);
    connect(m_remove, &QPushButton::clicked, this, &AccuracyDialog::removePlanned);
    connect(m_best, &QPushButton::clicked, this, &AccuracyDialog::findBestPosition);
    connect(m_advise, &QPushButton::clicked, this, &AccuracyDialog::askForAdvice);
    connect(&m_advising, &BackgroundTask::finished, this, &AccuracyDialog::showAdvice);
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        showChosen();
        recompute();
    });
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem *item) {
        tick(std::size_t(m_list->row(item)), item->checkState() == Qt::Checked);
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
    buttons->addWidget(m_advise);
    buttons->addStretch(1);
    m_advise->setToolTip(tr("Which registered camera to move: tries other positions within a metre of each"));
    m_advice->setAccessibleName(tr("Advice in words"));
    m_advice->setContentsMargins(12, 4, 12, 2);
    m_advice->hide();
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);
    layout->addWidget(m_advice);
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
        const bool isRegistered = std::holds_alternative<FloorView>(entry.camera) && !entry.movedFrom;
        auto *item = new QListWidgetItem(
            isRegistered ? tr("%1, registered %2").arg(entry.name, entry.remark) : entry.name, m_list);
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
    m_advise->setEnabled(!m_advising.isRunning() && !m_search.isRunning() &&
                         std::ranges::any_of(m_entries, [](const Entry &entry) {
                             return std::holds_alternative<FloorView>(entry.camera);
                         }));
    m_planCard->setEnabled(planned != nullptr && !m_search.isRunning() && !m_advising.isRunning());
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

/// Of a camera that is registered and its copies elsewhere only one counts.
void AccuracyDialog::tick(std::size_t row, bool isCounted)
{
    const auto itself = [this](std::size_t entry) { return m_entries[entry].movedFrom.value_or(entry); };
    for (std::size_t i = 0; isCounted && i < m_entries.size(); ++i)
        m_entries[i].isCounted &= itself(i) != itself(row);
    m_entries[row].isCounted = isCounted;
    showList();
}

void AccuracyDialog::askForAdvice()
{
    std::vector<AdvisedCamera> cameras;
    for (const Entry &entry : m_entries)
        if (const auto *view = std::get_if<FloorView>(&entry.camera); view && !entry.movedFrom)
            cameras.push_back({entry.name.toStdString(), *view});
    m_given = std::make_shared<PlacementAdvice>();
    m_question.robotHeightM = fromMillimetres(m_robotHeight->value());
    m_advising.start([given = m_given, cameras = std::move(cameras), layout = m_layout,
                      question = m_question](const JobControl &control) -> Result<void> {
        *given = ODO_TRY(placementAdvice(cameras, layout, question, control));
        return {};
    });
    m_advice->setText(tr("Trying other positions of the cameras…"));
    m_advice->show();
    showChosen();
}

void AccuracyDialog::showAdvice(const std::optional<Error> &error)
{
    QStringList sentences;
    if (error)
        sentences << errorLine(*error);
    for (const Entry &entry : m_entries)
        if (entry.movedFrom && entry.isCounted)
            m_entries[*entry.movedFrom].isCounted = true;
    std::erase_if(m_entries, [](const Entry &entry) { return entry.movedFrom.has_value(); });
    for (const Message &remark : m_given->remarks)
        sentences << shownWords(remark);
    for (const PlacementMove &move : m_given->moves) {
        sentences << shownWords(move.words);
        m_entries.push_back(
            {tr("%1, moved").arg(m_entries[move.camera].name), move.view, {}, move.camera, false});
    }
    if (!error && m_given->moves.empty())
        sentences << tr("Moving one camera lowers the largest error by less than a tenth.");
    m_advice->setText(sentences.join(QLatin1Char('\n')));
    showList();
}

void AccuracyDialog::done(int result)
{
    m_search.cancel();
    m_advising.cancel();
    QDialog::done(result);
}

} // namespace odo
