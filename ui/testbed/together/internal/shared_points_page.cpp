// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/together/internal/shared_points_page.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/marker_page.h"

#include "core/base/units.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/calibration/marker_detection.h"
#include "ui/testbed/floor/marker_canvas.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/table_list.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace odo {
namespace {

enum Column { PointColumn, SeenColumn, PositionColumn, ErrorColumn, ColumnCount };
constexpr std::size_t fewestPoints = 4;

QString wholeMillimetres(double metres)
{
    return QLocale().toString(std::lround(toMillimetres(metres))); // which has no −0
}

} // namespace

SharedPointsPage::SharedPointsPage(QWidget *parent)
    : QWidget(parent), m_canvas(new MarkerCanvas), m_referenceCanvas(new MarkerCanvas), m_name(new QLabel),
      m_referenceName(new QLabel), m_table(new QTableWidget(0, ColumnCount)),
      m_verdict(new RegistrationVerdict), m_remove(new QAction(tr("&Remove"), this)),
      m_undo(new QAction(tr("&Undo"), this))
{
    m_remove->setShortcut(QKeySequence::Delete);
    m_undo->setShortcut(QKeySequence::Undo);
    addActions({m_remove, m_undo});
    connect(m_remove, &QAction::triggered, this, &SharedPointsPage::removeCurrent);
    connect(m_undo, &QAction::triggered, this, &SharedPointsPage::undo);
    m_canvas->setAccessibleName(tr("Image of the camera to register; arrow keys move the selected point"));
    m_referenceCanvas->setAccessibleName(
        tr("Image of the registered camera; arrow keys move the selected point"));
    connect(m_canvas, &MarkerCanvas::markerSet, this,
            [this](const QString &label, const Eigen::Vector2d &pixel, bool snap) {
                position(&Point::pixel, m_images->camera.frame, label, pixel, snap);
            });
    connect(m_referenceCanvas, &MarkerCanvas::markerSet, this,
            [this](const QString &label, const Eigen::Vector2d &pixel, bool snap) {
                position(&Point::referencePixel, m_images->reference.frame, label, pixel, snap);
            });
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    int column = 0;
    for (const auto &[name, canvas] :
         {std::pair(m_name, m_canvas), std::pair(m_referenceName, m_referenceCanvas)}) {
        connect(canvas, &MarkerCanvas::picked, this, &SharedPointsPage::select);
        name->setStyleSheet(QStringLiteral("font-weight: 600"));
        name->setTextFormat(Qt::PlainText);
        layout->addWidget(name, 0, column);
        layout->addWidget(canvas, 1, column);
        layout->setColumnStretch(column++, 1);
    }
    layout->addWidget(makeSide(), 2, 0, 1, 2);
    layout->setRowStretch(1, 3);
    layout->setRowStretch(2, 2);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this] { showPoints(); });
}

