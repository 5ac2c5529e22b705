// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTranslator>

class QWidget;

namespace odo::test {

/// A language that nobody speaks: each word of the program comes out between ⟦ and ⟧.
/// What stands outside of the brackets was never given to a translator.
/// What a pattern of core's sentences holds stands outside of them: it is a name, or was to be found by a
/// pattern of its own.
class PseudoWords : public QTranslator
{
    Q_OBJECT
public:
    QString translate(const char *context, const char *source, const char *comment, int n) const override;
    bool isEmpty() const override { return false; }
};

/// What a window shows, or tells a screen reader, that no translator saw, with the widget it stands in.
/// known: names that a person gave and what else is the same in each language; numbers, units, keys, dates
/// and paths are. Longer names come before those that are in them.
QStringList untranslatedIn(const QWidget &window, const QStringList &known);

/// Labels and buttons whose words do not fit.
QStringList cutOffIn(const QWidget &window);

} // namespace odo::test
