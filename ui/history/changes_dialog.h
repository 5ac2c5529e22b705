// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QDialog>
#include <vector>

namespace odo {

/// What was changed in the project and when, to be looked through; it cannot be altered.
class ChangesDialog : public QDialog
{
    Q_OBJECT
public:
    explicit ChangesDialog(std::vector<ChangeEntry> changes, QWidget *parent = nullptr);
};

} // namespace odo
