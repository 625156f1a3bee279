// Answers of ecods_check with proofs, written to a folder.
#pragma once

#include "certificates/folder/certificate_folder.hpp"
#include "check_scene.hpp"
#include "scenes/io/hard_case_file.hpp"

namespace ecods::check {

// Of each pair of bodies how they are to each other, in this frame; with distances also how far, and with a clearance
// whether within it.
void certify_frame(const SceneWorld& world, std::size_t body_count, certificates::CertificateFolder& folder);

// How the two bodies are to each other, in both orders, how far, and whether within that distance and nothing.
void certify_case(const scenes::HardCase& hard, certificates::CertificateFolder& folder);

}  // namespace ecods::check
