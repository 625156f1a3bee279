// A locale in which numbers have decimal commas and points between digits, for the program as a whole.
#pragma once

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <string>

namespace ecods::scenes {

struct CommaPunct : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
};

// In C++ always; in C with a locale that is made in the folder, if localedef is there to make it.
class CommaLocale {
  public:
    explicit CommaLocale(const std::filesystem::path& folder)
        : old_(std::locale::global(std::locale(std::locale::classic(), new CommaPunct))) {
        std::ofstream(folder / "comma.src") << "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\n"
                                               "END LC_NUMERIC\n";
        // It complains of the categories that are not there, and makes the locale.
        const std::string command = "cd " + folder.string() +
                                    " && localedef --no-archive -c -f ANSI_X3.4-1968 -i ./comma.src ./comma "
                                    ">localedef.txt 2>&1";
        const int status = std::system(command.c_str());
        setenv("LOCPATH", folder.c_str(), 1);
        is_set_in_c_ = status >= 0 && std::setlocale(LC_NUMERIC, "comma") != nullptr;
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;
    ~CommaLocale() {
        std::setlocale(LC_NUMERIC, "C");
        unsetenv("LOCPATH");
        std::locale::global(old_);
    }

    bool is_set_in_c() const noexcept { return is_set_in_c_; }

  private:
    std::locale old_;
    bool is_set_in_c_ = false;
};

}  // namespace ecods::scenes
