// What the tests of every app's window in its languages share.
#pragma once

#include "widgets/language/language.h"
#include "widgets/pages/settings_dialog.h"
#include "widgets/testing/keyboard_walk.h"
#include "widgets/testing/text_walk.h"

#include <QApplication>
#include <QtTest>
#include <functional>

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

/// Called for every window that is shown, with its name in pictures and messages.
using Visit = std::function<void(QWidget &shown, const char *name)>;

/// The pages of the settings of \a window, which \a open opens.
inline void visitSettings(QWidget &window, const std::function<void()> &open, const Visit &visit)
{
    open();
    auto *settings = window.findChild<SettingsDialog *>();
    QVERIFY(settings);
    QVERIFY(QTest::qWaitForWindowExposed(settings));
    for (int page = 0; page < settings->pageCount(); ++page) {
        settings->showPage(page);
        QTest::qWait(0); // the page is laid out
        visit(*settings, qPrintable(QStringLiteral("settings-%1").arg(page)));
    }
    settings->close();
}

// Each of these makes an \a AppUnderTest and has \a visitAll(app, visit) show its windows one after the
// other. They give what is wrong, a line each; empty: nothing.

/// In the language \a code, of the app whose texts are named \a app.
template <typename AppUnderTest, typename VisitAll>
QString wrongInLanguage(const QString &code, const QString &app, const VisitAll &visitAll)
{
    if (!speak(*qApp, code, app))
        return QStringLiteral("the language is not there");
    AppUnderTest underTest;
    QStringList wrong;
    visitAll(underTest, [&](QWidget &shown, const char *name) {
        keepPicture(shown, QStringLiteral("%1-%2-%3").arg(app, code, QLatin1String(name)));
        const QString texts = wrongTexts(shown);
        if (!texts.isEmpty())
            wrong << QLatin1String(name) + QStringLiteral(":\n") + texts;
    });
    return wrong.join(QLatin1Char('\n'));
}

/// Texts no translator was asked for, but those \a named, which are the same in every language.
template <typename AppUnderTest, typename VisitAll>
QString untranslated(const QStringList &named, const VisitAll &visitAll)
{
    MarkingTranslator marks;
    QCoreApplication::installTranslator(&marks);
    AppUnderTest underTest;
    QStringList plain;
    visitAll(underTest, [&](QWidget &shown, const char *name) {
        for (const QString &text : unmarkedTexts(shown, named))
            plain << QLatin1String(name) + QStringLiteral(": ") + text;
    });
    QCoreApplication::removeTranslator(&marks);
    plain.removeDuplicates();
    return plain.join(QLatin1Char('\n'));
}

/// What Tab does not reach, or has no name.
template <typename AppUnderTest, typename VisitAll>
QString outOfReach(const VisitAll &visitAll)
{
    AppUnderTest underTest;
    QStringList wrong;
    visitAll(underTest, [&](QWidget &shown, const char *name) {
        for (const QString &problem : walkByKeyboard(shown).problems)
            wrong << QLatin1String(name) + QStringLiteral(": ") + problem;
    });
    return wrong.join(QLatin1Char('\n'));
}

} // namespace ductus::testing
