// The language an app speaks: the system's or the one chosen in the settings. English is the language of the
// sources, the others are made of translations/*.ts and are part of the program.
#pragma once

#include "document/settings/settings.h"

#include <QCoreApplication>
#include <QList>
#include <QString>
#include <QStringList>

namespace ductus {

struct Language
{
    QString code; // "fr"
    QString name; // in itself: "Français"
};

/// Those the suite speaks, English first.
const QList<Language> &languages();

/// What the user chose: a code, or "" for the system's.
inline const Setting<QString> chosenLanguage{"view/language", {}};

/// The code of the language to speak: \a chosen if it is one of languages(), else the first of \a wanted
/// (names as of QLocale::uiLanguages(), such as "de-AT") that is, else "en".
QString languageToSpeak(const QString &chosen, const QStringList &wanted);

/// Makes \a application speak \a code from now on: the texts of the shared window, those of \a program
/// ("layerpainter"; may be empty) and Qt's own. Windows that are there already keep their texts. Replaces
/// what an earlier call installed; false if a text file is missing, which leaves its texts in English.
bool speak(QCoreApplication &application, const QString &code, const QString &program);

/// Language and figures by \a settings and the system.
void speakAsChosen(QCoreApplication &application, const Settings &settings, const QString &program);

} // namespace ductus
