#include "cli/render/overlays.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "cli/render/drawers.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"

namespace mapwright::cli {
namespace {

struct Drawer {
  std::string_view schema;
  std::function<void(const Json&, converter::Overlay&, std::optional<std::size_t>)> draw;
};

const std::array<Drawer, 5>& drawers() {
  const auto findings = [](const Json& answer, auto& overlay, auto) {
    draw_findings(answer, overlay);
  };
  static const std::array<Drawer, 5> all{{
      {"mapwright.scan/1",
       [](const Json& answer, auto& overlay, auto) { draw_scans(answer, overlay); }},
      {"mapwright.localize/1", draw_localization},
      {"mapwright.plan/1",
       [](const Json& answer, auto& overlay, auto) { draw_plan(answer, overlay); }},
      {"mapwright.validate/1", findings},
      {"mapwright.check/1", findings},
  }};
  return all;
}

const Drawer* drawer_of(const Json& answer) {
  if (!answer.is_object() || !answer.contains("schema")) return nullptr;
  const auto found = std::find_if(drawers().begin(), drawers().end(), [&](const Drawer& drawer) {
    return answer.at("schema") == drawer.schema;
  });
  return found == drawers().end() ? nullptr : &*found;
}

[[noreturn]] void fail_answer(const std::string& path, const std::string& why) {
  throw Error(ExitStatus::kInput, path + ": " + why);
}

}  // namespace

Answer::Answer(std::string path) : path_(std::move(path)) {
  const std::string text = read_file(path_);
  try {
    json_ = std::make_unique<Json>(Json::parse(text));
  } catch (const Json::exception& error) {
    fail_answer(path_, std::string("is not JSON: ") + error.what());
  }
  if (drawer_of(*json_) == nullptr) {
    fail_answer(path_,
                "is no answer that can be drawn; expected one of scan, localize, plan, validate or "
                "check with --format json");
  }
}

Answer::Answer(Answer&&) noexcept = default;
Answer::~Answer() = default;

std::size_t Answer::iterations() const {
  if (json_->at("schema") != "mapwright.localize/1" || !json_->contains("iterations")) return 0;
  return json_->at("iterations").size();
}

void Answer::draw(converter::Overlay& overlay, std::optional<std::size_t> iteration) const {
  try {
    drawer_of(*json_)->draw(*json_, overlay, iteration);
  } catch (const Json::exception& error) {
    fail_answer(path_, std::string("is not as its schema says: ") + error.what());
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {
    fail_answer(path_, error.what());
  }
}

}  // namespace mapwright::cli
