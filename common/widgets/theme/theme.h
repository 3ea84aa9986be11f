// Dressing an application: palette, Fusion with a small style sheet, base font. Follows the system or the
// user's choice. Widgets that paint themselves ask coloursOf(palette()).
#pragma once

#include "document/settings/settings.h"
#include "widgets/theme/palette.h"

class QApplication;
class QFont;

namespace ductus {

enum class ThemeChoice { System, Dark, Light };

/// "system", "dark" or "light".
inline const Setting<QString> themeSetting{"appearance/theme", "system"};

ThemeChoice themeChoice(const Settings &settings);
void setThemeChoice(Settings &settings, ThemeChoice choice);

/// Whether \a choice means dark now. To be asked with the palette the system gave before the first dress().
bool isDark(ThemeChoice choice, const QPalette &systemPalette);

/// Palette, style sheet and font for \a app.
void dress(QApplication &application, const ThemeColours &colours);

/// The colours \a palette was made of by qtPalette(); those of the nearest theme for other palettes.
ThemeColours coloursOf(const QPalette &palette);

/// 10 pt of the system's sans. Its figures are of one width in the fonts Debian has by default; Qt 6.4 cannot
/// ask for them.
QFont baseFont();

/// \a font in the weight of headings.
QFont headingFont(const QFont &font);

} // namespace ductus
