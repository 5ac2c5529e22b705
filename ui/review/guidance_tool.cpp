// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/guidance_tool.h"

#include "core/tracking/searched_area.h"
#include "ui/models/timeline.h"
#include "ui/views/image/guidance_overlay.h"

#include <QAction>
#include <QApplication>
#include <QInputDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QSettings>

namespace odo {

namespace {

constexpr qsizetype fewestCorners = 3;

bool isAreaOf(const GuidanceItem &item, RecordId recording)
{
    return item.recording == recording &&
           (item.kind == GuidanceItem::Kind::Ignore || item.kind == GuidanceItem::Kind::Search);
}

} // namespace

GuidanceTool::GuidanceTool(Timeline &timeline, QObject *parent)
    : QObject(parent), m_timeline(timeline),
      m_ignore(add("ignoreArea", tr("&Ignore an area"),
                   tr("Draw an area of a view to ignore, such as a mirror or a screen: click its corners, "
                      "then press Enter"))),
      m_search(add("searchArea", tr("Search only an &area"),
                   tr("Draw the area of a view in which robots are searched: click its corners, then press "
                      "Enter"))),
      m_clear(add("clearGuidance", tr("&Remove all areas"), tr("Remove all areas of this trial")))
{
    for (QAction *action : {m_ignore, m_search}) {
        action->setCheckable(true);
        connect(action, &QAction::toggled, this,
                [this, action](bool isStarted) { begin(action, isStarted); });
    }
    m_ignore->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_P));
    connect(m_clear, &QAction::triggered, this, [this] {
        GuidanceEdit edit;
        edit.clearsAll = true;
        request(edit);
    });
    setScene(nullptr);
}

QAction *GuidanceTool::add(const char *name, const QString &text, const QString &toolTip)
{
    auto *action = new QAction(text, this);
    action->setObjectName(QString::fromLatin1(name));
    action->setToolTip(toolTip);
    return action;
}

QList<QAction *> GuidanceTool::actions() const
{
    return {m_ignore, m_search, m_clear};
}

void GuidanceTool::setScene(TrialScenePtr scene)
{
    giveUp();
    m_scene = std::move(scene);
    const bool isFilmed = m_scene && m_scene->imported.empty() && !m_scene->views.empty();
    m_ignore->setEnabled(isFilmed);
    m_search->setEnabled(isFilmed);
    m_clear->setEnabled(isFilmed && !m_scene->guidance.empty());
    Q_EMIT overlayChanged();
}

bool GuidanceTool::isDrawing() const
{
    return m_ignore->isChecked() || m_search->isChecked();
}

GuidanceItem::Kind GuidanceTool::kind() const
{
    return m_ignore->isChecked() ? GuidanceItem::Kind::Ignore : GuidanceItem::Kind::Search;
}

/// One of the two at a time. Keys are taken from the whole window while an area is drawn.
void GuidanceTool::begin(QAction *action, bool isStarted)
{
    m_corners.clear();
    m_mouse.reset();
    if (isStarted) {
        m_timeline.pause();
        (action == m_ignore ? m_search : m_ignore)->setChecked(false);
        qApp->installEventFilter(this);
    } else {
        qApp->removeEventFilter(this);
    }
    Q_EMIT drawingChanged(isDrawing());
    Q_EMIT overlayChanged();
}

void GuidanceTool::giveUp()
{
    m_ignore->setChecked(false);
    m_search->setChecked(false);
}

void GuidanceTool::addCorner(std::size_t view, const QPointF &pixel)
{
    if (view != m_view)
        m_corners.clear();
    m_view = view;
    m_corners << pixel;
    Q_EMIT overlayChanged();
}

void GuidanceTool::hover(std::size_t view, const std::optional<QPointF> &pixel)
{
    if (!isDrawing())
        return;
    m_mouse = view == m_view ? pixel : std::nullopt;
    Q_EMIT overlayChanged();
}

void GuidanceTool::finish()
{
    if (!isDrawing())
        return;
    GuidanceEdit edit;
    if (m_corners.size() >= fewestCorners && m_view < m_scene->views.size()) {
        GivenGuidance &area =
            edit.added.emplace_back(GivenGuidance{kind(), m_scene->views[m_view].camera, {}});
        for (const QPointF &corner : std::as_const(m_corners))
            area.pointsPx.emplace_back(corner.x(), corner.y());
    }
    giveUp();
    if (!edit.isEmpty())
        request(edit);
}

void GuidanceTool::request(const GuidanceEdit &edit)
{
    Q_EMIT requested(QString::fromStdString(m_scene->trial.name), edit);
}

void GuidanceTool::fill(QMenu &menu, std::size_t view, const QPointF &pixel)
{
    if (!m_scene || !m_scene->imported.empty() || view >= m_scene->views.size())
        return;
    fillByHand(menu, view, pixel);
    fillRemovals(menu, view);
    menu.addSeparator();
    fillAreas(menu, view, pixel);
}

