#pragma once
// Scenes as the command line names them, and what an importer made of them, for people and for programs.

#include <string>
#include <string_view>
#include <vector>

#include <heckbert/import/import.h>
#include <heckbert/report/json_parts.h>

namespace heckbert::cli {

/// A built-in scene, a file, or for "-" native JSON from standard input. Errors: InputError, ReadError.
import::Imported load_scene(const std::string& name);

/// "  ignored     map_Kd wood.png: ...", one line for each, or nothing.
std::string account_lines(const std::vector<std::string>& sentences, std::string_view label);

/// Keys "understood", "guessed", "ignored".
report::Json to_json(const import::Account& account);

}  // namespace heckbert::cli
