"""What catches a mutant."""
from . import checks
from .build import DoesNotCompile, Planting
from .lists import Broken
from .rows import DrawnRow, Row

COMPILER = "compiler (static_assert)"
NOT_COMPILED, SURVIVED = "not compiled", "survived"  # what became of a drawn mutant; or the stage that caught it


def try_mutant(build, mutants, mutant, work, commit, asks_all=False):
    """The row of a mutant: the first check of its list that fails, or, if `asks_all`, all of them; and every campaign."""
    digest = mutant.digest(build.root)
    planting = Planting(build, work, mutant.file, mutant.apply(build.root))
    asked = mutants.checks_of(mutant) + mutants.campaigns
    if not any(planting.reads(check.program) for check in asked):
        raise Broken(f"{mutant.name}: nothing that is checked reads {mutant.file}")
    caught, failed, said = "", [], []
    try:
        for check in mutants.checks_of(mutant):
            outcome = planting.run(check)
            if not outcome.passed:
                caught = caught or check.name + checks.failed_test(outcome)
                failed.append(check.key)
                if not asks_all:
                    break
        for campaign in mutants.campaigns:
            outcome = planting.run(campaign)
            said.append("no" if outcome.passed else checks.seen_by(outcome))
            if not outcome.passed:
                caught = caught or campaign.name
                failed.append(campaign.key)
    except DoesNotCompile as error:
        if not error.is_static_assert:
            raise Broken(f"{mutant.name} does not compile:\n{str(error)[:2000]}") from error
        caught, failed, said = COMPILER, [], ["-"] * len(mutants.campaigns)
    return Row(mutant.name, digest, commit, caught, said, failed if asks_all else None)


def try_drawn(build, mutant, asked, work, commit):
    """The row of a mutant that was drawn: the stage of the first of the checks that fails."""
    planting = Planting(build, work, mutant.file, mutant.apply(build.root))
    try:
        for check in asked:
            if planting.reads(check.program) and not planting.run(check).passed:
                return DrawnRow(mutant.name, commit, check.name, check.program)
    except DoesNotCompile:
        return DrawnRow(mutant.name, commit, NOT_COMPILED, "")
    return DrawnRow(mutant.name, commit, SURVIVED, "")
