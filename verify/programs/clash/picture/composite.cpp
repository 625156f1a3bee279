#include "programs/clash/picture/composite.hpp"

#include <algorithm>
#include <optional>

namespace ecods::clash {
namespace {

constexpr double veil = 0.36;           // opacity of a surface that a contact is seen through
constexpr double context_share = 0.22;  // of other parts' shades in what is seen of them
constexpr double thin = 0.02;           // in samples: regions that are thinner along the line of sight are not painted
constexpr std::size_t stripe_width = 16;  // in samples

bool is_part(const Fragment& fragment) {
    return fragment.layer <= Layer::second;
}

Rgb shaded(const Rgb& color, const Fragment& fragment) {
    // The light comes from above the eye, to its left: -{90, 141, 195} is of length 257. In integers: this is done for
    // every sample.
    const int cosine = -90 * fragment.normal[0] - 141 * fragment.normal[1] - 195 * fragment.normal[2];
    const int light = 635 + 430 * std::max(0, cosine) / (127 * 257);  // of 1024
    Rgb result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = static_cast<std::uint8_t>(std::min(color[k] * light / 1024, 255));
    return result;
}

const Rgb& color_of(const Fragment& fragment) {
    return fragment.layer == Layer::first ? first_color : second_color;
}

Surface surface_of(const Fragment& fragment, Surface::Kind kind) {
    return {kind, fragment.normal, static_cast<float>(fragment.depth)};
}

// The depth at which the next of the parts' surfaces after i is.
std::optional<double> next_part_depth(std::span<const Fragment> fragments, std::size_t i) {
    for (std::size_t k = i + 1; k < fragments.size(); ++k) {
        if (is_part(fragments[k])) return fragments[k].depth;
    }
    return {};
}

// The fragment at which a contact begins: a mark, a surface inside the other part, or where the line of sight is inside
// both parts from then on.
std::optional<std::size_t> find_contact(std::span<const Fragment> fragments, const Look& look) {
    std::array<bool, 2> is_inside{};
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const Fragment& each = fragments[i];
        if (each.layer == Layer::area || each.layer == Layer::line) return i;
        if (!is_part(each)) continue;
        const auto part = static_cast<std::size_t>(each.layer);
        if (!look.is_solid[part] && is_inside[1 - part]) return i;
        is_inside[part] = look.is_solid[part] && !is_inside[part];
        if (!is_inside[0] || !is_inside[1]) continue;
        const std::optional<double> end = next_part_depth(fragments, i);
        if (end && *end - each.depth > thin) return i;
    }
    return {};
}

Rgb contact_paint(const Fragment& fragment, std::size_t column, std::size_t row, const Stripes& stripes) {
    if (fragment.layer == Layer::line) return line_color;
    const std::size_t stripe = (column + row) / stripe_width % 4;
    if (stripes.first && stripe == 0) return shaded(first_color, fragment);
    if (stripes.second && stripe == 2) return shaded(second_color, fragment);
    return shaded(contact_color, fragment);
}

Sample without_contact(std::span<const Fragment> fragments) {
    Sample sample;
    const auto part = std::find_if(fragments.begin(), fragments.end(), is_part);
    if (part != fragments.end()) {
        sample.color = shaded(color_of(*part), *part);
        sample.front = surface_of(*part, part->layer == Layer::first ? Surface::Kind::first : Surface::Kind::second);
        return sample;
    }
    const auto other = std::find_if(fragments.begin(), fragments.end(),
                                    [](const Fragment& each) { return each.layer == Layer::context; });
    if (other == fragments.end()) return sample;
    sample.color = mix(background_color, shaded({190, 194, 200}, *other), context_share);
    sample.front = surface_of(*other, Surface::Kind::context);
    return sample;
}

}  // namespace

Rgb mix(const Rgb& a, const Rgb& b, double share_of_b) {
    const int share = static_cast<int>(share_of_b * 256 + 0.5);
    Rgb result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = static_cast<std::uint8_t>(a[k] + share * (b[k] - a[k]) / 256);
    return result;
}

Sample composite(std::span<const Fragment> fragments, std::size_t column, std::size_t row, const Look& look) {
    const std::optional<std::size_t> contact = find_contact(fragments, look);
    if (!contact) return without_contact(fragments);
    const Fragment& begin = fragments[*contact];
    const bool is_mark = !is_part(begin);
    Sample sample;
    sample.contact = surface_of(begin, begin.layer == Layer::line ? Surface::Kind::mark : Surface::Kind::contact);
    sample.front = sample.contact;
    sample.color = contact_paint(begin, column, row, is_mark ? Stripes{} : look.stripes);
    // From the contact forward. Of a part, the surface where it is entered counts.
    std::array<bool, 2> is_inside{};
    std::array<std::size_t, 2> veils{};
    std::size_t veil_count = 0;
    for (std::size_t i = 0; i < *contact; ++i) {
        if (!is_part(fragments[i])) continue;
        const auto part = static_cast<std::size_t>(fragments[i].layer);
        is_inside[part] = !is_inside[part];
        if (is_inside[part] && fragments[i].depth < begin.depth && veil_count < veils.size()) veils[veil_count++] = i;
    }
    for (std::size_t k = veil_count; k-- > 0;) {
        const Fragment& each = fragments[veils[k]];
        sample.color = mix(sample.color, shaded(color_of(each), each), veil);
        if (k == 0)
            sample.front = surface_of(each, each.layer == Layer::first ? Surface::Kind::first : Surface::Kind::second);
    }
    return sample;
}

}  // namespace ecods::clash
