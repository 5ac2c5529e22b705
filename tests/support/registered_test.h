// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTest>
#include <type_traits>

namespace odo::test {

/// Runs one test class with QtTest's own arguments, of which the first is the test's name.
using RunTest = int (*)(int argc, char **argv);

/// A test class of a folder's program, which runs the one that its first argument names.
class RegisteredTest
{
public:
    /// file: the source of the test, whose name without its ending is the test's.
    RegisteredTest(const char *file, RunTest run);
};

template <class Test, class Application>
int runTest(int argc, char **argv)
{
    Application application(argc, argv);
    if constexpr (!std::is_same_v<Application, QCoreApplication>)
        application.setAttribute(Qt::AA_Use96Dpi);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace odo::test

/// Makes a class the test of the file that says so, run by an application of the given class.
#define ODOGRAPH_TEST(Test, Application)                                                                     \
    static const odo::test::RegisteredTest registeredTest(__FILE__, odo::test::runTest<Test, Application>);
