#include "fuzz/engines/peers.hpp"

#include <utility>

#include "engines/narrow_engine.hpp"

namespace ecods::fuzz {
namespace {

class Peer final : public EngineUnderTest {
  public:
    explicit Peer(std::unique_ptr<bench::NarrowEngine> engine) : engine_(std::move(engine)) {}

    bool intersects(const scenes::MeshQuery& query) override { return engine_->query(query); }

  private:
    std::unique_ptr<bench::NarrowEngine> engine_;
};

}  // namespace

std::unique_ptr<EngineUnderTest> make_ecods(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::set_up_narrow_ecods(meshes));
}
std::unique_ptr<EngineUnderTest> make_fcl(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::set_up_narrow_fcl_obbrss(meshes));
}
std::unique_ptr<EngineUnderTest> make_bullet(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::set_up_narrow_bullet(meshes));
}
std::unique_ptr<EngineUnderTest> make_ode(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::set_up_narrow_ode(meshes));
}
std::unique_ptr<EngineUnderTest> make_cgal(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Peer>(bench::set_up_narrow_cgal(meshes));
}

}  // namespace ecods::fuzz
