// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/robots_dialog.h"

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/main_window/internal/pick_colour_dialog.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

enum Column { NameColumn, ColourColumn, DrawingColumn, HeightColumn, SizeColumn, ColumnCount };
constexpr int listSwatchSide = 14;

QString heightText(const RobotRecord &robot)
{
    switch (robot.heightMode) {
    case RobotRecord::Height::Given:
        return lengthText(robot.heightM.value_or(0));
    case RobotRecord::Height::Automatic:
        return RobotsDialog::tr("estimated from the views");
    case RobotRecord::Height::Free:
        break;
    }
    return RobotsDialog::tr("changes while it runs");
}

QTableWidgetItem *colourItem(const RobotRecord &robot)
{
    if (!robot.colour)
        return new QTableWidgetItem(RobotsDialog::tr("its silhouette"));
    QPixmap swatch(listSwatchSide, listSwatchSide);
    swatch.fill(QColor(robot.colour->red, robot.colour->green, robot.colour->blue));
    QIcon icon(swatch);
    icon.addPixmap(swatch, QIcon::Selected); // in a chosen row too it is the colour of the robot
    return new QTableWidgetItem(icon, QString::fromStdString(robot.colour->toString()));
}

QTableWidgetItem *drawingItem(const RobotRecord &robot, const QPalette &palette)
{
    auto *item = new QTableWidgetItem(drawingColourName(robot.drawingColour));
    if (robot.drawingColour != DrawingColour::Automatic) {
        QPixmap swatch(listSwatchSide, listSwatchSide);
        swatch.fill(drawnColour(robot.drawingColour, {}, palette));
        item->setIcon(swatch);
    }
    return item;
}

} // namespace

RobotsDialog::RobotsDialog(Project &project, bool readOnly, QWidget *parent)
    : QDialog(parent), m_project(project), m_changes(project), m_readOnly(readOnly),
      m_table(new QTableWidget(0, ColumnCount)), m_add(plainButton(tr("&Add…"))),
      m_edit(plainButton(tr("&Edit…"))), m_remove(plainButton(tr("&Delete"))), m_message(new QLabel)
{
    setWindowTitle(tr("Robots"));
    m_table->setHorizontalHeaderLabels(
        {tr("Robot"), tr("Detected by"), tr("Drawn in"), tr("Height of its top"), tr("Length × width")});
    m_table->setAccessibleName(tr("Robots"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    auto *words = new QLabel(
        tr("A new colour or height applies from the next tracking on; earlier results stay as they are."));
    words->setWordWrap(true);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setWordWrap(true);
    m_message->setAccessibleName(tr("Latest change"));
    auto *close = plainButton(tr("Close"));
    auto *bottom = new QHBoxLayout;
    for (QPushButton *button : {m_add, m_edit, m_remove})
        bottom->addWidget(button);
    bottom->addWidget(m_message, 1);
    bottom->addWidget(close);
    close->setDefault(true);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_table, 1);
    layout->addWidget(words);
    layout->addLayout(bottom);
    resize(820, 420);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_add, &QPushButton::clicked, this, &RobotsDialog::add);
    connect(m_edit, &QPushButton::clicked, this, &RobotsDialog::change);
    connect(m_remove, &QPushButton::clicked, this, &RobotsDialog::remove);
    connect(m_table, &QTableWidget::cellDoubleClicked, this, &RobotsDialog::change);
    addUndoKeys(*this, m_changes, [this](const Result<QString> &outcome) { showOutcome(outcome, {}); });
    refresh({});
}

