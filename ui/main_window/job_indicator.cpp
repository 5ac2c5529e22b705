// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/job_indicator.h"

#include "ui/views/elided_label.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace odo {
namespace {
constexpr int steps = 1000;
constexpr int progressWidth = 180;
constexpr int textWidth = 320;
} // namespace

JobIndicator::JobIndicator(QWidget *parent)
    : QWidget(parent), m_text(new ElidedLabel(this)), m_bar(new QProgressBar(this)),
      m_cancel(new QPushButton(tr("Cancel"), this))
{
    m_text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_text->setFixedWidth(textWidth);
    m_bar->setRange(0, steps);
    m_bar->setFixedWidth(progressWidth);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Progress"));
    m_cancel->setAccessibleName(tr("Cancel the running job"));
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_cancel->setEnabled(false);
        m_text->setFullText(tr("Stopping…"));
        Q_EMIT cancelRequested();
    });
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 1, 6, 1);
    layout->addWidget(m_text);
    layout->addWidget(m_bar);
    layout->addWidget(m_cancel);
    hide();
}

void JobIndicator::begin(const QString &text)
{
    m_cancel->setEnabled(true);
    m_bar->setValue(0);
    m_text->setFullText(text);
    show();
}

void JobIndicator::setProgress(double fraction, const QString &text)
{
    m_bar->setValue(static_cast<int>(fraction * steps));
    if (m_cancel->isEnabled()) // once stopping was asked for, that is what there is to say
        m_text->setFullText(text);
}

void JobIndicator::end()
{
    hide();
}

QString JobIndicator::text() const
{
    return m_text->fullText();
}

} // namespace odo
