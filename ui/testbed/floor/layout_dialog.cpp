// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/layout_dialog.h"

#include "core/base/units.h"
#include "core/exchange/file_name.h"
#include "core/exchange/labelled_points.h"
#include "core/geometry/homography.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSet>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

struct LayoutColumn
{
    enum { Label, X, Y, Count };
};
constexpr double flatterThan = 0.05; // of the extent: such markers say little across

QString csvFilter()
{
    return LayoutDialog::tr("Tables (*.csv *.txt);;All files (*)");
}

QString freeName(QString name, const QStringList &taken)
{
    if (!taken.contains(name))
        return name;
    for (int number = 2;; ++number)
        if (QString next = QStringLiteral("%1 (%2)").arg(name).arg(number); !taken.contains(next))
            return next;
}

/// A person writes 1 200,5 or 1200.5.
double millimetresOf(const QString &text)
{
    return typedNumber(text).value_or(std::numeric_limits<double>::quiet_NaN());
}

} // namespace

LayoutDialog::LayoutDialog(const MarkerLayout &start, const QStringList &taken, QWidget *parent)
    : QDialog(parent), m_layout(start), m_taken(taken), m_name(new QLineEdit),
      m_table(new QTableWidget(0, LayoutColumn::Count)), m_drawing(new LayoutDrawing), m_message(new QLabel)
{
    setWindowTitle(tr("Marker layout"));
    m_name->setText(freeName(start.name.empty() ? tr("Floor") : QString::fromStdString(start.name), taken));
    m_message->setWordWrap(true);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setObjectName(QStringLiteral("problem"));
    m_message->setAccessibleName(tr("Problems"));
    auto *intro =
        new QLabel(tr("Enter the floor positions of the markers, measured with a tape in millimetres from "
                      "the origin. Seen from above, X points right and Y away from you."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Name"), m_name);
    auto *row = new QHBoxLayout;
    row->addWidget(makeTable());
    row->addWidget(m_drawing, 1);
    QPushButton *cancel = plainButton(tr("Cancel"));
    m_save = plainButton(tr("&Save"));
    m_save->setProperty("primary", true);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_save);
    buttons->addWidget(cancel);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addLayout(form);
    layout->addLayout(row, 1);
    layout->addWidget(m_message);
    layout->addLayout(buttons);
    m_save->setDefault(true);
    resize(860, 560);
    connect(m_save, &QPushButton::clicked, this, &QDialog::accept);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_name, &QLineEdit::textChanged, this, [this] { check(); });
    connect(m_table, &QTableWidget::cellChanged, this, &LayoutDialog::readRow);
    connect(m_table, &QTableWidget::currentCellChanged, this,
            [this](int current) { m_drawing->setLayout(m_layout, current); });
    connect(m_drawing, &LayoutDrawing::picked, m_table, &QTableWidget::selectRow);
    connect(m_drawing, &LayoutDrawing::moved, this, [this](int marker, const Eigen::Vector2d &position) {
        m_layout.markers[std::size_t(marker)].pointInWorld = position;
        showMarkers();
    });
    if (m_layout.markers.empty())
        m_layout.markers = {{"O", {0, 0}}, {"U", {3, 0}}, {"V", {0, 2}}, {"D", {3, 2}}};
    showMarkers();
}

QWidget *LayoutDialog::makeTable()
{
    m_table->setHorizontalHeaderLabels({tr("Label"), tr("x, mm"), tr("y, mm")});
    m_table->setAccessibleName(tr("Markers"));
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    auto *box = new QWidget;
    box->setFixedWidth(330);
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table, 1);
    layout->addWidget(makeTools());
    return box;
}

QWidget *LayoutDialog::makeTools()
{
    auto *add = plainButton(tr("&Add")), *remove = plainButton(tr("&Remove")),
         *axes = plainButton(tr("A&xes")), *csv = plainButton(tr("&CSV"));
    connect(add, &QPushButton::clicked, this, &LayoutDialog::addMarker);
    connect(remove, &QPushButton::clicked, this, &LayoutDialog::removeMarker);
    auto *axesMenu = new QMenu(axes);
    axesMenu->addAction(tr("&Origin at the chosen marker"), this, [this] {
        AxesChange change;
        if (const int row = m_table->currentRow(); row >= 0)
            change.originMarker = m_layout.markers[std::size_t(row)].label;
        changeAxes(change);
    });
    axesMenu->addAction(tr("&Quarter turn"), this, [this] { changeAxes({.turnDegrees = 90}); });
    axesMenu->addAction(tr("&Half turn"), this, [this] { changeAxes({.reverseX = true, .reverseY = true}); });
    axesMenu->addSeparator();
    for (const auto &[unit, words] :
         {std::pair("cm", tr("Convert from &centimetres")), std::pair("m", tr("Convert from &metres")),
          std::pair("inch", tr("Convert from &inches"))})
        axesMenu->addAction(words, this,
                            [this, unit = unit] { changeAxes({.lengthFactor = *lengthFactorFrom(unit)}); });
    axes->setMenu(axesMenu);
    auto *csvMenu = new QMenu(csv);
    csvMenu->addAction(tr("&Import…"), this, [this] {
        const QString file = QFileDialog::getOpenFileName(
            this, tr("Positions of the markers (label,x_mm,y_mm)"), {}, csvFilter());
        if (!file.isEmpty())
            showOutcome(importCsv(file));
    });
    csvMenu->addAction(tr("&Export…"), this, [this] {
        const QString offered =
            QString::fromStdString(fileNameOf(m_name->text().toStdString())) + QStringLiteral(".csv");
        if (const auto chosen = askOutput(this, tr("Positions of the markers"), offered,
                                          {{csvFilter(), QStringLiteral("csv"), FileKind::Csv}}))
            showOutcome(exportCsv(chosen->target));
    });
    csv->setMenu(csvMenu);
    auto *tools = new QWidget;
    auto *row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    for (QPushButton *button : {add, remove, axes, csv})
        row->addWidget(button);
    return tools;
}

