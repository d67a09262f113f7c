// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "core/input_error.hpp"

namespace alignability {
namespace {

const std::vector<std::string> kKeys{"goal", "max", "min", "mode", "negate", "origin", "resolution", "risk_weight", "seed", "start"};

TEST(DidYouMean, RecognizesASlipOfTheKeyboard) {
  EXPECT_EQ(did_you_mean("risk_wieght", kKeys), " (did you mean 'risk_weight'?)");  // two letters swapped
  EXPECT_EQ(did_you_mean("resoluton", kKeys), " (did you mean 'resolution'?)");     // one left out
  EXPECT_EQ(did_you_mean("sseed", kKeys), " (did you mean 'seed'?)");               // one too many
  EXPECT_EQ(did_you_mean("gaol", kKeys), " (did you mean 'goal'?)");
  EXPECT_EQ(did_you_mean("mdoe", kKeys), " (did you mean 'mode'?)");
  EXPECT_EQ(did_you_mean("negtae", kKeys), " (did you mean 'negate'?)");
  EXPECT_EQ(did_you_mean("maxx", kKeys), " (did you mean 'max'?)");
}

TEST(DidYouMean, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(did_you_mean("velocity", kKeys), "");
  EXPECT_EQ(did_you_mean("x", kKeys), "");
  EXPECT_EQ(did_you_mean("", kKeys), "");
  EXPECT_EQ(did_you_mean("seed", {}), "");
  EXPECT_EQ(did_you_mean(std::string(100000, 'a'), kKeys), "");
}

TEST(DidYouMean, DoesNotTakeOneShortWordForAnother) {
  EXPECT_EQ(did_you_mean("max", std::vector<std::string>{"min"}), "");
  EXPECT_EQ(did_you_mean("rate", std::vector<std::string>{"name"}), "");
}

TEST(DidYouMean, NamesTheNearestOfSeveral) {
  const std::vector<std::string> near{"free_threshold", "free_thresh", "free_trash"};
  EXPECT_EQ(did_you_mean("free_thrsh", near), " (did you mean 'free_thresh'?)");
}

TEST(DidYouMean, FindsAnyWordOfFourLettersWithOneLetterChanged) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 200; ++i) {
    std::string word(4 + random() % 20, ' ');
    for (char& letter : word) letter = static_cast<char>('a' + random() % 26);
    std::string slip = word;
    slip[random() % slip.size()] = '_';
    EXPECT_EQ(did_you_mean(slip, std::vector<std::string>{word}), " (did you mean '" + word + "'?)") << slip;
  }
}

TEST(InputErrorMessage, ReadsLikeACompilers) {
  EXPECT_STREQ(InputError("maps/a.yaml", {7, 3}, "unknown").what(), "maps/a.yaml:7:3: unknown");
  EXPECT_STREQ(InputError("maps/a.yaml", {7, 0}, "unknown").what(), "maps/a.yaml:7: unknown");
  EXPECT_STREQ(InputError("maps/a.png", "damaged").what(), "maps/a.png: damaged");
  const InputError error("maps/a.yaml", {7, 3}, "unknown");
  EXPECT_EQ(error.file(), "maps/a.yaml");
  EXPECT_EQ(error.position().line, 7);
  EXPECT_EQ(error.position().column, 3);
}

}  // namespace
}  // namespace alignability
