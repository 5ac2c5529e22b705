// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/present/present_window.h"

#include "ui/views/present/present_source.h"
#include "ui/views/widgets/labels.h"

#include <QCloseEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

constexpr QSize usualPresentSize(1280, 720), leastPresentSize(480, 270);

void setHeight(QWidget &widget, double pixels, bool isBold = false)
{
    QFont font = widget.font();
    font.setPixelSize(std::max(9, static_cast<int>(pixels)));
    font.setBold(isBold);
    widget.setFont(font);
}

QLabel *plainLabel(const QString &text = {})
{
    auto *label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

PresentWindow::PresentWindow(QWidget &beside)
    : QWidget(&beside, Qt::Window), m_beside(beside), m_team(new ElidedLabel), m_more(new ElidedLabel),
      m_badge(new BadgeLabel({})), m_body(new QHBoxLayout), m_results(new QWidget),
      m_column(new QVBoxLayout(m_results))
{
    setObjectName(QStringLiteral("page"));
    setAttribute(Qt::WA_StyledBackground);
    setWindowTitle(tr("Presentation"));
    setMinimumSize(leastPresentSize);
    setFocusPolicy(Qt::StrongFocus); // not the map, whose frame would be seen
    m_team->setAccessibleName(tr("Team"));
    m_more->setAccessibleName(tr("Trial"));
    m_more->setObjectName(QStringLiteral("quiet"));
    m_more->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto *head = new QHBoxLayout;
    head->addWidget(m_team, 3);
    head->addWidget(m_badge);
    head->addWidget(m_more, 2);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_body->setSpacing(16);
    m_body->addWidget(m_results, 2);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 10, 16, 16);
    layout->addLayout(head);
    layout->addLayout(m_body, 1);
}

void PresentWindow::setSource(PresentSource *source)
{
    if (m_source)
        m_source->disconnect(this);
    m_source = source;
    delete m_map;
    m_map = nullptr;
    if (source) {
        m_map = source->makeMap();
        m_body->insertWidget(0, m_map, 3);
        connect(source, &PresentSource::changed, this, &PresentWindow::fill);
        connect(source, &PresentSource::moved, this, &PresentWindow::showSpeeds);
        connect(source, &QObject::destroyed, this, [this] { setSource(nullptr); });
    }
    fill();
}

bool PresentWindow::isSettled() const
{
    return !m_source || m_source->isSettled();
}

void PresentWindow::fill()
{
    delete m_results->layout();
    qDeleteAll(m_results->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly));
    m_column = new QVBoxLayout(m_results);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_robots.clear();
    const PresentedRun run = m_source ? m_source->run() : PresentedRun{};
    m_team->setFullText(run.team.isEmpty() && run.more.isEmpty() ? tr("No trial") : run.team);
    m_more->setFullText(run.more);
    m_badge->setBadge(run.badge);
    for (const PresentedRobot &robot : run.robots)
        addRobot(robot, run.robots.size() > 1);
    m_column->addStretch(1);
    fitType();
    showSpeeds();
}

void PresentWindow::addRobot(const PresentedRobot &robot, bool isNamed)
{
    RobotPart part{plainLabel(robot.name), plainLabel(), plainLabel(robot.unit), {}, {}};
    part.name->setVisible(isNamed);
    part.speed->setAccessibleName(tr("Speed now"));
    part.unit->setObjectName(QStringLiteral("quiet"));
    auto *now = new QHBoxLayout;
    now->addWidget(part.speed, 0, Qt::AlignBaseline);
    now->addWidget(part.unit, 1, Qt::AlignBaseline);
    auto *grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    for (const auto &[name, value] : robot.results) {
        auto *caption = plainLabel(name);
        caption->setObjectName(QStringLiteral("quiet"));
        caption->setWordWrap(true);
        const int row = grid->rowCount();
        grid->addWidget(caption, row, 0);
        auto *number = plainLabel(value);
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(number, row, 1);
        part.captions.push_back(caption);
        part.values.push_back(number);
    }
    if (!m_robots.empty())
        m_column->addSpacing(2 * m_column->spacing());
    m_column->addWidget(part.name);
    m_column->addLayout(now);
    m_column->addLayout(grid);
    m_robots.push_back(std::move(part));
}

void PresentWindow::showSpeeds()
{
    for (std::size_t robot = 0; m_source && robot < m_robots.size(); ++robot)
        m_robots[robot].speed->setText(m_source->speed(robot));
}

/// By the window's height, or less where it is narrow.
void PresentWindow::fitType()
{
    const double percent = std::min(height() / 100.0, width() / 178.0);
    const double share =
        m_robots.size() > 1 ? 1.6 / static_cast<double>(std::min<std::size_t>(3, m_robots.size())) : 1;
    setHeight(*m_team, 8 * percent, true);
    setHeight(*m_more, 4 * percent);
    setHeight(*m_badge, 3 * percent);
    if (m_map)
        setHeight(*m_map, 2.2 * percent);
    for (const RobotPart &part : m_robots) {
        setHeight(*part.name, 4 * percent, true);
        setHeight(*part.speed, 18 * percent * share, true);
        setHeight(*part.unit, 6 * percent * share);
        for (QLabel *caption : part.captions)
            setHeight(*caption, 3 * percent);
        for (QLabel *value : part.values)
            setHeight(*value, 4.5 * percent, true);
    }
}

void PresentWindow::present()
{
    const QScreen *own = m_beside.screen();
    const QList<QScreen *> screens = QGuiApplication::screens();
    const auto other = std::ranges::find_if(screens, [own](const QScreen *screen) { return screen != own; });
    if (other != screens.end()) {
        setGeometry((*other)->geometry());
        showFullScreen();
    } else {
        resize(usualPresentSize.boundedTo(own->availableSize()));
        show();
    }
    raise();
    activateWindow();
    setFocus();
}

void PresentWindow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitType();
}

void PresentWindow::keyPressEvent(QKeyEvent *event)
{
    const auto move = [this](PresentSource::Move how) {
        if (m_source)
            m_source->move(how);
    };
    switch (event->key()) {
    case Qt::Key_Escape:
        close();
        break;
    case Qt::Key_F11:
        isFullScreen() ? showNormal() : showFullScreen();
        break;
    case Qt::Key_Space:
        move(PresentSource::Move::Play);
        break;
    case Qt::Key_Left:
        move(PresentSource::Move::Back);
        break;
    case Qt::Key_Right:
        move(PresentSource::Move::Forward);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void PresentWindow::closeEvent(QCloseEvent *event)
{
    QWidget::closeEvent(event);
    Q_EMIT closed();
}

} // namespace odo
