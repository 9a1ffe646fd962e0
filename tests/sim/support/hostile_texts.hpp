#pragma once
// Names that mean something to YAML, to a terminal, or to nobody.

#include <string>
#include <vector>

namespace armtune::internal::test {

/// All of them UTF-8, none with a NUL.
inline std::vector<std::string> hostile_texts() {
  std::vector<std::string> texts = {"a: b",
                                    "a #b",
                                    "#a",
                                    "a:",
                                    "- a",
                                    "? a",
                                    "[a",
                                    "a]",
                                    "{a}",
                                    "a, b",
                                    "*a",
                                    "&a",
                                    "!a",
                                    "%a",
                                    "@a",
                                    "`a",
                                    "'a'",
                                    "\"a\"",
                                    "a\\",
                                    "a\\n",
                                    "|",
                                    ">",
                                    "yes",
                                    "No",
                                    "ON",
                                    "null",
                                    "~",
                                    "true",
                                    "False",
                                    "y",
                                    "1",
                                    "-1.5",
                                    "1e5",
                                    "0x1f",
                                    "1_000",
                                    "1:30",
                                    ".inf",
                                    ".nan",
                                    "<<",
                                    "=",
                                    "---",
                                    "...",
                                    "2026-11-25",
                                    "",
                                    " a",
                                    "a ",
                                    "a  b",
                                    "\t",
                                    "a\tb",
                                    "a\nb",
                                    "\n",
                                    "a\r\nb",
                                    "a\rb",
                                    "\x1b[31mred",
                                    "a\x7f",
                                    "a\x01",
                                    "é",
                                    "\xF0\x9F\xA4\x96",
                                    "a\xC2\x85injected: 1",
                                    "a\xE2\x80\xA8injected: 1",
                                    "a\xE2\x80\xA9injected: 1",
                                    "a\xC2\x9B[31m",
                                    "\xEF\xBB\xBF"
                                    "a",
                                    "a\xEF\xBF\xBE",
                                    "a\xF0\x9F\xBF\xBF"};
  texts.push_back(std::string(2000, 'k'));  // longer than a key in one line
  std::string separators;
  for (int i = 0; i < 300; ++i) separators += "\xE2\x80\xA8";  // that long once it is escaped
  texts.push_back(separators);
  return texts;
}

}  // namespace armtune::internal::test
