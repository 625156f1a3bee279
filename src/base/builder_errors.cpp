// Makes the errors that builders throw for bad arguments.
#include <string>

#include "base/make_error.hpp"
#include "base/number_text.hpp"

namespace ecods {

InvalidArgument invalid_size(const std::string& part, double value) {
    return {part + " is " + decimal_text(value) + ", not finite and positive", Argument::size, part, value};
}

InvalidArgument size_not_even(const std::string& part, double value) {
    return {part + " is " + decimal_text(value) + ", and half of it is no double", Argument::size, part, value};
}

InvalidArgument size_too_large(const std::string& part, double value) {
    return {part + " is " + decimal_text(value) + ": a vertex would be infinite", Argument::size, part, value};
}

InvalidArgument invalid_base(double value) {
    return {"base is " + decimal_text(value) + ", not finite and below all heights", Argument::size, "base", value};
}

InvalidArgument invalid_count(const std::string& part, std::size_t count, std::size_t min, std::size_t max) {
    return {part + " is " + std::to_string(count) + ", not from " + std::to_string(min) + " to " + std::to_string(max),
            Argument::count, part, static_cast<double>(count)};
}

InvalidArgument invalid_rows(std::size_t height_count, std::size_t columns) {
    return {std::to_string(height_count) + " heights do not make rows of " + std::to_string(columns) + " columns",
            Argument::count, "columns", static_cast<double>(columns)};
}

InvalidArgument polygon_not_convex(std::size_t index) {
    InvalidArgument error("the polygon turns the other way here, or begins to go around again: it is not convex",
                          Argument::polygon);
    return error.at({}, index);
}

}  // namespace ecods
