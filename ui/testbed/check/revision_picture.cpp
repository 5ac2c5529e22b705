// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/revision_picture.h"

#include "core/video/picture.h"
#include "core/video/picture_reader.h"
#include "ui/views/screen_image.h"

namespace odo {

RevisionPicture::RevisionPicture(QWidget *parent) : MarkerCanvas(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents); // to look at
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Picture that it was made from"));
    connect(&m_task, &BackgroundTask::finished, this, &RevisionPicture::show);
}

QSize RevisionPicture::sizeHint() const { return minimumSizeHint(); }

void RevisionPicture::setRevision(const Revision &revision)
{
    m_revision = revision;
    setVisible(!revision.picture.empty());
    setMarkers({});
    setPicture({}, {});
    setEmptyText(tr("Reading the picture…"));
    read();
}

void RevisionPicture::read()
{
    if (m_revision.picture.empty() || m_task.isRunning())
        return;
    m_read = std::make_shared<Read>(Read{m_revision.picture, {}});
    m_task.start([read = m_read](const JobControl &) -> Result<void> {
        const auto picture = readPicture(read->file);
        if (!picture)
            return tl::unexpected(picture.error());
        read->image = toImage(toScreen(*picture, picture->format.width, picture->format.height));
        return {};
    });
}

void RevisionPicture::show(const std::optional<Error> &error)
{
    if (m_read->file != m_revision.picture) // another one was chosen meanwhile
        return read();
    if (error)
        return setEmptyText(tr("The picture cannot be read."));
    setPicture(m_read->image, m_read->image.size());
    setMarkers(m_revision.markers);
}

} // namespace odo