void RobotsDialog::refresh(const std::string &choose)
{
    auto robots = m_project.robots().all();
    if (!robots) {
        m_message->setText(errorLine(robots.error()));
        return;
    }
    m_robots = std::move(*robots);
    int row = std::max(0, m_table->currentRow());
    m_table->setRowCount(static_cast<int>(m_robots.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const RobotRecord &robot = m_robots[static_cast<std::size_t>(i)];
        auto *name = new QTableWidgetItem(QString::fromStdString(robot.name));
        // a long one is cut off in the list
        name->setToolTip(QString::fromStdString(robot.name).toHtmlEscaped());
        m_table->setItem(i, NameColumn, name);
        m_table->setItem(i, ColourColumn, colourItem(robot));
        m_table->setItem(i, DrawingColumn, drawingItem(robot, palette()));
        m_table->setItem(i, HeightColumn, new QTableWidgetItem(heightText(robot)));
        const bool isSized = robot.lengthM && robot.widthM;
        m_table->setItem(i, SizeColumn,
                         new QTableWidgetItem(isSized ? tr("%1 × %2").arg(lengthText(*robot.lengthM),
                                                                          lengthText(*robot.widthM))
                                                      : QString()));
        if (robot.name == choose)
            row = i;
    }
    m_table->setCurrentCell(std::min(row, m_table->rowCount() - 1), NameColumn);
    m_add->setEnabled(!m_readOnly);
    m_edit->setEnabled(!m_readOnly && current());
    m_remove->setEnabled(!m_readOnly && current());
}

const RobotRecord *RobotsDialog::current() const
{
    return recordAt(m_robots, m_table->currentRow());
}

void RobotsDialog::add()
{
    RobotDialog dialog(newestRecordings(m_project), this);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const RobotRecord robot = dialog.robot();
    apply(addRobotWords(robot.name), robot.name, [&] { return withoutValue(m_project.robots().add(robot)); });
}

void RobotsDialog::change()
{
    if (!m_edit->isEnabled())
        return;
    const RobotRecord before = *current();
    RobotDialog dialog(newestRecordings(m_project), this);
    dialog.setRobot(before);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const RobotRecord robot = dialog.robot();
    apply(ODO_TEXT("ui.change_robot", "change robot %1")(Named::robot(before.name)), robot.name,
          [&] { return m_project.robots().set(robot); });
}

void RobotsDialog::remove()
{
    const RobotRecord robot = *current();
    apply(ODO_TEXT("ui.delete_robot", "delete robot %1")(Named::robot(robot.name)), {},
          [&] { return m_project.robots().remove(robot.id); });
}

void RobotsDialog::apply(const Message &words, const std::string &choose,
                         const std::function<Result<void>()> &work)
{
    showOutcome(m_changes.make(words, work), choose);
}

void RobotsDialog::showOutcome(const Result<QString> &outcome, const std::string &choose)
{
    m_message->setText(outcome ? *outcome : errorLine(outcome.error()));
    refresh(choose);
    if (outcome)
        Q_EMIT changed();
}

namespace {
constexpr double usualHeightMm = 60;
constexpr int robotSwatchSide = 16;
constexpr double farthestReferenceMm = 2000;
} // namespace

RobotDialog::RobotDialog(QList<PickableVideo> videos, QWidget *parent)
    : QDialog(parent), m_videos(std::move(videos)), m_name(new QLineEdit), m_look(new QComboBox),
      m_colourButton(new QPushButton), m_pickButton(new QPushButton(tr("&Pick from a video…"))),
      m_drawing(new QComboBox), m_heightMode(new QComboBox), m_height(new NumberBox),
      m_forward(new NumberBox), m_left(new NumberBox), m_footprint(new RobotFootprint),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Add robot"));
    m_heightMode->addItem(tr("Estimated from the views"), static_cast<int>(RobotRecord::Height::Automatic));
    m_heightMode->addItem(tr("Measured"), static_cast<int>(RobotRecord::Height::Given));
    m_heightMode->addItem(tr("Changes while it runs (ramp)"), static_cast<int>(RobotRecord::Height::Free));
    m_height->setRange(0, 2000);
    m_height->setSuffix(tr(" mm"));
    m_height->setValue(usualHeightMm);
    m_height->setAccessibleName(tr("Height of the robot's top"));
    auto *form = new QFormLayout;
    form->addRow(tr("&Name"), m_name);
    m_look->addItem(tr("Its silhouette"), false);
    m_look->addItem(tr("A colour of its own"), true);
    m_look->setToolTip(
        tr("The silhouette works for any robot. A colour of its own helps if several things move."));
    form->addRow(tr("D&etected by"), m_look);
    auto *colour = new QHBoxLayout;
    colour->addWidget(m_colourButton);
    colour->addWidget(m_pickButton);
    form->addRow(tr("&Colour of its top"), colour);
    qobject_cast<QLabel *>(form->labelForField(colour))->setBuddy(m_colourButton);
    m_drawing->addItem(drawingColourName(DrawingColour::Automatic),
                       static_cast<int>(DrawingColour::Automatic));
    for (std::size_t place = 0; place < drawingColours.size(); ++place) {
        QPixmap swatch(robotSwatchSide, robotSwatchSide);
        swatch.fill(seriesColour(static_cast<int>(place), palette()));
        m_drawing->addItem(swatch, drawingColourName(drawingColours[place]),
                           static_cast<int>(drawingColours[place]));
    }
    m_drawing->setToolTip(tr("Colour in charts and maps; the robot itself may have another"));
    form->addRow(tr("&Drawn in"), m_drawing);
    form->addRow(tr("&Height of its top"), m_heightMode);
    form->addRow(QString(), m_height);
    auto *reference = new QHBoxLayout;
    for (QDoubleSpinBox *box : {m_forward, m_left}) {
        box->setRange(-farthestReferenceMm, farthestReferenceMm);
        box->setDecimals(0);
        box->setToolTip(tr("Offset from the middle of the robot's footprint; 0 and 0 is the middle itself."));
        reference->addWidget(box);
    }
    m_forward->setSuffix(tr(" mm forward"));
    m_forward->setAccessibleName(tr("Reference point, forward of the robot's middle"));
    m_left->setSuffix(tr(" mm left"));
    m_left->setAccessibleName(tr("Reference point, left of the robot's middle"));
    form->addRow(tr("&Reference point"), reference);
    qobject_cast<QLabel *>(form->labelForField(reference))->setBuddy(m_forward);
    form->addRow(QString(), m_footprint);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_buttons);
    connect(m_colourButton, &QPushButton::clicked, this, &RobotDialog::chooseColour);
    connect(m_look, &QComboBox::currentIndexChanged, this, &RobotDialog::updateButtons);
    connect(m_pickButton, &QPushButton::clicked, this, &RobotDialog::pickColour);
    connect(m_name, &QLineEdit::textChanged, this, &RobotDialog::updateButtons);
    connect(m_heightMode, &QComboBox::currentIndexChanged, this, &RobotDialog::updateButtons);
    for (QDoubleSpinBox *box : {m_forward, m_left})
        connect(box, &QDoubleSpinBox::valueChanged, this, &RobotDialog::showFootprint);
    connect(m_drawing, &QComboBox::currentIndexChanged, this, &RobotDialog::showFootprint);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showColour();
    updateButtons();
}

