#include "preshape/base/sha256.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/base");

TEST_CASE("SHA-256: the published test vectors come out") {
  // [FIPS180-4] and NIST's example values.
  CHECK(sha256_hex("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_hex("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256_hex(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("SHA-256: how the bytes are cut into pieces does not matter") {
  const std::string text(1000, 'x');
  for (const std::size_t piece : {1u, 7u, 55u, 56u, 63u, 64u, 65u, 999u}) {
    Sha256 hash;
    for (std::size_t i = 0; i < text.size(); i += piece) hash.update(std::string_view(text).substr(i, piece));
    CHECK(hash.hex() == sha256_hex(text));
  }
}

TEST_CASE("SHA-256: a number is fed lowest byte first") {
  Sha256 hash;
  hash.update_little_endian(0x0807060504030201u);
  CHECK(hash.hex() == sha256_hex("\x01\x02\x03\x04\x05\x06\x07\x08"));
}

TEST_SUITE_END();
