package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** What the newest lines of an audit log say: how the configuration came to be as it is. */
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
          // A refused change tells the revision only.
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

  /** Counts the changes, from 0. */
  long revision() {
    return revision;
  }

  /** The newest change that was not taken back yet; empty if none is remembered. */
  Optional<AuditEntry> undoable() {
    return undoable.isEmpty() ? Optional.empty() : Optional.of(undoable.get(undoable.size() - 1));
  }

  /** The newest change or undo that stands; empty if none is remembered. */
  Optional<AuditEntry> newest() {
    return standing.isEmpty() ? Optional.empty() : Optional.of(standing.get(standing.size() - 1));
  }

  /** Who changed what after a revision, for a message; empty text if nothing is remembered. */
  String since(long seen) {
    return standing.stream()
        .filter(entry -> entry.revision() > seen)
        .map(AuditEntry::told)
        .collect(Collectors.joining("; "));
  }
}
