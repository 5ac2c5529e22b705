// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

namespace odo::test {

/// How many times longer anything may take in a program that is watched by a sanitizer, on a machine that
/// does other things too. Included by tests that judge how long something takes; their QTRY_VERIFY waits
/// accordingly.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr int slowness = 40;
#undef QTRY_VERIFY
#define QTRY_VERIFY(expression) QTRY_VERIFY_WITH_TIMEOUT(expression, 5000 * odo::test::slowness)
#else
constexpr int slowness = 1;
#endif

} // namespace odo::test
