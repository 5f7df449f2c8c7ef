#include "view/page_reading.hpp"

#include <zlib.h>

#include <regex>
#include <stdexcept>

namespace rigor::test {

std::string inflated(const std::string& deflated, std::size_t raw_size) {
  std::string bytes(raw_size, '\0');
  uLongf size = static_cast<uLongf>(raw_size);
  const int result =
      uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                 reinterpret_cast<const Bytef*>(deflated.data()), static_cast<uLong>(deflated.size()));
  if (result != Z_OK || size != raw_size) throw std::runtime_error("not a whole zlib stream");
  return bytes;
}

std::string inflated(const PageBlock& block) {
  return inflated(block.deflated, block.raw_size);
}

std::string decoded_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xff);
  }
  return bytes;
}

std::vector<ReadBlock> blocks_of_page(const std::string& html) {
  std::vector<ReadBlock> blocks;
  const std::string begin = "<script type=\"text/plain\" class=\"rigor-data\" ";
  for (std::size_t at = 0; (at = html.find(begin, at)) != std::string::npos; ++at) {
    const std::size_t text = html.find('>', at) + 1, end = html.find('<', text);
    const std::string tag = html.substr(at, text - at);
    const auto attribute = [&tag](const std::string& name) {
      std::smatch match;
      std::regex_search(tag, match, std::regex("data-" + name + "=\"([^\"]*)\""));
      return match[1].str();
    };
    const std::string deflated = decoded_base64(html.substr(text, end - text));
    const uLong checksum =
        crc32(0, reinterpret_cast<const Bytef*>(deflated.data()), static_cast<uInt>(deflated.size()));
    blocks.push_back({std::stoi(attribute("run")), attribute("kind"),
                      inflated(deflated, std::stoul(attribute("raw"))),
                      deflated.size() == std::stoul(attribute("size")) &&
                          checksum == std::stoul(attribute("crc"), nullptr, 16)});
  }
  return blocks;
}

}  // namespace rigor::test
