// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "chart.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

/// A folder of this test that is empty, and gone afterwards: tests run at the same time.
struct Folder {
  Folder()
      : path(fs::path(testing::TempDir()) /
             (std::string("awd-report-") +
              testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(path);
  }
  ~Folder() { fs::remove_all(path); }
  std::string page() const {
    std::ifstream file(path / "index.html", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  fs::path path;
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++times;
  return times;
}

bool has(const std::string& text, const std::string& part) { return count(text, part) > 0; }

TEST(Report, EscapesWhatHtmlWouldRead) {
  EXPECT_EQ(htmlEscape("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  ReportSection section("x", "1 < 2");
  section.paragraph("<script>");
  section.command("awd-bench x --only a&b");
  section.table({"<i>", {"<b>"}, {{"</td>"}}});
  EXPECT_TRUE(has(section.html(), "<h2>1 &lt; 2</h2>"));
  for (const char* raw : {"<script>", "<i>", "<b>", "></td></td>", "a&b"}) {
    EXPECT_FALSE(has(section.html(), raw)) << raw;
  }
}

TEST(Report, ImagesAreInThePageAsBase64) {
  ReportSection section("x", "x");
  section.images(
      {{"none", ""}, {"one", "M"}, {"two", "Ma"}, {"three", "Man"}, {"high", "\xff\xff"}}, "all");
  for (const char* data : {"base64,\"", "base64,TQ==\"", "base64,TWE=\"", "base64,TWFu\"",
                           "base64,//8=\"", "alt=\"three\""}) {
    EXPECT_TRUE(has(section.html(), data)) << data;
  }
}

TEST(Report, ColumnsOfNumbersAreMarked) {
  ReportSection section("x", "x");
  section.table({"", {"word", "number", "mixed"}, {{"f2", "-1.5 [1, 2]", "3"}, {"m2", "–", "a"}}});
  EXPECT_TRUE(has(section.html(),
                  "<th scope=\"col\">word</th><th scope=\"col\" class=\"number\">"
                  "number</th><th scope=\"col\">mixed</th>"));
  EXPECT_EQ(count(section.html(), "<td class=\"number\">"), 2u);
}

TEST(Report, NumbersAreShort) {
  EXPECT_EQ(shortNumber(1234.5), "1230");
  EXPECT_EQ(shortNumber(-999999.0), "-1000000");
  EXPECT_EQ(shortNumber(1.23e7), "1.23e+07");
  EXPECT_EQ(shortNumber(0.12345), "0.123");
  EXPECT_EQ(shortNumber(std::nan("")), "–");
}

TEST(Report, SectionsKeepTheirOrderAndEachOther) {
  const Folder folder;
  for (const char* name : {"speed", "zebra", "guide", "density", "paper"}) {
    ReportSection section(name, std::string("Title of ") + name);
    section.paragraph("first");
    writeReport(folder.path.string(), section);
  }
  ReportSection again("guide", "Title of guide");
  again.paragraph("second");
  writeReport(folder.path.string(), again);

  const std::string page = folder.page();
  std::size_t last = 0;
  for (const char* name : {"paper", "guide", "density", "speed", "zebra"}) {
    const std::string tag = "<section id=\"" + std::string(name) + "\">";
    ASSERT_EQ(count(page, tag), 1u) << name;
    EXPECT_GT(page.find(tag), last) << name;
    last = page.find(tag);
    EXPECT_TRUE(has(page, "<a href=\"#" + std::string(name) + "\">Title of " + name + "</a>"));
  }
  EXPECT_EQ(count(page, "<p>first</p>"), 4u);
  EXPECT_EQ(count(page, "<p>second</p>"), 1u);
}

TEST(Report, ThePageLoadsNothing) {
  const Folder folder;
  ReportSection section("x", "x");
  section.images({{"one", "M"}}, "images");
  Plot plot;
  plot.panels = {{"", {{"a", {{1.0, 1.0, 1.0, 1.0}}}}}};
  section.plot(plot, "plot");
  writeReport(folder.path.string(), section);
  const std::string page = folder.page();
  EXPECT_TRUE(has(page, "default-src 'none'"));
  EXPECT_TRUE(has(page, "name=\"viewport\""));
  EXPECT_TRUE(has(page, "prefers-color-scheme: dark"));
  for (const char* loading : {"http://", "https://", "src=\"/", "url(", "@import", "<link"}) {
    EXPECT_FALSE(has(page, loading)) << loading;
  }
}

TEST(Chart, DrawsWhatCanBeShownAndNamesIt) {
  Plot plot;
  plot.title = "error & time";
  plot.x = {"time, s", true};
  plot.y = {"error", true};
  plot.names = {"b", "a"};
  const double nan = std::nan("");
  plot.panels = {
      {"one", {{"a", {{1.0, 2.0, 1.0, 4.0}, {2.0, 1.0, 1.0, 1.0}, {3.0, 0.0, 0.0, 0.0}}}}},
      {"none", {}},
      {"two", {{"c<", {{1.0, nan, nan, nan}, {2.0, 1.0, 1.0, 1.0}}}}}};
  plot.columns = 2;
  const std::string svg = chartSvg(plot);
  EXPECT_TRUE(has(svg, "<title>error &amp; time</title>"));
  EXPECT_TRUE(has(svg, "<desc>error against time, s for a, c&lt;.</desc>"));
  EXPECT_TRUE(has(svg, "viewBox=\"0 0 "));
  EXPECT_EQ(count(svg, "class=\"chart-frame\""), 2u);
  EXPECT_EQ(count(svg, "<g><title>"), 3u);  // a point with no place on the axes has no marker
  EXPECT_TRUE(has(svg, "a: 2 [1, 4] at 1"));
  EXPECT_EQ(count(svg, "chart-whisker"), 3u);
  EXPECT_TRUE(has(svg, "chart-line chart-colour-1"));  // a is the second of the names
  EXPECT_FALSE(has(svg, "chart-line chart-colour-0"));
  for (const char* bad : {"nan", "inf"}) EXPECT_FALSE(has(svg, bad)) << bad;
}

TEST(Chart, OfNothingIsEmpty) { EXPECT_TRUE(has(chartSvg(Plot()), "<svg class=\"chart\"")); }

}  // namespace
}  // namespace bench
