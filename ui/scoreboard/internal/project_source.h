// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scoreboard/internal/board_source.h"

#include <QTimer>
#include <memory>

namespace odo {

/// The standings of a project, read at once and again when others change it. It ends when the file is moved
/// or deleted.
class ProjectSource : public BoardSource
{
    Q_OBJECT
public:
    ProjectSource(std::unique_ptr<Project> project, StandingsChoice choice);
    ~ProjectSource() override;
    Result<BoardContent> begin() override;

private:
    void follow();

    const std::unique_ptr<Project> m_project;
    BoardReader m_reader;
    BoardContent m_newest;
    bool m_withPseudonyms = false;
    QTimer m_timer;
};

} // namespace odo
