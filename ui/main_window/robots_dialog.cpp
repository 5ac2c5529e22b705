// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/robots_dialog.h"

#include "core/base/without_value.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/main_window/pick_colour_dialog.h"
#include "ui/main_window/robot_dialog.h"
#include "ui/models/error_words.h"
#include "ui/models/figure_text.h"
#include "ui/views/plain_button.h"
#include "ui/views/robot_colours.h"
#include "ui/views/table_list.h"
#include "ui/views/undo_keys.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>

namespace odo {
namespace {

enum Column { NameColumn, ColourColumn, DrawingColumn, HeightColumn, SizeColumn, ColumnCount };
constexpr int listSwatchSide = 14;

QString heightText(const RobotRecord &robot)
{
    switch (robot.heightMode) {
    case RobotRecord::Height::Told:
        return lengthText(robot.heightM.value_or(0));
    case RobotRecord::Height::Automatic:
        return RobotsDialog::tr("found from the views");
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
        {tr("Robot"), tr("Found by"), tr("Drawn in"), tr("Height of its top"), tr("Length × width")});
    m_table->setAccessibleName(tr("Robots"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    auto *words = new QLabel(tr("Another colour or height counts from the next tracking on; what was "
                                "measured before stays as it is."));
    words->setWordWrap(true);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setWordWrap(true);
    m_message->setAccessibleName(tr("What was done"));
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
    addUndoKeys(*this, m_changes, [this](const Result<QString> &outcome) { tell(outcome, {}); });
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
        name->setToolTip(QString::fromStdString(robot.name).toHtmlEscaped()); // a long one is cut off in the list
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
    apply(tr("add robot %1").arg(QString::fromStdString(robot.name)), robot.name,
          [&] { return withoutValue(m_project.robots().add(robot)); });
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
    apply(tr("change robot %1").arg(QString::fromStdString(before.name)), robot.name,
          [&] { return m_project.robots().set(robot); });
}

void RobotsDialog::remove()
{
    const RobotRecord robot = *current();
    apply(tr("delete robot %1").arg(QString::fromStdString(robot.name)), {},
          [&] { return m_project.robots().remove(robot.id); });
}

void RobotsDialog::apply(const QString &words, const std::string &choose,
                         const std::function<Result<void>()> &work)
{
    tell(m_changes.make(words, work), choose);
}

void RobotsDialog::tell(const Result<QString> &outcome, const std::string &choose)
{
    m_message->setText(outcome ? *outcome : errorLine(outcome.error()));
    refresh(choose);
    if (outcome)
        Q_EMIT changed();
}

} // namespace odo
