#include "support/xr_runtime/script.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

namespace ductus::xr {

namespace {

std::optional<double> numberOf(const std::string &text)
{
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0')
        return std::nullopt;
    return value;
}

std::vector<double> valuesOf(const Pose &pose)
{
    const Eigen::Quaterniond &q = pose.orientation;
    return {pose.position.x(), pose.position.y(), pose.position.z(), q.x(), q.y(), q.z(), q.w()};
}

void setPose(Pose &pose, const std::vector<double> &v)
{
    pose.position = {v[0], v[1], v[2]};
    if (v.size() == 7)
        pose.orientation = Eigen::Quaterniond(v[6], v[3], v[4], v[5]).normalized();
}

} // namespace

Script::Script(std::filesystem::path file) : mFile(std::move(file))
{
    advance(0);
}

void Script::readNewLines()
{
    if (mFile.empty())
        return;
    std::ifstream stream(mFile, std::ios::binary);
    stream.seekg(std::streamoff(mRead));
    std::stringstream rest;
    rest << stream.rdbuf();
    const std::string text = rest.str();
    std::size_t begin = 0;
    // A line that is still being written waits for its end.
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
        add(text.substr(begin, end - begin));
    mRead += begin;
}

void Script::add(const std::string &text)
{
    std::istringstream words(text.substr(0, text.find('#')));
    Line line;
    line.from = line.to = mFrame;
    std::string word;
    if (!(words >> word))
        return;
    if (const auto frames = numberOf(word.substr(1)); word[0] == '+' && frames && *frames >= 0) {
        line.to = mFrame + std::int64_t(*frames);
        words >> line.word;
    } else if (std::isdigit(static_cast<unsigned char>(word[0]))) {
        const std::size_t dash = word.find('-');
        const auto from = numberOf(word.substr(0, dash));
        const auto to = dash == std::string::npos ? from : numberOf(word.substr(dash + 1));
        if (!from || !to || *to < *from || !(words >> line.word)) {
            mMistakes.push_back(text);
            return;
        }
        line.from = std::int64_t(*from);
        line.to = std::int64_t(*to);
    } else {
        line.word = word;
    }
    while (words >> word)
        line.arguments.push_back(word);
    mWaiting.push_back(std::move(line));
}

void Script::advance(std::int64_t frame)
{
    mFrame = frame;
    readNewLines();
    // In the order of the file: of two lines for one thing the later counts.
    for (Line &line : mWaiting)
        if (line.from <= frame)
            run(line, frame);
    std::erase_if(mWaiting, [&](const Line &line) { return line.to <= frame; });
}

std::optional<std::vector<double>> Script::numbersOf(const Line &line, std::size_t first) const
{
    std::vector<double> numbers;
    for (std::size_t i = first; i < line.arguments.size(); ++i) {
        const auto number = numberOf(line.arguments[i]);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

void Script::run(Line &line, std::int64_t frame)
{
    const double share =
        line.to == line.from ? 1 : std::min(1.0, double(frame - line.from) / double(line.to - line.from));
    if (!setValues(line, share) && !setOption(line)) {
        std::string text = line.word;
        for (const std::string &argument : line.arguments)
            text += " " + argument;
        mMistakes.push_back(text);
        line.to = line.from; // once is enough
    }
}

bool Script::setValues(Line &line, double share)
{
    const auto blend = [&](const std::vector<double> &now, const std::vector<double> &goal) {
        if (line.begin.empty())
            line.begin = now;
        std::vector<double> values = goal;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = line.begin[i] + share * (goal[i] - line.begin[i]);
        return values;
    };
    const bool isHead = line.word == "head", isLeft = line.word == "left";
    if (isHead || isLeft || line.word == "right") {
        Pose &pose = isHead ? mScene.head : mScene.hands[isLeft ? 0 : 1];
        const auto numbers = numbersOf(line, 0);
        if (!numbers || (numbers->size() != 3 && numbers->size() != 7))
            return false;
        setPose(pose, blend(valuesOf(pose), *numbers));
        return true;
    }
    if (line.word == "input") {
        const auto numbers = numbersOf(line, 1);
        if (!numbers || numbers->size() != 1)
            return false;
        double &value = mScene.inputs["/user/hand/" + line.arguments[0]];
        value = blend({value}, *numbers)[0];
        return true;
    }
    return false;
}

bool Script::setOption(const Line &line)
{
    const std::vector<std::string> &words = line.arguments;
    const std::string first = words.empty() ? "" : words[0];
    const auto number = [&](std::size_t i) { return i < words.size() ? numberOf(words[i]) : std::nullopt; };
    if (line.word == "tracked" && (first == "left" || first == "right") && number(1))
        mScene.tracked[first == "left" ? 0 : 1] = *number(1) != 0;
    else if (line.word == "state" && !first.empty())
        mOrders.push_back({Order::Kind::State, first});
    else if (line.word == "lose" && first == "session")
        mOrders.push_back({Order::Kind::LoseSession, first});
    else if (line.word == "lose" && first == "instance")
        mOrders.push_back({Order::Kind::LoseInstance, first});
    else if (line.word == "fail" && number(1))
        mOrders.push_back({Order::Kind::Fail, first, int(*number(1)), int(number(2).value_or(1))});
    else if (line.word == "profile" && !first.empty())
        mScene.profile = first;
    else if (line.word == "extensions")
        mScene.hasOpenGl = first != "none";
    else if (line.word == "headset" && number(0))
        mScene.hasHeadset = *number(0) != 0;
    else if (line.word == "stage" && number(0))
        mScene.hasStage = *number(0) != 0;
    else if (line.word == "pace" && number(0))
        mScene.paceMilliseconds = int(*number(0));
    else if (line.word == "dump" && !first.empty())
        mScene.dumpFolder = first == "off" ? "" : first;
    else if (line.word == "size" && number(0) && number(1)) {
        mScene.width = int(*number(0));
        mScene.height = int(*number(1));
    } else if (line.word == "formats" && !words.empty()) {
        mScene.formats.clear();
        for (const std::string &word : words)
            mScene.formats.push_back(std::strtoll(word.c_str(), nullptr, 0));
    } else {
        return false;
    }
    return true;
}

std::vector<Order> Script::takeOrders()
{
    return std::exchange(mOrders, {});
}

} // namespace ductus::xr
