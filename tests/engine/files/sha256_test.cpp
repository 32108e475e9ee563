// The examples of FIPS 180-4 and its test vectors, and messages about as long as one block and two.
#include "lober/curve/files.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "curve_testing.hpp"

namespace lober {
using namespace detail;
namespace {

void expect_digest(std::string_view message, std::string_view digest) {
  EXPECT_EQ(sha256(test::bytes_of(message)), digest);
  const std::string path =
      (std::filesystem::temp_directory_path() / ("lober-hashed-" + std::to_string(::getpid()))).string();
  std::ofstream(path, std::ios::binary) << message;
  EXPECT_EQ(sha256_of_file(path), digest);
  std::filesystem::remove(path);
}

TEST(Sha256, KnownVectors) {
  expect_digest("", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  expect_digest("abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  expect_digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
                "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  expect_digest(std::string(1000000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileLongerThanAPieceAndOfNone) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("lober-hashed-" + std::to_string(::getpid()))).string();
  std::string content;
  for (int k = 0; content.size() < 2'500'000; ++k) content += std::to_string(k) + "\n";
  std::ofstream(path, std::ios::binary) << content;
  EXPECT_EQ(sha256_of_file(path), sha256(test::bytes_of(content)));
  std::filesystem::remove(path);
  EXPECT_THROW((void)sha256_of_file(path), DataError);
}

// By sha256sum of GNU coreutils.
TEST(Sha256, AboutTheLengthOfABlock) {
  expect_digest(std::string(55, 'a'), "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
  expect_digest(std::string(56, 'a'), "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a");
  expect_digest(std::string(63, 'a'), "7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34");
  expect_digest(std::string(64, 'a'), "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
  expect_digest(std::string(65, 'a'), "635361c48bb9eab14198e76ea8ab7f1a41685d6ad62aa9146d301d4f17eb0ae0");
  expect_digest(std::string(119, 'a'), "31eba51c313a5c08226adf18d4a359cfdfd8d2e816b13f4af952f7ea6584dcfb");
  expect_digest(std::string(120, 'a'), "2f3d335432c70b580af0e8e1b3674a7c020d683aa5f73aaaedfdc55af904c21c");
  expect_digest(std::string(128, 'a'), "6836cf13bac400e9105071cd6af47084dfacad4e5e302c94bfed24e013afb73e");
}

}  // namespace
}  // namespace lober
