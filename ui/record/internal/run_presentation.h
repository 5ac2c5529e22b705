// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/internal/run_results.h"
#include "ui/views/present/present_source.h"

#include <vector>

namespace odo {

class LiveBoard;
class RunCard;

/// The run of Record for a presentation: who is up with the speeds now, and what the run gave, until the next
/// one begins. GUI thread.
class RunPresentation : public PresentSource
{
    Q_OBJECT
public:
    /// Both must outlive it.
    RunPresentation(LiveBoard &board, const RunCard &card, QObject *parent = nullptr);
    /// That of the card begins.
    void begin();
    /// From now on whoever is next is on the card; this run stays until that one begins.
    void end() { m_hasEnded = true; }
    void setResults(const std::vector<RunResultCard::Result> &results);
    QWidget *makeMap() override;
    PresentedRun run() const override;
    QString speed(std::size_t robot) const override;

private:
    PresentedRun lineUp() const;

    LiveBoard &m_board;
    const RunCard &m_card;
    bool m_hasEnded = false;
    PresentedRun m_last; ///< the one that began last
};

} // namespace odo
