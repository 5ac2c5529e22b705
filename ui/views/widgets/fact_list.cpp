// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/fact_list.h"

#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/models/verdict_mark.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

class ExplanationDialogWords
{
    Q_DECLARE_TR_FUNCTIONS(ExplanationDialog)
};

constexpr QSize usualSize(480, 420);

} // namespace

QString howComputedWords()
{
    return ExplanationDialogWords::tr("How was this computed?");
}

void showExplanation(QWidget *parent, const Explanation &explanation)
{
    auto *dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("explanation"));
    dialog->setWindowTitle(howComputedWords());
    auto *text = new QPlainTextEdit(explanation.text());
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setAccessibleName(howComputedWords());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton *copy = buttons->addButton(ExplanationDialogWords::tr("&Copy"), QDialogButtonBox::ActionRole);
    QObject::connect(copy, &QPushButton::clicked, dialog,
                     [words = explanation.text()] { QApplication::clipboard()->setText(words); });
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(usualSize);
    dialog->show();
}

namespace {

constexpr int rowMargin = 5;

void empty(QGridLayout *layout)
{
    while (QLayoutItem *item = layout->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

QToolButton *howButton(const Fact &fact, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setText(QStringLiteral("?"));
    button->setProperty("flat", true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolTip(howComputedWords());
    button->setAccessibleName(QStringLiteral("%1: %2").arg(fact.name, howComputedWords()));
    QObject::connect(button, &QToolButton::clicked, button,
                     [button, how = *fact.how] { showExplanation(button->window(), how); });
    return button;
}

} // namespace

FactList::FactList(Badges badges) : m_badges(badges), m_layout(new QGridLayout(this))
{
    m_layout->setContentsMargins(10, 0, 10, 0);
    m_layout->setHorizontalSpacing(14);
    m_layout->setVerticalSpacing(0);
    m_layout->setColumnStretch(1, 1);
}

void FactList::setFacts(const QList<Fact> &facts)
{
    empty(m_layout);
    m_widestName = 0;
    for (int row = 0; row < facts.size(); ++row) {
        addRow(row, facts.at(row));
        m_widestName = std::max(m_widestName, fontMetrics().horizontalAdvance(facts.at(row).name));
    }
    fitNames();
}

/// Names have one line each, but for long ones where their values would be left too little.
void FactList::fitNames()
{
    constexpr double share = 0.45;
    m_layout->setColumnMinimumWidth(0, std::min(m_widestName + 2, static_cast<int>(share * width())));
}

void FactList::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitNames();
}

QWidget *FactList::withBadgeBeneath(QLabel *value, const Fact &fact)
{
    auto *both = new QWidget(this);
    auto *layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, rowMargin + 2);
    layout->setSpacing(0);
    layout->addWidget(value);
    layout->addWidget(new BadgeLabel(fact.badge, both), 0, Qt::AlignLeft);
    if (!fact.action.isEmpty()) {
        auto *button = new QPushButton(fact.action, both);
        button->setObjectName(QStringLiteral("factAction"));
        button->setAccessibleName(QStringLiteral("%1: %2").arg(fact.name, fact.action));
        connect(button, &QPushButton::clicked, this, &FactList::actionRequested);
        layout->addSpacing(rowMargin);
        layout->addWidget(button, 0, Qt::AlignLeft);
    }
    return both;
}

void FactList::addRow(int row, const Fact &fact)
{
    auto *name = new QLabel(fact.name, this);
    name->setObjectName(QStringLiteral("quiet"));
    auto *value = new QLabel(breakable(fact.value), this);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAccessibleName(QStringLiteral("%1: %2").arg(fact.name, fact.value));
    for (QLabel *label : {name, value}) {
        label->setTextFormat(Qt::PlainText);
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->setContentsMargins(0, rowMargin, 0, rowMargin + 1);
        label->setWordWrap(true);
    }
    m_layout->addWidget(name, row, 0);
    const bool hasBadge = !fact.badge.text.isEmpty(), isBeside = hasBadge && m_badges == Badges::Beside;
    m_layout->addWidget(hasBadge && !isBeside ? withBadgeBeneath(value, fact) : value, row, 1, 1,
                        isBeside || fact.how ? 1 : 2);
    if (fact.how)
        m_layout->addWidget(howButton(fact, this), row, 2, Qt::AlignRight | Qt::AlignTop);
    if (isBeside)
        m_layout->addWidget(new BadgeLabel(fact.badge, this), row, 2, Qt::AlignRight | Qt::AlignVCenter);
}

void FactList::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(ThemeColours::of(palette()).grid);
    for (int row = 0; row < m_layout->rowCount(); ++row)
        if (const QLayoutItem *value = m_layout->itemAtPosition(row, 1))
            painter.drawLine(0, value->geometry().bottom(), width(), value->geometry().bottom());
}

