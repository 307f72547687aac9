// SPDX-License-Identifier: MIT
// Which defect explains a wrong result.
#pragma once

#include "defects/study.h"

#include <span>

namespace cageproof::judge {

/// The signature of one defect: whether it explains a bad case, and what was seen. Keys are those of the table.
struct Signature {
  std::string_view key;
  bool (*explains)(const Study&, const Case&);
  std::string (*evidence)(const Study&, const Case&);
};

/// In the order of the table: the first that explains a case is named. The last explains every case.
std::span<const Signature> signatures();

}  // namespace cageproof::judge
