// What the tests of every app's window in its languages share.
#pragma once

#include "widgets/language/language.h"
#include "widgets/testing/keyboard_walk.h"
#include "widgets/testing/text_walk.h"

#include <QApplication>
#include <QtTest>

namespace ductus::testing {

/// A row for every language of the suite.
inline void addLanguageRows()
{
    QTest::addColumn<QString>("code");
    for (const Language &language : languages())
        QTest::newRow(qPrintable(language.code)) << language.code;
}

/// The words of what is wrong with the texts that \a window shows.
inline QString wrongTexts(QWidget &window)
{
    QStringList wrong = cutTexts(window);
    for (const QString &clash : clashingKeys(window))
        wrong << QStringLiteral("access key taken twice: ") + clash;
    return wrong.join(QLatin1Char('\n'));
}

/// A picture of \a window in the folder DUCTUS_SHOTS names, if it names one.
inline void keepPicture(QWidget &window, const QString &name)
{
    const QString folder = qEnvironmentVariable("DUCTUS_SHOTS");
    if (!folder.isEmpty())
        window.grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
}

} // namespace ductus::testing