QScrollArea *scrolled(FactList *facts, const QString &accessibleName)
{
    auto *body = new QWidget;
    body->setObjectName(QStringLiteral("cardBody"));
    auto *layout = new QVBoxLayout(body);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(facts);
    layout->addStretch(1);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setAccessibleName(accessibleName);
    scroll->setWidget(body);
    return scroll;
}

namespace {

constexpr int columnCount = 2;
constexpr int metricPadding = 10;

} // namespace

MetricGrid::MetricGrid(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    setAccessibleName(tr("Metrics"));
}

void MetricGrid::setMetrics(std::vector<NamedMetric> named)
{
    m_metrics = std::move(named);
    m_current = 0;
    QStringList words;
    for (const NamedMetric &each : m_metrics)
        words += QStringLiteral("%1: %2").arg(each.name, each.number.text());
    setAccessibleDescription(words.join(QStringLiteral("; ")));
    updateGeometry();
    update();
}

void MetricGrid::setChoosable(const QString &toolTip)
{
    m_isChoosable = true;
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setToolTip(toolTip);
}

QRect MetricGrid::cellOf(std::size_t index) const
{
    const int row = static_cast<int>(index) / columnCount, column = static_cast<int>(index) % columnCount;
    const int cellWidth = width() / columnCount;
    return {column * cellWidth, row * rowHeight(), cellWidth, rowHeight()};
}

bool MetricGrid::wants(const QKeyEvent &event) const
{
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        return m_isChoosable && !m_metrics.empty() && event.modifiers() == Qt::NoModifier;
    default:
        return false;
    }
}

bool MetricGrid::event(QEvent *event)
{
    // Before the time line, whose keys some of these are.
    if (event->type() == QEvent::ShortcutOverride && wants(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void MetricGrid::keyPressEvent(QKeyEvent *event)
{
    if (!wants(*event)) {
        QWidget::keyPressEvent(event);
        return;
    }
    const auto move = [this](int by) {
        const int wanted = static_cast<int>(m_current) + by;
        if (wanted >= 0 && wanted < static_cast<int>(m_metrics.size()))
            m_current = static_cast<std::size_t>(wanted);
        update();
    };
    switch (event->key()) {
    case Qt::Key_Left:
        return move(-1);
    case Qt::Key_Right:
        return move(1);
    case Qt::Key_Up:
        return move(-columnCount);
    case Qt::Key_Down:
        return move(columnCount);
    default:
        Q_EMIT chosen(m_current);
    }
}

void MetricGrid::mouseReleaseEvent(QMouseEvent *event)
{
    for (std::size_t i = 0; m_isChoosable && event->button() == Qt::LeftButton && i < m_metrics.size(); ++i)
        if (cellOf(i).contains(event->position().toPoint())) {
            m_current = i;
            update();
            Q_EMIT chosen(i);
            return;
        }
}

int MetricGrid::rowCount() const
{
    return std::max(1, (static_cast<int>(m_metrics.size()) + columnCount - 1) / columnCount);
}

QFont MetricGrid::valueFont() const
{
    QFont large = font();
    large.setPointSizeF(font().pointSizeF() * 1.55);
    return large;
}

int MetricGrid::rowHeight() const
{
    return metricPadding + fontMetrics().height() + QFontMetrics(valueFont()).height() + metricPadding - 4;
}

QSize MetricGrid::sizeHint() const
{
    return {columnCount * fontMetrics().averageCharWidth() * 24, rowCount() * rowHeight()};
}

QSize MetricGrid::minimumSizeHint() const
{
    return {columnCount * fontMetrics().averageCharWidth() * 18, rowCount() * rowHeight()};
}

QFont MetricGrid::fittingFont(const QString &text, int width) const
{
    // A value must never lose its end; it shrinks instead.
    const double natural = QFontMetricsF(font()).horizontalAdvance(text);
    QFont fitting = font();
    if (natural > width && width > 0)
        fitting.setPointSizeF(font().pointSizeF() * std::max(0.6, width / natural));
    return fitting;
}

void MetricGrid::paintMetric(QPainter &painter, const NamedMetric &metric, const QRect &cell) const
{
    const ThemeColours colours = ThemeColours::of(palette());
    const QRect inner = cell.adjusted(metricPadding, metricPadding - 2, -4, 0);
    painter.setFont(font());
    painter.setPen(colours.muted);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop,
                     fontMetrics().elidedText(metric.name, Qt::ElideRight, inner.width()));
    const QFont large = valueFont();
    const QFontMetrics largeMetrics(large);
    const int baseline = inner.top() + fontMetrics().height() + largeMetrics.ascent();
    painter.setFont(large);
    painter.setPen(colours.text);
    painter.drawText(inner.left(), baseline, metric.number.value);
    const int left = inner.left() + largeMetrics.horizontalAdvance(metric.number.value) + 6;
    painter.setPen(colours.muted);
    painter.setFont(fittingFont(metric.number.smallPrint(), inner.right() - left));
    painter.drawText(left, baseline, metric.number.smallPrint());
}

void MetricGrid::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    if (m_metrics.empty()) {
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(metricPadding, 0, -metricPadding, 0),
                         Qt::AlignCenter | Qt::TextWordWrap, tr("No result yet: track the trial"));
        return;
    }
    const int height = rowHeight(), columnWidth = width() / columnCount;
    for (std::size_t i = 0; i < m_metrics.size(); ++i)
        paintMetric(painter, m_metrics[i], cellOf(i));
    for (int row = 1; row < rowCount(); ++row)
        painter.fillRect(0, row * height, width(), 1, colours.border);
    painter.fillRect(columnWidth, 0, 1, rowCount() * height, colours.border);
    if (hasFocus() && m_isChoosable) {
        painter.setPen(QPen(colours.accent, 2));
        painter.drawRect(cellOf(m_current).adjusted(2, 2, -2, -2));
    }
}

