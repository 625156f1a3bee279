#include "judge/case_truth.hpp"

#include "judge/text.hpp"

namespace ecods::judge {
namespace {

std::vector<Promise> promises_of(const scenes::KnownTime& time, const std::optional<FirstContact>& contact) {
    if (!time) return {};
    return {{(contact ? contact->time : -1) == *time, "time " + text(*time), text(contact)}};
}

std::string kind_of(const std::optional<FirstContact>& contact) {
    return contact ? written(contact->kind) : "nothing";
}

oracle::Soup soup(const scenes::PosedMesh& body) {
    return {body.mesh->vertices(), body.mesh->triangles(), body.pose};
}

}  // namespace

std::string kind_of(const CastTruth& truth) {
    return kind_of(truth.contact());
}

std::string kind_of(const TurnTruth& truth) {
    return kind_of(truth.contact());
}

std::string kind_of(const HitTruth& truth) {
    return truth.hits().empty() ? "nothing" : written(truth.hits().front().kind);
}

std::string kind_of(const DistanceTruth& truth) {
    return text(truth.closest().kind);
}

std::string kind_of(const ConvexTruth& truth) {
    return truth.kind();
}

std::string kind_of(const SolidTruth& truth) {
    return written(truth.relation());
}

std::vector<Promise> promises_of(const scenes::CastCase& made, const CastTruth& truth) {
    return promises_of(made.time, truth.contact());
}

std::vector<Promise> promises_of(const scenes::MoveCase& made, const CastTruth& truth) {
    return promises_of(made.time, truth.contact());
}

std::vector<Promise> promises_of(const scenes::TurnCase& made, const TurnTruth& truth) {
    return promises_of(made.time, truth.contact());
}

std::vector<Promise> promises_of(const scenes::HitCase& made, const HitTruth& truth) {
    if (!made.known) return {};
    const bool is_kept = !truth.hits().empty() && truth.hits()[0].parameter == made.known->parameter &&
                         truth.hits()[0].feature == made.known->feature;
    return {{is_kept, "parameter " + text(made.known->parameter), kind_of(truth)}};
}

std::vector<Promise> promises_of(const scenes::DistanceCase& made, const DistanceTruth& truth) {
    if (!made.distance) return {};
    return {{*made.distance == truth.distance(), "distance " + text(*made.distance), text(truth.distance())}};
}

std::vector<Promise> promises_of(const scenes::ConvexCase& made, const ConvexTruth& truth) {
    std::vector<Promise> promises;
    if (made.distance) {
        promises.push_back(
            {*made.distance == truth.distance(), "distance " + text(*made.distance), text(truth.distance())});
    }
    if (made.depth) {
        promises.push_back({truth.depth() && *made.depth == truth.depth()->depth, "depth " + text(*made.depth),
                            truth.depth() ? text(*truth.depth()) : "apart"});
    }
    return promises;
}

std::vector<Promise> promises_of(const scenes::SolidCase& made, const SolidTruth& truth) {
    std::vector<Promise> promises;
    if (made.relation) {
        promises.push_back({*made.relation == truth.relation(), written(*made.relation), written(truth.relation())});
    }
    for (const scenes::KnownSide& known : made.points) {
        if (!known.point.allFinite()) continue;
        const Side side = static_cast<Side>(oracle::locate(known.point, soup(made.a)).side);
        promises.push_back({known.side == side, written(known.side), written(side)});
    }
    return promises;
}

}  // namespace ecods::judge
