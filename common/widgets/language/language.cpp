#include "widgets/language/language.h"

#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace ductus {

namespace {

const QString english = QStringLiteral("en");

bool isSpoken(const QString &code)
{
    for (const Language &language : languages())
        if (language.code == code)
            return true;
    return false;
}

// Owned by the application and found there again: the next language takes its place.
bool install(QCoreApplication &application, const QString &part, const QString &file, const QString &folder)
{
    const QString name = QStringLiteral("ductus-translator-") + part;
    if (auto *earlier = application.findChild<QTranslator *>(name)) {
        QCoreApplication::removeTranslator(earlier);
        delete earlier;
    }
    if (file.isEmpty())
        return true;
    auto *translator = new QTranslator(&application);
    translator->setObjectName(name);
    if (!translator->load(file, folder)) {
        delete translator;
        return false;
    }
    return QCoreApplication::installTranslator(translator);
}

} // namespace

const QList<Language> &languages()
{
    static const QList<Language> all{{english, QStringLiteral("English")},
                                     {QStringLiteral("fr"), QStringLiteral("Français")},
                                     {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                     {QStringLiteral("es"), QStringLiteral("Español")},
                                     {QStringLiteral("ja"), QStringLiteral("日本語")}};
    return all;
}

QString languageToSpeak(const QString &chosen, const QStringList &wanted)
{
    if (isSpoken(chosen))
        return chosen;
    for (const QString &name : wanted) {
        const QString code = name.section(QLatin1Char('-'), 0, 0).section(QLatin1Char('_'), 0, 0);
        if (isSpoken(code))
            return code;
    }
    return english;
}

bool speak(QCoreApplication &application, const QString &code, const QString &program)
{
    const QString ours = QStringLiteral(":/ductus/translations");
    const auto file = [&](const QString &part) {
        // The sources are English; only their plural forms are written down.
        return part.isEmpty() ? QString() : part + QLatin1Char('_') + code;
    };
    const bool hasQt = install(application, QStringLiteral("qt"),
                               code == english ? QString() : file(QStringLiteral("qtbase")),
                               QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    const bool hasCommon =
        install(application, QStringLiteral("common"), file(QStringLiteral("common")), ours);
    const bool hasProgram = install(application, QStringLiteral("program"), file(program), ours);
    return hasQt && hasCommon && hasProgram;
}

void speakAsChosen(QCoreApplication &application, const Settings &settings, const QString &program)
{
    const QLocale system = QLocale::system();
    const QString code = languageToSpeak(settings.value(chosenLanguage), system.uiLanguages());
    if (!speak(application, code, program))
        qWarning("Some texts in the language \"%s\" are missing in this installation.", qPrintable(code));
    // Somebody who reads French on an English system expects French figures, too; a Swiss who reads German
    // keeps those of Switzerland.
    if (system.name().section(QLatin1Char('_'), 0, 0) != code && !settings.value(chosenLanguage).isEmpty())
        QLocale::setDefault(QLocale(code));
}

} // namespace ductus
