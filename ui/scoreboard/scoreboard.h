// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/school/hub_address.h"
#include "core/workflow/compare/trial_metrics.h"

#include <QHostAddress>
#include <QObject>
#include <QString>
#include <memory>

namespace odo {

class BoardSource;
class Project;

/// Which standings a page shows, and where it is served.
struct ScoreboardSettings
{
    /// What is empty in it is chosen at each reading: the task of the newest trial that has one, the metric
    /// as readStandings() does.
    StandingsChoice choice;
    QHostAddress address{QHostAddress::LocalHost};
    quint16 port = 8080; ///< 0: any that is free
};

/// The standings of a project or of a school's hub as a web page that follows it: a change is on the page
/// within a second. It only reads, through a connection of its own, and shows the names of teams, classes and
/// tasks alone. On the thread that made it, which needs an event loop.
class Scoreboard : public QObject
{
    Q_OBJECT
public:
    /// Reads the project and begins to listen. Errors: those of readStandings(); Unavailable or NotFound,
    /// with what to do, where the port or the address cannot be had.
    static Result<std::unique_ptr<Scoreboard>> start(std::unique_ptr<Project> project,
                                                     const ScoreboardSettings &settings);
    /// The same of a hub; any of its roles will do. While the hub is away the page says so and keeps the last
    /// standings. Errors: those of HubResults, and of the port as above.
    static Result<std::unique_ptr<Scoreboard>> start(const HubAddress &hub,
                                                     const ScoreboardSettings &settings);
    ~Scoreboard() override;

    QHostAddress address() const;
    quint16 port() const;
    /// What others open: where it listens on all addresses, by the first one of this computer.
    QString url() const;
    /// What is shown now, with what was chosen.
    const StandingsChoice &choice() const;

Q_SIGNALS:
    /// The project's file is gone. Nothing more is shown.
    void ended(const odo::Error &error);

private:
    struct Parts;
    explicit Scoreboard(std::unique_ptr<Parts> parts);
    static Result<std::unique_ptr<Scoreboard>> serve(std::unique_ptr<BoardSource> source,
                                                     const ScoreboardSettings &settings);
    void publish();

    const std::unique_ptr<Parts> m_parts;
};

} // namespace odo
