#include "converter/gdal/messages.hpp"

#include <cpl_error.h>

#include <algorithm>
#include <utility>

namespace mapwright::converter {
namespace {

constexpr std::size_t kMostWarnings = 100;

void CPL_STDCALL on_message(CPLErr severity, CPLErrorNum /*number*/, const char* text) {
  if (severity == CE_None || severity == CE_Debug) return;
  auto* messages = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  messages->add(severity == CE_Failure || severity == CE_Fatal, text);
}

}  // namespace

// "In file ./port/cpl_vsil_gzip.cpp, at line 812, return -1"
std::string without_source_line(const std::string& message) {
  return message.rfind("In file ", 0) == 0 ? "its compressed data is damaged" : message;
}

GdalMessages::GdalMessages() {
  CPLPushErrorHandlerEx(on_message, this);
}
GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
}

void GdalMessages::add(bool is_error, const char* text) {
  if (is_error && first_error_.empty()) {
    first_error_ = text;
  } else if (warnings_.size() < kMostWarnings &&
             std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) {
    warnings_.emplace_back(text);
  }
}

std::vector<std::string> GdalMessages::take_warnings() {
  return std::exchange(warnings_, {});
}

}  // namespace mapwright::converter