void LayoutDialog::showMarkers()
{
    m_showing = true;
    const int row = std::max(0, m_table->currentRow());
    m_table->setRowCount(int(m_layout.markers.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const Marker &marker = m_layout.markers[std::size_t(i)];
        QLocale locale; // a person edits these: 2,750 could be read as 2.75
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        const auto number = [&](double metres) {
            return std::isfinite(metres) ? locale.toString(toMillimetres(metres), 'g', 9) : QString();
        };
        const QString texts[] = {QString::fromStdString(marker.label), number(marker.pointInWorld.x()),
                                 number(marker.pointInWorld.y())};
        for (int column = 0; column < LayoutColumn::Count; ++column)
            m_table->setItem(i, column, new QTableWidgetItem(texts[column]));
    }
    m_table->setCurrentCell(std::min(row, m_table->rowCount() - 1), std::max(0, m_table->currentColumn()));
    m_showing = false;
    m_drawing->setLayout(m_layout, m_table->currentRow());
    check();
}

void LayoutDialog::readRow(int row)
{
    if (m_showing)
        return;
    Marker &marker = m_layout.markers[std::size_t(row)];
    marker.label = m_table->item(row, LayoutColumn::Label)->text().trimmed().toStdString();
    marker.pointInWorld = {fromMillimetres(millimetresOf(m_table->item(row, LayoutColumn::X)->text())),
                           fromMillimetres(millimetresOf(m_table->item(row, LayoutColumn::Y)->text()))};
    m_drawing->setLayout(m_layout, row);
    check();
}

void LayoutDialog::addMarker()
{
    QString label = QStringLiteral("P1");
    const auto taken = [&] {
        return std::ranges::any_of(m_layout.markers,
                                   [&](const Marker &marker) { return marker.label == label.toStdString(); });
    };
    for (int number = 1; taken(); ++number)
        label = QStringLiteral("P%1").arg(number);
    m_layout.markers.push_back({label.toStdString(), {1, 1}});
    showMarkers();
    m_table->setCurrentCell(m_table->rowCount() - 1, LayoutColumn::X);
}

void LayoutDialog::removeMarker()
{
    if (const int row = m_table->currentRow(); row >= 0)
        m_layout.markers.erase(m_layout.markers.begin() + row);
    showMarkers();
}

QString LayoutDialog::problem() const
{
    if (m_name->text().trimmed().isEmpty())
        return tr("The layout has no name.");
    if (m_taken.contains(m_name->text().trimmed()))
        return tr("A layout with this name exists, and cameras may use it. Enter another name.");
    QSet<QString> labels;
    std::vector<Eigen::Vector2d> points;
    for (const Marker &marker : m_layout.markers) {
        const QString label = QString::fromStdString(marker.label);
        if (label.isEmpty())
            return tr("A marker has no label.");
        if (labels.contains(label))
            return tr("Two markers are called %1.").arg(label);
        labels << label;
        if (!marker.pointInWorld.allFinite())
            return tr("The position of %1 is not a number.").arg(label);
        points.push_back(marker.pointInWorld);
    }
    if (points.size() < 4)
        return tr("The layout needs four markers; it has %1.").arg(points.size());
    if (const auto twins = coincidentPoints(points))
        return tr("%1 and %2 have the same position.")
            .arg(QString::fromStdString(m_layout.markers[std::size_t((*twins)[0])].label),
                 QString::fromStdString(m_layout.markers[std::size_t((*twins)[1])].label));
    if (widestQuadrilateral(points).flatness < flatterThan)
        return tr("The markers are nearly on a line and cannot determine the camera position. Move one to "
                  "the side.");
    return {};
}

void LayoutDialog::check()
{
    m_layout.name = m_name->text().trimmed().toStdString();
    const QString wrong = problem();
    m_message->setText(wrong);
    m_save->setEnabled(wrong.isEmpty());
}

void LayoutDialog::showOutcome(const Result<void> &outcome)
{
    if (!outcome)
        m_message->setText(errorLine(outcome.error()));
}

Result<void> LayoutDialog::importCsv(const QString &file)
{
    auto read = ODO_TRY(readLayoutCsv(pathOf(file)));
    m_layout.markers = std::move(read.markers);
    showMarkers();
    return {};
}

Result<void> LayoutDialog::exportCsv(const OutputTarget &target) const
{
    return writeLayoutCsv(target, m_layout);
}

void LayoutDialog::changeAxes(const AxesChange &change)
{
    const auto axes = axesTransformOf(m_layout, change);
    if (!axes)
        return showOutcome(tl::unexpected(axes.error()));
    m_layout = transformed(m_layout, *axes);
    showMarkers();
}

namespace {

constexpr double leastExtentM = 1, filledPart = 0.7;

} // namespace

LayoutDrawing::LayoutDrawing(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Markers from above"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LayoutDrawing::setLayout(const MarkerLayout &layout, int current)
{
    m_layout = layout;
    m_current = current;
    if (!m_dragging) // the ground must not move under the hand
        fit();
    update();
}

void LayoutDrawing::fit()
{
    Eigen::Vector2d lower(0, 0), upper(0, 0); // the axes begin in the origin
    for (const Marker &marker : m_layout.markers) {
        if (!marker.pointInWorld.allFinite())
            continue;
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    m_middle = 0.5 * (lower + upper);
    const Eigen::Vector2d extent = (upper - lower).cwiseMax(leastExtentM);
    m_pixelsPerMetre = filledPart * std::min(width() / extent.x(), height() / extent.y());
}

QPointF LayoutDrawing::toScreen(const Eigen::Vector2d &point) const
{
    const Eigen::Vector2d from = m_pixelsPerMetre * (point - m_middle);
    return {0.5 * width() + from.x(), 0.5 * height() - from.y()};
}

Eigen::Vector2d LayoutDrawing::toWorld(const QPointF &position) const
{
    return m_middle +
           Eigen::Vector2d(position.x() - 0.5 * width(), 0.5 * height() - position.y()) / m_pixelsPerMetre;
}

void LayoutDrawing::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.mapGround);
    painter.setPen(colours.mapGrid);
    const Eigen::Vector2d lower = toWorld({0, double(height())}), upper = toWorld({double(width()), 0});
    const std::vector<double> columns = floorGridLines(lower.x(), upper.x());
    for (const double x : columns)
        painter.drawLine(QPointF(toScreen({x, 0}).x(), 0), QPointF(toScreen({x, 0}).x(), height()));
    for (const double y : columns.empty() ? std::vector<double>() : floorGridLines(lower.y(), upper.y()))
        painter.drawLine(QPointF(0, toScreen({0, y}).y()), QPointF(width(), toScreen({0, y}).y()));
    const QPointF origin = toScreen({0, 0});
    const double axis = 46;
    painter.setPen(QPen(colours.text, 1.6));
    painter.drawLine(origin, origin + QPointF(axis, 0));
    painter.drawLine(origin, origin - QPointF(0, axis));
    painter.drawText(origin + QPointF(axis + 4, 4), QStringLiteral("X"));
    painter.drawText(origin + QPointF(-4, -axis - 5), QStringLiteral("Y"));
    for (int i = 0; i < int(m_layout.markers.size()); ++i) {
        const Marker &marker = m_layout.markers[std::size_t(i)];
        if (!marker.pointInWorld.allFinite())
            continue;
        const QPointF at = toScreen(marker.pointInWorld);
        painter.setPen(QPen(i == m_current ? colours.accent : colours.text, i == m_current ? 2.5 : 1));
        painter.setBrush(i == m_current ? colours.card : colours.text);
        painter.drawRect(QRectF(at.x() - 6, at.y() - 6, 12, 12));
        painter.setPen(colours.text);
        painter.drawText(at + QPointF(10, 16), QString::fromStdString(marker.label));
    }
    painter.setPen(colours.muted);
    painter.drawText(rect().adjusted(8, 6, -8, -6), Qt::AlignRight | Qt::AlignBottom,
                     !columns.empty() ? tr("grid %1 m").arg(QLocale().toString(floorGridM)) : QString());
}

void LayoutDrawing::mousePressEvent(QMouseEvent *event)
{
    for (int i = 0; i < int(m_layout.markers.size()); ++i) {
        if (QLineF(toScreen(m_layout.markers[std::size_t(i)].pointInWorld), event->position()).length() >
            floorGrabPx)
            continue;
        m_current = i;
        m_dragging = true;
        Q_EMIT picked(i);
        update();
        return;
    }
}

void LayoutDrawing::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_dragging)
        return;
    Q_EMIT moved(m_current, onDragStep(toWorld(event->position())));
}

void LayoutDrawing::mouseReleaseEvent(QMouseEvent *)
{
    m_dragging = false;
    fit();
    update();
}

void LayoutDrawing::resizeEvent(QResizeEvent *)
{
    fit();
}

} // namespace odo
