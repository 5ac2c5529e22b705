// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/board_options.h"

namespace odo {

QList<QCommandLineOption> boardOptions()
{
    return {{option::board, QStringLiteral("Inner corners; detected if not given."), QStringLiteral("CxR")},
            {option::square, QStringLiteral("Side of a square."), QStringLiteral("LENGTH")},
            {option::pattern, QStringLiteral("What is printed on the board; detected if not given."),
             QStringLiteral("PATTERN")}};
}

Result<BoardSpec> boardFrom(const CommandCall &call)
{
    BoardSpec board;
    if (call.isSet(option::board)) {
        const auto size = ODO_TRY(call.sizePair(option::board));
        board.columns = int(size.first);
        board.rows = int(size.second);
        if (board.columns < 3 || board.rows < 3 || board.columns > 100 || board.rows > 100)
            return call.wrongCall(
                ODO_TEXT("app.board_counts_corners", "--board counts inner corners, 3x3 to 100x100"));
    }
    if (call.isSet(option::square)) {
        board.squareM = ODO_TRY(call.lengthM(option::square));
    }
    const std::string patternName = call.value(option::pattern);
    if (patternName == "charuco")
        board.pattern = BoardPattern::Charuco;
    else if (patternName == "checkerboard")
        board.pattern = BoardPattern::Checkerboard;
    else if (call.isSet(option::pattern))
        return call.wrongCall(ODO_TEXT("app.pattern_is", "--pattern is checkerboard or charuco"));
    return board;
}

} // namespace odo
