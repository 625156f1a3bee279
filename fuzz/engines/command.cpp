#include "fuzz/engines/command.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "fuzz/engines/body_json.hpp"
#include "process/program.hpp"

namespace ecods::fuzz {
namespace {

using Json = nlohmann::ordered_json;

Json mesh_json(std::size_t index, const Mesh& mesh) {
    Json json = {{"mesh", index}};
    add_mesh(json, mesh);
    return json;
}

Json body_json(const scenes::MeshAt& at) {
    Json json = {{"mesh", at.mesh_index}};
    add_pose(json, at.pose);
    return json;
}

class Command final : public EngineUnderTest {
  public:
    // setpriv: when this process is ended because the engine hangs, the engine is ended, too.
    Command(const std::string& command, std::span<const scenes::NamedMesh> meshes)
        : program_({"setpriv", "--pdeathsig", "KILL", "sh", "-c", "exec " + command}),
          command_(command),
          meshes_(meshes),
          is_sent_(meshes.size(), false) {}

    bool intersects(const scenes::MeshQuery& query) override {
        std::string lines;
        for (const std::size_t mesh : {query.a.mesh_index, query.b.mesh_index}) {
            if (!is_sent_[mesh]) lines += mesh_json(mesh, *meshes_[mesh].mesh).dump() + "\n";
            is_sent_[mesh] = true;
        }
        const std::size_t number = count_++;
        const Json question = {{"query", number}, {"a", body_json(query.a)}, {"b", body_json(query.b)}};
        return answer_in(answer_to(lines + question.dump()), number);
    }

  private:
    std::string answer_to(const std::string& lines) {
        try {
            return program_.ask(lines);
        } catch (const std::runtime_error&) {  // which would name setpriv
            throw std::runtime_error(command_ + ": ended without an answer");
        }
    }

    static bool answer_in(const std::string& line, std::size_t number) {
        const Json answer = Json::parse(line, nullptr, false);
        if (answer.is_object() && answer.contains("query") && answer["query"] == number &&
            answer.contains("intersects") && answer["intersects"].is_boolean())
            return answer["intersects"].get<bool>();
        throw std::runtime_error(fmt::format("the answer to query {} is no {{\"query\": {}, \"intersects\": true}}: {}",
                                             number, number, line.substr(0, 200)));
    }

    process::Conversation program_;
    std::string command_;
    std::span<const scenes::NamedMesh> meshes_;
    std::vector<bool> is_sent_;
    std::size_t count_ = 0;
};

}  // namespace

EngineMaker command_engine(const std::string& name, const std::string& command) {
    return {.name = name,
            .use = command,
            .make = [command](std::span<const scenes::NamedMesh> meshes) -> std::unique_ptr<EngineUnderTest> {
                return std::make_unique<Command>(command, meshes);
            },
            .shows_errors = true};
}

}  // namespace ecods::fuzz
