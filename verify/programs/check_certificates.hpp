// Answers of ecods_check with proofs, written to a folder.
#pragma once

#include "certificates/folder/certificate_folder.hpp"
#include "check_scene.hpp"
#include "scenes/io/hard_case_file.hpp"

namespace ecods::check {

// The lists of this frame: which bodies collide, and with a clearance which are close. With distances also how far the
// bodies of each pair are from each other.
void certify_frame(SceneWorld& world, std::size_t body_count, certificates::CertificateFolder& folder);

// How the two bodies are to each other, in both orders, how far, and whether within that distance and nothing.
void certify_case(const scenes::HardCase& hard, certificates::CertificateFolder& folder);

}  // namespace ecods::check
