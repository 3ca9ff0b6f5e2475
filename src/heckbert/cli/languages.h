#pragma once
// Languages as a user names them: the name of a built-in grammar or class ("whitted", "@caustic"), a .grammar file, or
// an expression ("LS+DE"). Every command takes all three; expressions are read in the dialect of the settings, and what
// is well-formed and hardly meant is noted on standard error.

#include <string>
#include <string_view>
#include <vector>

#include <heckbert/cli/settings.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::cli {

/// The grammar that `text` means; an expression becomes a class whose name and title are the expression.
/// `what` names the text in errors. Errors: InputError, also for what has no language; ReadError, LimitError.
taxonomy::Grammar find_grammar(const std::string& text, std::string_view what, const Settings& settings);

/// All of them. Errors: as find_grammar, with the diagnostics of every text that is wrong.
std::vector<taxonomy::Grammar> find_grammars(const std::vector<std::string>& texts, std::string_view what,
                                             const Settings& settings);

/// As find_grammars, but what has no language (proxies, transformers) is found too: for showing, not for matching.
std::vector<taxonomy::Grammar> find_described(const std::vector<std::string>& texts, std::string_view what,
                                              const Settings& settings);

/// What coverage is asked of: the teaching set when there are no texts; for the text "all" every algorithm, with what
/// has no language among them; else as find_grammars.
std::vector<taxonomy::Grammar> find_to_cover(const std::vector<std::string>& texts, std::string_view what,
                                             const Settings& settings);

/// As find_grammars for texts that may begin with a name of their own, "caustic=LS+DE", which becomes the grammar's.
/// Errors: also InputError for a name given twice.
std::vector<taxonomy::Grammar> find_named_grammars(const std::vector<std::string>& texts, std::string_view what,
                                                   const Settings& settings);

/// The built-in teaching set and all classes.
taxonomy::GrammarLibrary teaching_library();

/// The first `count` words, shortest first, of D, G and S between this kind of light and a pinhole eye that the
/// language has, or that it has not; in plain letters. Looks at words of up to five scatterings.
std::vector<std::string> first_words(const taxonomy::Language& language, taxonomy::Symbol light, bool contained,
                                     std::size_t count);

/// A word for people: plain letters, or with subscripts where the plain letters would be read as another word.
std::string show(const taxonomy::Word& word);

}  // namespace heckbert::cli
