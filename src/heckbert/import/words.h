#pragma once
// Numbers, colours and lists in sentences for people.

#include <string>
#include <vector>

#include <heckbert/record/rgb.h>

namespace heckbert::import {

std::string to_text(double number);  ///< shortest of six digits: "0.725", "1e+09"
std::string to_text(Rgb colour);     ///< "0.5" for a grey, else "0.1 0.2 0.3"
std::string join(const std::vector<std::string>& words, const std::string& between = ", ");
/// "1 triangle", "3 triangles"
std::string count(std::size_t number, const std::string& noun);

}  // namespace heckbert::import
