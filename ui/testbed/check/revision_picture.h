// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/revisions.h"
#include "ui/models/background_task.h"
#include "ui/testbed/floor/marker_canvas.h"

namespace odo {

/// The picture that a calibration or registration was made from, with its markers; read on a thread of its own. Hidden where
/// none was kept.
class RevisionPicture : public MarkerCanvas
{
    Q_OBJECT
public:
    explicit RevisionPicture(QWidget *parent = nullptr);
    void setRevision(const Revision &revision);

    QSize sizeHint() const override;

private:
    void read();
    void show(const std::optional<Error> &error);

    Revision m_revision;
    struct Read
    {
        std::filesystem::path file;
        QImage image;
    };
    std::shared_ptr<Read> m_read; ///< that is being read, or was last
    BackgroundTask m_task;
};

} // namespace odo
