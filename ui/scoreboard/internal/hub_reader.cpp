// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/hub_reader.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <QTemporaryDir>
#include <utility>

namespace odo {

namespace {

/// A trial of the hub as a scene: by a project of its own for a moment, so it is read as any trial.
TrialScenePtr sceneOf(const HubTrial &trial)
{
    const QTemporaryDir folder;
    if (!folder.isValid())
        return {};
    const auto project =
        Project::create(folder.filePath(QStringLiteral("run.odo")).toStdString(), "Standings");
    if (!project)
        return {};
    const auto row = storeSchoolDocument(**project, trial.document, 0, trial.owner);
    if (!row)
        return {};
    const auto stored = (*project)->trials().get(*row);
    return stored ? loadTrialScene(**project, stored->name).value_or(TrialScenePtr()) : TrialScenePtr();
}

} // namespace

Message checkHubAddress()
{
    return ODO_TEXT("ui.check_hub", "check the address, the login in ~/.pgpass, and the network");
}

HubReader::HubReader(HubAddress address, StandingsChoice choice)
    : m_address(std::move(address)), m_choice(std::move(choice))
{
}

HubReader::~HubReader() = default;

Result<std::optional<BoardContent>> HubReader::readIfChanged()
{
    auto content = ask();
    if (content)
        return content;
    m_hub.reset();
    m_state.reset();
    Error error = content.error();
    if (error.code == ErrorCode::Unavailable)
        error.advice = checkHubAddress(); // the hub's own is for those who publish
    return tl::unexpected(std::move(error));
}

Result<std::optional<BoardContent>> HubReader::ask()
{
    if (!m_hub)
        m_hub = ODO_TRY(HubResults::connect(m_address));
    const auto state = ODO_TRY(m_hub->state()); // before what is read: what changes meanwhile shows later
    if (m_state == state)
        return std::nullopt;
    auto standings = ODO_TRY(m_hub->standings(m_choice));
    BoardContent content;
    content.reading = standings.reading;
    ODO_TRY(addBestRun(standings, content));
    m_state = state;
    return content;
}

Result<void> HubReader::addBestRun(const HubStandings &standings, BoardContent &content)
{
    const TeamStanding *team = nameBestRun(content);
    if (!team || !m_hub->mayReadTrials())
        return {};
    const TeamRun &run = team->bestRun();
    const std::string &robot = standings.robots.at(std::size_t(run.robot) - 1);
    const auto revision = ODO_TRY(m_hub->revisionOf(run.trial));
    return m_map.show(content, run.trial + '\n' + std::to_string(revision) + '\n' + robot, robot,
                      [&]() -> Result<TrialScenePtr> {
                          const auto trial = ODO_TRY(m_hub->trial(run.trial));
                          return trial ? sceneOf(*trial) : TrialScenePtr();
                      });
}

} // namespace odo
