#include "target.hpp"

#include "fields/grids.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

/// A table from anywhere: it is refused, or is a grid no larger than itself, with finite values everywhere.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const char* column : {"", "E_Pa"}) try {
      const matrigrate::fields::Samples grid = matrigrate::fields::samples_from_csv(text, column);
      if (grid.values.size() != grid.columns * grid.rows || grid.values.size() > size) std::abort();
      for (const double at : {0.0, -1e9, 0.3})
        if (std::isnan(grid.at({at, -at}))) std::abort();
    } catch (const std::invalid_argument&) { // refused
    }
  return 0;
}
