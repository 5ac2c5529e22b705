// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/image_file_filter.h"

#include "ui/views/widgets/form_fields.h"

namespace odo {

QString imageFileFilter()
{
    return PathField::tr(
        "Images and videos (*.png *.jpg *.jpeg *.heic *.heif *.hif *.webp *.tif *.tiff *.bmp *.mp4 "
        "*.mkv *.avi *.mov *.webm);;All files (*)");
}

} // namespace odo
