// A call on a thread of its own, whose memories no question has used: what it needs is allocated again each time.
#pragma once

#include <exception>
#include <thread>

namespace ecods::allocation {

// Calls the function on a new thread, and waits for it. Throws what it throws.
template <class Function>
void in_a_new_thread(const Function& call) {
    std::exception_ptr thrown;
    std::thread thread([&]() noexcept {
        try {
            call();
        } catch (...) {
            thrown = std::current_exception();
        }
    });
    thread.join();
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace ecods::allocation
