package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** Recent history of a configuration from its audit log. */
final class ChangeHistory {
  private final List<AuditEntry> standing = new ArrayList<>();
  private final List<AuditEntry> undoable = new ArrayList<>();
  private long revision;

  ChangeHistory(List<AuditEntry> entries) {
    for (AuditEntry entry : entries) {
      switch (entry.outcome()) {
        case ACCEPTED -> standing.add(entry);
        case FAILED -> standing.removeIf(failed -> failed.revision() == entry.revision());
        default -> {
          // A rejected change only provides the revision.
        }
      }
      revision =
          entry.outcome() == AuditEntry.Outcome.FAILED ? entry.revision() - 1 : entry.revision();
    }
    for (AuditEntry entry : standing) {
      if (entry.undoes().isPresent()) {
        long undone = entry.undoes().getAsLong();
        undoable.removeIf(change -> change.revision() == undone);
      } else {
        undoable.add(entry);
      }
    }
  }

  long revision() {
    return revision;
  }

  /** Latest change not undone yet; empty if none is known. */
  Optional<AuditEntry> undoable() {
    return undoable.isEmpty() ? Optional.empty() : Optional.of(undoable.get(undoable.size() - 1));
  }

  /** Latest effective change or undo; empty if none is known. */
  Optional<AuditEntry> newest() {
    return standing.isEmpty() ? Optional.empty() : Optional.of(standing.get(standing.size() - 1));
  }

  /** Summary of later changes, for a message; empty if none is known. */
  String since(long seen) {
    return standing.stream()
        .filter(entry -> entry.revision() > seen)
        .map(AuditEntry::told)
        .collect(Collectors.joining("; "));
  }
}
