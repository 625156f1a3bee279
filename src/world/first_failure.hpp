// The error that an update throws when tests of several pairs threw.
#pragma once

#include <exception>
#include <mutex>
#include <utility>

#include "ecods/ids.hpp"

namespace ecods {

// What went wrong first, in the order of the pairs and not of time: which error is thrown depends neither on workers
// nor on history.
class FirstFailure {
  public:
    void keep(const BodyPair& bodies, std::exception_ptr error) {
        const std::lock_guard lock(mutex_);
        if (error_ && bodies > bodies_) return;
        bodies_ = bodies;
        error_ = std::move(error);
    }
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

  private:
    std::mutex mutex_;
    BodyPair bodies_;
    std::exception_ptr error_;
};

}  // namespace ecods
