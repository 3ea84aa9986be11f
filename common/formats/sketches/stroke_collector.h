// What every sketch reader does with points: collects them into strokes, keeps to the limit, warns of strokes
// that are too short, and says at the end whether anything is left.
#pragma once

#include "formats/sketch_file.h"
#include "formats/text/text_lines.h"

namespace ductus {

class StrokeCollector
{
public:
    StrokeCollector(const TextLines &lines, const SketchReadOptions &options, SketchFileKind kind);

    /// Starts a stroke at the current line; one that is under way is ended.
    void beginStroke();
    bool isInStroke() const { return mBeginLine > 0; }
    std::int64_t strokeBeginLine() const { return mBeginLine; }
    int strokePointCount() const { return int(mPoints.size()); }

    /// Adds to the stroke under way, or says TooLarge.
    std::optional<Error> addPoint(const Vec3 &point);

    /// Strokes of fewer than two points are dropped with a warning.
    void endStroke();

    /// A stroke that came about elsewhere. Its points are not counted against the limit.
    void addStroke(std::vector<Vec3> points);

    /// "hat.curves:12: text". After 50 warnings the rest is only counted.
    void warn(std::int64_t line, const std::string &text);

    /// The file as a value, or TooLittleData if no stroke is left. Takes the content out of the collector.
    Result<SketchFile> finish();

private:
    const TextLines &mLines;
    int mMaxPoints;
    SketchFile mFile;
    std::vector<Vec3> mPoints;
    std::int64_t mBeginLine = 0;
    std::int64_t mPointCount = 0;
    std::int64_t mWarningCount = 0;
};

/// The error every reader gives for more points than allowed, at the current line of \a lines.
Error tooManyPoints(const TextLines &lines, const std::string &found, int maxPoints);

} // namespace ductus
