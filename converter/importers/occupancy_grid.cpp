#include "converter/importers/occupancy_grid.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>

#include "converter/gdal/messages.hpp"
#include "converter/importers/grid_description.hpp"

namespace mapwright::converter {
namespace {

constexpr double kMostCells = 1e9;

/// Pixels from 0 to 255, row by row from the top.
struct Image {
  std::size_t columns = 0, rows = 0;
  std::vector<float> pixels;
};

tl::unexpected<Failure> image_failure(const std::string& path, const std::string& why) {
  return input_failure(path + ": " +
                       (why.empty() ? "is no PGM (binary, P5), PNG or BMP image" : why));
}

GDALDatasetUniquePtr open_image(const std::string& path) {
  static std::once_flag registered;
  std::call_once(registered, GDALAllRegister);
  const std::array<const char*, 4> drivers{"PNM", "PNG", "BMP", nullptr};
  return GDALDatasetUniquePtr(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data()));
}

double full_scale(GDALDataset& dataset) {
  return dataset.GetRasterBand(1)->GetRasterDataType() == GDT_UInt16 ? 65535.0 : 255.0;
}

// Grey, or red, green and blue; a last band of a grey or colour image with alpha does not count.
int colour_bands(GDALDataset& dataset) {
  return dataset.GetRasterCount() >= 3 ? 3 : 1;
}

// Adds a share of the band's pixels; a palette's entries count by their mean.
bool add_band(GDALRasterBand& band, float share, Image& image) {
  std::vector<float> values(image.pixels.size());
  const int columns = static_cast<int>(image.columns), rows = static_cast<int>(image.rows);
  if (band.RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float32, 0, 0,
                    nullptr) != CE_None) {
    return false;
  }
  const GDALColorTable* palette = band.GetColorTable();
  for (std::size_t i = 0; i < values.size(); ++i) {
    float value = values[i];
    if (palette != nullptr) {
      const GDALColorEntry* entry = palette->GetColorEntry(static_cast<int>(value));
      if (entry == nullptr) return false;
      value = static_cast<float>(entry->c1 + entry->c2 + entry->c3) / 3.0F;
    }
    image.pixels[i] += share * value;
  }
  return true;
}

Result<Image> read_image(const std::string& path) {
  const GdalMessages messages;
  const GDALDatasetUniquePtr dataset = open_image(path);
  if (!dataset) return image_failure(path, messages.first_error());
  Image image;
  image.columns = static_cast<std::size_t>(dataset->GetRasterXSize());
  image.rows = static_cast<std::size_t>(dataset->GetRasterYSize());
  if (static_cast<double>(image.columns) * static_cast<double>(image.rows) > kMostCells) {
    return image_failure(path, "has more than a thousand million pixels");
  }
  image.pixels.assign(image.columns * image.rows, 0.0F);
  const int bands = colour_bands(*dataset);
  const auto share = static_cast<float>(255.0 / full_scale(*dataset) / bands);
  for (int band = 1; band <= bands; ++band) {
    if (!add_band(*dataset->GetRasterBand(band), share, image)) {
      return image_failure(path, messages.first_error());
    }
  }
  return image;
}

OccupancyGrid classified(const Image& image, const GridDescription& description) {
  OccupancyGrid grid{image.columns, image.rows, description.resolution_m, description.origin, {}};
  grid.cells.reserve(image.pixels.size());
  for (std::size_t row = image.rows; row-- > 0;) {
    for (std::size_t column = 0; column < image.columns; ++column) {
      grid.cells.push_back(description.cell_of(image.pixels[row * image.columns + column]));
    }
  }
  return grid;
}

Result<std::string> text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) return input_failure(path + ": cannot be read");
  return text;
}

}  // namespace

Result<OccupancyGrid> read_grid_map(const std::string& yaml_path) {
  const auto yaml = text_of(yaml_path);
  if (!yaml) return tl::unexpected(yaml.error());
  const auto description = parse_grid_description(*yaml, yaml_path);
  if (!description) return tl::unexpected(description.error());
  const auto folder = std::filesystem::path(yaml_path).parent_path();
  const auto image = read_image((folder / description->image).string());
  if (!image) return tl::unexpected(image.error());
  return classified(*image, *description);
}

}  // namespace mapwright::converter