QWidget *SharedPointsPage::makeTable()
{
    m_table->setHorizontalHeaderLabels({tr("Point"), tr("Seen in"), tr("On the floor, mm"), tr("Error")});
    m_table->setAccessibleName(tr("Floor points"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(ErrorColumn, QHeaderView::Stretch);
    auto *buttons = new QHBoxLayout;
    buttons->setContentsMargins(10, 4, 10, 8);
    buttons->addWidget(actionButton(m_remove, m_remove->text()));
    buttons->addWidget(actionButton(m_undo, m_undo->text()));
    buttons->addStretch(1);
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
    return content;
}

QWidget *SharedPointsPage::makeSide()
{
    auto *points = new Card(tr("Floor points"));
    points->setContent(makeTable());
    auto *side = new QWidget;
    auto *layout = new QHBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(points, 1);
    layout->addWidget(m_verdict, 1);
    return side;
}

void SharedPointsPage::wait(const QString &words)
{
    m_images.reset();
    m_points.clear();
    m_before.clear();
    for (MarkerCanvas *canvas : {m_canvas, m_referenceCanvas}) {
        canvas->setImage({}, {});
        canvas->setEmptyText(words);
    }
    evaluate();
    m_verdict->showVerdict(words, {});
}

void SharedPointsPage::showFailure(const Error &error)
{
    wait(shownWords(error.why));
    m_verdict->showVerdict(shownWords(error.why), shownWords(error.advice));
}

void SharedPointsPage::showNotSaved(const Error &error)
{
    m_verdict->reportNotSaved(error);
}

void SharedPointsPage::begin(std::shared_ptr<const ImagePair> images, const FloorCamera &camera,
                             const CheckCamera &reference)
{
    m_images = std::move(images);
    m_camera = camera;
    m_reference = reference;
    m_points.clear();
    for (const MarkerPixel &marker : m_images->camera.markers) {
        const auto there = std::ranges::find(m_images->reference.markers, marker.label, &MarkerPixel::label);
        if (there != m_images->reference.markers.end())
            m_points.push_back({QString::fromStdString(marker.label), marker.pixel, there->pixel});
    }
    do
        addEmptyPoint();
    while (m_points.size() < fewestPoints);
    m_name->setText(tr("Camera %1, to be registered").arg(camera.name));
    m_referenceName->setText(tr("Camera %1, registered").arg(reference.name));
    for (const auto &[canvas, image] :
         {std::pair(m_canvas, &m_images->camera), std::pair(m_referenceCanvas, &m_images->reference)})
        canvas->setImage(image->image, {image->frame.format.width, image->frame.format.height});
    m_referenceCanvas->setFloor(reference.view, reference.layout);
    evaluate();
    const auto first = std::ranges::find_if(m_points, [](const Point &point) { return !point.pixel; });
    m_table->selectRow(first == m_points.end() ? 0 : int(first - m_points.begin()));
    m_canvas->setFocus();
}

void SharedPointsPage::addEmptyPoint()
{
    for (int number = 1;; ++number) {
        const QString label = tr("P%1", "a point").arg(number);
        if (std::ranges::find(m_points, label, &Point::label) == m_points.end()) {
            m_points.push_back({label, std::nullopt, std::nullopt});
            return;
        }
    }
}

QString SharedPointsPage::currentLabel() const
{
    const int row = m_table->currentRow();
    return row < 0 || row >= int(m_points.size()) ? QString() : m_points[std::size_t(row)].label;
}

void SharedPointsPage::select(const QString &label)
{
    const auto point = std::ranges::find(m_points, label, &Point::label);
    if (point != m_points.end())
        m_table->selectRow(int(point - m_points.begin()));
}

void SharedPointsPage::position(std::optional<Eigen::Vector2d> Point::*where, const Frame &frame,
                                const QString &label, const Eigen::Vector2d &pixel, bool snap)
{
    const auto point = std::ranges::find(m_points, label, &Point::label);
    if (point == m_points.end())
        return;
    m_before.push_back(m_points);
    const SnappedMarker seen =
        snap ? snapToMarker(frame, pixel) : SnappedMarker{SnappedMarker::Kind::None, pixel, 0};
    (*point).*where = seen.kind == SnappedMarker::Kind::None ? pixel : seen.pixel;
    const int row = int(point - m_points.begin());
    if (std::ranges::all_of(m_points, [](const Point &each) { return each.pixel && each.referencePixel; }))
        addEmptyPoint();
    evaluate();
    if (snap)
        goOnFrom(row);
}

/// The user clicks in one image, then in the other, then at the next point.
void SharedPointsPage::goOnFrom(int row)
{
    const Point &point = m_points[std::size_t(row)];
    if (!point.pixel)
        m_canvas->setFocus();
    else if (!point.referencePixel)
        m_referenceCanvas->setFocus();
    else {
        const auto next = std::ranges::find_if(m_points, [](const Point &each) { return !each.pixel; });
        if (next != m_points.end())
            m_table->selectRow(int(next - m_points.begin()));
        m_canvas->setFocus();
    }
}

void SharedPointsPage::removeCurrent()
{
    const QString label = currentLabel();
    const auto point = std::ranges::find(m_points, label, &Point::label);
    if (point == m_points.end())
        return;
    m_before.push_back(m_points);
    point->pixel.reset();
    point->referencePixel.reset();
    evaluate();
}

void SharedPointsPage::undo()
{
    if (m_before.empty())
        return;
    m_points = std::move(m_before.back());
    m_before.pop_back();
    evaluate();
}

std::vector<SharedPoint> SharedPointsPage::points() const
{
    std::vector<SharedPoint> shared;
    for (const Point &point : m_points) {
        if (point.pixel && point.referencePixel)
            shared.push_back({point.label.toStdString(), *point.pixel, *point.referencePixel});
    }
    return shared;
}

void SharedPointsPage::evaluate()
{
    m_registration.reset();
    std::optional<FloorView> view;
    if (m_images) {
        const FrameFormat &format = m_images->camera.frame.format;
        const std::optional<Intrinsics> lens =
            m_camera.intrinsics ? std::optional(m_camera.intrinsics->calibration.intrinsics) : std::nullopt;
        const auto shared = points();
        const auto chained = registerViaCamera(
            m_reference->view,
            ODO_TEXT("ui.camera_named", "camera %1")(Named::camera(m_reference->name.toStdString())), shared,
            cameraOf(lens, format.width, format.height), lens.has_value());
        if (chained) {
            m_registration = *chained;
            const FloorRegistration &registration = chained->registration;
            view = floorViewOf(registration, *CameraModel::create(registration.intrinsics), chained->pixels);
            m_verdict->showVerdict(registration);
        } else {
            m_verdict->showVerdict(
                shownWords(chained.error().why),
                shared.size() < fewestPoints
                    ? tr("Click a floor point in the left image, then the same point in the "
                         "right image. A click snaps to what is near it, to a tenth of a pixel; "
                         "arrow keys move the selected point, Space snaps it.")
                    : shownWords(chained.error().advice));
        }
    }
    m_canvas->setFloor(view, m_reference ? m_reference->layout : MarkerLayout());
    m_undo->setEnabled(!m_before.empty());
    showPoints();
    Q_EMIT completeChanged();
}

void SharedPointsPage::showPoints()
{
    const QSignalBlocker quiet(m_table);
    const int row = m_table->currentRow();
    m_table->setRowCount(int(m_points.size()));
    const QLocale locale;
    std::vector<MarkerPixel> here, there;
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const Point &point = m_points[std::size_t(i)];
        QString position, error;
        if (point.pixel)
            here.push_back({point.label.toStdString(), *point.pixel});
        if (point.referencePixel) {
            there.push_back({point.label.toStdString(), *point.referencePixel});
            const auto at = m_reference->view.floorFromPixel(*point.referencePixel, 0);
            position = at ? tr("%1; %2").arg(wholeMillimetres(at->x()), wholeMillimetres(at->y()))
                          : tr("beyond the horizon");
        }
        if (m_registration) {
            const auto &markers = m_registration->registration.markers;
            const auto found = std::ranges::find(markers, point.label.toStdString(), &MarkerError::label);
            if (found != markers.end())
                error = tr("%1 mm").arg(locale.toString(toMillimetres(found->errorM), 'f', 1));
        }
        const QString seen = point.pixel && point.referencePixel ? tr("both images")
                             : point.pixel                       ? tr("left only")
                             : point.referencePixel              ? tr("right only")
                                                                 : tr("not set yet");
        const QString texts[] = {point.label, seen, position, error};
        for (int column = 0; column < ColumnCount; ++column)
            m_table->setItem(i, column, new QTableWidgetItem(texts[column]));
    }
    if (row >= 0 && row < m_table->rowCount())
        m_table->selectRow(row);
    m_canvas->setMarkers(std::move(here));
    m_referenceCanvas->setMarkers(std::move(there));
    const QString label = currentLabel();
    m_canvas->setCurrent(label);
    m_referenceCanvas->setCurrent(label);
    const auto point = std::ranges::find(m_points, label, &Point::label);
    m_remove->setEnabled(point != m_points.end() && (point->pixel || point->referencePixel));
}

} // namespace odo
