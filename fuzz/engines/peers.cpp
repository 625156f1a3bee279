#include "fuzz/engines/peers.hpp"

#include "engines/narrow_engine.hpp"

namespace ecods::fuzz {
namespace {

class Peer final : public EngineUnderTest {
  public:
    Peer(const bench::NarrowMaker& maker, std::span<const scenes::NamedMesh> meshes)
        : workload_{"", {meshes.begin(), meshes.end()}, {}}, engine_(maker.set_up(workload_)) {}

    bool intersects(const scenes::MeshQuery& query) override { return engine_->ask(query, 0) != 0; }

  private:
    scenes::MeshPairs workload_;
    std::unique_ptr<bench::Touch::Engine> engine_;
};

}  // namespace

std::unique_ptr<EngineUnderTest> make_ecods(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::ecods_narrow().front(), meshes);
}
std::unique_ptr<EngineUnderTest> make_fcl(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::fcl_narrow().front(), meshes);
}
std::unique_ptr<EngineUnderTest> make_bullet(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::bullet_narrow().front(), meshes);
}
std::unique_ptr<EngineUnderTest> make_ode(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::ode_narrow().front(), meshes);
}
std::unique_ptr<EngineUnderTest> make_cgal(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::cgal_narrow().front(), meshes);
}

}  // namespace ecods::fuzz
