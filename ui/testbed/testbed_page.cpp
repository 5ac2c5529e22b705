// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/testbed_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/floor_readings.h"
#include "core/workflow/trial_sources.h"
#include "ui/models/camera_lists.h"
#include "ui/models/shown_message.h"
#include "ui/models/timeline.h"
#include "ui/testbed/check/expected_accuracy.h"
#include "ui/testbed/internal/floor_copy.h"
#include "ui/testbed/internal/known_cameras.h"
#include "ui/testbed/internal/testbed_tools.h"
#include "ui/views/image/camera_view.h"
#include "ui/views/image/floor_read_out.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/empty_state.h"
#include "ui/views/widgets/table_list.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>

namespace odo {
namespace {

constexpr int tableHeight = 100; // header and two cameras

QHBoxLayout *buttonRow(const QList<QAction *> &actions)
{
    auto *buttons = new QHBoxLayout;
    buttons->setContentsMargins(10, 4, 10, 4);
    buttons->setSpacing(8);
    for (QAction *action : actions)
        buttons->addWidget(actionButton(action, action->iconText()));
    buttons->addStretch(1);
    return buttons;
}

} // namespace

TestbedPage::TestbedPage(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_live(new LiveCameras(listCameras, this)),
      m_tools(new TestbedTools(project, *m_live, *this)), m_checks(new CheckTools(project, *m_live, *this)),
      m_timeline(new Timeline(this)), m_cameras(new CameraListModel(this)), m_table(new QTableView),
      m_layoutList(new QListWidget), m_view(new CameraView(*m_timeline)),
      m_readOut(new FloorReadOut(*m_view)), m_facts(new FactList), m_sketch(new FloorSketch),
      m_sketchCard(new Card(tr("From above"))), m_showAccuracy(new QCheckBox(tr("expected &accuracy"))),
      m_accuracy(new AccuracyMaker(this)),
      m_empty(new EmptyState(QStringLiteral("testbed"), tr("No cameras yet"),
                             tr("A testbed is a floor with markers and the cameras that watch it. Start with "
                                "the lens calibration of the first camera, or with the marker positions."))),
      m_stack(new QStackedWidget(this))
{
    setObjectName(QStringLiteral("page"));
    setFocusProxy(m_table);
    auto *left = new QSplitter(Qt::Vertical);
    left->addWidget(makeCameraCard());
    left->addWidget(makeLayoutCard());
    left->setSizes({640, 200});
    auto *right = new QSplitter(Qt::Vertical);
    m_sketchCard->setContent(m_sketch);
    m_sketchCard->addToHeader(m_showAccuracy);
    auto *tasks = new QPushButton(tr("Tas&ks…"));
    tasks->setToolTip(tr("Courses on this floor: gates, paths, limits, scoring"));
    m_sketchCard->addToHeader(tasks);
    connect(tasks, &QPushButton::clicked, this, &TestbedPage::tasksRequested);
    m_showAccuracy->setChecked(true);
    right->addWidget(m_view);
    right->addWidget(m_sketchCard);
    right->setSizes({520, 380});
    auto *splitter = new QSplitter;
    splitter->addWidget(left);
    splitter->addWidget(right);
    splitter->setSizes({420, 780});
    splitter->setStretchFactor(1, 1);
    for (QSplitter *each : {left, right, splitter}) {
        each->setHandleWidth(8);
        each->setChildrenCollapsible(false);
    }
    auto *content = new QWidget;
    auto *contentLayout = new QHBoxLayout(content);
    contentLayout->setContentsMargins(8, 8, 8, 8);
    contentLayout->addWidget(splitter);
    for (const TestbedTools::Tool tool :
         {TestbedTools::Calibrate, TestbedTools::NewLayout, TestbedTools::PrintTargets}) {
        QAction *action = m_tools->action(tool);
        QPushButton *button =
            m_empty->addButton(QStringLiteral("add"), action->text().remove(QLatin1Char('&')));
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
    }
    m_stack->addWidget(content);
    m_stack->addWidget(m_empty);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_stack);
    new FloorCopy(*m_view, *m_readOut);
    connect(m_view, &CameraView::settled, this, &TestbedPage::settled);
    connect(m_accuracy, &AccuracyMaker::ready, this, &TestbedPage::showAccuracy);
    connect(m_showAccuracy, &QCheckBox::toggled, this, &TestbedPage::showLayout);
    connect(m_checks, &CheckTools::registerRequested, m_tools, &TestbedTools::registerAgain);
    connect(m_checks, &CheckTools::changed, this, [this](const QString &words) {
        refresh();
        Q_EMIT changed(words, {});
    });
    connect(m_tools, &TestbedTools::failed, this, &TestbedPage::failed);
    connect(m_checks, &CheckTools::failed, this, &TestbedPage::failed);
    connect(m_tools, &TestbedTools::changed, this,
            [this](const QString &words, const std::vector<Message> &warnings) {
                refresh();
                Q_EMIT changed(words, warnings);
            });
}

TestbedPage::~TestbedPage() = default;

QWidget *TestbedPage::makeCameraCard()
{
    m_table->setModel(m_cameras);
    m_table->setAccessibleName(tr("Cameras"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setColumnHidden(CameraListModel::VerdictColumn, true);
    m_table->setItemDelegateForColumn(
        CameraListModel::RegistrationColumn,
        new BadgeDelegate(CameraListModel::BadgeTextRole, CameraListModel::BadgeStateRole, this));
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setMinimumHeight(tableHeight);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &TestbedPage::showCamera);

    auto *scroll = scrolled(m_facts, tr("Details of the camera"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_factCard = new Card(tr("Camera"));
    m_factCard->setContent(scroll);

    auto *content = new QWidget;
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->setSpacing(0);
    contentLayout->addWidget(m_table);
    // At most three side by side: a wider column would shrink the image.
    const QList<QAction *> rows[] = {
        {m_tools->action(TestbedTools::Calibrate), m_tools->action(TestbedTools::Register),
         m_checks->action(CheckTools::Moved)},
        {m_tools->action(TestbedTools::RegisterViaCamera), m_tools->action(TestbedTools::RegisterJointly),
         m_checks->action(CheckTools::Revisions)},
        {m_tools->action(TestbedTools::ImportCalibration), m_checks->action(CheckTools::Length),
         m_checks->action(CheckTools::Accuracy)}};
    for (const QList<QAction *> &row : rows)
        contentLayout->addLayout(buttonRow(row));
    auto *card = new Card(tr("Cameras"));
    card->setContent(content);

    auto *both = new QSplitter(Qt::Vertical);
    both->setHandleWidth(8);
    both->setChildrenCollapsible(false);
    both->addWidget(card);
    both->addWidget(m_factCard);
    both->setSizes({260, 380});
    return both;
}

QWidget *TestbedPage::makeLayoutCard()
{
    m_layoutList->setAccessibleName(tr("Marker layouts"));
    connect(m_layoutList, &QListWidget::currentRowChanged, this, &TestbedPage::showLayout);
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_layoutList, 1);
    layout->addLayout(
        buttonRow({m_tools->action(TestbedTools::NewLayout), m_tools->action(TestbedTools::ImportLayout),
                   m_tools->action(TestbedTools::PrintTargets)}));
    auto *card = new Card(tr("Marker layouts"));
    card->setContent(content);
    return card;
}

void TestbedPage::refresh()
{
    const QString camera = currentCamera();
    const int layoutRow = std::max(0, m_layoutList->currentRow());
    Result<std::vector<CameraRow>> cameras = loadCameraRows(m_project);
    Result<std::vector<LayoutRecord>> layouts = m_project.layouts().all();
    if (!cameras || !layouts) {
        Q_EMIT failed(cameras ? layouts.error() : cameras.error());
        return;
    }
    m_cameras->setRows(std::move(*cameras));
    m_table->resizeColumnsToContents();
    m_layouts = std::move(*layouts);
    const QSignalBlocker quiet(m_layoutList);
    m_layoutList->clear();
    for (const LayoutRecord &record : m_layouts) {
        QStringList labels;
        for (const Marker &marker : record.layout.markers)
            labels << QString::fromStdString(marker.label);
        m_layoutList->addItem(QStringLiteral("%1: %2").arg(QString::fromStdString(record.layout.name),
                                                           labels.join(QStringLiteral(", "))));
    }
    m_layoutList->setCurrentRow(std::min(layoutRow, m_layoutList->count() - 1));
    m_stack->setCurrentIndex(m_cameras->rowCount() == 0 && m_layouts.empty() ? 1 : 0);
    const int row = std::max(0, static_cast<int>(cameraNames().indexOf(camera)));
    if (m_cameras->rowCount() > 0)
        m_table->setCurrentIndex(m_cameras->index(row, 0)); // shows it
    else
        showCamera();
    showLayout();
}

QStringList TestbedPage::cameraNames() const
{
    QStringList names;
    for (int row = 0; row < m_cameras->rowCount(); ++row)
        names << QString::fromStdString(m_cameras->row(row).camera.name);
    return names;
}

QString TestbedPage::currentCamera() const
{
    return m_table->currentIndex().data(CameraListModel::NameRole).toString();
}

void TestbedPage::calibrate(const QStringList &stills)
{
    m_tools->calibrateBy(stills);
}

QList<QAction *> TestbedPage::toolActions() const
{
    return m_tools->actions() + m_checks->actions();
}

void TestbedPage::updateTools()
{
    const int row = m_layoutList->currentRow();
    const auto layout = row < 0 ? std::nullopt : std::optional(m_layouts.at(static_cast<std::size_t>(row)));
    m_tools->setCurrent(currentCamera(), layout);
    bool isRegistered = false;
    for (int i = 0; i < m_cameras->rowCount(); ++i)
        isRegistered = isRegistered || m_cameras->row(i).registration.has_value();
    m_checks->setCurrent(currentCamera(), layout, isRegistered);
}

void TestbedPage::showCamera()
{
    updateTools();
    const QModelIndex current = m_table->currentIndex();
    if (!current.isValid()) {
        m_view->setScene(nullptr, 0);
        m_view->setTitle(tr("Image"));
        m_readOut->setReading({});
        m_facts->setFacts({});
        return;
    }
    const CameraRow &camera = m_cameras->row(current.row());
    m_factCard->setTitle(tr("Camera %1").arg(QString::fromStdString(camera.camera.name)));
    m_facts->setFacts(cameraFacts(camera));
    const Result<TrialScenePtr> scene = newestImage(m_project, camera);
    if (!scene)
        Q_EMIT failed(scene.error());
    m_view->setScene(scene.value_or(nullptr), 0);
    const auto reading =
        camera.registration ? floorReadingOf(m_project, *camera.registration) : tl::unexpected(Error());
    PixelOnFloor onFloor;
    if (reading)
        onFloor = [read = *reading](const QPointF &pixel) { return read.at({pixel.x(), pixel.y()}); };
    m_readOut->setReading(std::move(onFloor));
    m_view->setBadge(cameraBadge(camera.registration)); // as it is now
    if (scene && *scene)
        m_timeline->setFrameTimes((*scene)->frameTimes());
}

void TestbedPage::showLayout()
{
    updateTools();
    const int row = m_layoutList->currentRow();
    if (row < 0) {
        m_sketch->setTestbed(std::nullopt, {});
        m_sketch->setAccuracy(std::nullopt);
        m_sketchCard->setRemark({});
        return;
    }
    const LayoutRecord &record = m_layouts.at(static_cast<std::size_t>(row));
    std::vector<CameraRow> cameras;
    for (int i = 0; i < m_cameras->rowCount(); ++i)
        cameras.push_back(m_cameras->row(i));
    Result<std::vector<SketchedCamera>> sketched = sketchedCameras(m_project, cameras, record.id);
    if (!sketched)
        Q_EMIT failed(sketched.error());
    m_sketch->setTestbed(record.layout, sketched.value_or(std::vector<SketchedCamera>()));
    AccuracyRequest request{record.layout, {}, std::nullopt, 0};
    for (const CameraRow &camera : cameras) {
        if (!camera.registration || camera.registration->layout != record.id)
            continue;
        if (const auto view = floorViewOf(m_project, *camera.registration))
            request.cameras.emplace_back(*view);
    }
    m_accuracy->make(std::move(request));
}

void TestbedPage::showAccuracy(const ExpectedAccuracy &accuracy)
{
    const bool isShown =
        m_showAccuracy->isChecked() && m_layoutList->currentRow() >= 0 && accuracy.summary.seenPart > 0;
    m_sketch->setAccuracy(isShown ? std::optional(accuracy.map) : std::nullopt);
    m_sketchCard->setRemark(isShown ? shownWords(accuracy.summary.words) : QString());
    if (isSettled())
        Q_EMIT settled();
}

bool TestbedPage::isSettled() const
{
    return m_stack->currentIndex() == 1 || (m_view->isSettled() && !m_accuracy->isRunning());
}

} // namespace odo
