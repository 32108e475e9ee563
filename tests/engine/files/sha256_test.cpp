// The examples of FIPS 180-4 and its test vectors, by the instructions of the machine and by portable code.
#include "engine/files/sha256.hpp"
#include "lober/files.hpp"

#include <random>

#include "curve_testing.hpp"

namespace lober {
namespace {

void expect_digest(std::string_view message, std::string_view digest) {
  EXPECT_EQ(sha256(testing::bytes_of(message)), digest);
  EXPECT_EQ(sha256_portable(testing::bytes_of(message)), digest);
}

TEST(Sha256, KnownVectors) {
  expect_digest("", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  expect_digest("abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  expect_digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
                "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  expect_digest(std::string(1000000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, BothImplementationsAgreeForEveryLength) {
  std::mt19937_64 random(3);
  std::string message;
  for (int length = 0; length < 300; ++length) {
    EXPECT_EQ(sha256(testing::bytes_of(message)), sha256_portable(testing::bytes_of(message))) << length;
    message += static_cast<char>(random());
  }
}

}  // namespace
}  // namespace lober