void GuidanceTool::fillByHand(QMenu &menu, std::size_t view, const QPointF &pixel)
{
    for (const SceneRobot &one : m_scene->robots) {
        if (!one.analysis)
            continue;
        const std::string &robot = one.robot.name;
        const QString shown = QString::fromStdString(robot).replace(u'&', QStringLiteral("&&"));
        connect(menu.addAction(tr("Set %1 here by hand…").arg(shown)), &QAction::triggered, this,
                [this, robot, view, pixel] { setPoint(robot, view, pixel); });
        const auto &selection = m_timeline.selection();
        if (!selection)
            continue;
        GivenGuidance hidden{GuidanceItem::Kind::Hidden,  m_scene->views[view].camera, {}, robot,
                             toSeconds(selection->begin), toSeconds(selection->end)};
        connect(menu.addAction(tr("%1 is not visible here in the selected time").arg(shown)),
                &QAction::triggered, this, [this, hidden] { requestByHand(hidden); });
        hidden.view.clear();
        connect(menu.addAction(tr("%1 is not visible in any view in the selected time").arg(shown)),
                &QAction::triggered, this, [this, hidden] { requestByHand(hidden); });
    }
}

/// Of what was said of the frame shown.
void GuidanceTool::fillRemovals(QMenu &menu, std::size_t view)
{
    const auto frame = m_scene->frameAt(view, m_timeline.currentTime());
    for (const GuidanceItem &item : m_scene->guidance) {
        const bool isPoint = item.kind == GuidanceItem::Kind::Point;
        if ((!isPoint && item.kind != GuidanceItem::Kind::Hidden) || !frame ||
            item.recording != m_scene->views[view].recording.id || *frame < item.fromFrame ||
            *frame > item.toFrame)
            continue;
        connect(menu.addAction(isPoint ? tr("Remove the point set by hand") : tr("It is visible after all")),
                &QAction::triggered, this, [this, id = item.id] {
                    GuidanceEdit edit;
                    edit.removed = {id};
                    Q_EMIT byHandRequested(QString::fromStdString(m_scene->trial.name), edit);
                });
    }
}

void GuidanceTool::setPoint(const std::string &robot, std::size_t view, const QPointF &pixel)
{
    const QString sigmaKey = QStringLiteral("review/sigmaByHand");
    constexpr double usualPx = 2, leastPx = 0.1, mostPx = 100;
    bool isGiven = false;
    const double sigma = QInputDialog::getDouble(
        QApplication::activeWindow(), tr("Set a point by hand"), tr("Uncertainty σ of this point, pixels:"),
        QSettings().value(sigmaKey, usualPx).toDouble(), leastPx, mostPx, 1, &isGiven);
    if (!isGiven)
        return;
    QSettings().setValue(sigmaKey, sigma);
    const double timeS = toSeconds(m_timeline.currentTime());
    requestByHand({GuidanceItem::Kind::Point,
                   m_scene->views[view].camera,
                   {{pixel.x(), pixel.y()}},
                   robot,
                   timeS,
                   timeS,
                   sigma});
}

void GuidanceTool::requestByHand(const GivenGuidance &given)
{
    GuidanceEdit edit;
    edit.added = {given};
    Q_EMIT byHandRequested(QString::fromStdString(m_scene->trial.name), edit);
}

void GuidanceTool::fillAreas(QMenu &menu, std::size_t view, const QPointF &pixel)
{
    for (const GuidanceItem &item : m_scene->guidance) {
        if (!isAreaOf(item, m_scene->views[view].recording.id) ||
            !isWithin(item.pointsPx, {pixel.x(), pixel.y()}))
            continue;
        const QString text = item.kind == GuidanceItem::Kind::Ignore ? tr("Remove this ignored area")
                                                                     : tr("Remove this search area");
        connect(menu.addAction(text), &QAction::triggered, this, [this, id = item.id] {
            GuidanceEdit edit;
            edit.removed = {id};
            request(edit);
        });
    }
    menu.addSeparator();
    menu.addActions({m_ignore, m_search});
}

ImageOverlay GuidanceTool::overlay() const
{
    return [this](QPainter &painter, std::size_t view, std::int64_t frame, const ImageMap &map) {
        if (!m_scene || view >= m_scene->views.size())
            return;
        paintGuidance(painter, *m_scene, view, frame, map);
        if (isDrawing() && view == m_view)
            paintDrawnArea(painter, kind(), m_corners, m_mouse, map);
    };
}

bool GuidanceTool::eventFilter(QObject *watched, QEvent *event)
{
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (!isOverride && event->type() != QEvent::KeyPress)
        return QObject::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    if (key != Qt::Key_Escape && key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Backspace)
        return QObject::eventFilter(watched, event);
    event->accept(); // no shortcut takes it then
    if (isOverride)
        return true;
    if (key == Qt::Key_Escape) {
        giveUp();
    } else if (key == Qt::Key_Backspace) {
        if (!m_corners.isEmpty())
            m_corners.removeLast();
        Q_EMIT overlayChanged();
    } else {
        finish();
    }
    return true;
}

} // namespace odo
