// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/page.hpp"

#include <expat.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "core/file.hpp"
#include "pictures/alignability_picture.hpp"
#include "pictures/text.hpp"
#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"
#include "tests/pictures/read_png.hpp"
#include "tests/pictures/small_site.hpp"

namespace alignability {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::size_t kLargestFile = 10'000'000;

// What an SVG consists of.
struct SvgParts {
  std::map<std::string, std::string> root;  // attributes
  std::map<std::string, int> elements;      // how many
  std::vector<double> image_widths;
  std::vector<std::string> ids;
  std::set<std::string> used;  // ids
};

void collect(void* parts_pointer, const XML_Char* name, const XML_Char** attributes) {
  SvgParts& parts = *static_cast<SvgParts*>(parts_pointer);
  const bool is_root = parts.elements.empty();
  ++parts.elements[name];
  for (; *attributes != nullptr; attributes += 2) {
    const std::string key = attributes[0];
    const std::string value = attributes[1];
    if (is_root) parts.root[key] = value;
    if (key == "id") parts.ids.push_back(value);
    if (key == "xlink:href" && value.starts_with('#')) parts.used.insert(value.substr(1));
    if (std::string(name) == "image" && key == "width") parts.image_widths.push_back(std::stod(value));
  }
}

SvgParts parse(const std::string& svg) {
  SvgParts parts;
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  XML_SetUserData(parser.get(), &parts);
  XML_SetStartElementHandler(parser.get(), collect);
  EXPECT_EQ(XML_Parse(parser.get(), svg.data(), static_cast<int>(svg.size()), XML_TRUE), XML_STATUS_OK)
      << XML_ErrorString(XML_GetErrorCode(parser.get()));
  std::ranges::sort(parts.ids);
  EXPECT_EQ(std::ranges::adjacent_find(parts.ids), parts.ids.end()) << "an id twice";
  return parts;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class PageFile : public ::testing::Test {
 protected:
  std::string saved(const detail::Page& page, const std::string& name) {
    page.save(folder_ / name);
    return read_file(folder_ / name, kLargestFile);
  }
  std::string map_as(const std::string& name) {
    const SmallSite site;
    draw_alignability_map(site.map, site.occupancy, {.title = "small", .risk = {}}, folder_ / name);
    return read_file(folder_ / name, kLargestFile);
  }

  TemporaryFolder folder_;
};

TEST_F(PageFile, IsOfTheKindThatItsNameSays) {
  const detail::Page page(120.0, 60.5);
  EXPECT_THAT(saved(page, "page.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(saved(page, "page.svg"), StartsWith("<?xml"));
  EXPECT_THAT(saved(page, "page.pdf"), StartsWith("%PDF-"));
}

TEST_F(PageFile, OfAnotherNameIsRefused) {
  const detail::Page page(120.0, 60.0);
  for (const std::string name : {"page.jpg", "page", "page.PNG", "page.svg.gz", ".svg"}) {
    EXPECT_THAT(thrown_message([&] { page.save(folder_ / name); }), HasSubstr("a picture's name ends in .png, .svg or .pdf")) << name;
  }
  EXPECT_EQ(folder_.files(), 0);
}

TEST_F(PageFile, IsAsLargeAsThePageRoundedUpInEveryKind) {
  const detail::Page page(120.0, 60.5);
  page.save(folder_ / "page.png");
  const Picture png(folder_ / "page.png");
  EXPECT_EQ(png.width(), 120);
  EXPECT_EQ(png.height(), 61);
  const SvgParts svg = parse(saved(page, "page.svg"));
  EXPECT_EQ(svg.root.at("width"), "120px");
  EXPECT_EQ(svg.root.at("height"), "61px");
  EXPECT_EQ(svg.root.at("viewBox"), "0 0 120 61");
  EXPECT_THAT(saved(page, "page.pdf"), HasSubstr("/MediaBox [ 0 0 120 61 ]"));
}

TEST_F(PageFile, HasTextAsGlyphsThatAreUsedNotAsPixels) {
  const detail::Page page(200.0, 60.0);
  detail::draw_text(page.context(), "abca", {10.0, 40.0}, {});
  const SvgParts svg = parse(saved(page, "page.svg"));
  EXPECT_EQ(svg.elements.at("symbol"), 4);  // of the font's own box for what it lacks, a, b and c
  EXPECT_EQ(svg.elements.count("image"), 0u);
  EXPECT_TRUE(std::ranges::includes(svg.ids, svg.used));
  EXPECT_GE(svg.used.size(), 3u);
  const std::string pdf = saved(page, "page.pdf");
  EXPECT_THAT(pdf, HasSubstr("/Type /Font"));
  EXPECT_THAT(pdf, Not(HasSubstr("/Subtype /Image")));
}

TEST_F(PageFile, OfAMapIsDrawnInLinesButForTheMapItself) {
  const std::string bytes = map_as("map.svg");
  const SvgParts svg = parse(bytes);
  EXPECT_GT(svg.elements.at("path"), 10);
  EXPECT_GT(svg.elements.at("use"), 50);
  ASSERT_FALSE(svg.image_widths.empty());
  const double width = std::stod(svg.root.at("width"));
  for (const double image : svg.image_widths) EXPECT_LT(image, width);
  EXPECT_EQ(count(bytes, "<image style=\"image-rendering:pixelated\""), svg.elements.at("image"));
  EXPECT_TRUE(std::ranges::includes(svg.ids, svg.used));
}

TEST_F(PageFile, IsOnePageOfPdfWhoseMapIsNotSmoothed) {
  const std::string pdf = map_as("map.pdf");
  EXPECT_EQ(count(pdf, "/Type /Page "), 1);
  EXPECT_THAT(pdf, Not(HasSubstr("/Interpolate true")));
  EXPECT_THAT(pdf, HasSubstr("%%EOF"));
}

TEST_F(PageFile, OfTheSameDrawingHasTheSameBytes) {
  for (const std::string kind : {".png", ".svg", ".pdf"}) {
    const std::string first = map_as("first" + kind);
    EXPECT_EQ(first, map_as("second" + kind)) << kind;
  }
}

}  // namespace
}  // namespace alignability
