#pragma once

#include <cstddef>
#include <cstdint>

/// What a fuzzer calls again and again with bytes of its own making. It must return for any bytes: what a reader
/// refuses, it refuses with its own exceptions.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
