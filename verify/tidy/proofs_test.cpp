// Derivations in src and claims in verify/proofs: neither is without the other.
#include "tidy/proof_rules.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>

#include "tidy/repository.hpp"

namespace ecods::tidy {
namespace {

const fs::path proofs = root / "verify" / "proofs";

std::map<std::string, std::string> sources() {
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::recursive_directory_iterator(root / "src")) {
        const auto ending = entry.path().extension();
        if (ending == ".cpp" || ending == ".hpp") {
            texts[fs::relative(entry.path(), root).generic_string()] = read(entry.path());
        }
    }
    return texts;
}

// Returns the files whose derivations no claim proves, by verify/proofs/believed.txt: a path and a reason in each line.
std::map<std::string, std::string> believed() {
    std::map<std::string, std::string> reasons;
    std::istringstream lines{read(proofs / "believed.txt")};
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t colon = line.find(": ");
        EXPECT_NE(colon, std::string::npos) << line;
        if (colon != std::string::npos) reasons[line.substr(0, colon)] = line.substr(colon + 2);
    }
    return reasons;
}

TEST(ProofRules, DerivationsAreFound) {
    for (const char* text : {"// off by 3 u' of it", "// Bound. Let x be", "// Bound, in doubles",
                             "    // Bound: that of", "// Derivation.", "// with v = 2^-23",
                             "inline double side_bound(int a) {", "constexpr double own_bound = 1;"}) {
        EXPECT_EQ(find_derivations(text).size(), 1U) << text;
    }
    for (const char* text : {"// the bound. It", "OverlapBound.", "if (x.is_bound()) {", "const u = 'u';",
                             "// a derivation", "auto at = std::lower_bound(a, b);", "u'"}) {
        EXPECT_TRUE(find_derivations(text).empty()) << text;
    }
    EXPECT_EQ(find_derivations("a\n// u'\n").at(0).line, 2);
}

TEST(ProofRules, ClaimsAreFound) {
    const auto found = find_claims("// Bound.\n// Claim: verify/proofs/a_b.py\n    // Claim: verify/proofs/c2.g\n");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].what, "a_b.py");
    EXPECT_EQ(found[0].line, 2);
    EXPECT_EQ(found[1].what, "c2.g");
    for (const char* text : {"// Claim: a.py", "// Claim: verify/proofs/a.txt", "Claim: verify/proofs/a.py",
                             "// see Claim: verify/proofs/a.py", "// Claim: verify/proofs/a.py is it"}) {
        EXPECT_TRUE(find_claims(text).empty()) << text;
    }
}

TEST(Proofs, EveryDerivationNamesItsClaim) {
    auto open = believed();
    for (const auto& [file, text] : sources()) {
        const auto derivations = find_derivations(text);
        const bool has_claim = !find_claims(text).empty(), is_believed = open.contains(file);
        if (!derivations.empty() && !has_claim && !is_believed) {
            ADD_FAILURE() << file << ":" << derivations[0].line
                          << ": a bound without a claim in verify/proofs: " << derivations[0].what;
        }
        if (is_believed) {
            EXPECT_FALSE(derivations.empty()) << file << " derives no bound; verify/proofs/believed.txt names it";
            EXPECT_FALSE(has_claim) << file << " names a claim; verify/proofs/believed.txt need not name it";
            EXPECT_FALSE(open[file].empty()) << file << " is believed without a reason";
            open.erase(file);
        }
    }
    for (const auto& [file, reason] : open) ADD_FAILURE() << "verify/proofs/believed.txt: there is no " << file;
}

TEST(Proofs, EveryClaimIsNamedAndInTheTable) {
    std::map<std::string, std::set<std::string>> files_of;
    for (const auto& [file, text] : sources()) {
        for (const Finding& claim : find_claims(text)) {
            EXPECT_TRUE(fs::exists(proofs / claim.what)) << file << ":" << claim.line << ": there is no " << claim.what;
            files_of[claim.what].insert(file);
        }
    }
    const std::string table = read(proofs / "README.md");
    for (const auto& entry : fs::directory_iterator(proofs)) {
        const std::string name = entry.path().filename().string(), ending = entry.path().extension().string();
        if ((ending != ".g" && ending != ".py" && ending != ".md") || name == "rounding.py" || name == "README.md")
            continue;
        EXPECT_TRUE(files_of.contains(name)) << "no derivation in src names verify/proofs/" << name;
        EXPECT_NE(table.find("`" + name + "`"), std::string::npos) << "verify/proofs/README.md has no row of " << name;
    }
}

}  // namespace
}  // namespace ecods::tidy
