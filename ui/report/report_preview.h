// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/project_reader.h"
#include "ui/report/report_maker.h"

#include <QImage>
#include <QList>
#include <QScrollArea>

namespace odo {

/// The first pages of a report as they will be printed, one below the other, as wide as there is room. They are made
/// and painted on a thread of its own; what is overtaken by another report is not shown. Keys scroll. GUI thread.
class ReportPreview : public QScrollArea
{
    Q_OBJECT
public:
    static constexpr std::size_t mostPages = 12;

    /// projectFile: that must stay open meanwhile.
    explicit ReportPreview(std::filesystem::path projectFile, QWidget *parent = nullptr);
    ~ReportPreview() override; ///< waits for the page in work
    void show(const ReportMaker &maker);
    /// Shows nothing, and gives up what is being made.
    void clear();
    bool isSettled() const { return !m_reader.isRunning(); }
    const QList<QImage> &pictures() const { return m_pictures; }

Q_SIGNALS:
    /// The pages are there, or why there are none (empty: they are). isAll: there are no further ones.
    void made(const QString &failure, bool isAll);

private:
    class Sheets;
    struct Made
    {
        QList<QImage> pictures;
        bool isAll = true;
    };
    static Result<Made> make(Project &project, const ReportMaker &maker, const CancelToken &cancel);
    void take(Result<Made> made);

    CancelToken m_cancel; ///< of what is being made
    ProjectReader m_reader;
    QList<QImage> m_pictures;
    Sheets *m_sheets;
};

} // namespace odo
