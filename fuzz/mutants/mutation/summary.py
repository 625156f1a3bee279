"""What a run found out about its checks: how many mutants each caught, and which catch nothing that others do not."""


def lines_of(lists, rows):
    """For each list that was run: its checks, and its survivors."""
    for each in lists:
        known = [(m, rows[m.name]) for m in each.mutants if m.name in rows]
        if not known:
            continue
        yield f"{each.name}.list: {len(known)} mutants"
        complete = [row for _, row in known if row.failed is not None]
        for check in each.checks + each.campaigns:
            first = sum(row.caught == check.name or row.caught.startswith(f"{check.name} (")
                        for m, row in known if check.is_of(m.file))
            line = f"  {check.key}: first to catch {first}"
            if complete:
                failing = [row for row in complete if check.key in row.failed]
                alone = sum(len(row.failed) == 1 for row in failing)
                line += f"; of {len(complete)} that all were asked about it catches {len(failing)}, alone {alone}"
                if not alone:
                    line += ": nothing that others do not catch"
            yield line
        for mutant, row in known:
            if not row.caught:
                yield f"  {mutant.name}: " + (f"changes no answer: {mutant.excuse}" if mutant.excuse else "SURVIVED")
