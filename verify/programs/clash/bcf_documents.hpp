// The documents of a BCF 2.1 file as texts.
#pragma once

#include <string>

#include "programs/clash/picture/camera.hpp"
#include "programs/clash/report.hpp"

namespace ecods::clash {

// The folder of a clash's topic, which is its GUID.
std::string topic_guid(const ClashReport& report, const Clash& clash);

std::string bcf_version();

// markup.bcf of the clash of an index; `date` as xs:dateTime.
std::string bcf_markup(const ClashReport& report, std::size_t index, bool has_picture, const std::string& date);

// viewpoint.bcfv of it: the two parts are selected and colored, with the camera and the first lines of intersection.
std::string bcf_viewpoint(const ClashReport& report, std::size_t index, const Camera& camera);

}  // namespace ecods::clash
