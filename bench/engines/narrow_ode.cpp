// ODE's triangle meshes (OPCODE inside). Its manual has bodies' geoms moved by dGeomSetPosition and dGeomSetRotation
// and asked by dCollide.
#include <ode/ode.h>

#include <array>

#include "engines/narrow_engine.hpp"

namespace ecods::bench {

namespace {

struct OdeMesh {
    std::vector<float> vertices;
    std::vector<dTriIndex> indices;
    dTriMeshDataID data = nullptr;
    std::array<dGeomID, 2> geoms{};  // as the first and as the second of a pair
};

class NarrowOde final : public Touch::Engine {
  public:
    explicit NarrowOde(const scenes::MeshPairs& workload) : meshes_(workload.meshes.size()) {
        dInitODE2(0);
        dAllocateODEDataForThread(dAllocateMaskAll);
        for (std::size_t i = 0; i < meshes_.size(); ++i) build(meshes_[i], *workload.meshes[i].mesh);
    }

    ~NarrowOde() override {
        for (OdeMesh& mesh : meshes_) {
            for (dGeomID geom : mesh.geoms) dGeomDestroy(geom);
            dGeomTriMeshDataDestroy(mesh.data);
        }
        dCloseODE();
    }

    double ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        dContactGeom contact;
        const int flags = 1 | static_cast<int>(CONTACTS_UNIMPORTANT);
        return dCollide(placed(query.a, 0), placed(query.b, 1), flags, &contact, sizeof contact) > 0 ? 1 : 0;
    }

  private:
    static void build(OdeMesh& made, const Mesh& mesh) {
        for (const Vec3& v : mesh.vertices())
            for (int axis = 0; axis < 3; ++axis) made.vertices.push_back(static_cast<float>(v[axis]));
        for (const Triangle& t : mesh.triangles()) made.indices.insert(made.indices.end(), t.begin(), t.end());
        made.data = dGeomTriMeshDataCreate();
        // Single precision is what its trees hold; doubles would be converted at every look.
        dGeomTriMeshDataBuildSingle(made.data, made.vertices.data(), 3 * sizeof(float),
                                    static_cast<int>(mesh.vertices().size()), made.indices.data(),
                                    static_cast<int>(made.indices.size()), 3 * sizeof(dTriIndex));
        for (dGeomID& geom : made.geoms) {
            geom = dCreateTriMesh(nullptr, made.data, nullptr, nullptr, nullptr);
            dGeomTriMeshEnableTC(geom, dTriMeshClass, 0);
        }
    }

    dGeomID placed(const scenes::MeshAt& at, std::size_t role) {
        const dGeomID geom = meshes_[at.mesh_index].geoms[role];
        dMatrix3 R;  // three rows of four
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) R[4 * row + column] = at.pose.R(row, column);
            R[4 * row + 3] = 0;
        }
        dGeomSetRotation(geom, R);
        dGeomSetPosition(geom, at.pose.t.x(), at.pose.t.y(), at.pose.t.z());
        return geom;
    }

    std::vector<OdeMesh> meshes_;
};

}  // namespace

std::vector<NarrowMaker> ode_narrow() {
    return {{.name = "ODE trimesh",
             .use =
                 "dGeomTriMeshDataBuildSingle(), dCollide() for one contact, CONTACTS_UNIMPORTANT; poses double, tree "
                 "and triangles float",
             .set_up = makes<NarrowOde>()}};
}

}  // namespace ecods::bench
