// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/internal/task_editor.h"

#include "core/analysis/task_templates.h"
#include "core/base/units.h"
#include "core/exchange/task_file.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/tasks/internal/part_tables.h"
#include "ui/testbed/tasks/internal/scoring_table.h"
#include "ui/testbed/tasks/internal/task_canvas.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTabWidget>
#include <numbers>

namespace odo {

namespace {

enum Tab { CourseTab, ZonesTab };
constexpr int columnWidth = 480;

/// 0 stands for none.
QDoubleSpinBox *limitBox(const QString &unit, double most, std::optional<double> limit)
{
    auto *box = new NumberBox;
    box->setRange(0, most);
    box->setDecimals(2);
    box->setSingleStep(0.5);
    box->setSuffix(unit);
    box->setSpecialValueText(TaskEditor::tr("none"));
    box->setValue(limit.value_or(0));
    return box;
}

std::optional<double> limitOf(const QDoubleSpinBox &box)
{
    return box.value() > 0 ? std::optional(box.value()) : std::nullopt;
}

/// Where a task begins: in the middle of the markers.
Eigen::Vector2d middleOf(const std::optional<MarkerLayout> &layout)
{
    Eigen::AlignedBox2d box;
    if (layout)
        for (const Marker &marker : layout->markers)
            box.extend(marker.pointInWorld);
    return box.isEmpty() ? TemplateSizes().centre : Eigen::Vector2d(box.center());
}

} // namespace

TaskEditor::TaskEditor(TaskDraft draft, QWidget *parent)
    : QDialog(parent), m_taken(draft.taken), m_task(std::move(draft.task)),
      m_name(new QLineEdit(QString::fromStdString(m_task.name))), m_template(new TemplateForm),
      m_gates(new GateTable), m_speed(limitBox(tr(" m/s"), 100, m_task.task.limits.maxSpeedMps)),
      m_accel(limitBox(tr(" m/s²"), 1000, m_task.task.limits.maxAccelMps2)),
      m_zones(new ZoneTable(middleOf(draft.layout))), m_scoring(new ScoringTable(draft.metrics)),
      m_canvas(new TaskCanvas), m_tabs(new QTabWidget), m_message(new QLabel),
      m_save(plainButton(tr("&Save")))
{
    setWindowTitle(tr("Task"));
    m_canvas->setLayout(draft.layout);
    m_template->setTemplate(m_task.task.kind, suggestedSizes(m_task.task, middleOf(draft.layout)));
    m_scoring->setCriteria(draft.scoring);
    m_tabs->insertTab(CourseTab, makeCourse(), tr("&Course"));
    m_tabs->insertTab(ZonesTab, m_zones, tr("&Zones"));
    m_tabs->addTab(m_scoring, tr("Sco&ring"));
    m_tabs->setFixedWidth(columnWidth);
    auto *row = new QHBoxLayout;
    row->addWidget(m_tabs);
    row->addWidget(m_canvas, 1);
    auto *remark = new QLabel(draft.remark);
    remark->setTextFormat(Qt::PlainText);
    remark->setWordWrap(true);
    remark->setVisible(!draft.remark.isEmpty());
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(row, 1);
    layout->addWidget(remark);
    layout->addLayout(makeButtons());
    resize(QSize(1040, 660).boundedTo(screen()->availableSize() * 0.95));
    connectAll();
    if (m_task.id == 0 && m_task.task.gates.empty() && m_task.task.path.points.empty())
        recreate();
    m_gates->setGates(m_task.task.gates);
    m_zones->setZones(m_task.task.zones);
    m_canvas->setTask(m_task.task);
    m_canvas->setCurrentGate(0);
    m_gates->setCurrent(0);
    m_name->selectAll();
    check();
}

QLayout *TaskEditor::makeButtons()
{
    m_message->setTextFormat(Qt::PlainText);
    m_message->setWordWrap(true);
    m_message->setObjectName(QStringLiteral("problem"));
    m_message->setAccessibleName(tr("Problems"));
    auto *import = plainButton(tr("Import &file…")), *cancel = plainButton(tr("Cancel"));
    import->setToolTip(tr("Import gates, path, limits and zones from a task file (JSON)"));
    m_save->setProperty("primary", true);
    m_save->setDefault(true);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(import);
    buttons->addWidget(m_message, 1);
    buttons->addWidget(m_save);
    buttons->addWidget(cancel);
    connect(import, &QPushButton::clicked, this, &TaskEditor::importFile);
    connect(m_save, &QPushButton::clicked, this, &QDialog::accept);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    return buttons;
}

void TaskEditor::connectAll()
{
    connect(m_name, &QLineEdit::textChanged, this, &TaskEditor::check);
    connect(m_template, &TemplateForm::changed, this, &TaskEditor::recreate);
    connect(m_gates, &GateTable::changed, this, &TaskEditor::takeGates);
    connect(m_gates, &GateTable::currentChanged, m_canvas, &TaskCanvas::setCurrentGate);
    connect(m_canvas, &TaskCanvas::gateMoved, this, &TaskEditor::moveGate);
    connect(m_canvas, &TaskCanvas::gatePicked, this, [this](int gate) {
        m_gates->setCurrent(gate);
        m_tabs->setCurrentIndex(CourseTab);
    });
    connect(m_zones, &ZoneTable::changed, this, &TaskEditor::takeZones);
    connect(m_zones, &ZoneTable::currentChanged, m_canvas, &TaskCanvas::setCurrentZone);
    connect(m_canvas, &TaskCanvas::zoneMoved, this, &TaskEditor::moveZone);
    connect(m_canvas, &TaskCanvas::zonePicked, this, [this](int zone) {
        m_zones->setCurrent(zone);
        m_tabs->setCurrentIndex(ZonesTab);
    });
    for (QDoubleSpinBox *limit : {m_speed, m_accel})
        connect(limit, &QDoubleSpinBox::valueChanged, this, &TaskEditor::takeLimits);
    connect(m_scoring, &ScoringTable::changed, this, &TaskEditor::check);
}

QWidget *TaskEditor::makeCourse()
{
    auto *course = new QWidget;
    auto *name = new QFormLayout;
    name->addRow(tr("&Name"), m_name);
    auto *limits = new QFormLayout;
    limits->addRow(tr("Speed limi&t"), m_speed);
    limits->addRow(tr("Acceleration l&imit"), m_accel);
    m_speed->setToolTip(tr("No robot in the task can exceed it: a measurement beyond it is a spike"));
    m_accel->setToolTip(m_speed->toolTip());
    auto *layout = new QVBoxLayout(course);
    layout->addLayout(name);
    layout->addWidget(m_template);
    layout->addWidget(m_gates, 1);
    layout->addLayout(limits);
    return course;
}

void TaskEditor::recreate()
{
    const TaskLimits limits = m_task.task.limits;
    const std::vector<Zone> zones = m_task.task.zones;
    const auto made = taskFromTemplate(m_template->kind(), m_template->sizes());
    m_templateProblem = made ? QString() : errorLine(made.error());
    if (made) {
        m_task.task = *made;
        m_task.task.limits = limits;
        m_task.task.zones = zones;
        m_gates->setGates(m_task.task.gates);
        m_canvas->setTask(m_task.task);
    }
    check();
}

void TaskEditor::takeGates()
{
    m_task.task.gates = m_gates->gates();
    m_canvas->setTask(m_task.task);
    check();
}

void TaskEditor::moveGate(int gate, const Eigen::Vector2d &from, const Eigen::Vector2d &to)
{
    Gate &moved = m_task.task.gates[static_cast<std::size_t>(gate)];
    moved.from = from;
    moved.to = to;
    m_gates->setGates(m_task.task.gates);
    m_canvas->setTask(m_task.task);
    check();
}

void TaskEditor::takeZones()
{
    m_task.task.zones = m_zones->zones();
    m_canvas->setTask(m_task.task);
    check();
}

void TaskEditor::moveZone(int zone, const std::vector<Eigen::Vector2d> &corners)
{
    m_task.task.zones[static_cast<std::size_t>(zone)].corners = corners;
    m_zones->setZones(m_task.task.zones);
    m_canvas->setTask(m_task.task);
    check();
}

void TaskEditor::takeLimits()
{
    m_task.task.limits = {limitOf(*m_speed), limitOf(*m_accel)};
    check();
}

void TaskEditor::importFile()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Task file"), {},
                                                      tr("Tasks (*.json *.yaml *.yml);;All files (*)"));
    if (file.isEmpty())
        return;
    const auto read = readTaskFile(pathOf(file));
    if (!read) {
        m_message->setText(errorLine(read.error()));
        return;
    }
    m_task.task = *read;
    m_template->setTemplate(read->kind, suggestedSizes(*read, TemplateSizes().centre));
    m_gates->setGates(read->gates);
    m_zones->setZones(read->zones);
    m_canvas->setTask(*read);
    m_speed->setValue(read->limits.maxSpeedMps.value_or(0));
    m_accel->setValue(read->limits.maxAccelMps2.value_or(0));
    check();
}

