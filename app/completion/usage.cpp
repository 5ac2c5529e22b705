// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/completion/usage.h"

#include <QRegularExpression>

namespace odo {

namespace {

/// "add P.odo NAME | list P.odo" in two.
QStringList alternatives(const QString &usage)
{
    QStringList parts(QString{});
    int depth = 0;
    for (const QString &word : usage.simplified().split(u' ')) {
        if (depth == 0 && word == u"|") {
            parts << QString();
            continue;
        }
        depth += int(word.count(u'[') + word.count(u'(') - word.count(u']') - word.count(u')'));
        parts.last() += word + u' ';
    }
    return parts;
}

/// Its words without brackets, each option a word of its own, and whether it may be given again.
QStringList wordsOf(QString form)
{
    form.replace(QStringLiteral("|--"), QStringLiteral(" --"));
    static const QRegularExpression brackets(QStringLiteral("[\\[\\]()]"));
    form.replace(QStringLiteral("[,...]"), QString()).remove(brackets);
    return form.split(u' ', Qt::SkipEmptyParts);
}

} // namespace

const QCommandLineOption *optionNamed(const CommandSyntax &syntax, const QString &name)
{
    const auto its = std::ranges::find_if(
        syntax.options, [&](const QCommandLineOption &option) { return option.names().contains(name); });
    return its == syntax.options.end() ? nullptr : &*its;
}

std::vector<UsageForm> usageForms(const CommandSyntax &syntax)
{
    std::vector<UsageForm> forms;
    for (const QString &alternative : alternatives(syntax.arguments)) {
        UsageForm form;
        QString expected; // the option whose value comes next
        for (QString word : wordsOf(alternative)) {
            const bool isRepeated = word.endsWith(QStringLiteral("..."));
            if (isRepeated)
                word.chop(3);
            if (!expected.isEmpty()) {
                form.valueForms.insert(expected, word);
                expected.clear();
            } else if (word.startsWith(u'-')) {
                const QString name = word.mid(word.startsWith(QStringLiteral("--")) ? 2 : 1);
                const QCommandLineOption *option = optionNamed(syntax, name);
                if (option && !option->valueName().isEmpty())
                    expected = option->names().constLast();
            } else if (!word.isEmpty() && word != u"|") {
                form.positionals << word;
                form.isLastRepeated = isRepeated;
            }
        }
        forms.push_back(std::move(form));
    }
    return forms;
}

} // namespace odo
