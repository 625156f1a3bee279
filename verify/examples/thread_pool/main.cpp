// A world that works on the threads of oneTBB: any executor and number of threads gives the same answers.
#include <fmt/core.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

#include "ecods/world.hpp"
#include "scenes/room.hpp"

namespace {

class TbbExecutor final : public ecods::Executor {
  public:
    explicit TbbExecutor(int worker_count) : arena_(worker_count) {}

    std::size_t worker_count() const noexcept override { return static_cast<std::size_t>(arena_.max_concurrency()); }

    // No two threads of an arena have the same index at once, which is what `worker` asks for.
    void run(std::size_t task_count, const std::function<void(std::size_t, std::size_t)>& task) override {
        arena_.execute([&] {
            tbb::parallel_for(std::size_t{0}, task_count, [&](std::size_t i) {
                task(i, static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()));
            });
        });
    }

  private:
    tbb::task_arena arena_;
};

}  // namespace

int main() {
    namespace scenes = ecods::scenes;
    const scenes::Scene room = scenes::room({.ship_count = 300, .frame_count = 20});
    for (const int worker_count : {1, 2}) {
        ecods::World world({.executor = std::make_shared<TbbExecutor>(worker_count)});
        std::vector<ecods::BodyId> ships;
        for (const scenes::SceneBody& body : room.bodies)
            ships.push_back(world.create_body(room.meshes[body.mesh_index].mesh, body.pose));
        for (const scenes::Frame& frame : room.frames) {
            for (const scenes::Move& move : frame.moves) world.set_pose(ships[move.body_index], move.pose);
            world.update();
        }
        fmt::print("{} threads: {} pairs touch, digest {:016x}\n", worker_count, world.colliding_pairs().size(),
                   world.digest());
    }
}
