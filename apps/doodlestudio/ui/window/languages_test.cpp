// DoodleStudio in each of its languages: nothing cut off, no key taken twice, nothing left untranslated; and
// everything within reach of the keyboard, with a name.
#include "doodlestudio/ui/film/export_dialog.h"
#include "doodlestudio/ui/testing/studio_under_test.h"
#include "widgets/testing/language_check.h"

using namespace ductus;
using namespace ductus::testing;

class LanguagesTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanup() { speak(*qApp, QStringLiteral("en"), {}); }
    void fitsEveryLanguage_data() { addLanguageRows(); }
    void fitsEveryLanguage();
    void everyTextIsTranslated();
    void keysReachEverything();

private:
    QTemporaryDir mCache;
};

namespace {

/// The window as it is at the start, at work, and its dialogs, one after the other.
void visitAll(StudioUnderTest &app, const Visit &visit)
{
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    visit(*app.window, "start");
    app.window->openSample(QStringLiteral("passing-box"));
    QTRY_VERIFY_WITH_TIMEOUT(!app.window->doodle().isEmpty(), 60'000);
    visit(*app.window, "clip");
    ExportDialog film(app.window->doodle(), app.jobs, app.window.get());
    film.show();
    visit(film, "export");
    film.close();
    visitSettings(
        *app.window, [&] { app.actions.action(QStringLiteral("edit.settings"))->trigger(); }, visit);
}

} // namespace

void LanguagesTest::initTestCase()
{
    qputenv("XDG_CACHE_HOME", mCache.path().toUtf8());
}

void LanguagesTest::fitsEveryLanguage()
{
    QFETCH(QString, code);
    QCOMPARE(wrongInLanguage<StudioUnderTest>(code, QStringLiteral("doodlestudio"), visitAll), QString());
}

void LanguagesTest::everyTextIsTranslated()
{
    QCOMPARE(untranslated<StudioUnderTest>({"DoodleStudio", "LayerPainter"}, visitAll), QString());
}

void LanguagesTest::keysReachEverything()
{
    QCOMPARE(outOfReach<StudioUnderTest>(visitAll), QString());
}

QTEST_MAIN(LanguagesTest)
#include "languages_test.moc"
