// Binds certificate.hpp: answers with a proof.
#include "ecods/certificate.hpp"

#include <sstream>

#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

// Binds copying and pickling of certificates. A copy is the object itself, which never changes. Pickling raises
// TypeError, because a certificate refers to meshes.
template <class T>
void keep_whole(py::class_<T>& type) {
    copies_are_itself(type);
    type.def("__reduce__", [](const py::object& self) -> py::object {
        throw py::type_error(type_name(self) + " is not pickled: keep its text, str(certificate), which checkers read");
    });
}

void add_certificates(py::module_& m) {
    py::class_<Certificate> certificate(
        m, "Certificate",
        "A claim and its proof, which verify/certificates checks. str() is the text, which is what to keep: the object "
        "refers to its meshes and cannot be pickled, and a copy is the object itself.");
    certificate.def_property_readonly("claim", &Certificate::claim, "The Claim that is proved.")
        .def_property_readonly("value", &Certificate::value,
                               "The number in a claim of distance, within, beyond or hit; otherwise 0.")
        .def_property_readonly("step_count", &Certificate::step_count, "The number of steps of the proof.")
        .def_property_readonly("axis_count", &Certificate::axis_count, "The number of directions that the steps name.")
        .def("__str__", &Certificate::to_string)
        .def("__repr__", [](const Certificate& self) {
            return "<ecods.Certificate of " + std::string(py::str(py::cast(self.claim()))) + ", value " +
                   std::string(py::repr(py::float_(self.value()))) + ", " + std::to_string(self.step_count()) +
                   " steps>";
        });
    keep_whole(certificate);
    py::class_<WorldCertificate> of_world(
        m, "WorldCertificate",
        "The lists of a world with their proof. str() is the text to keep, as of a Certificate.");
    of_world.def_property_readonly("colliding_count", &WorldCertificate::colliding_count)
        .def_property_readonly("close_count", &WorldCertificate::close_count)
        .def_property_readonly("apart_count", &WorldCertificate::apart_count)
        .def(
            "meshes",
            [](const WorldCertificate& self) {
                std::vector<std::shared_ptr<MeshShape>> meshes;
                for (const auto& shape : self.shapes()) meshes.push_back(to_python(shape));
                return meshes;
            },
            "Each mesh once, in the order of the bodies: checkers need certified_mesh() of each.")
        .def("__str__", &WorldCertificate::to_string)
        .def("__repr__", [](const WorldCertificate& self) {
            return "<ecods.WorldCertificate of " + std::to_string(self.colliding_count()) + " colliding, " +
                   std::to_string(self.close_count()) + " close, " + std::to_string(self.apart_count()) +
                   " apart pairs>";
        });
    keep_whole(of_world);
}

}  // namespace

void bind_certificates(py::module_& m) {
    add_certificates(m);
    const py::keep_alive<0, 1> keeps_a;
    const py::keep_alive<0, 2> keeps_b;
    m.def(
        "certify", asked<PosedMesh, PosedMesh>(ECODS_QUESTION(certify)), py::arg("a"), py::arg("b"), keeps_a, keeps_b,
        "relation(a, b) of two surfaces with its proof. Raises NotSupported for Solids, as all certificates: ask about "
        "surface_of(solid).");
    m.def("certify_distance", asked<PosedMesh, PosedMesh>(ECODS_QUESTION(certify_distance)), py::arg("a"), py::arg("b"),
          keeps_a, keeps_b, "distance(a, b) with its proof.");
    m.def("certify_within", asked<PosedMesh, PosedMesh, double>(ECODS_QUESTION(certify_within)), py::arg("a"),
          py::arg("b"), py::arg("max_distance"), keeps_a, keeps_b, "within(a, b, max_distance) with its proof.");
    m.def("certify_hit", asked<Segment, PosedMesh>(ECODS_QUESTION(certify_hit)), py::arg("segment"), py::arg("body"),
          keeps_b, "first_hit(segment, body) with its proof.");
    m.def(
        "certified_mesh",
        [](const MeshShape& mesh) {
            std::ostringstream text;
            write_certified_mesh(text, mesh);
            return text.str();
        },
        py::arg("mesh"), "The text of a mesh that checkers of certificates read.");
    m.def("certified_mesh_digest", &certified_mesh_digest, py::arg("mesh"),
          "The SHA-256 of certified_mesh(mesh), 64 hexadecimal digits: its name in certificates.");
}

}  // namespace ecods::python
