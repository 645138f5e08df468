package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** Where the changes of one configuration are written down, before they are made. */
interface ChangeJournal {
  /** The right to change the configuration, which one holder at a time has. */
  interface Turn extends AutoCloseable {
    @Override
    void close() throws IOException;
  }

  /**
   * Waits until nobody else changes the configuration.
   *
   * @throws IOException if that lasts too long or cannot be found out
   */
  Turn take() throws IOException;

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
}
