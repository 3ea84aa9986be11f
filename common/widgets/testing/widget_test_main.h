// main() for widget tests: without a display, in the dark theme, with the figures and dots of no particular
// language.
#pragma once

#include "widgets/theme/theme.h"

#include <QApplication>
#include <QtTest>

#define DUCTUS_WIDGET_TEST_MAIN(TestClass)                                                                   \
    int main(int argc, char *argv[])                                                                         \
    {                                                                                                        \
        qputenv("QT_QPA_PLATFORM", "offscreen");                                                             \
        QLocale::setDefault(QLocale::c());                                                                   \
        QApplication application(argc, argv);                                                                \
        ductus::dress(application, ductus::themeColours(true, ductus::AppKind::SketchSurfacer));             \
        TestClass test;                                                                                      \
        return QTest::qExec(&test, argc, argv);                                                              \
    }
