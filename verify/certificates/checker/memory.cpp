#include "memory.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace certificate_checker {
namespace {

// Blocks are of so many bytes, or twice that, and so on; larger ones are not kept.
constexpr std::size_t step = 64;
constexpr std::size_t class_count = 8;
struct Block {
    Block* next;
};
std::array<Block*, class_count> kept{};

std::size_t class_of(std::size_t size) {
    return (size - 1) / step;
}

void* checked(void* block) {
    if (block == nullptr) throw std::bad_alloc();
    return block;
}

void* allocate(std::size_t size) {
    const std::size_t c = class_of(size);
    if (c >= class_count) return checked(std::malloc(size));
    if (kept[c] == nullptr) return checked(std::malloc((c + 1) * step));
    return std::exchange(kept[c], kept[c]->next);
}

void give_back(void* block, std::size_t size) {
    const std::size_t c = class_of(size);
    if (c >= class_count) return std::free(block);
    kept[c] = new (block) Block{kept[c]};
}

void* resize(void* block, std::size_t old_size, std::size_t size) {
    const std::size_t c = class_of(size), old_c = class_of(old_size);
    if (c == old_c && c < class_count) return block;
    if (c >= class_count && old_c >= class_count) return checked(std::realloc(block, size));
    void* const other = allocate(size);
    std::memcpy(other, block, std::min(old_size, size));
    give_back(block, old_size);
    return other;
}

}  // namespace

void keep_memory_of_numbers() {
    mp_set_memory_functions(&allocate, &resize, &give_back);
}

}  // namespace certificate_checker
