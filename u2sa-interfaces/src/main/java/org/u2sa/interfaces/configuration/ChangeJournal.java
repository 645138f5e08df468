package org.u2sa.interfaces.configuration;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** Write-ahead journal of a configuration's changes. */
interface ChangeJournal {
  /** Acquires exclusive access for a change; the caller closes it. */
  Closeable take() throws IOException;

  /** Latest entries, oldest first, including at least the latest accepted one. */
  List<AuditEntry> recent() throws IOException;

  /**
   * @throws IOException if writing fails; the entry is then absent
   */
  void append(AuditEntry entry) throws IOException;

  /** In-memory journal of a configuration without a file. */
  static final class InMemory implements ChangeJournal {
    private static final int KEPT = 200;

    private final Deque<AuditEntry> entries = new ArrayDeque<>();

    @Override
    public Closeable take() {
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
}
