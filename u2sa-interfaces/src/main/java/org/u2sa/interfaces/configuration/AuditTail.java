package org.u2sa.interfaces.configuration;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The newest entries of an audit log, as far as it was read: the newest changes, and the last
 * refusal. Immutable.
 *
 * @param key what the file system calls the file; null if there is none
 * @param end where the last whole line that was read ends [bytes]
 * @param entries oldest first
 */
record AuditTail(Object key, long end, List<AuditEntry> entries) {
  /** Of a log that is not there. */
  static final AuditTail NONE = new AuditTail(null, 0, List.of());

  private static final int MOST_ENTRIES = 200;

  /** Of a log of which nothing was read yet, from a place in it. */
  static AuditTail of(Object key, long from) {
    return new AuditTail(key, from, List.of());
  }

  /** Whether it tells of the file of that key. File systems without keys have one name a file. */
  boolean isOf(Object otherKey) {
    return end > 0 && Objects.equals(key, otherKey);
  }

  /**
   * This tail and what follows in the file.
   *
   * @param cut whether the first line is half a line, to be passed over
   */
  AuditTail with(byte[] bytes, int length, boolean cut) {
    int whole = length;
    while (whole > 0 && bytes[whole - 1] != '\n') {
      whole--;
    }
    List<AuditEntry> all = new ArrayList<>(entries);
    String[] lines = new String(bytes, 0, whole, StandardCharsets.UTF_8).split("\n");
    for (int i = cut ? 1 : 0; i < lines.length; i++) {
      AuditLine.read(lines[i]).ifPresent(all::add);
    }
    return new AuditTail(key, end + whole, newest(all));
  }

  private static List<AuditEntry> newest(List<AuditEntry> all) {
    List<AuditEntry> kept = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i).outcome() != AuditEntry.Outcome.REFUSED || i == all.size() - 1) {
        kept.add(all.get(i));
      }
    }
    return List.copyOf(kept.subList(Math.max(0, kept.size() - MOST_ENTRIES), kept.size()));
  }
}