namespace {
constexpr std::size_t shownMetrics = 6;
}

ResultPanel::ResultPanel(QWidget *parent)
    : Card(tr("Result"), parent), m_grid(new MetricGrid(this)), m_robots(new QComboBox(this))
{
    setContent(m_grid);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_robots->setAccessibleName(tr("Robot whose result is shown"));
    m_robots->hide();
    addToHeader(m_robots);
    connect(m_robots, &QComboBox::currentIndexChanged, this, &ResultPanel::showRobot);
    m_grid->setChoosable(howComputedWords());
    connect(m_grid, &MetricGrid::chosen, this, [this](std::size_t index) {
        const std::size_t scored = m_score ? 1 : 0; // the score comes first
        showExplanation(window(), index < scored
                                      ? explainScore(*m_score, analysisInputs(*m_scene, m_robot))
                                      : explainMetric(*m_scene, m_robot, m_shown.at(index - scored)));
    });
}

void ResultPanel::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    const QSignalBlocker blocked(m_robots);
    m_robots->clear();
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot)
        m_robots->addItem(QString::fromStdString(m_scene->robots[robot].robot.name));
    m_robots->setVisible(m_robots->count() > 1);
    const bool isSound = !m_scene || m_scene->verdict.level() == CheckLevel::Pass;
    setBadge(isSound ? Badge() : verdictBadge(m_scene->verdict));
    showRobot(m_robots->count() > 0 ? 0 : -1);
}

void ResultPanel::showRobot(int robot)
{
    const bool known = m_scene && robot >= 0 && robot < static_cast<int>(m_scene->robots.size());
    if (!known) {
        m_grid->setMetrics({});
        setRemark({});
        return;
    }
    const SceneRobot &shown = m_scene->robots[static_cast<std::size_t>(robot)];
    QStringList remark;
    if (!m_scene->trial.teamName.empty())
        remark += shownTeam(m_scene->trial);
    if (m_robots->count() == 1)
        remark += tr("robot “%1”").arg(QString::fromStdString(shown.robot.name));
    setRemark(remark.join(QStringLiteral(" · ")));
    std::vector<NamedMetric> named;
    m_robot = static_cast<std::size_t>(robot);
    m_score = scoreOf(*m_scene, m_robot);
    if (m_score)
        named.push_back({metricName("score"), scoreNumber(*m_score)});
    m_shown = shown.analysis
                  ? informativeMetrics(shown.analysis->profile.metrics, shownMetrics - named.size())
                  : std::vector<Metric>();
    for (const Metric &metric : m_shown)
        named.push_back({metricName(metric.name), metricNumber(metric)});
    m_grid->setMetrics(std::move(named));
}

} // namespace odo
