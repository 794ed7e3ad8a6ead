// A raster as a picture file of 8 bits.
#pragma once

#include "lutlib/plot/raster.h"

#include <string>

namespace converter {

/// Throws UsageError where a file of this name cannot hold one. `what` is to be written: "a sheet".
void require_raster_name(const std::string& path, const std::string& what);

/// Writes codes as they are; `source` is what the picture was made of, kept in PNG files.
void write_raster(const std::string& path, const plot::Raster& raster, const std::string& source);

} // namespace converter