void RobotDialog::chooseColour()
{
    const QColor chosen = QColorDialog::getColor(QColor(m_colour.red, m_colour.green, m_colour.blue), this,
                                                 tr("Colour of the robot's top"));
    if (!chosen.isValid())
        return;
    m_colour = {static_cast<std::uint8_t>(chosen.red()), static_cast<std::uint8_t>(chosen.green()),
                static_cast<std::uint8_t>(chosen.blue())};
    showColour();
}

void RobotDialog::pickColour()
{
    PickColourDialog dialog(m_videos, this);
    if (dialog.exec() != QDialog::Accepted || !dialog.colour())
        return;
    m_colour = *dialog.colour();
    showColour();
}

void RobotDialog::showColour()
{
    QPixmap swatch(robotSwatchSide, robotSwatchSide);
    swatch.fill(QColor(m_colour.red, m_colour.green, m_colour.blue));
    m_colourButton->setIcon(swatch);
    m_colourButton->setText(QString::fromStdString(m_colour.toString()));
}

void RobotDialog::showFootprint()
{
    m_footprint->setRobot(robot());
}

void RobotDialog::updateButtons()
{
    m_colourButton->setEnabled(m_look->currentData().toBool());
    m_pickButton->setEnabled(m_look->currentData().toBool());
    m_height->setEnabled(m_heightMode->currentData().toInt() == static_cast<int>(RobotRecord::Height::Given));
    const bool hasHeading =
        m_heightMode->currentData().toInt() != static_cast<int>(RobotRecord::Height::Free);
    m_forward->setEnabled(hasHeading);
    m_left->setEnabled(hasHeading);
    showFootprint();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(!m_name->text().trimmed().isEmpty());
}

void RobotDialog::setRobot(const RobotRecord &robot)
{
    setWindowTitle(tr("Change robot"));
    m_before = robot;
    m_colour = robot.colour.value_or(m_colour);
    m_look->setCurrentIndex(m_look->findData(robot.colour.has_value()));
    m_name->setText(QString::fromStdString(robot.name));
    m_drawing->setCurrentIndex(m_drawing->findData(static_cast<int>(robot.drawingColour)));
    m_heightMode->setCurrentIndex(m_heightMode->findData(static_cast<int>(robot.heightMode)));
    if (robot.heightM)
        m_height->setValue(toMillimetres(*robot.heightM));
    m_forward->setValue(toMillimetres(robot.referenceM.x()));
    m_left->setValue(toMillimetres(robot.referenceM.y()));
    showColour();
    updateButtons();
}

RobotRecord RobotDialog::robot() const
{
    RobotRecord robot = m_before;
    robot.heightM.reset();
    robot.name = m_name->text().trimmed().toStdString();
    robot.colour = m_look->currentData().toBool() ? std::optional(m_colour) : std::nullopt;
    robot.drawingColour = static_cast<DrawingColour>(m_drawing->currentData().toInt());
    robot.heightMode = static_cast<RobotRecord::Height>(m_heightMode->currentData().toInt());
    if (robot.heightMode == RobotRecord::Height::Given)
        robot.heightM = fromMillimetres(m_height->value());
    const bool hasHeading = robot.heightMode != RobotRecord::Height::Free;
    robot.referenceM =
        hasHeading ? Eigen::Vector2d(fromMillimetres(m_forward->value()), fromMillimetres(m_left->value()))
                   : Eigen::Vector2d::Zero();
    return robot;
}

} // namespace odo
