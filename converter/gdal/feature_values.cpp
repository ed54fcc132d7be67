#include "converter/gdal/feature_values.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <ogr_feature.h>

namespace mapwright::converter {
namespace {

std::string as_utf8(const OGRFeature& from, int field, SourceFeature& feature) {
  const char* text = from.GetFieldAsString(field);
  if (CPLIsUTF8(text, -1) != 0) return text;
  feature.reencoded.emplace_back(from.GetFieldDefnRef(field)->GetNameRef());
  char* recoded = CPLRecode(text, CPL_ENC_ISO8859_1, CPL_ENC_UTF8);
  std::string utf8 = recoded;
  CPLFree(recoded);
  return utf8;
}

// GDAL's own text of a list is cut after 80 characters.
std::string joined(char** texts) {
  std::string all;
  for (; texts != nullptr && *texts != nullptr; ++texts) {
    all += (all.empty() ? "" : " ") + std::string(*texts);
  }
  return all;
}

FieldValue value_of(const OGRFeature& from, int field, SourceFeature& feature) {
  if (from.IsFieldSetAndNotNull(field) == 0) return {};
  switch (from.GetFieldDefnRef(field)->GetType()) {
    case OFTInteger:
    case OFTInteger64:
      return std::int64_t{from.GetFieldAsInteger64(field)};
    case OFTReal:
      return from.GetFieldAsDouble(field);
    case OFTStringList:
      return joined(from.GetFieldAsStringList(field));
    default:
      return as_utf8(from, field, feature);
  }
}

}  // namespace

void read_values(const OGRFeature& from, SourceFeature& feature) {
  const int count = from.GetFieldCount();
  feature.values.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    feature.values[static_cast<std::size_t>(i)] = value_of(from, i, feature);
  }
}

}  // namespace mapwright::converter
