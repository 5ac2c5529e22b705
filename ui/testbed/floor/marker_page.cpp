// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/marker_page.h"

#include "core/base/units.h"
#include "core/calibration/marker_detection.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/marker_canvas.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

constexpr int sideWidth = 380;
constexpr std::size_t leastMarkers = 4;
struct MarkerColumn
{
    enum { Label, Place, Seen, Error, Count };
};

} // namespace

MarkerPage::MarkerPage(QWidget *parent)
    : QWidget(parent), m_canvas(new MarkerCanvas), m_table(new QTableWidget(0, MarkerColumn::Count)),
      m_verdict(new RegistrationVerdict), m_remove(new QAction(tr("&Remove"), this)),
      m_undo(new QAction(tr("&Undo"), this))
{
    m_remove->setShortcut(QKeySequence::Delete);
    m_undo->setShortcut(QKeySequence::Undo);
    addActions({m_remove, m_undo});
    connect(m_remove, &QAction::triggered, this, &MarkerPage::removeCurrent);
    connect(m_undo, &QAction::triggered, this, &MarkerPage::undo);
    connect(&m_search, &BackgroundTask::finished, this, &MarkerPage::takeOthers);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_canvas, 1);
    layout->addWidget(makeSide());
    connect(m_canvas, &MarkerCanvas::markerSet, this, &MarkerPage::position);
    connect(m_canvas, &MarkerCanvas::picked, this, [this](const QString &label) {
        for (int row = 0; row < m_table->rowCount(); ++row)
            if (m_table->item(row, MarkerColumn::Label)->text() == label)
                m_table->selectRow(row);
    });
    connect(m_table, &QTableWidget::currentCellChanged, this, [this] {
        m_canvas->setCurrent(currentLabel());
        m_remove->setEnabled(std::ranges::find(m_pixels, currentLabel().toStdString(), &MarkerPixel::label) !=
                             m_pixels.end());
    });
}

