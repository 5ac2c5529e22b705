// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/timeline_bar.h"

#include "ui/models/figure_text.h"
#include "ui/models/timeline.h"
#include "ui/views/theme.h"
#include "ui/views/time_slider.h"
#include "ui/views/transport_icon.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

namespace odo {

namespace {

constexpr double offeredRates[] = {0.1, 0.25, 0.5, 1, 2, 4, 8};

QString rateText(double rate)
{
    return QLocale().toString(rate, 'g', 3) + QChar(u'×');
}

} // namespace

TimelineBar::TimelineBar(Timeline &timeline, QWidget *parent)
    : QFrame(parent), m_timeline(timeline), m_first(new QToolButton(this)), m_play(new QToolButton(this)),
      m_last(new QToolButton(this)), m_time(new QLabel(this)), m_frame(new QLabel(this)),
      m_slider(new TimeSlider(timeline, this)), m_rate(new QComboBox(this))
{
    setAccessibleName(tr("Time line"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    makeButtons();
    m_time->setTextFormat(Qt::PlainText);
    m_frame->setTextFormat(Qt::PlainText);
    m_time->setAccessibleName(tr("Time"));
    m_frame->setAccessibleName(tr("Frame"));
    m_rate->setAccessibleName(tr("Speed of playing"));
    m_rate->setToolTip(tr("Speed of playing"));
    m_rate->setFocusPolicy(Qt::TabFocus); // Space goes on playing
    for (const double rate : offeredRates)
        m_rate->addItem(rateText(rate), rate);
    connect(m_rate, &QComboBox::activated, this,
            [this](int index) { m_timeline.setRate(m_rate->itemData(index).toDouble()); });

    auto *words = new QVBoxLayout;
    words->setSpacing(1);
    words->addStretch();
    words->addWidget(m_time);
    words->addWidget(m_frame);
    words->addStretch();
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 10, 14, 8);
    layout->setSpacing(10);
    for (QToolButton *button : {m_first, m_play, m_last})
        layout->addWidget(button);
    layout->addLayout(words);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_rate);

    connect(&m_timeline, &Timeline::currentChanged, this, &TimelineBar::showCurrent);
    connect(&m_timeline, &Timeline::rangeChanged, this, &TimelineBar::showCurrent);
    connect(&m_timeline, &Timeline::playingChanged, this, &TimelineBar::showPlaying);
    connect(&m_timeline, &Timeline::rateChanged, this, &TimelineBar::showRate);
    applyColours();
    showCurrent();
    showPlaying();
    showRate();
}

void TimelineBar::makeButtons()
{
    const auto join = [this](QToolButton *button, Timeline::Command command, const QString &name) {
        button->setAccessibleName(name);
        button->setToolTip(name);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setIconSize(QSize(16, 16));
        button->setFixedSize(button == m_play ? QSize(42, 34) : QSize(34, 34));
        QAction *action = m_timeline.action(command);
        connect(button, &QToolButton::clicked, action, &QAction::trigger);
        button->setEnabled(action->isEnabled());
        connect(action, &QAction::enabledChanged, button, &QWidget::setEnabled);
    };
    join(m_first, Timeline::Command::First, tr("To the first frame (Home)"));
    join(m_play, Timeline::Command::PlayPause, tr("Play (Space)"));
    join(m_last, Timeline::Command::Last, tr("To the last frame (End)"));
}

void TimelineBar::setScene(TrialScenePtr scene)
{
    m_slider->setScene(std::move(scene));
}

void TimelineBar::showCurrent()
{
    const qint64 count = m_timeline.frameCount();
    m_time->setText(timeCode(m_timeline.currentTime()));
    m_frame->setText(count == 0 ? tr("no frames")
                                : tr("frame %1 of %2").arg(m_timeline.currentFrame() + 1).arg(count));
    // Wide enough for the last frame, so that the slider does not move while playing.
    const QString widest = tr("frame %1 of %2").arg(count).arg(count);
    m_frame->setMinimumWidth(m_frame->fontMetrics().horizontalAdvance(widest) + 4);
}

void TimelineBar::showPlaying()
{
    const QString name = m_timeline.isPlaying() ? tr("Pause (Space)") : tr("Play (Space)");
    m_play->setAccessibleName(name);
    m_play->setToolTip(name);
    m_play->setIcon(transportIcon(m_timeline.isPlaying() ? TransportSign::Pause : TransportSign::Play,
                                  palette().color(QPalette::HighlightedText)));
}

void TimelineBar::showRate()
{
    const double rate = m_timeline.rate();
    const QSignalBlocker blocked(m_rate);
    int index = m_rate->findData(rate);
    // A rate that is not on offer (a shuttle backwards) stands as one more entry while it lasts.
    while (m_rate->count() > static_cast<int>(std::size(offeredRates)))
        m_rate->removeItem(m_rate->count() - 1);
    index = m_rate->findData(rate);
    if (index < 0) {
        m_rate->addItem(rateText(rate), rate);
        index = m_rate->count() - 1;
    }
    m_rate->setCurrentIndex(index);
}

void TimelineBar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setPen(QPen(colours.border, 1));
    painter.setBrush(colours.card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
}

void TimelineBar::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange)
        applyColours();
    QFrame::changeEvent(event);
}

void TimelineBar::applyColours()
{
    const ThemeColours colours = ThemeColours::of(palette());
    QPalette muted;
    muted.setColor(QPalette::WindowText, colours.muted);
    m_frame->setPalette(muted);
    const QString plain =
        QStringLiteral("QToolButton { background: %1; border: 1px solid %2; border-radius: 5px; }"
                       "QToolButton:hover { border-color: %3; }"
                       "QToolButton:focus { border: 2px solid %3; }")
            .arg(colours.card.name(), colours.border.name(), colours.accent.name());
    m_first->setStyleSheet(plain);
    m_last->setStyleSheet(plain);
    m_play->setStyleSheet(
        QStringLiteral("QToolButton { background: %1; border: 1px solid %1; border-radius: 5px; }"
                       "QToolButton:hover { background: %2; }"
                       "QToolButton:focus { border: 2px solid %3; }"
                       "QToolButton:disabled { background: %4; border-color: %4; }")
            .arg(colours.accent.name(), colours.accent.lighter(112).name(), colours.text.name(),
                 colours.border.name()));
    m_first->setIcon(transportIcon(TransportSign::First, colours.text));
    m_last->setIcon(transportIcon(TransportSign::Last, colours.text));
    showPlaying();
}

} // namespace odo
