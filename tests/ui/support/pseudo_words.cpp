// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/pseudo_words.h"

#include "ui/views/widgets/labels.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTextDocumentFragment>
#include <QToolButton>

namespace odo::test {
namespace {

const QChar opening(0x27e6), closing(0x27e7);

QString positionOf(const QWidget &widget)
{
    QString place = QString::fromLatin1(widget.metaObject()->className());
    if (!widget.accessibleName().isEmpty())
        place += u' ' + widget.accessibleName().left(40);
    return place;
}

/// What is outside of all brackets.
QString outside(const QString &text)
{
    QString left;
    int depth = 0;
    for (const QChar c : text) {
        if (c == opening)
            ++depth;
        else if (c == closing)
            --depth;
        else if (depth == 0)
            left += c;
    }
    return left;
}

/// "Play (Space)" without the name of the key, which Qt translates.
QString withoutKeys(QString text)
{
    static const QRegularExpression between(QStringLiteral("\\(([^()]+)\\)"));
    qsizetype from = 0;
    for (auto match = between.match(text); match.hasMatch(); match = between.match(text, from)) {
        from = match.capturedStart() + 1;
        if (!QKeySequence(match.captured(1), QKeySequence::NativeText).toString().isEmpty())
            text.remove(match.capturedStart(), match.capturedLength());
    }
    return text;
}

bool isKnown(const QString &text, const QStringList &known)
{
    if (known.contains(text.trimmed()))
        return true;
    static const QRegularExpression word(QStringLiteral("\\p{L}[\\p{L}'-]*"));
    static const QRegularExpression date(QStringLiteral("\\b[0-9]{1,2} \\p{Lu}\\p{Ll}{2} [0-9]{4}\\b")),
        path(QStringLiteral("(^|\\s)/[^\\s]+"));
    QString left = withoutKeys(outside(text)).remove(date).remove(path);
    for (const QString &name : known) {
        left.replace(name, QStringLiteral(" "));
        if (const qsizetype elided = left.indexOf(u'…');
            elided >= 0 && name.endsWith(QStringView(left).mid(elided + 1)))
            left.truncate(elided); // a name whose middle was left out
    }
    auto each = word.globalMatch(left);
    while (each.hasNext())
        if (each.next().captured().size() > 2) // units have one or two letters
            return false;
    return true;
}

/// Every text of a widget, whether it is seen, spoken or shown on hovering.
QStringList textsOf(const QWidget &widget)
{
    QStringList texts{widget.accessibleName(), widget.accessibleDescription(), widget.toolTip()};
    if (widget.isWindow())
        texts << widget.windowTitle();
    if (const auto *label = qobject_cast<const ElidedLabel *>(&widget))
        texts << label->fullText();
    else if (const auto *plain = qobject_cast<const QLabel *>(&widget))
        texts << plain->text();
    else if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
        texts << button->text();
    else if (const auto *group = qobject_cast<const QGroupBox *>(&widget))
        texts << group->title();
    else if (const auto *line = qobject_cast<const QLineEdit *>(&widget))
        texts << line->placeholderText();
    else if (const auto *box = qobject_cast<const QComboBox *>(&widget))
        for (int i = 0; i < box->count(); ++i)
            texts << box->itemText(i);
    else if (const auto *tabs = qobject_cast<const QTabBar *>(&widget))
        for (int i = 0; i < tabs->count(); ++i)
            texts << tabs->tabText(i);
    else if (const auto *header = qobject_cast<const QHeaderView *>(&widget))
        for (int i = 0; header->model() && header->orientation() == Qt::Horizontal && i < header->count();
             ++i)
            texts << header->model()->headerData(i, Qt::Horizontal).toString();
    for (const QAction *action : widget.actions())
        texts << action->text() << action->toolTip();
    return texts;
}

int roomForText(const QComboBox &box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    option.frame = box.hasFrame();
    return box.style()
        ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
        .width();
}

} // namespace

QString PseudoWords::translate(const char *context, const char *source, const char *, int) const
{
    const QString words = QString::fromUtf8(source);
    if (QByteArrayView(context) == "base.foreign")
        return words; // what it holds stays English, and is told from what is translated
    const QString ellipsis = words.endsWith(u'…') ? QStringLiteral("…") : QString();
    return opening + words.chopped(ellipsis.size()) + closing + ellipsis;
}

QStringList untranslatedIn(const QWidget &window, const QStringList &known)
{
    QStringList found;
    QList<const QWidget *> widgets{&window};
    for (const auto *widget : window.findChildren<QWidget *>())
        widgets << widget;
    for (const QWidget *widget : widgets)
        for (const QString &text : textsOf(*widget)) {
            const QString plain =
                Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
            if (!isKnown(plain, known))
                found << positionOf(*widget) + QStringLiteral(": ") + plain;
        }
    found.removeDuplicates();
    return found;
}

QStringList cutOffIn(const QWidget &window)
{
    QStringList found;
    const auto note = [&found](const QWidget &widget, const QString &text, int wanted, int room) {
        if (wanted > room)
            found << QStringLiteral("%1 has %2 of %3 pixels: %4")
                         .arg(positionOf(widget))
                         .arg(room)
                         .arg(wanted)
                         .arg(text);
    };
    for (const auto *widget : window.findChildren<QWidget *>()) {
        if (!widget->isVisibleTo(&window))
            continue;
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const auto *tool = qobject_cast<const QToolButton *>(widget);
        const bool isSignAlone =
            tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
        if (button && !button->text().isEmpty() && !isSignAlone) {
            constexpr int edges = 4;
            const bool isBelow = tool && tool->toolButtonStyle() == Qt::ToolButtonTextUnderIcon;
            const int sign = button->icon().isNull() || isBelow ? 0 : button->iconSize().width();
            note(*widget, button->text(),
                 widget->fontMetrics().size(Qt::TextShowMnemonic, button->text()).width() + sign + edges,
                 widget->width());
        }
        if (const auto *box = qobject_cast<const QComboBox *>(widget))
            note(*widget, box->currentText(), widget->fontMetrics().horizontalAdvance(box->currentText()),
                 roomForText(*box));
        const auto *label = qobject_cast<const QLabel *>(widget);
        if (!label || label->text().isEmpty() || qobject_cast<const ElidedLabel *>(widget))
            continue;
        if (label->wordWrap())
            note(*widget, label->text() + QStringLiteral(" (its height)"),
                 label->heightForWidth(label->width()), label->height() + 1);
        else
            note(*widget, label->text(), label->sizeHint().width(), label->width());
    }
    found.removeDuplicates();
    return found;
}

} // namespace odo::test
