// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/figure_panel.h"

#include <QBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <utility>

namespace odo {

namespace {

/// Words, and a plot beside them, or beneath them where it is narrow.
class FigureRow : public QWidget
{
public:
    FigureRow(QWidget *words, QWidget *plot) : m_layout(new QBoxLayout(QBoxLayout::TopToBottom, this))
    {
        m_layout->setContentsMargins(0, 0, 0, 0);
        m_layout->addWidget(words, 1);
        m_layout->addWidget(plot, 1);
    }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QWidget::resizeEvent(event);
        constexpr int leastForBoth = 440;
        m_layout->setDirection(width() < leastForBoth ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    }

private:
    QBoxLayout *m_layout;
};

} // namespace

FigurePanel::FigurePanel(const QString &title, const QString &name, const QString &none, Compute compute,
                         QWidget *parent)
    : Card(title, parent), m_none(none), m_compute(std::move(compute)), m_body(new QWidget)
{
    m_body->setObjectName(QStringLiteral("cardBody"));
    auto *layout = new QVBoxLayout(m_body);
    layout->setContentsMargins(10, 6, 10, 6);
    layout->setSpacing(4);
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setAccessibleName(name);
    scroll->setWidget(m_body);
    setContent(scroll);
    connect(&m_task, &BackgroundTask::finished, this, &FigurePanel::finish);
}

void FigurePanel::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_isStale = true;
    begin();
}

void FigurePanel::showEvent(QShowEvent *event)
{
    Card::showEvent(event);
    begin();
}

void FigurePanel::begin()
{
    if (!m_isStale || !isVisible() || m_task.isRunning()) // else it begins when that has ended
        return;
    m_isStale = false;
    m_made = std::make_shared<std::vector<Figure>>();
    m_task.start([made = m_made, scene = m_scene, compute = m_compute](const JobControl &) -> Result<void> {
        if (scene)
            *made = compute(*scene);
        return {};
    });
}

void FigurePanel::finish()
{
    if (m_isStale)
        return begin();
    showFigures();
    Q_EMIT settled();
}

void FigurePanel::showFigures()
{
    auto *layout = static_cast<QVBoxLayout *>(m_body->layout());
    while (QLayoutItem *item = layout->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    QStringList spoken;
    for (const Figure &figure : *m_made) {
        auto *words = new QLabel(figure.words());
        words->setTextFormat(Qt::PlainText);
        words->setWordWrap(true);
        words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        words->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        if (figure.plot)
            layout->addWidget(new FigureRow(words, figure.plot()), 1);
        else
            layout->addWidget(words);
        spoken << words->text();
    }
    if (m_made->empty())
        layout->addWidget(new QLabel(m_none), 0, Qt::AlignTop);
    setAccessibleDescription(spoken.join(u'\n'));
}

} // namespace odo
