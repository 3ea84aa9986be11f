#include "widgets/theme/theme.h"

#include "widgets/theme/style_sheet.h"

#include <QApplication>
#include <QFontDatabase>
#include <QStyle>
#include <QStyleFactory>

namespace ductus {

ThemeChoice themeChoice(const Settings &settings)
{
    const QString word = settings.value(themeSetting);
    if (word == QLatin1String("dark"))
        return ThemeChoice::Dark;
    return word == QLatin1String("light") ? ThemeChoice::Light : ThemeChoice::System;
}

void setThemeChoice(Settings &settings, ThemeChoice choice)
{
    switch (choice) {
    case ThemeChoice::System:
        settings.reset(themeSetting);
        break;
    case ThemeChoice::Dark:
        settings.set(themeSetting, QStringLiteral("dark"));
        break;
    case ThemeChoice::Light:
        settings.set(themeSetting, QStringLiteral("light"));
        break;
    }
}

bool isDark(ThemeChoice choice, const QPalette &systemPalette)
{
    if (choice != ThemeChoice::System)
        return choice == ThemeChoice::Dark;
    return systemPalette.color(QPalette::Window).lightness() < 128;
}

void dress(QApplication &application, const ThemeColours &colours)
{
    if (application.style()->objectName() != QLatin1String("fusion"))
        QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(qtPalette(colours));
    QApplication::setFont(baseFont());
    application.setStyleSheet(styleSheet(colours));
}

ThemeColours coloursOf(const QPalette &palette)
{
    const bool dark = palette.color(QPalette::Active, QPalette::Window).lightness() < 128;
    const QColor accent = palette.color(QPalette::Active, QPalette::LinkVisited);
    for (AppKind app : {AppKind::LayerPainter, AppKind::DoodleStudio}) {
        if (themeColours(dark, app).accent == accent)
            return themeColours(dark, app);
    }
    return themeColours(dark, AppKind::SketchSurfacer);
}

QFont baseFont()
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    // Without a desktop Qt says "Sans Serif", which is what fontconfig prefers; a point size of 9 on some.
    font.setPointSizeF(10.0);
    font.setStyleHint(QFont::SansSerif);
    return font;
}

QFont headingFont(const QFont &font)
{
    QFont heading = font;
    heading.setWeight(QFont::DemiBold);
    return heading;
}

} // namespace ductus
