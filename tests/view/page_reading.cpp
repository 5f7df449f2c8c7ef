#include "view/page_reading.hpp"

#include <zlib.h>

#include <regex>
#include <stdexcept>
#include <vector>

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

std::string decoded_seven_bit_text(const std::string& text, std::size_t size) {
  // The groups of seven bits.
  std::vector<unsigned> groups;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned byte = static_cast<unsigned char>(text[i]);
    if (byte < 128) {
      groups.push_back(byte);
      continue;
    }
    const unsigned code = (byte & 31) << 6 | (static_cast<unsigned char>(text.at(++i)) & 63u);
    groups.push_back(std::string({'\0', '\r', '<'}).at(code / 128 - 1) & 127);
    groups.push_back(code % 128);
  }
  // Bit after bit.
  std::string bytes(size, '\0');
  for (std::size_t bit = 0; bit < 8 * size; ++bit) {
    const unsigned value = groups.at(bit / 7) >> (6 - bit % 7) & 1;
    bytes[bit / 8] = static_cast<char>(static_cast<unsigned char>(bytes[bit / 8]) | value << (7 - bit % 8));
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
    const std::string deflated =
        decoded_seven_bit_text(html.substr(text, end - text), std::stoul(attribute("size")));
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