TaskRecord TaskEditor::task() const
{
    TaskRecord task = m_task;
    task.name = m_name->text().trimmed().toStdString();
    return task;
}

std::vector<Criterion> TaskEditor::scoring() const
{
    return m_scoring->criteria();
}

QString TaskEditor::problem() const
{
    if (m_name->text().trimmed().isEmpty())
        return tr("The task has no name.");
    if (m_taken.contains(m_name->text().trimmed()))
        return tr("A task with this name exists. Enter another name.");
    if (!m_templateProblem.isEmpty())
        return m_templateProblem;
    for (const Gate &gate : m_task.task.gates)
        if (gate.name.empty())
            return tr("A gate has no name.");
    for (const Zone &zone : m_task.task.zones)
        if (zone.name.empty())
            return tr("A zone has no name.");
    if (const auto valid = checkTask(m_task.task); !valid)
        return errorLine(valid.error());
    if (const auto valid = checkScoring(m_scoring->criteria()); !valid)
        return errorLine(valid.error());
    return {};
}

void TaskEditor::check()
{
    const QString wrong = problem();
    m_message->setText(wrong);
    m_save->setEnabled(wrong.isEmpty());
}

namespace {

constexpr double mostMm = 100'000, degree = std::numbers::pi / 180;
constexpr TaskTemplate kinds[] = {TaskTemplate::StraightLine, TaskTemplate::Circle, TaskTemplate::FigureEight,
                                  TaskTemplate::Slalom, TaskTemplate::Free};

} // namespace

