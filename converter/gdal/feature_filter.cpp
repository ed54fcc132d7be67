#include "converter/gdal/feature_filter.hpp"

#include <ogrsf_frmts.h>

#include "converter/gdal/messages.hpp"

namespace mapwright::converter {
namespace {

struct ReleaseDefinition {
  void operator()(OGRFeatureDefn* definition) const { definition->Release(); }
};

}  // namespace

struct FeatureFilter::Impl {
  std::unique_ptr<OGRFeatureDefn, ReleaseDefinition> definition;
  OGRFeatureUniquePtr row;
  mutable OGRFeatureQuery query;
};

FeatureFilter::FeatureFilter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FeatureFilter::FeatureFilter(FeatureFilter&&) noexcept = default;
FeatureFilter& FeatureFilter::operator=(FeatureFilter&&) noexcept = default;
FeatureFilter::~FeatureFilter() = default;

Result<FeatureFilter> FeatureFilter::create(const std::vector<std::string>& fields,
                                            const std::string& where) {
  if (where.empty()) return FeatureFilter(nullptr);
  const GdalMessages messages;
  auto impl = std::make_unique<Impl>();
  impl->definition.reset(new OGRFeatureDefn("features"));
  impl->definition->Reference();
  for (const auto& name : fields) {
    OGRFieldDefn field(name.c_str(), OFTString);
    impl->definition->AddFieldDefn(&field);
  }
  if (impl->query.Compile(impl->definition.get(), where.c_str()) != OGRERR_NONE) {
    return usage_failure(messages.first_error());
  }
  impl->row.reset(new OGRFeature(impl->definition.get()));
  return FeatureFilter(std::move(impl));
}

bool FeatureFilter::holds(const SourceFeature& feature) const {
  if (!impl_) return true;
  impl_->row->SetFID(feature.fid);
  for (std::size_t i = 0; i < feature.values.size(); ++i) {
    const auto* text = std::get_if<std::string>(&feature.values[i]);
    if (text == nullptr)
      impl_->row->SetFieldNull(static_cast<int>(i));
    else
      impl_->row->SetField(static_cast<int>(i), text->c_str());
  }
  return impl_->query.Evaluate(impl_->row.get()) != 0;
}

}  // namespace mapwright::converter
