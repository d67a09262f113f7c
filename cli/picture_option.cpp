// SPDX-License-Identifier: BSD-3-Clause
#include "cli/picture_option.hpp"

namespace alignability::cli {

void add_picture_option(CLI::App& command, PictureKinds& kinds) {
  command.add_option("--pictures", kinds.names, "What NAME.png is written as, apart by commas: a file of each")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"png", "svg", "pdf"}))
      ->default_str("png")
      ->needs(command.get_option("--output"));
}

}  // namespace alignability::cli
