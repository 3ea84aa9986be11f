// Fixtures: project files of released versions, kept for ever. With DUCTUS_WRITE_FIXTURES in the environment
// one that is missing is made; one that is there is never written again.
#pragma once

#include "project/project_writer.h"
#include "project/schema_check.h"

#include <QtTest>
#include <filesystem>
#include <fstream>

namespace ductus {

inline void writeFixtureIfAsked(const std::filesystem::path &path, const Project &project)
{
    if (!qEnvironmentVariableIsSet("DUCTUS_WRITE_FIXTURES") || std::filesystem::exists(path))
        return;
    const Result<SerializedProject> made = serializedProject(project);
    QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char *>(made->bytes.data()), std::streamsize(made->bytes.size()));
}

inline Bytes fixtureBytes(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::span<const std::byte> bytes = asBytes(text);
    return Bytes(bytes.begin(), bytes.end());
}

/// Against the schemas of today.
inline void verifyFixtureIsValid(const std::filesystem::path &path)
{
    const auto lines = projectSchemaViolations(fixtureBytes(path), "v1");
    QVERIFY2(lines.ok(), lines.ok() ? "" : lines.error().message().c_str());
    QVERIFY2(lines->empty(), lines->empty() ? "" : lines->front().c_str());
}

} // namespace ductus
