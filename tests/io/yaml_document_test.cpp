#include "rigor/io/files/yaml_document.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/files/text_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

namespace rigor::yaml_document_test {
namespace {

using Kind = YamlNode::Kind;

YamlNode::Pointer parsed(const std::string& text) {
  return parse_yaml(text, 0, YamlSources{{"f.yaml"}});
}

/// The message of text that is refused, within a second: nothing in a file may cost time or memory before it
/// is refused.
std::string message_of(const std::string& text) {
  const std::clock_t start = std::clock();
  std::string message = "accepted";
  try {
    parsed(text);
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 1);
  return message;
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(YamlDocument, KeepsPlacesKindsAndQuotes) {
  const YamlNode::Pointer root = parsed("a: 1\nb:\n  - \"x\"\n  - {c: ~}\n  -\n");
  ASSERT_EQ(root->kind, Kind::map);
  EXPECT_EQ(root->find("a")->value->text, "1");
  EXPECT_EQ(root->find("a")->line, 1);
  EXPECT_EQ(root->find("a")->value->column, 4);
  const YamlNode& list = *root->find("b")->value;
  ASSERT_EQ(list.entries.size(), 3u);
  EXPECT_TRUE(list.entries[0].value->is_quoted);
  EXPECT_EQ(list.entries[0].value->line, 3);
  EXPECT_EQ(list.entries[0].value->column, 5);
  EXPECT_EQ(list.entries[1].value->find("c")->value->kind, Kind::null);
  EXPECT_EQ(list.entries[2].value->kind, Kind::null);
  EXPECT_FALSE(root->find("c"));
}

TEST(YamlDocument, JsonIsTheSameThing) {
  const YamlNode::Pointer root =
      parsed("{\"a\":[1,\n\t2.5e3],\"b\":{\"c\":\"x\\/y\\u00e9\"},\"d\":null,\"e\":true}");
  EXPECT_EQ(root->find("a")->value->entries[1].value->text, "2.5e3");
  EXPECT_EQ(root->find("b")->value->find("c")->value->text, "x/yé");
  EXPECT_EQ(root->find("d")->value->kind, Kind::null);
  EXPECT_EQ(root->find("e")->value->text, "true");
}

TEST(YamlDocument, JsonSurrogatePairsAreOneCharacter) {
  EXPECT_EQ(parsed("{\"a\": \"\\ud83d\\ude00\"}")->find("a")->value->text, "😀");
  // An escaped backslash is not the start of an escape.
  EXPECT_EQ(parsed("{\"a\": \"\\\\ud83d\\\\ude00\"}")->find("a")->value->text, "\\ud83d\\ude00");
  // Half a pair is no character.
  EXPECT_NE(message_of("{\"a\": \"\\ud83d\"}"), "accepted");
}

TEST(YamlDocument, AliasesShareTheirNode) {
  const YamlNode::Pointer root = parsed("a: &x [1, 2]\nb: *x\n");
  EXPECT_EQ(root->find("a")->value, root->find("b")->value);
  EXPECT_EQ(root->size, 7u);
}

TEST(YamlDocument, KeepsDuplicateKeysForTheReader) {
  EXPECT_EQ(parsed("a: 1\na: 2\n")->entries.size(), 2u);
}

TEST(YamlDocument, AliasBombsAreRefused) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + repeated(alias + ", ", 9) + alias +
            "]\n";
  }
  // a5 would be the first with more than half a million: 10 + 1 values of a0, tenfold each line.
  EXPECT_EQ(message_of(bomb).substr(0, 9), "f.yaml:6:");
  EXPECT_NE(message_of(bomb).find("more than 500000 values (aliases written out)"), std::string::npos);
}

TEST(YamlDocument, ChainsOfAliasesAreRefused) {
  std::string chain = "a0: &a0 [x]\n";
  for (int i = 1; i < 1000; ++i) {
    chain += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [*a" + std::to_string(i - 1) + "]\n";
  }
  EXPECT_EQ(message_of(chain), "f.yaml:31:12: nested deeper than 32 levels");
}

TEST(YamlDocument, AliasesIntoThemselvesAreRefused) {
  EXPECT_EQ(message_of("a: &x [*x]\n"), "f.yaml:1:8: an alias inside of what it names");
  EXPECT_EQ(message_of("a: *y\n").substr(0, 24), "f.yaml:1:4: not YAML: th");
}

TEST(YamlDocument, DeepNestingIsRefused) {
  const std::string deep = "nested deeper than 32 levels";
  EXPECT_NE(message_of("a: " + repeated("{a: ", 100000)).find(deep), std::string::npos);
  EXPECT_NE(message_of(repeated("{a: ", 100000)), "accepted");
  EXPECT_NE(message_of(repeated("- ", 100000)).find(deep), std::string::npos);
  EXPECT_NE(message_of("a: " + repeated("[", 40) + repeated("]", 40)).find(deep), std::string::npos);
  EXPECT_NE(message_of(repeated("[", 100000)), "accepted");
  EXPECT_NE(message_of("? " + repeated("? ", 100000)), "accepted");
  std::string indented;
  for (int i = 0; i < 500; ++i) indented += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_NE(message_of(indented).find(deep), std::string::npos);
}

TEST(YamlDocument, TooManyValuesAreRefused) {
  YamlLimits limits;
  limits.max_nodes = 1000;
  const YamlSources sources{{"f.yaml"}};
  EXPECT_NO_THROW(parse_yaml("[" + repeated("1,", 900) + "1]", 0, sources, true, limits));
  EXPECT_THROW(parse_yaml("[" + repeated("1,", 1000) + "1]", 0, sources, true, limits), InputError);
  limits.max_bytes = 10;
  EXPECT_THROW(parse_yaml("a: 1234567890", 0, sources, true, limits), InputError);
}

TEST(YamlDocument, WhatIsNotPartOfASceneIsRefused) {
  EXPECT_EQ(message_of("a: !!str 1\n"),
            "f.yaml:1:4: the tag 'tag:yaml.org,2002:str'; tags are not part of a scene");
  EXPECT_EQ(message_of("[a, b]: 1\n"),
            "f.yaml:1:1: a key that is not plain text, or a bracket that is not closed");
  EXPECT_EQ(message_of("a: &x 1\n*x : 2\n"), "f.yaml:2:1: an alias as a key; keys are plain text");
  EXPECT_EQ(message_of("a: 1\n---\nb: 2\n"),
            "f.yaml:2:1: a second document starts here; a scene is one document");
  EXPECT_EQ(message_of(""), "f.yaml: it is empty");
  EXPECT_EQ(message_of("# only a comment\n"), "f.yaml: it is empty");
  EXPECT_EQ(message_of("a: [1, 2\n").substr(0, 22), "f.yaml:2:1: not YAML: ");
  EXPECT_EQ(message_of("a: 1\n\tb: 2\n").substr(0, 22), "f.yaml:2:1: not YAML: ");
}

TEST(YamlDocument, OtherEncodingsAreRefusedWithTheReason) {
  using namespace std::string_literals;
  EXPECT_EQ(message_of("a: x\0y\n"s), "f.yaml:1:5: a NUL byte; the file must be text in UTF-8");
  EXPECT_EQ(message_of("a: 1\nb: \xff\xfe\x80\n"),
            "f.yaml:2:4: the bytes '\\xff' are not UTF-8; save the file as UTF-8");
  EXPECT_EQ(message_of("\xff\xfe"s + "a\0:\0"s),
            "f.yaml: the file is UTF-16, must be UTF-8; save it as UTF-8");
  EXPECT_EQ(message_of("a\0:\0 \0001\0"s), "f.yaml: the file is UTF-16, must be UTF-8; save it as UTF-8");
  EXPECT_EQ(message_of("\xfe\xff\0a"s), "f.yaml: the file is UTF-16, must be UTF-8; save it as UTF-8");
  EXPECT_EQ(message_of("\xff\xfe\0\0a\0\0\0"s),
            "f.yaml: the file is UTF-32, must be UTF-8; save it as UTF-8");
}

class TextFile : public testing::Test {
 protected:
  // Tests of one suite may run at the same time.
  TextFile()
      : path_(std::filesystem::path(testing::TempDir()) /
              ("rigor_text_file_" + std::to_string(::getpid()) + ".txt")) {}
  ~TextFile() override { std::filesystem::remove(path_); }
  void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
  std::string message(const std::filesystem::path& path) const {
    try {
      read_text_file(path, 20);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  std::filesystem::path path_;
};

TEST_F(TextFile, ByteOrderMarkIsLeftOut) {
  write("\xEF\xBB\xBFname: ü\n");
  EXPECT_EQ(read_text_file(path_, 20), "name: ü\n");
}

TEST_F(TextFile, EmptyFileIsEmptyText) {
  write("");
  EXPECT_EQ(read_text_file(path_, 20), "");
}

TEST_F(TextFile, WhatIsNoFileIsRefused) {
  EXPECT_EQ(message("no/such/file"), "no/such/file: there is no such file");
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(message(folder), folder + ": it is a directory, not a file");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: it is not a regular file");
  write("a text of more than twenty bytes");
  EXPECT_EQ(message(path_), path_.string() + ": the file has 32 bytes, must be at most 20");
}

}  // namespace
}  // namespace rigor::yaml_document_test
