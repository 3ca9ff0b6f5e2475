#pragma once
// The errors of everything that people type into this layer: expressions in every dialect, words, grammar files. One
// row says all there is to say about an error: its stable code, the message, what to do about it, and a text that makes
// it happen. Messages, `heckbert grammar errors` and docs/errors.md come from this table, and a test reads every sample
// and gets that error and no other. The hundreds group them: letters, brackets and counts, operators and names, ends of
// a path, grammar files, and warnings about texts that are well-formed and hardly meant.

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/error.h>

namespace heckbert::taxonomy {

/// A code once given keeps its meaning; those of errors that no longer exist are not given again.
enum class ErrorCode : std::uint16_t {
  UnknownLetter = 101,
  ForeignLetter = 102,
  UnknownSubscript = 103,
  Lookalike = 104,
  NotUtf8 = 105,
  ControlCharacter = 106,
  SmallLetter = 107,
  NumberedLobe = 108,
  WrongPlace = 109,
  SeveralWords = 110,
  LabelMisplaced = 111,
  SecondLabel = 112,
  EyeLabelled = 113,
  LabelOfNothing = 114,
  LabelAlone = 115,

  NeverClosed = 201,
  ClosesNothing = 202,
  EmptyParentheses = 203,
  EmptySet = 204,
  OperatorInSet = 205,
  NotTakenAway = 206,
  MalformedCount = 207,
  CountTooGreat = 208,
  CountReversed = 209,
  RepetitionUnavailable = 210,
  NothingToRepeat = 211,
  SecondRepetition = 212,
  GroupUnavailable = 213,
  RepetitionInGroup = 214,
  EmptyGroup = 215,

  EmptyText = 301,
  EmptyAlternative = 302,
  PieceMissing = 303,
  NoOperator = 304,
  WholeInsidePath = 305,
  UnknownName = 306,
  NoLanguage = 307,
  NameMissing = 308,
  NamesUnavailable = 309,
  BlankRefused = 310,
  UnknownPrefix = 311,
  TooDeep = 312,
  TooLarge = 313,

  EqualEnds = 401,
  EmptyPath = 402,
  EndMissing = 403,
  EndInside = 404,
  EventAtEnd = 405,

  NoKey = 501,
  ContinuesNothing = 502,
  UnknownKey = 503,
  KeyTwice = 504,
  KeyMissing = 505,
  KeyElsewhere = 506,
  NoValue = 507,
  WrongValue = 508,
  WrongName = 509,
  NameTaken = 510,
  UnknownHost = 511,
  CapturesNothing = 512,

