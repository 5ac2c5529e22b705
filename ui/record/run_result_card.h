// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/profile.h"
#include "ui/views/card.h"

#include <QList>
#include <vector>

class QLabel;
class QPushButton;

namespace odo {

class FigureGrid;

/// What a run gave, as soon as it has ended: first from what was seen live, then from the recording itself.
class RunResultCard : public Card
{
    Q_OBJECT
public:
    explicit RunResultCard(QWidget *parent = nullptr);

    /// The figures of one robot's run.
    struct Result
    {
        QString robot;
        std::vector<Metric> metrics;
        std::size_t spikes = 0;
    };
    enum class From { Live, Recording };
    void setWorking(const QString &trial);
    void setResults(const QString &trial, const std::vector<Result> &results, From from);
    /// No figures, and why.
    void setFailure(const QString &trial, const QString &words);

    QString words() const;
    QString trial() const { return m_trial; }

Q_SIGNALS:
    void openRequested(const QString &trial);

private:
    QString m_trial;
    FigureGrid *m_grid;
    QLabel *m_words;
    QPushButton *m_open;
};

} // namespace odo
