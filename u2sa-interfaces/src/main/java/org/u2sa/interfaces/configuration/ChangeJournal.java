package org.u2sa.interfaces.configuration;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** Where the changes of one configuration are written down, before they are made. */
interface ChangeJournal {
  /**
   * Waits until nobody else changes the configuration; whoever has the turn closes it.
   *
   * @throws IOException if that lasts too long or cannot be found out
   */
  Closeable take() throws IOException;

  /** The newest entries, oldest first: at least the newest accepted one. */
  List<AuditEntry> recent() throws IOException;

  /**
   * Adds an entry, which outlasts a power cut from then on.
   *
   * @throws IOException if it could not be written; then it is not there
   */
  void append(AuditEntry entry) throws IOException;

  /** The journal of a configuration without a file, which lasts as long as the object. */
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
