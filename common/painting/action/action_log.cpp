#include "painting/action/action_log.h"

#include "base/sha256.h"
#include "painting/action/action_json.h"
#include "painting/storage/painting_content.h"

namespace ductus {

namespace {

constexpr char attempted[] = "Playing the action log";
constexpr std::size_t maxPath = 4096;

std::string placeOf(const std::string &name, std::size_t line)
{
    return name + ":" + std::to_string(line + 1);
}

struct EventWriter
{
    OrderedJson operator()(const LogStart &start) const
    {
        OrderedJson parameters = OrderedJson::object();
        if (!start.source.empty())
            parameters = {{"source", start.source}, {"sha256", start.sha256}};
        return {{"action", "start"}, {"objects", OrderedJson::object()}, {"parameters", parameters}};
    }
    OrderedJson operator()(const LogUndo &) const { return bare("undo"); }
    OrderedJson operator()(const LogRedo &) const { return bare("redo"); }
    OrderedJson operator()(const PaintingAction &action) const { return actionToJson(action); }

    static OrderedJson bare(const char *word)
    {
        return {{"action", word}, {"objects", OrderedJson::object()}, {"parameters", OrderedJson::object()}};
    }
};

LogEntry readEntry(const JsonReader &reader)
{
    LogEntry entry;
    if (reader.has("time"))
        entry.time = reader.string("time", 64);
    const std::string word = reader.string("action", 64);
    if (word == "start") {
        LogStart start;
        if (reader.has("parameters") && reader.member("parameters").has("source")) {
            start.source = reader.member("parameters").string("source", maxPath);
            start.sha256 = reader.member("parameters").string("sha256", 64);
        }
        entry.event = start;
    } else if (word == "undo") {
        entry.event = LogUndo();
    } else if (word == "redo") {
        entry.event = LogRedo();
    } else {
        entry.event = actionFromJson(reader);
    }
    if (reader.has("made")) {
        for (const std::uint64_t id : reader.unsignedIntegers("made", 10'000'000))
            entry.made.push_back(std::int32_t(std::min<std::uint64_t>(id, INT32_MAX)));
    }
    return entry;
}

class Player
{
public:
    explicit Player(const OpenSource &open) : mOpen(open) {}

    const Painting &painting() const { return mHistory[mPresent]; }

    Result<void> play(const LogEntry &entry)
    {
        mEntry = &entry;
        return std::visit([this](const auto &event) { return on(event); }, entry.event);
    }

private:
    static Error wrong(const char *problem, const char *remedy)
    {
        return {ErrorCode::InvalidArgument, attempted, problem, remedy, ""};
    }

    Result<void> on(const LogStart &start)
    {
        Painting begun;
        if (!start.source.empty()) {
            Result<Painting> opened = mOpen(start.source);
            if (!opened)
                return opened.error();
            if (!start.sha256.empty() && paintingFingerprint(*opened) != start.sha256)
                return wrong("the painting it started from has changed since",
                             "Give the file as it was with --start");
            begun = std::move(*opened);
        }
        mHistory = {std::move(begun)};
        mPresent = 0;
        return {};
    }

    Result<void> on(const LogUndo &)
    {
        if (mPresent == 0)
            return wrong("there is nothing to undo", "Remove the line");
        --mPresent;
        return {};
    }

    Result<void> on(const LogRedo &)
    {
        if (mPresent + 1 >= mHistory.size())
            return wrong("there is nothing to redo", "Remove the line");
        ++mPresent;
        return {};
    }

    Result<void> on(const PaintingAction &action)
    {
        Result<PerformedAction> result = performed(painting(), action);
        if (!result)
            return result.error();
        if (!mEntry->made.empty() && mEntry->made != result->made)
            return wrong("its ids do not fit this painting",
                         "Start from the painting the log was made with, or remove the members \"made\"");
        mHistory.resize(mPresent + 1);
        mHistory.push_back(std::move(result->painting));
        ++mPresent;
        return {};
    }

    const OpenSource &mOpen;
    const LogEntry *mEntry = nullptr;
    std::vector<Painting> mHistory{Painting()};
    std::size_t mPresent = 0;
};

} // namespace

std::string paintingFingerprint(const Painting &painting)
{
    BufferPacker packer; // names buffers by their content
    return sha256Hex(asBytes(jsonText(PaintingContent(painting, {}).toJson(Uuid(), packer))));
}

std::string logLine(const LogEntry &entry)
{
    OrderedJson json = OrderedJson::object();
    if (!entry.time.empty())
        json["time"] = entry.time;
    json.update(std::visit(EventWriter(), entry.event));
    if (!entry.made.empty())
        json["made"] = entry.made;
    std::string text = jsonText(json, 0);
    text.pop_back(); // the end of the line
    return text;
}

Result<std::vector<LogEntry>> parsedLog(std::string_view text, const std::string &name)
{
    std::vector<LogEntry> log;
    std::size_t number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty() && line.back() == '\r')
            line.pop_back();
        const std::string place = placeOf(name, number++);
        if (line.find_first_not_of(" \t") == std::string::npos) {
            continue;
        }
        const Result<JsonDocument> json = parsedJson(std::move(line), place);
        if (!json)
            return json.error();
        const JsonReader reader(*json, place);
        reader.expectObject();
        LogEntry entry = readEntry(reader);
        if (reader.failed()) {
            Error error = reader.error();
            error.attempted = "Reading the action log";
            return error;
        }
        log.push_back(std::move(entry));
    }
    return log;
}

Result<Painting> replayed(const std::vector<LogEntry> &log, const std::string &name, const OpenSource &open,
                          const JobControl &control, const AfterEntry &after)
{
    Player player(open);
    for (std::size_t i = 0; i < log.size(); ++i) {
        if (control.isCancelled())
            return cancelledError(attempted);
        control.progress(double(i) / double(log.size()), attempted);
        if (Result<void> played = player.play(log[i]); !played) {
            Error error = played.error();
            error.place = placeOf(name, i) + (error.place.empty() ? "" : " (" + error.place + ")");
            return error;
        }
        if (after && !after(i, player.painting()))
            break;
    }
    return player.painting();
}

} // namespace ductus
