#include "cli/verb.hpp"

namespace mapwright::cli {

#define MAPWRIGHT_VERB(name, summary) std::unique_ptr<Verb> make_##name();
#include "cli/verbs.def"
#undef MAPWRIGHT_VERB

const std::vector<VerbEntry>& verbs() {
  static const std::vector<VerbEntry> entries{
#define MAPWRIGHT_VERB(name, summary) {#name, summary, &make_##name},
#include "cli/verbs.def"
#undef MAPWRIGHT_VERB
  };
  return entries;
}

}  // namespace mapwright::cli