  StraightThrough = 601,
  NoSuchEvent = 602,
  NoPath = 603,
};

/// What a sample is read as, where it is no expression of a dialect.
inline constexpr std::string_view kReadAsWord = "word";
inline constexpr std::string_view kReadAsGrammar = "grammar file";

struct ErrorFacts {
  ErrorCode code;
  std::string_view title;    ///< for lists
  std::string_view message;  ///< each {} is filled in by the reader
  std::string_view remedy;   ///< what lies behind it and what to do, in sentences
  std::string_view read_as;  ///< the name of a dialect, or one of the two above
  std::string_view sample;   ///< has this error and no other
};

/// Deeper than any expression may nest.
inline constexpr auto kDeepParentheses = [] {
  std::array<char, 600> text{};
  for (char& c : text) c = '(';
  return text;
}();

inline constexpr std::array kErrors{
    // ---- letters ---------------------------------------------------------------------------------------------------
    ErrorFacts{ErrorCode::UnknownLetter, "unknown letter", "unknown letter {}; expected {}",
               "The character has no meaning there. The letters of a dialect are listed in dialects.md.", "heckbert",
               "LQE"},
    ErrorFacts{ErrorCode::ForeignLetter, "letter of another notation", "{} is not read here: {}",
               "Another renderer has this letter. Write what stands for it here, or say with --dialect whose "
               "expression it is.",
               "heckbert", "LRE"},
    ErrorFacts{ErrorCode::UnknownSubscript, "unknown subscript", "{} is no letter; expected {}",
               "A small letter behind a capital narrows it: Dr reflects, Dt transmits, La is an area light. Not every "
               "letter has every subscript.",
               "heckbert", "LDxE"},
    ErrorFacts{ErrorCode::Lookalike, "character that only looks right", "{}",
               "Slides, papers and manuals have letters of other alphabets, dashes and blanks that look like those of "
               "an expression. Type it anew.",
               "vray", "C<\u0422[GS]>(.+L|.*[OB])"},
    ErrorFacts{ErrorCode::NotUtf8, "not UTF-8", "a byte that is not UTF-8; expected {}",
               "The text was saved in another encoding, or is no text.", "heckbert",
               "L\xFF"
               "E"},
    ErrorFacts{ErrorCode::ControlCharacter, "control character", "a control character; expected {}",
               "An invisible character got into the text. Type it anew.", "heckbert",
               "L\x01"
               "E"},
    ErrorFacts{ErrorCode::SmallLetter, "small letter", "{} is no letter: small letters are subscripts, as in Dr",
               "Events and ends are capitals. A name of a class or algorithm inside an expression begins with '@'.",
               "heckbert", "ldse"},
    ErrorFacts{ErrorCode::NumberedLobe, "numbered lobe", "numbered lobes are not told apart by our words",
               "RenderMan numbers the lobes of a material. A word says only diffuse, glossy or specular; without the "
               "number the letter is every lobe.",
               "renderman", "CD2L"},
    ErrorFacts{ErrorCode::WrongPlace, "letter in the wrong place of <..>", "{} is {}; the {} place in '<..>' is for {}",
               "An event in angle brackets is its type (R, T, V), then its scattering (D, G, S), then a label: <RD>. "
               "Any of them may be '.'.",
               "osl", "C<D>L"},
    ErrorFacts{ErrorCode::SeveralWords, "expression in place of a word",
               "{} stands for several words; a word has the letters L, D, G, S, V, E only",
               "A word is one path, letter by letter. Sets of paths are expressions, and other commands take those.",
               kReadAsWord, "LXE"},
    ErrorFacts{ErrorCode::LabelMisplaced, "label in the wrong place of <..>",
               "a label stands third in '<..>', behind the type and the scattering",
               "A type or a scattering that does not matter is '.': <..'lamp'>.", "osl", "C<'skin'>L"},
    ErrorFacts{ErrorCode::SecondLabel, "second label", "a second label; a letter of our words has one",
               "A renderer hangs one name on an event: an object's, a material's or a light group's.", "osl",
               "C<RD'skin''oil'>L"},
    ErrorFacts{ErrorCode::EyeLabelled, "label of the eye", "the eye has no label; lights and events have",
               "Leave it out, or write it behind the letter that it belongs to.", "heckbert", "LDE'main'"},
    ErrorFacts{ErrorCode::LabelOfNothing, "label that contradicts", "none of the letters before this label has it",
               "The letters have labels already, and this is not among them.", "heckbert", "L[D'wall']'floor'E"},
    ErrorFacts{ErrorCode::LabelAlone, "label without its letter",
               "a label without its letter; it stands right behind one, D'wall'",
               "In a word each label belongs to one event or light. In an expression a label alone is any event that "
               "has it.",
               kReadAsWord, "L 'wall'E"},

    // ---- brackets and counts ---------------------------------------------------------------------------------------
    ErrorFacts{ErrorCode::NeverClosed, "bracket never closed", "{} is never closed; expected {}",
               "Each opening bracket needs its partner.", "heckbert", "L(DE"},
    ErrorFacts{ErrorCode::ClosesNothing, "bracket that closes nothing", "{} closes nothing",
               "There is a closing bracket too many, or its opening partner is missing.", "heckbert", "LD)E"},
    ErrorFacts{ErrorCode::EmptyParentheses, "empty parentheses", "empty parentheses; expected a piece of a path",
               "What may be missing is written with '?': (DS)?.", "heckbert", "L()E"},
    ErrorFacts{
        ErrorCode::EmptySet, "empty set", "an empty set; expected {}",
        "Brackets hold the letters to choose from, [DG], or those to leave out, [^S]; some event has to be left.",
        "heckbert", "L[]E"},
    ErrorFacts{
        ErrorCode::OperatorInSet, "operator inside brackets", "{} inside brackets; letters stand side by side there",
        "[DG] is D or G already. Longer pieces to choose from stand in parentheses: (DS|G).", "heckbert", "L[D|S]E"},
    ErrorFacts{ErrorCode::NotTakenAway, "wrong kind inside [^ ]", "{} inside [^ ]; {}",
               "[^S] is every event but S. Ends cannot be taken away, nor can letters of two kinds at once; name what "
               "is wanted instead.",
               "heckbert", "L[^L]E"},
    ErrorFacts{ErrorCode::MalformedCount, "malformed count",
               "a count is written {n}, {n,} or {n,m} with numbers n and m",
               "{2} is exactly two, {2,} two or more, {0,2} at most two.", "heckbert", "LD{,3}E"},
    ErrorFacts{ErrorCode::CountTooGreat, "count too great", "a count above {}, the greatest that is read",
               "No path is that long. Any number of times is '*'.", "heckbert", "LD{20000}E"},
    ErrorFacts{ErrorCode::CountReversed, "count that runs backwards",
               "the least number of this count exceeds the greatest", "{2,3} is two or three.", "heckbert", "LD{3,2}E"},
    ErrorFacts{ErrorCode::RepetitionUnavailable, "repetition that the dialect lacks", "{} has no {}",
               "Not every renderer has '?' and counts. grammar translate writes such an expression out.", "osl",
               "CD?L"},
    ErrorFacts{ErrorCode::NothingToRepeat, "nothing to repeat", "nothing to repeat before {}",
               "'*', '+', '?' and counts stand behind the piece that they repeat.", "heckbert", "*LDE"},
    ErrorFacts{ErrorCode::SecondRepetition, "second repetition", "a second repetition of one item; {} reads one",
               "Put the item with its first repetition into parentheses.", "osl", "CD+*L"},
    ErrorFacts{ErrorCode::GroupUnavailable, "<..> in Heckbert's notation",
               "'<..>' groups of light path expressions are not read in this notation",
               "Reflection and transmission are subscripts: <RD> is Dr, <TS> is St. Or say with --dialect whose "
               "expression it is.",
               "heckbert", "L<RD>E"},
    ErrorFacts{ErrorCode::RepetitionInGroup, "repetition inside <..>",
               "a repetition inside '<..>', which stands for one event",
               "Repeat the whole event: <RD>+. Some guides teach <RD+>, which renderers refuse or misread.", "arnold",
               "C<RD+>L"},
    ErrorFacts{ErrorCode::EmptyGroup, "empty <..>", "an empty event; expected its type and its scattering, as in <RD>",
               "Any event is '.'.", "osl", "C<>L"},

    // ---- operators and names ---------------------------------------------------------------------------------------
    ErrorFacts{ErrorCode::EmptyText, "nothing there", "an empty {}; expected a path such as {}",
               "The text has nothing but blanks and comments.", "heckbert", ""},
    ErrorFacts{ErrorCode::EmptyAlternative, "empty alternative", "an empty alternative",
               "Something has to stand on both sides of '|'. A piece that may be missing is written with '?'.",
               "heckbert", "LDE |"},
    ErrorFacts{ErrorCode::PieceMissing, "missing piece", "expected {}",
               "An operator lacks its operand, or a place between two operators is empty.", "heckbert", "LDE &"},
    ErrorFacts{ErrorCode::NoOperator, "unknown operator", "{} is no operator here",
               "Alternatives are separated by '|'. On whole paths there are also '&', '-' and '!' in Heckbert's "
               "notation and '&', '-' and '^' in V-Ray's.",
               "heckbert", "LDE || LSE"},
    ErrorFacts{ErrorCode::WholeInsidePath, "whole path inside a path",
               "{} works on whole paths and cannot stand inside one",
               "Names and '&', '-', '!' combine sets of whole paths: LX*E - LDE. Within a path, an event other than S "
               "is [^S].",
               "heckbert", "L!SE"},
    ErrorFacts{ErrorCode::UnknownName, "unknown name", "no class or algorithm is called {}",
               "'heckbert grammar list' shows all names. A name may contain '-', so the difference of two names needs "
               "a blank.",
               "heckbert", "@whited"},
    ErrorFacts{ErrorCode::NoLanguage, "name without a language", "{}",
               "Some methods are not sets of paths. 'heckbert grammar show' says what they are; a transformer captures "
               "what its host does, so ask for the host.",
               "heckbert", "@metropolis"},
    ErrorFacts{ErrorCode::NameMissing, "'@' without a name",
               "'@' without a name; expected the name of a class or algorithm, as in @caustic",
               "No blank between '@' and the name.", "heckbert", "@ | LDE"},
    ErrorFacts{ErrorCode::NamesUnavailable, "names in another dialect", "{} has no named classes",
               "Names with '@' are Heckbert's notation. On the command line a name without '@' works in every dialect.",
               "osl", "@caustic"},
    ErrorFacts{ErrorCode::BlankRefused, "blank", "{} takes no blanks inside an expression", "Delete them.", "osl",
               "CD L"},
    ErrorFacts{ErrorCode::UnknownPrefix, "unknown prefix", "{} has no prefix {}",
               "Words before the expression, such as 'unoccluded;', belong to certain renderers. dialects.md lists "
               "them.",
               "osl", "unoccluded;CDL"},
    ErrorFacts{ErrorCode::TooDeep, "nested too deep", "nested deeper than {} levels",
               "No person nests that deep: look for an opening bracket repeated by accident.", "heckbert",
               std::string_view(kDeepParentheses.data(), kDeepParentheses.size())},
    ErrorFacts{ErrorCode::TooLarge, "too large", "{} is too large: {}",
               "The automaton of the piece would exceed the budget. A letter wanted exactly n places before the end, "
               ".*D.{30}, takes 2^n states, whatever the program. Lower the count, or ask several smaller questions.",
               "heckbert", "L.*D.{30}E"},

    // ---- ends of a path --------------------------------------------------------------------------------------------
    ErrorFacts{ErrorCode::EqualEnds, "both ends alike", "both ends are {}; a path runs from a light to an eye",
               "Write L ... E, or E ... L.", "heckbert", "LDL"},
    ErrorFacts{ErrorCode::EmptyPath, "empty path",
               "this matches the empty path; a path has a light end L and an eye end E",
               "Every path has two ends. 'Any number of diffuse bounces' is LD*E.", "heckbert", "D*"},
    ErrorFacts{ErrorCode::EndMissing, "missing end", "this path has {}; a whole path runs L ... E or E ... L",
               "Alternation binds loosest: LD|SE is LD or SE. Write L(D|S)E.", "heckbert", "LDS"},
    ErrorFacts{ErrorCode::EndInside, "end in the middle", "{} is an end in the middle of a path; expected D, G, S or V",
               "A path has a light at one end and the eye at the other, and nothing but events between.", "heckbert",
               "LDLE"},
    ErrorFacts{ErrorCode::EventAtEnd, "event at an end", "{} at the {} of a path; expected {}",
               "Some of the paths that this matches would lack an end.", "heckbert", "L?DE"},

    // ---- grammar files ---------------------------------------------------------------------------------------------
    ErrorFacts{ErrorCode::NoKey, "no key", "expected 'key: value'",
               "Each line of a grammar file begins with a key. A value goes on in lines that are indented.",
               kReadAsGrammar, "kind: class\nname: x\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\nLSE\n"},
    ErrorFacts{ErrorCode::ContinuesNothing, "continuation of nothing",
               "a continuation line that continues nothing; expected 'key: value' at the margin",
               "The file begins with an indented line.", kReadAsGrammar,
               "  LDE\nkind: class\nname: x\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\n"},
    ErrorFacts{ErrorCode::UnknownKey, "unknown key", "unknown key {}", "grammar/README.md lists the keys.",
               kReadAsGrammar,
               "kind: class\nname: x\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\ncolour: red\n"},
    ErrorFacts{ErrorCode::KeyTwice, "key twice", "a second {}; it stands once",
               "Only 'bias', 'variance' and 'precondition' may stand several times.", kReadAsGrammar,
               "kind: class\nname: x\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\ntitle: y\n"},
    ErrorFacts{ErrorCode::KeyMissing, "missing key", "the key {} is missing",
               "Which keys a grammar must have depends on its kind; see grammar/README.md.", kReadAsGrammar,
               "kind: class\nname: x\ntitle: x\norder: 1\nsource: ours\n"},
    ErrorFacts{ErrorCode::KeyElsewhere, "key of another kind", "the key {} does not belong to kind {}",
               "Which keys a grammar may have depends on its kind; see grammar/README.md.", kReadAsGrammar,
               "kind: class\nname: x\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\nhost: whitted\n"},
    ErrorFacts{ErrorCode::NoValue, "key without a value", "the key {} has no value",
               "Give it one, or leave the line out where the key is optional.", kReadAsGrammar,
               "kind: class\nname: x\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\nnotes:\n"},
    ErrorFacts{ErrorCode::WrongValue, "wrong value", "expected {}", "The key takes only such values.", kReadAsGrammar,
               "kind: class\nname: x\ntitle: x\norder: five\nsource: ours\nexpression: LDE\n"},
    ErrorFacts{ErrorCode::WrongName, "wrong name",
               "a name has small letters, digits and '-' between them, and is not 'none'",
               "Names are written behind '@' in expressions, and are the names of files.", kReadAsGrammar,
               "kind: class\nname: My Class\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\n"},
    ErrorFacts{ErrorCode::NameTaken, "name taken", "the name {} is taken", "Another grammar has it; choose another.",
               kReadAsGrammar, "kind: class\nname: whitted\ntitle: x\norder: 1\nsource: ours\nexpression: LDE\n"},
    ErrorFacts{ErrorCode::UnknownHost, "unknown host", "no algorithm is called {}",
               "A transformer works on an algorithm; 'heckbert grammar list' shows their names.", kReadAsGrammar,
               "kind: transformer\nname: x\ntitle: x\norder: 1\nsource: ours\nhost: whited\n"},
    ErrorFacts{
        ErrorCode::CapturesNothing, "algorithm that captures nothing",
        "both expressions are 'none'; an algorithm captures something",
        "A method without paths of its own is a transformer, a proxy or a predicate.", kReadAsGrammar,
        "kind: algorithm\nname: x\ntitle: x\norder: 1\nsource: ours\nexpression: none\nexpression-delta: none\n"},

    // ---- warnings --------------------------------------------------------------------------------------------------
    ErrorFacts{ErrorCode::StraightThrough, "straight-through event",
               "straight-through events are left out of our words, so this matches nothing",
               "A path through a cut-out or an index-matched surface is the same word as without it. Delete 's'.",
               "osl", "C(D|s)O"},
    ErrorFacts{ErrorCode::NoSuchEvent, "impossible event", "no event of our words is this, so it matches nothing",
               "Type and scattering contradict each other: a light does not scatter.", "osl", "C(D|<VD>)O"},
    ErrorFacts{
        ErrorCode::NoPath, "no path matches", "no path matches this in {}",
        "In this dialect the expression lacks an end. 'heckbert grammar translate' says what it means elsewhere.",
        "iray", "CD|SL"},
};

static_assert(std::is_sorted(kErrors.begin(), kErrors.end(),
                             [](const ErrorFacts& a, const ErrorFacts& b) { return a.code <= b.code; }));

constexpr const ErrorFacts& facts(ErrorCode code) {
  return *std::find_if(kErrors.begin(), kErrors.end(), [code](const ErrorFacts& f) { return f.code == code; });
}

/// "HB101".
std::string label(ErrorCode code);

/// The row of a label, in small letters or capitals, with or without "HB"; nothing when there is none.
const ErrorFacts* find_error(std::string_view label);

/// The message of the table with its places filled in, in order; as many values as there are places.
std::string message_of(ErrorCode code, std::initializer_list<std::string_view> values = {});

/// The diagnostic of this error for the characters [offset, offset + length) of `text`, as heckbert::diagnose.
Diagnostic diagnose(ErrorCode code, std::string_view source, std::string_view text, std::size_t offset,
                    std::size_t length, std::initializer_list<std::string_view> values = {},
                    std::string suggestion = {});

/// By source, then by place; what has the same place stays in the order in which it was found.
void sort_by_place(std::vector<Diagnostic>& diagnostics);

/// "message; suggestion [HB601]": a diagnostic that is no error, for one line.
std::string warning_text(const Diagnostic& diagnostic);

}  // namespace heckbert::taxonomy
