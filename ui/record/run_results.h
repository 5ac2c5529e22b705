// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/run_measuring.h"

namespace odo {

/// Has runs measured when they have ended, shows the figures of the last one on its card, and tells of each
/// in sentences. Lives on the project's thread; the card must outlive it.
class RunResults : public QObject
{
    Q_OBJECT
public:
    RunResults(Project &project, RunResultCard &card, QObject *parent = nullptr);

    /// A run has ended, as it was seen live; its recording is being completed.
    void takeEnded(const QString &trial, std::vector<LiveRun> runs, const std::optional<TaskRecord> &task);
    /// The recording is complete in the project.
    void takeRecorded(const QString &trial, const QStringList &warnings);
    /// There is no recording, and why.
    void takeGivenUp(const QString &trial, const Error &error);
    /// While somebody records, nothing is measured.
    void setRecording(bool recording) { m_measuring->setRecording(recording); }

Q_SIGNALS:
    void changed(const QString &words); ///< the project has a new trial, or new figures of one
    void failed(const odo::Error &error);

private:
    void show(const QString &trial, const std::vector<RunResultCard::Result> &results,
              RunResultCard::From from);
    void showFailure(const QString &trial, const QString &words);

    RunMeasuring *m_measuring;
    RunResultCard &m_card;
};

} // namespace odo
