package org.u2sa.interfaces.configuration;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** The journal of a configuration without a file, which lasts as long as the object. */
final class MemoryJournal implements ChangeJournal {
  private static final int KEPT = 200;

  private final Deque<AuditEntry> entries = new ArrayDeque<>();

  @Override
  public Turn take() {
    return () -> {};
  }

  @Override
  public List<AuditEntry> recent() {
    return new ArrayList<>(entries);
  }

  @Override
  public void append(AuditEntry entry) {
    entries.add(entry);
    if (entries.size() > KEPT) {
      entries.remove();
    }
  }
}