QWidget *MarkerPage::makeSide()
{
    m_table->setHorizontalHeaderLabels({tr("Marker"), tr("Position, mm"), tr("Seen as"), tr("Error")});
    m_table->setAccessibleName(tr("Markers"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setStretchLastSection(true);
    auto *content = new QWidget;
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->addWidget(m_table, 1);
    auto *buttons = new QHBoxLayout;
    buttons->setContentsMargins(10, 4, 10, 8);
    buttons->addWidget(actionButton(m_remove, m_remove->text()));
    buttons->addWidget(actionButton(m_undo, m_undo->text()));
    buttons->addStretch(1);
    contentLayout->addLayout(buttons);
    auto *markers = new Card(tr("Markers"));
    markers->setContent(content);
    auto *side = new QWidget;
    side->setFixedWidth(sideWidth);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(markers, 3);
    layout->addWidget(m_verdict, 2);
    return side;
}

void MarkerPage::wait(const QString &words)
{
    m_search.cancel();
    m_image.reset();
    m_pixels.clear();
    m_layout = {};
    m_canvas->setImage({}, {});
    m_canvas->setEmptyText(words);
    evaluate();
    m_verdict->showVerdict(words, {});
}

void MarkerPage::showFailure(const Error &error)
{
    wait(shownWords(error.why));
    m_verdict->showVerdict(shownWords(error.why), shownWords(error.advice));
}

void MarkerPage::showNotSaved(const Error &error)
{
    m_verdict->reportNotSaved(error);
}

void MarkerPage::begin(std::shared_ptr<const StillImage> image, const MarkerLayout &layout,
                       const std::optional<Intrinsics> &intrinsics)
{
    m_image = std::move(image);
    m_layout = layout;
    m_intrinsics = intrinsics;
    m_pixels = m_image->markers;
    m_kinds.clear();
    for (const MarkerPixel &marker : m_pixels)
        m_kinds.emplace_back(marker.label, tr("found"));
    m_before.clear();
    m_search.cancel();
    m_canvas->setImage(m_image->image, {m_image->frame.format.width, m_image->frame.format.height});
    evaluate();
    m_table->selectRow(0);
    m_canvas->setFocus();
}

QString MarkerPage::currentLabel() const
{
    const QTableWidgetItem *item =
        m_table->currentRow() < 0 ? nullptr : m_table->item(m_table->currentRow(), MarkerColumn::Label);
    return item ? item->text() : QString();
}

void MarkerPage::remember()
{
    m_before.push_back(m_pixels);
}

void MarkerPage::position(const QString &label, const Eigen::Vector2d &pixel, bool snap)
{
    remember();
    const SnappedMarker seen =
        snap ? snapToMarker(m_image->frame, pixel) : SnappedMarker{SnappedMarker::Kind::None, pixel, 0};
    const std::string name = label.toStdString();
    std::erase_if(m_pixels, [&](const MarkerPixel &marker) { return marker.label == name; });
    std::erase_if(m_kinds, [&](const auto &kind) { return kind.first == name; });
    m_pixels.push_back({name, seen.pixel});
    m_kinds.emplace_back(name, snappedWords(seen.kind));
    evaluate();
    if (snap)
        findOthers();
    // The next one that is nowhere yet, so that a person clicks them one after the other.
    for (int row = 0; snap && row < m_table->rowCount(); ++row) {
        const std::string next = m_table->item(row, MarkerColumn::Label)->text().toStdString();
        if (std::ranges::find(m_pixels, next, &MarkerPixel::label) == m_pixels.end()) {
            m_table->selectRow(row);
            break;
        }
    }
}

/// Those marked by hand may tell all others apart, which look alike.
void MarkerPage::findOthers()
{
    if (!m_image->notFound || m_pixels.size() >= leastMarkers)
        return;
    const auto found = std::make_shared<std::vector<MarkerPixel>>();
    MarkerSearch search{cameraOf(m_intrinsics, m_image->frame.format.width, m_image->frame.format.height),
                        m_intrinsics.has_value(), m_pixels};
    const bool started = m_search.start([found, image = m_image, layout = m_layout,
                                         search = std::move(search)](const JobControl &) -> Result<void> {
        if (auto markers = findMarkers(image->frame, layout, search))
            *found = std::move(*markers);
        return {};
    });
    if (started) {
        m_searched = m_pixels;
        m_others = found;
    }
}

void MarkerPage::takeOthers()
{
    const bool isSame = std::ranges::equal(m_pixels, m_searched, [](const auto &a, const auto &b) {
        return a.label == b.label && a.pixel == b.pixel;
    });
    if (!m_image || m_search.isCancelled())
        return;
    if (!isSame)
        return findOthers();
    if (m_others->size() <= m_pixels.size())
        return;
    remember();
    m_pixels = *m_others;
    for (const MarkerPixel &marker : m_pixels) {
        if (std::ranges::find(m_kinds, marker.label, [](const auto &kind) { return kind.first; }) ==
            m_kinds.end())
            m_kinds.emplace_back(marker.label, tr("found"));
    }
    evaluate();
}

void MarkerPage::removeCurrent()
{
    const std::string name = currentLabel().toStdString();
    remember();
    std::erase_if(m_pixels, [&](const MarkerPixel &marker) { return marker.label == name; });
    evaluate();
}

void MarkerPage::undo()
{
    if (m_before.empty())
        return;
    m_pixels = std::move(m_before.back());
    m_before.pop_back();
    evaluate();
}

void MarkerPage::evaluate()
{
    m_registration.reset();
    std::optional<FloorView> view;
    if (m_image) {
        const CameraModel camera =
            cameraOf(m_intrinsics, m_image->frame.format.width, m_image->frame.format.height);
        const auto registered =
            registerFloor(m_layout, m_pixels, camera, m_intrinsics.has_value(), {true, {}});
        if (registered) {
            m_registration = *registered;
            view = floorViewOf(*registered, *CameraModel::create(registered->intrinsics), m_pixels);
            m_verdict->showVerdict(*registered);
        } else {
            // Why none was found says which one to mark, where the others follow from it.
            const auto &notFound = m_image->notFound;
            m_verdict->showVerdict(
                shownWords(notFound && m_pixels.empty() ? notFound->why : registered.error().why),
                m_pixels.size() < 4
                    ? tr("Select a marker in the table and click its position. The click snaps "
                         "to what is near it, to a tenth of a pixel.")
                    : shownWords(registered.error().advice));
        }
    }
    m_canvas->setMarkers(m_pixels);
    m_canvas->setFloor(view, m_layout);
    m_undo->setEnabled(!m_before.empty());
    showTable();
    Q_EMIT completeChanged();
}

void MarkerPage::showTable()
{
    const int row = m_table->currentRow();
    const QSignalBlocker quiet(m_table);
    m_table->setRowCount(int(m_layout.markers.size()));
    QLocale locale; // two numbers beside one another: 3,000, 0 could be read as three
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const Marker &marker = m_layout.markers[std::size_t(i)];
        const bool seen = std::ranges::find(m_pixels, marker.label, &MarkerPixel::label) != m_pixels.end();
        const auto kind =
            std::ranges::find(m_kinds, marker.label, [](const auto &each) { return each.first; });
        QString error;
        if (m_registration) {
            const auto found = std::ranges::find(m_registration->markers, marker.label, &MarkerError::label);
            if (found != m_registration->markers.end())
                error = tr("%1 mm").arg(locale.toString(toMillimetres(found->errorM), 'f', 1));
        }
        const QString texts[] = {
            QString::fromStdString(marker.label),
            tr("%1, %2").arg(locale.toString(toMillimetres(marker.pointInWorld.x()), 'f', 0),
                             locale.toString(toMillimetres(marker.pointInWorld.y()), 'f', 0)),
            !seen                   ? tr("not visible")
            : kind == m_kinds.end() ? tr("found")
                                    : kind->second,
            error};
        for (int column = 0; column < MarkerColumn::Count; ++column)
            m_table->setItem(i, column, new QTableWidgetItem(texts[column]));
    }
    for (int column = 0; column + 1 < MarkerColumn::Count; ++column) // the last takes what is left
        m_table->resizeColumnToContents(column);
    if (row >= 0 && row < m_table->rowCount())
        m_table->selectRow(row);
    m_canvas->setCurrent(currentLabel());
    m_remove->setEnabled(std::ranges::find(m_pixels, currentLabel().toStdString(), &MarkerPixel::label) !=
                         m_pixels.end());
}

RegistrationVerdict::RegistrationVerdict(QWidget *parent)
    : Card(tr("Camera position"), parent), m_verdict(new QLabel), m_advice(new QLabel)
{
    showAsVerdict(*m_verdict, *m_advice);
    m_verdict->setAccessibleName(tr("Verdict"));
    auto *said = new QWidget;
    auto *layout = new QVBoxLayout(said);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->addWidget(m_verdict);
    layout->addWidget(m_advice);
    layout->addStretch(1);
    setContent(said);
}

void RegistrationVerdict::showVerdict(const FloorRegistration &registration)
{
    const Eigen::Vector3d &at = registration.worldFromCamera.translation;
    const QLocale locale;
    showVerdict(shownWords(registration.verdict),
                tr("Camera position: x %1 m, y %2 m, %3 m above the floor.")
                    .arg(locale.toString(at.x(), 'f', 2), locale.toString(at.y(), 'f', 2),
                         locale.toString(at.z(), 'f', 2)));
}

void RegistrationVerdict::showVerdict(const QString &verdict, const QString &advice)
{
    m_verdict->setText(verdict);
    m_advice->setText(advice);
}

void RegistrationVerdict::reportNotSaved(const Error &error)
{
    m_advice->setText(tr("The registration was not stored. %1").arg(errorLine(error)));
}

} // namespace odo
