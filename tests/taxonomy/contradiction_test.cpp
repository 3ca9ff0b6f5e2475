// Why expressions have no path: the culprits are the smallest set of operands, and what they demand is what they do.

#include <heckbert/taxonomy/contradiction.h>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/grammar.h>

namespace heckbert::taxonomy {
namespace {

TEST(Contradiction, IsToldOfTheOperandsThatLeaveNothing) {
  struct Case {
    const char* expression;
    const char* reason;
  };
  const Case cases[] = {
      // What each of two demands.
      {"LD*E & L.*S.*E", "every path of 'LD*E' has no event but D, and every path of 'L.*S.*E' has S"},
      {"L.*S.*E & LD*E", "every path of 'L.*S.*E' has S, and every path of 'LD*E' has no event but D"},
      {"LaDE & [LpLd].*E", "every path of 'LaDE' begins at La, and every path of '[LpLd].*E' begins at Lp or Ld"},
      {"LDEl & LX*Ep", "every path of 'LDEl' ends at El, and every path of 'LX*Ep' ends at Ep"},
      {"L.E & L..E", "every path of 'L.E' has exactly 1 event, and every path of 'L..E' has exactly 2 events"},
      {"L.{3,}E & L.?E", "every path of 'L.{3,}E' has at least 3 events, and every path of 'L.?E' has at most 1 event"},
      {"LS.*E & LD.*E",
       "every path of 'LS.*E' has S beside the light, and every path of 'LD.*E' has D beside the light"},
      {"L.*SE & E[^S].*L",
       "every path of 'L.*SE' has S beside the eye, and every path of 'E[^S].*L' has D, G or V "
       "beside the eye"},
      {"LE & L.*DtE", "every path of 'LE' has no event, and every path of 'L.*DtE' has D"},
      {"L(DS)+E & L(SD)+E",
       "every path of 'L(DS)+E' has D beside the light, and every path of 'L(SD)+E' has S "
       "beside the light"},
      {"L(DD)*E & L.*D.*E & LD(DD)*E", "'L(DD)*E' and 'LD(DD)*E' have no path in common"},
      // Names, groups and alternatives.
      {"@radiosity & @caustic", "every path of '@radiosity' has no event but D, and every path of '@caustic' has S"},
      {"(LDE | LSE) & LGE",
       "every path of '(LDE | LSE)' has no event but D or S, and every path of 'LGE' has "
       "G"},
      {"(LDE & LSE) | (LGE & LVE)", "every path of 'LDE' has no event but D, and every path of 'LSE' has S"},
      // What is taken away.
      {"LDE - LD*E", "every path of 'LDE' is in 'LD*E', which is taken away"},
      {"LDE & !LX*E", "every path of 'LDE' is in 'LX*E', which is taken away"},
      {"LD?E - LE - LDE", "every path of 'LD?E' is in 'LE' or 'LDE', which are taken away"},
      {"LD?E & L.E - LDE", "every path of 'LD?E' and 'L.E' is in 'LDE', which is taken away"},
      {"!L.*E", "every path is in 'L.*E', which is taken away"},
      {"LX*E & L(D|V)*E & L.E & !LDE", "every path of 'LX*E', 'L(D|V)*E' and 'L.E' is in 'LDE', which is taken away"},
      {"L[DS]E & L[SG]E & L[DG]E", "no path is in all of 'L[DS]E', 'L[SG]E' and 'L[DG]E'"},
      // Others are left out: the smallest set, not the first that was written.
      {"L.*E & LX*E & LD*E & LN*E & LS+E", "every path of 'LD*E' has no event but D, and every path of 'LS+E' has S"},
      {"(LDE & LSE) & L.*E", "every path of 'LDE' has no event but D, and every path of 'LSE' has S"},
      {"(LDE - LDE) & L.*E", "every path of 'LDE' is in 'LDE', which is taken away"},
  };
  const Names names = builtin_grammars().names();
  for (const Case& c : cases) EXPECT_EQ(why_empty(c.expression, Dialect::Heckbert, names), c.reason) << c.expression;
}

TEST(Contradiction, IsFoundInVRaysOperatorsToo) {
  EXPECT_EQ(why_empty("CD*[LOB] & C.*S.*[LOB]", Dialect::VRay),
            "every path of 'CD*[LOB]' has no event but D, and every path of 'C.*S.*[LOB]' has S");
  EXPECT_EQ(why_empty("^C.*", Dialect::VRay), "every path is in 'C.*', which is taken away");
}

TEST(Contradiction, IsNoneWhereSomethingMatchesOrNothingWasCombined) {
  for (const char* text : {"LDE", "LDE & LD*E", "LD*E - LDE", "!LDE", "LDE | (LDE & LSE)"})
    EXPECT_EQ(why_empty(text), std::nullopt) << text;
  EXPECT_EQ(why_empty("CD", Dialect::Osl), std::nullopt);
}

}  // namespace
}  // namespace heckbert::taxonomy
