// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/range_card.h"

#include "ui/models/timeline.h"
#include "ui/review/range_facts.h"
#include "ui/views/fact_list.h"
#include "ui/views/profile_chart.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace odo {
namespace {
constexpr int noFit = -1;
}

RangeCard::RangeCard(Timeline &timeline, QWidget *parent)
    : Card(tr("Range"), parent), m_timeline(timeline), m_reporter(new RangeReporter(this)),
      m_robot(new QComboBox(this)), m_shape(new QComboBox), m_fitted(new QComboBox), m_facts(new FactList)
{
    makeChoices();
    auto *fit = new QHBoxLayout;
    fit->setContentsMargins(10, 8, 10, 4);
    fit->setSpacing(8);
    auto *name = new QLabel(tr("&Fit"));
    name->setBuddy(m_shape);
    fit->addWidget(name);
    fit->addWidget(m_shape, 1);
    fit->addWidget(m_fitted, 1);
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(fit);
    QScrollArea *scroll = scrolled(m_facts, tr("Figures of the range"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(scroll, 1);
    setContent(content);
    addToHeader(m_robot);
    setVisible(false);
    connect(&m_timeline, &Timeline::selectionChanged, this, &RangeCard::request);
    connect(m_reporter, &RangeReporter::reported, this, &RangeCard::show);
    for (QComboBox *choice : {m_robot, m_shape, m_fitted})
        connect(choice, &QComboBox::currentIndexChanged, this, &RangeCard::request);
}

void RangeCard::makeChoices()
{
    m_robot->setAccessibleName(tr("Robot whose range is shown"));
    m_robot->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_shape->setAccessibleName(tr("What is fitted to the curve"));
    m_shape->addItem(tr("none"), noFit);
    m_shape->addItem(tr("constant"), static_cast<int>(FitShape::Constant));
    m_shape->addItem(tr("straight line"), static_cast<int>(FitShape::Line));
    m_shape->addItem(tr("parabola"), static_cast<int>(FitShape::Parabola));
    m_fitted->setAccessibleName(tr("Quantity that is fitted"));
    for (QComboBox *choice : {m_shape, m_fitted})
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
}

void RangeCard::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    {
        const QSignalBlocker quiet(m_robot);
        m_robot->clear();
        for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot)
            if (m_scene->robots[robot].analysis)
                m_robot->addItem(QString::fromStdString(m_scene->robots[robot].robot.name), int(robot));
    }
    m_robot->setVisible(m_robot->count() > 1);
    request();
}

void RangeCard::setQuantities(const QList<Quantity> &quantities)
{
    m_quantities.clear();
    for (const Quantity quantity : quantities)
        if (!m_quantities.contains(quantity))
            m_quantities << quantity;
    {
        const QSignalBlocker quiet(m_fitted);
        const QVariant chosen = m_fitted->currentData();
        m_fitted->clear();
        for (const Quantity quantity : std::as_const(m_quantities))
            m_fitted->addItem(quantityName(quantity), static_cast<int>(quantity));
        m_fitted->setCurrentIndex(std::max(0, m_fitted->findData(chosen)));
    }
    request();
}

void RangeCard::request()
{
    if (!m_timeline.selection() || m_robot->count() == 0 || m_quantities.isEmpty()) {
        m_reporter->forget();
        setShown(false);
        Q_EMIT fitChanged(std::nullopt);
        return;
    }
    RangeRequest wanted{m_scene, static_cast<std::size_t>(m_robot->currentData().toInt()),
                        *m_timeline.selection(), m_quantities};
    wanted.fitted = static_cast<Quantity>(m_fitted->currentData().toInt());
    if (const int shape = m_shape->currentData().toInt(); shape != noFit)
        wanted.shape = static_cast<FitShape>(shape);
    m_fitted->setEnabled(wanted.shape.has_value());
    m_reporter->request(std::move(wanted));
    setShown(true);
}

void RangeCard::show(const RangeReport &report)
{
    if (report.request.scene != m_scene)
        return;
    m_facts->setFacts(fitFacts(report) + rangeFacts(report));
    std::optional<FitOverlay> overlay;
    if (report.fit && *report.fit)
        overlay = FitOverlay{report.request.robot, report.request.fitted, report.request.span, **report.fit};
    Q_EMIT fitChanged(overlay);
}

void RangeCard::setShown(bool isShown)
{
    if (isShown == isVisibleTo(parentWidget()))
        return;
    setVisible(isShown);
    Q_EMIT shownChanged(isShown);
}

} // namespace odo