QString templateName(TaskTemplate kind)
{
    switch (kind) {
    case TaskTemplate::StraightLine:
        return TemplateForm::tr("Straight line");
    case TaskTemplate::Circle:
        return TemplateForm::tr("Circle");
    case TaskTemplate::FigureEight:
        return TemplateForm::tr("Figure eight");
    case TaskTemplate::Slalom:
        return TemplateForm::tr("Slalom");
    case TaskTemplate::Free:
        break;
    }
    return TemplateForm::tr("Free");
}

TemplateForm::TemplateForm(QWidget *parent)
    : QWidget(parent), m_form(new QFormLayout(this)), m_kind(new QComboBox), m_direction(new NumberBox),
      m_poles(new QSpinBox)
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(5);
    for (const TaskTemplate kind : kinds)
        m_kind->addItem(templateName(kind), static_cast<int>(kind));
    m_form->addRow(tr("Te&mplate"), m_kind);
    m_x = addLength(tr("Centre &x"));
    m_y = addLength(tr("Centre &y"));
    for (QDoubleSpinBox *position : {m_x, m_y})
        position->setMinimum(-mostMm);
    m_length = addLength(tr("&Length"));
    m_width = addLength(tr("&Width"));
    m_direction->setRange(-360, 360);
    m_direction->setDecimals(0);
    m_direction->setSuffix(QStringLiteral("°"));
    m_direction->setToolTip(tr("Driving direction: 0° along X, 90° along Y"));
    m_form->addRow(tr("&Direction"), m_direction);
    m_poles->setRange(1, 100);
    m_form->addRow(tr("&Poles"), m_poles);
    m_gate = addLength(tr("&Gates' width"));
    showSizes();
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        showSizes();
        Q_EMIT changed();
    });
    connect(m_direction, &QDoubleSpinBox::valueChanged, this, &TemplateForm::changed);
    connect(m_poles, &QSpinBox::valueChanged, this, &TemplateForm::changed);
}

QDoubleSpinBox *TemplateForm::addLength(const QString &words)
{
    auto *length = new NumberBox;
    length->setRange(1, mostMm);
    length->setDecimals(0);
    length->setSingleStep(50);
    length->setSuffix(tr(" mm"));
    m_form->addRow(words, length);
    connect(length, &QDoubleSpinBox::valueChanged, this, &TemplateForm::changed);
    return length;
}

void TemplateForm::showSizes()
{
    const TaskTemplate kind = this->kind();
    const bool isRound = kind == TaskTemplate::Circle || kind == TaskTemplate::FigureEight;
    m_form->setRowVisible(m_width, kind == TaskTemplate::FigureEight || kind == TaskTemplate::Slalom);
    m_form->setRowVisible(m_direction, !isRound);
    m_form->setRowVisible(m_poles, kind == TaskTemplate::Slalom);
    const auto call = [this](QWidget *field, const QString &words) {
        qobject_cast<QLabel *>(m_form->labelForField(field))->setText(words);
    };
    call(m_length, kind == TaskTemplate::Circle        ? tr("Diam&eter")
                   : kind == TaskTemplate::FigureEight ? tr("&Width")
                   : kind == TaskTemplate::Free        ? tr("Start to finis&h")
                                                       : tr("&Length"));
    call(m_width, kind == TaskTemplate::FigureEight ? tr("&Height") : tr("S&wing, side to side"));
}

void TemplateForm::setTemplate(TaskTemplate kind, const TemplateSizes &sizes)
{
    const QSignalBlocker quiet(this);
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(kind)));
    m_x->setValue(toMillimetres(sizes.centre.x()));
    m_y->setValue(toMillimetres(sizes.centre.y()));
    m_length->setValue(toMillimetres(sizes.lengthM));
    m_width->setValue(toMillimetres(sizes.widthM));
    m_direction->setValue(sizes.directionRad / degree);
    m_poles->setValue(sizes.poles);
    m_gate->setValue(toMillimetres(sizes.gateM));
    showSizes();
}

TaskTemplate TemplateForm::kind() const
{
    return static_cast<TaskTemplate>(m_kind->currentData().toInt());
}

TemplateSizes TemplateForm::sizes() const
{
    TemplateSizes sizes;
    sizes.centre = {fromMillimetres(m_x->value()), fromMillimetres(m_y->value())};
    sizes.lengthM = fromMillimetres(m_length->value());
    sizes.widthM = fromMillimetres(m_width->value());
    sizes.directionRad = m_direction->value() * degree;
    sizes.poles = m_poles->value();
    sizes.gateM = fromMillimetres(m_gate->value());
    return sizes;
}

} // namespace odo
