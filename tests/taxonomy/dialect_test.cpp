// Expressions of other renderers: what they mean, how they are written, and what is said about broken ones.

#include <heckbert/taxonomy/dialect.h>

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/work.h>

namespace heckbert::taxonomy {
namespace {

using enum Dialect;
using ::testing::AllOf;
using ::testing::HasSubstr;

Language meaning(std::string_view text, Dialect dialect) {
  return read_expression(text, dialect).language;
}

std::string errors_of(std::string_view text, Dialect dialect) {
  try {
    read_expression(text, dialect);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// ---- reading -------------------------------------------------------------------------------------------------------

struct Same {
  Dialect dialect;
  const char* text;
  const char* heckbert;
};

void expect_all(const std::vector<Same>& table) {
  for (const Same& row : table)
    EXPECT_EQ(meaning(row.text, row.dialect), compile(row.heckbert))
        << row.text << " in " << facts(row.dialect).title << " is not " << row.heckbert;
}

TEST(Dialect, LettersMeanWhatEachRendererSays) {
  expect_all({
      {Osl, "CDL", "E D [LaLpLd]"},
      {Osl, "CDO", "E D La"},
      {Osl, "CDB", "E D Le"},
      {Osl, "CD[LOB]", "E D L"},
      {Osl, "C<RD>L", "E Dr [LaLpLd]"},
      {Osl, "C<T[GS]>O", "E [GtSt] La"},
      {Osl, "C<.D>O", "E D La"},
      {Osl, "C<R.>O", "E [DrGrSr] La"},
      {Osl, "C<R..>O", "E [DrGrSr] La"},
      {Osl, "C<T>O", "E [DtGtSt] La"},
      {Osl, "CRO", "E [DrGrSr] La"},
      {Osl, "CTO", "E [DtGtSt] La"},
      {Osl, "CVO", "E V La"},
      {Osl, "C<V.>O", "E V La"},
      {Osl, "C<[RV].>O", "E [DrGrSrV] La"},
      {Osl, "C<R[^D]>O", "E [GrSr] La"},
      {Osl, "C[^D]O", "E [GSV] La"},
      {Osl, "C[^R]O", "E [DtGtStV] La"},
      {Osl, "C<L.>", "E [LaLpLd]"},
      {Osl, "C[<L.>OB]", "E L"},
      {Osl, "C.*", "L.*E"},
      {Osl, "C.*[LOB]", "L.*E"},
      {Osl, ".DO", "E D La"},
      {Osl, "C<Ts>*DO", "E D La"},
      {MoonRay, "CD[<L.>O]", "E D [LaLpLd]"},
      {MoonRay, " CDL ", "E D [LaLpLd]"},
      {RenderMan, "CDL", "E D L"},
      {RenderMan, "CSL", "E [GS] L"},
      {RenderMan, "C [D S] L", "E . L & !(L.*V.*E)"},
      {Arnold, "CSL", "E [GS] [LaLpLd]"},
      {Arnold, "C[DSV]L", "E . [LaLpLd]"},
      {Karma, "CGL", "E [GS] [LaLpLd]"},
      {Karma, "C<TG>O", "E [GtSt] La"},
      {VRay, "CGL", "E G [LaLpLd]"},
      {VRay, "CD?L", "E D? [LaLpLd]"},
      {Iray, "L.*E", "L.*E"},
      {Iray, "E.*L", "L.*E"},
      {Iray, "La D E", "La D E"},
      {Iray, "Lp <RS> E", "[LpLd] Sr E"},
      {Iray, "E D Le", "Le D E"},
      {Iray, "E[<RG><TS>]Le", "Le [GrSt] E"},
      {Iray, "L[^S]E", "L[DGV]E"},
      {Iray, "LDS{1,2}E|E S L", "LDSS?E|LSE"},
      {Heckbert, "LD?S*E", "LD?S*E"},
  });
}

TEST(Dialect, PrecedenceAndCountsAreEachDialectsOwn) {
  expect_all({
      {Osl, "CD|SO", "E (D|S) La"},
      {RenderMan, "CD|SO", "E (D|[GS]) La"},
      {MoonRay, "CD|SO", "E (D|S) La"},
      {Osl, "CD*|SO", "E (D*|S) La"},
      {Osl, "CD|S*O", "E (D|S*) La"},
      {Osl, "C(DD)|SO", "E (DD|S) La"},
      {Osl, "CD|S|GO", "E [DSG] La"},
      {Osl, "CD{2}O", "E D D La"},
      {Osl, "CD{2,}O", "E D{2,} La"},
      {Osl, "CD{0,1}O", "E D? La"},
      {RenderMan, "CD{2}O", "E D D La"},
      {Iray, "LaDE|LaSE", "LaDE|LaSE"},
      {VRay, "CDO|CSO", "E [DS] La"},
      {Arnold, "CDO|CSO", "E [DG] La | E S La"},
      {Karma, "C(DO|GO)", "E [DGS] La"},
      {VRay, "C.*O & ^CD.*O", "E (.*) La - E D .* La"},
      {VRay, "C.*O - CD.*O", "E .* La - E D .* La"},
      {VRay, "C.O - CDO - CDO", "E . La - E D La"},
      {VRay, "^C.*", "LE - LE"},
      {VRay, "C<RD>(.+L|.*[OB])", "E Dr (.+ [LaLpLd] | .* [LaLe])"},
  });
}

// peers.md, 2b: how vendors write the same idea; each is read as what it says.
TEST(Dialect, TheSameIdeaInSixSpellings) {
  const char* everything_without_media = "L[DGS]*E";
  expect_all({
      {Heckbert, "L(D|S)*E", "L(D|S)*E"},
      {Osl, "C.*[LOB]", "L.*E"},
      {RenderMan, "C[DS]*[<L.>O]", everything_without_media},
      {Arnold, "C.*", "L.*E"},
      {VRay, "C.*", "L.*E"},
      // Direct diffuse.
      {Osl, "CDL", "[LaLpLd] D E"},
      {RenderMan, "C<RD>[<L.>O]", "L Dr E"},
      {Arnold, "C<RD>L", "[LaLpLd] Dr E"},
      {VRay, "C<RD>L", "[LaLpLd] Dr E"},
      {MoonRay, "CD[<L.>O]", "[LaLpLd] D E"},
      // Indirect diffuse.
      {Osl, "CD.+L", "[LaLpLd] .+ D E"},
      {RenderMan, "C<RD>[DS]+[<L.>O]", "L [DGS]+ Dr E"},
      {Arnold, "C<RD>[DSVOB].*", "L .+ Dr E | [LaLe] Dr E"},
      {VRay, "C<RD>(.+L|.*[OB])", "[LaLpLd] .+ Dr E | [LaLe] .* Dr E"},
      // Caustics.
      {Osl, "CDS+L", "[LaLpLd] S+ D E"},
      {RenderMan, "CD[S]+[<L.>O]", "L [GS]+ D E"},
      {MoonRay, "CD[S]+[<L.>O]", "[LaLpLd] S+ D E"},
      // Radiosity and Whitted.
      {Osl, "CD*L", "[LaLpLd] D* E"},
      {Osl, "CS*D{0,1}L", "[LaLpLd] D? S* E"},
  });
}

TEST(Dialect, TheVRayPresetLosesPathsWhenPastedIntoOsl) {
  const Translation t = translate("C<RD>(.+L|.*[OB])", VRay, Osl);
  ASSERT_TRUE(t.differs_on.has_value());
  EXPECT_TRUE(t.only_in_from);
  EXPECT_EQ(fine(*t.differs_on), "LaDrEp");
  EXPECT_EQ(meaning(t.writing.text, Osl), t.reading.language);
}

TEST(Dialect, AWholeUnionAndATightUnionDifferOnTheShortestWord) {
  const Translation t = translate("CD|SL", Osl, Iray);
  EXPECT_EQ(t.reading.language, compile("[LaLpLd](D|S)E"));
  ASSERT_TRUE(t.differs_on.has_value());
  EXPECT_EQ(fine(*t.differs_on), "LaDrEp");
  EXPECT_TRUE(t.only_in_from);
  const Reading in_iray = read_expression("CD|SL", Iray);
  EXPECT_TRUE(in_iray.language.is_empty());
  ASSERT_EQ(in_iray.warnings.size(), 1u);
  EXPECT_THAT(in_iray.warnings[0].message, HasSubstr("no path matches this in Iray"));
  EXPECT_FALSE(translate("CDO", Osl, Arnold).differs_on.has_value());
}

TEST(Dialect, OfTwoWordsOnWhichDialectsDifferTheShorterIsShown) {
  // Each dialect has a word that the other lacks: LaDrGrEp is OSL's, LaDrEp is V-Ray's; LeEp Iray's, LaSrEp Karma's.
  struct Case {
    const char* text;
    Dialect longer, shorter;
    const char* word;
  };
  for (const auto& [text, longer, shorter, word] :
       {Case{"CG|C.O", Osl, VRay, "LaDrEp"}, Case{"CL|SS.", Osl, Arnold, "LaEp"}, Case{"CG*L", Karma, Iray, "LeEp"}}) {
    const Translation there = translate(text, longer, shorter), back = translate(text, shorter, longer);
    for (const Translation& t : {there, back}) {
      ASSERT_TRUE(t.differs_on) << text;
      EXPECT_EQ(fine(*t.differs_on), word) << text;
    }
    EXPECT_FALSE(there.only_in_from) << text;
    EXPECT_TRUE(back.only_in_from) << text;
  }
}

TEST(Dialect, EventsThatOurWordsDoNotHaveMatchNothingAndSaySo) {
  const Reading straight = read_expression("C<Ts>DL", Osl);
  EXPECT_TRUE(straight.language.is_empty());
  ASSERT_EQ(straight.warnings.size(), 2u);
  EXPECT_THAT(straight.warnings[0].message, HasSubstr("matches nothing"));
  EXPECT_THAT(format(read_expression("C<LD>", Osl).warnings.at(0)), HasSubstr("\n   ^^^^\n"));
}

// ---- prefixes ------------------------------------------------------------------------------------------------------

TEST(Dialect, PrefixesAreKeptWhereTheyExist) {
  const Reading r = read_expression("lpe:noclamp;unoccluded;C<RD>[<L.>O]", RenderMan);
  EXPECT_EQ(r.prefixes, (std::vector<std::string>{"lpe", "noclamp", "unoccluded"}));
  EXPECT_EQ(r.language, meaning("C<RD>[<L.>O]", RenderMan));
  EXPECT_EQ(translate("lpe:unoccluded;CDO", RenderMan, Karma).writing.text, "unoccluded;CDO");
  EXPECT_EQ(translate("lpe:CDO", RenderMan, Osl).writing.text, "CDO");
  EXPECT_EQ(translate("lpe:noclamp;CDO", RenderMan, Osl).writing.refusal, "OSL has no prefix 'noclamp'");
  EXPECT_THAT(errors_of("unoccluded;CDL", Osl), HasSubstr("OSL has no prefix 'unoccluded'"));
  EXPECT_THAT(errors_of("unocluded;CDL", Karma), HasSubstr("did you mean 'unoccluded'?"));
}

// ---- writing -------------------------------------------------------------------------------------------------------

struct Carried {
  Dialect from;
  const char* text;
  Dialect to;
  const char* expected;
};

TEST(Dialect, TranslationsReadAsAPersonWouldWriteThem) {
  const Carried table[] = {
      {Heckbert, "LD?S*E", Osl, "CS*D{0,1}[LOB]"},
      {Heckbert, "LS+DE", Osl, "CDS+[LOB]"},
      {Heckbert, "L(D|S)*E", Osl, "C(D|S)*[LOB]"},
      {Heckbert, "L.*E", Osl, "C.*[LOB]"},
      {Heckbert, "LD(G|S)*E", Arnold, "CS*D[LOB]"},
      {Heckbert, "LD(G|S)*E", Karma, "CG*D[LOB]"},
      {Heckbert, "L Dr [GtSt] E", Osl, "C<T[GS]><RD>[LOB]"},
      {Heckbert, "La D E", Iray, "LaDE"},
      {Heckbert, "[LpLd] D E", Iray, "LpDE"},
      {Osl, "CS*D{0,1}L", VRay, "CS*D?L"},
      {Osl, "CS*D{0,1}L", Heckbert, "[LaLpLd]D?S*E"},
      {Osl, "CD|SO", Iray, "La(D|S)E"},
      {Osl, "CD{2,3}O", VRay, "CDDD?O"},
      {Osl, "CD{2,}O", Karma, "CDD+O"},
      {VRay, "CD?O", Arnold, "C(DO|O)"},
      {VRay, "C(DG|S)O", Osl, "C((DG)|S)O"},
      {Arnold, "C<RD>L", MoonRay, "C<RD>L"},
      {Iray, "L.*E", RenderMan, "C.*[LO]"},
  };
  for (const Carried& row : table) {
    const Translation t = translate(row.text, row.from, row.to);
    EXPECT_EQ(t.writing.text, row.expected) << row.text << ": " << t.writing.refusal;
    EXPECT_EQ(meaning(t.writing.text, row.to), t.reading.language) << row.text;
  }
}

TEST(Dialect, WhatCannotBeSaidIsRefusedWithTwoWords) {
  const Carried table[] = {
      {Heckbert, "LSE", Karma, "LaSrEp is in it and LaGrEp is not, and Karma cannot tell Gr from Sr"},
      {Heckbert, "LGE", Arnold, "LaGrEp is in it and LaSrEp is not, and Arnold cannot tell Gr from Sr"},
      {Heckbert, "LpDE", Osl, "LpDrEp is in it and LaDrEp is not, and OSL cannot say Lp without La"},
      {Heckbert, "LdDE", Iray, "LdDrEp is in it and LpDrEp is not, and Iray cannot tell Lp from Ld"},
      {Heckbert, "LDEp", Osl, "LaDrEp is in it and LaDrEl is not, and OSL cannot tell Ep from El"},
      {Heckbert, "LeDE", RenderMan, "LeDrEp is in it and LpDrEp is not, and RenderMan cannot tell Lp from Le"},
      {Heckbert, "L D{50} S E", Karma,
       "LaDrDrDrDrDrDrDrDrDr...DrDrDrDrDrDrDrDrSrEp is in it and LaDrDrDrDrDrDrDrDrDr...DrDrDrDrDrDrDrDrGrEp is not, "
       "and Karma cannot tell Gr from Sr"},
      {VRay, "CDL-CDL", Osl, "no path is in it, and OSL has no expression for that"},
  };
  for (const Carried& row : table) {
    const Writing w = translate(row.text, row.from, row.to).writing;
    EXPECT_EQ(w.refusal, row.expected) << row.text;
    EXPECT_EQ(w.text, "") << row.text;
  }
}

TEST(Dialect, OperatorsOnWholeExpressionsAreWorkedOutForDialectsWithoutThem) {
  for (const DialectFacts& d : kDialects) {
    const Translation t = translate("LX*E - LD?[GS]*E", Heckbert, d.dialect);
    ASSERT_NE(t.writing.text, "") << d.title << ": " << t.writing.refusal;
    EXPECT_EQ(meaning(t.writing.text, d.dialect), t.reading.language) << d.title << " " << t.writing.text;
  }
}

TEST(Dialect, OperatorsOnWholeExpressionsAreKeptWhereTheDialectHasThem) {
  const Carried table[] = {
      {Heckbert, "LX*E - LD?[GS]*E", VRay, "C[DGS]*[LOB] - C[GS]*D?[LOB]"},
      {Heckbert, "!LD*E", VRay, "^CD*[LOB]"},
      {Heckbert, "!(LD*E | LSE)", VRay, "^(CD*[LOB]|CS[LOB])"},
      {Heckbert, "LX*E & !(LDE - ESL)", VRay, "C[DGS]*[LOB] & (^(CD[LOB] - CS[LOB]))"},
      {Heckbert, "LaDE - LpDE | LSE", VRay, ""},  // Lp alone cannot be said
      {Heckbert, "@whitted - @radiosity", VRay, ""},
      {VRay, "C.*O - CD.*O", Heckbert, "La.*E - La.*DE"},
      {VRay, "^CD*O", Heckbert, "!LaD*E"},
      {Heckbert, "@caustic - LSDE", Heckbert, "LS+DE - LSDE"},
  };
  for (const Carried& row : table) {
    const Names names = builtin_grammars().names();
    const Translation t = translate(row.text, row.from, row.to, names);
    const std::string expected = *row.expected != 0 ? row.expected : t.writing.text;
    EXPECT_EQ(t.writing.text, expected) << row.text << ": " << t.writing.refusal;
    EXPECT_TRUE(t.writing.text.empty() || meaning(t.writing.text, row.to) == t.reading.language) << row.text;
  }
  // Without a text to keep, the complement is used where it is shorter.
  EXPECT_EQ(write_expression(compile("!LDSGE"), VRay).text, "^CGSD[LOB]");
  EXPECT_EQ(write_expression(compile("!LDSGE"), Heckbert).text, "!LDSGE");
}

// ---- broken expressions --------------------------------------------------------------------------------------------

struct Broken {
  Dialect dialect;
  const char* text;
  const char* message;
  const char* suggestion;
};

TEST(Dialect, BrokenExpressionsOfVendorsAreRepaired) {
  const Broken table[] = {
      {VRay, "C<\u0422[GS]>(.+L|.*[OB])", "Cyrillic letter that looks like T", "did you mean 'C<T[GS]>(.+L|.*[OB])'?"},
      {RenderMan, "lpe:CD[S]+[<L.>>O]", "'>' closes nothing", "did you mean 'lpe:CD[S]+[<L.>O]'?"},
      {Arnold, "C<RD+>L", "a repetition inside '<..>'", "did you mean 'C<RD>+L'?"},
  };
  for (const Broken& row : table) {
    const std::string errors = errors_of(row.text, row.dialect);
    EXPECT_THAT(errors, AllOf(HasSubstr(row.message), HasSubstr(row.suggestion))) << row.text;
    EXPECT_THAT(errors, HasSubstr("^")) << row.text;
  }
}

TEST(Dialect, MistakesAreNamedWithARemedy) {
  const Broken table[] = {
      {Osl, "CD?L", "OSL has no '?'", "did you mean 'CD{0,1}L'?"},
      {RenderMan, "CD?L", "RenderMan has no '?'", "write both"},
      {Karma, "CSL", "'S' is not read here: Karma writes G", "did you mean 'CGL'?"},
      {Arnold, "CGL", "Arnold writes S", "did you mean 'CSL'?"},
      {Osl, "EDL", "OSL writes C", "did you mean 'CDL'?"},
      {Osl, "C D L", "no blanks", "did you mean 'CDL'?"},
      {Osl, "CD+*L", "a second repetition", "(D+)*"},
      {Osl, "C<RD'skin>L", "the label is never closed", ""},
      {Arnold, "C<R'coat'>L", "a label stands third", "did you mean 'C<R.'coat'>L'?"},
      {Osl, "C<'coat'>L", "a label stands third", "did you mean 'C<..'coat'>L'?"},
      {VRay, "C<RD'1''2'>L", "a second label", "a letter of our words has one"},
      {Karma, "C<RG['hair'['coat']]>L", "is for labels in quotes", ""},
      {RenderMan, "C<RD2>L", "numbered lobes", "did you mean 'C<RD>L'?"},
      {RenderMan, "CD2L", "numbered lobes", "did you mean 'CDL'?"},
      {Osl, "C(DL", "'(' is never closed", "did you mean 'C(DL)'?"},
      {Osl, "C[DSL", "'[' is never closed", "did you mean 'C[DSL]'?"},
      {Osl, "C<RD", "'<' is never closed", "did you mean 'C<RD>'?"},
      {Osl, "CD)L", "')' closes nothing", "did you mean 'CDL'?"},
      {Osl, "C<D>L", "'D' is a scattering", "did you mean 'C<.D>L'?"},
      {Osl, "C<RT>L", "'T' is a type of event", ""},
      {Osl, "C<>L", "an empty event", "did you mean 'C.L'?"},
      {Osl, "C[]L", "an empty set", ""},
      {Osl, "C[^RD]L", "event types and scattering letters together", ""},
      {Osl, "C(D|)L", "an empty alternative", ""},
      {Iray, "C(D|)L", "an empty alternative", ""},
      {Osl, "C*|", "an empty alternative", ""},
      {Osl, "|D", "an empty alternative", ""},
      {Osl, "^CDL", "'^' is no operator here", ""},
      {VRay, "C(CDL&CDL)L", "'&' works on whole paths", ""},
      {Osl, "CAL", "albedo is no light path", ""},
      {Karma, "CD{2}L", "no such count in its documents", ""},
      {Osl, "CD{3,1}L", "the least number of this count exceeds the greatest", "did you mean 'CD{1,3}L'?"},
      {Osl, "CD{a}L", "a count is written", ""},
      {Osl, "", "an empty expression", ""},
      {Iray, "  ", "an empty expression", ""},
      {Osl, "@whitted", "OSL has no named classes", ""},
      {Iray, "LDB", "Iray writes Le", "did you mean 'LDLe'?"},
      {Osl, "C\xff", "unknown letter", ""},
  };
  for (const Broken& row : table)
    EXPECT_THAT(errors_of(row.text, row.dialect), AllOf(HasSubstr(row.message), HasSubstr(row.suggestion))) << row.text;
}

TEST(Dialect, NoRepairIsProposedThatDoesNotReadBack) {
  // Closing the bracket leaves an empty event, dropping the stray ones an operator without its right side.
  for (const auto& [dialect, text, message, repair] :
       {Broken{Osl, "C<", "'<' is never closed", "'C<>'"}, Broken{VRay, "CD)&]", "']' closes nothing", "'CD&'"}})
    EXPECT_THAT(errors_of(text, dialect), AllOf(HasSubstr(message), Not(HasSubstr(repair)))) << text;
}

TEST(Dialect, AllErrorsOfATextAreFound) {
  try {
    read_expression("CQD?<R'x'>L>", Osl);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 4u);
    EXPECT_EQ(error.diagnostics()[0].column, 2u);
    EXPECT_EQ(error.diagnostics()[1].column, 4u);
    EXPECT_EQ(error.diagnostics()[2].column, 7u);
    EXPECT_EQ(error.diagnostics()[3].column, 12u);
  }
}

TEST(Dialect, TenThousandCharactersTakeFewSteps) {
  std::string letters, groups;
  for (int i = 0; i < 4900; ++i) letters += "DG";
  for (int i = 0; i < 900; ++i) groups += "(D|G)*S";
  const WorkLimit counter(kUnlimitedSteps);
  EXPECT_EQ(translate("C" + letters + "O", Osl, VRay).writing.text, "C" + letters + "O");
  EXPECT_NE(translate("C" + groups + "L", Osl, RenderMan).writing.refusal, "");
  // 6.4 million; read, written, read back, and read as the other dialect, of which each reading may take 3 million.
  EXPECT_LT(counter.spent(), 10'000'000u);
}

TEST(Dialect, NestingWithoutEndAndCountsWithoutBoundAreRefused) {
  EXPECT_THAT(errors_of("C" + std::string(5000, '(') + "D", Osl), HasSubstr("nested deeper"));
  EXPECT_THAT(errors_of(std::string(5000, '^') + "CL", VRay), HasSubstr("nested deeper"));
  EXPECT_THAT(errors_of("CD" + std::string(5000, '*') + "L", Heckbert), HasSubstr("nested deeper"));
  EXPECT_THAT(errors_of("CD{99999999999}L", Osl), HasSubstr("a count above"));
  EXPECT_THROW(read_expression("C.{30}D.*L", Osl), LimitError);
}

}  // namespace
}  // namespace heckbert::taxonomy
