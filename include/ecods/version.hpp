// The version of this library; CMake reads it from here.
#pragma once

#define ECODS_VERSION_MAJOR 0
#define ECODS_VERSION_MINOR 3
#define ECODS_VERSION_PATCH 0
