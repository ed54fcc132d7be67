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

// "In file ./port/cpl_vsil_gzip.cpp, at line 812, return -1"; "./ogr/ogrdxflayer.cpp, 3367: error
// at line 149 of …"
std::string plain_message(std::string message) {
  if (message.starts_with("In file ")) return "its compressed data is damaged";
  const auto colon = message.find(": ");
  if (message.starts_with("./") && colon != message.npos) message.erase(0, colon + 2);
  for (const char* advice : {" To avoid accepting it,", " You may set the "}) {
    if (const auto at = message.find(advice); at != message.npos) message.erase(at);
  }
  while (message.ends_with('.') || message.ends_with(' ')) message.pop_back();
  return message;
}

GdalMessages::GdalMessages() {
  CPLPushErrorHandlerEx(on_message, this);
}
GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
}

void GdalMessages::add(bool is_error, const char* said) {
  const std::string text = plain_message(said);
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
