// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace odo::test {

namespace {

std::map<std::string, RunTest> &registered()
{
    static std::map<std::string, RunTest> tests;
    return tests;
}

} // namespace

RegisteredTest::RegisteredTest(const char *file, RunTest run)
{
    registered().emplace(std::filesystem::path(file).stem().string(), run);
}

} // namespace odo::test

int main(int argc, char **argv)
{
    const auto &tests = odo::test::registered();
    const bool isNamed = argc > 1 && tests.contains(argv[1]);
    const auto test = isNamed ? tests.find(argv[1]) : tests.size() == 1 ? tests.begin() : tests.end();
    if (test == tests.end()) {
        std::fprintf(stderr, "Name one test, then QtTest's arguments:\n");
        for (const auto &[name, run] : tests)
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    // settings and temporary files of its own
    QCoreApplication::setApplicationName(QString::fromStdString(test->first));
    return isNamed ? test->second(argc - 1, argv + 1) : test->second(argc, argv);
}
