package org.u2sa.interfaces;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;
import org.u2sa.messages.contract.ConfigurationAssignment;

/**
 * Changes a configuration: all variables of a change or none. In this order, while other writers of
 * the file wait: the file is read anew, everything is checked, the audit log says what is about to
 * be done, the file is replaced, the memory follows. If the power fails between log and file, the
 * next change finds that out and the log says so.
 */
final class ConfigurationChanges {
  private static final int LONGEST_TEXT = 200; // of what is refused, whose author may be anybody

  private final ConfigurationValues memory;
  private final Optional<Path> path;
  private final ChangeJournal journal;
  private long revision;

  ConfigurationChanges(ConfigurationValues memory, Optional<Path> path) {
    this(memory, path, path.isPresent() ? new AuditFile(path.get()) : new MemoryJournal(), 0);
  }

  private ConfigurationChanges(
      ConfigurationValues memory, Optional<Path> path, ChangeJournal journal, long revision) {
    this.memory = memory;
    this.path = path;
    this.journal = journal;
    this.revision = revision;
  }

  /** The changes of a copy of the configuration, which go on where these are. */
  ConfigurationChanges forSuccessor(ConfigurationValues copy) {
    return new ConfigurationChanges(copy, path, journal, revision);
  }

  /** One attempt, while nobody else writes. */
  private interface Attempt {
    ConfigurationOutcome make(ChangeHistory history, Optional<ConfigurationFile> file)
        throws IOException;
  }

  /** Takes note of the revision of the file, which was just read. */
  void begin(Optional<ConfigurationFile> file) {
    try {
      ChangeHistory history = new ChangeHistory(journal.recent());
      revision = history.revision() - (lost(history, file).isPresent() ? 1 : 0);
    } catch (IOException e) {
      revision = 0; // no reason not to start; a change is refused, and the answer says why
    }
  }

  /** Counts the changes that this object knows of. */
  long revision() {
    return revision;
  }

  ConfigurationOutcome change(
      Map<String, ?> wanted, OptionalLong seen, ChangeOrigin by, ConfigurationCheck check) {
    Map<String, String> texts = new LinkedHashMap<>();
    wanted.forEach((name, value) -> texts.put(name, String.valueOf(value)));
    return attempt(
        by,
        texts,
        (history, file) -> {
          if (seen.isPresent() && seen.getAsLong() != history.revision()) {
            throw new ConfigurationException(outdated(seen.getAsLong(), history));
          }
          ChangePlanner planner = new ChangePlanner(memory, file);
          List<PlannedChange> plan = planner.set(wanted, seen.isPresent());
          return make(plan, file, by, OptionalLong.empty(), check);
        });
  }

  ConfigurationOutcome undo(ChangeOrigin by, ConfigurationCheck check) {
    return attempt(
        by,
        Map.of(),
        (history, file) -> {
          AuditEntry last =
              history
                  .undoable()
                  .orElseThrow(
                      () ->
                          new ConfigurationException(
                              memory.origin() + ": no change is remembered that could be undone"));
          List<PlannedChange> plan = new ChangePlanner(memory, file).undo(last);
          return make(plan, file, by, OptionalLong.of(last.revision()), check);
        });
  }

  private ConfigurationOutcome attempt(
      ChangeOrigin by, Map<String, String> wanted, Attempt attempt) {
    try {
      ChangeJournal.Turn turn = journal.take();
      try {
        Optional<ConfigurationFile> file = path.map(ConfigurationFile::read);
        return attempt.make(history(file), file);
      } catch (ConfigurationException e) {
        return refused(by, wanted, e.getMessage());
      } finally {
        turn.close();
      }
    } catch (IOException e) {
      return new ConfigurationOutcome(
          Optional.of(place(wanted.keySet()) + e), asked(wanted), Set.of(), revision);
    }
  }

  private ChangeHistory history(Optional<ConfigurationFile> file) throws IOException {
    ChangeHistory history = new ChangeHistory(journal.recent());
    Optional<AuditEntry> lost = lost(history, file);
    if (lost.isPresent()) {
      journal.append(lost.get().failed("the process ended before it was written"));
      history = new ChangeHistory(journal.recent());
    }
    revision = history.revision();
    return history;
  }

  private Optional<AuditEntry> lost(ChangeHistory history, Optional<ConfigurationFile> file) {
    return history.newest().filter(new ChangePlanner(memory, file)::wasLost);
  }

  private ConfigurationOutcome make(
      List<PlannedChange> plan,
      Optional<ConfigurationFile> file,
      ChangeOrigin by,
      OptionalLong undoes,
      ConfigurationCheck check)
      throws IOException {
    Map<String, Object> proposed = memory.all();
    plan.forEach(change -> proposed.put(change.name(), change.newValue()));
    Optional<String> objection = check.refusal(proposed);
    if (objection.isPresent()) {
      throw new ConfigurationException(memory.origin() + ": " + objection.get());
    }
    List<PlannedChange> changes =
        plan.stream().filter(PlannedChange::changes).collect(Collectors.toList());
    if (!changes.isEmpty()) {
      Optional<ConfigurationFile> after = file.map(now -> edited(now, changes));
      AuditEntry entry =
          new AuditEntry(
              revision + 1,
              by,
              AuditEntry.Outcome.ACCEPTED,
              "",
              undoes,
              changes.stream().map(PlannedChange::audited).collect(Collectors.toList()));
      journal.append(entry);
      write(after, entry);
      changes.forEach(memory::adopt);
      revision++;
    }
    return new ConfigurationOutcome(
        Optional.empty(),
        plan.stream().map(PlannedChange::told).collect(Collectors.toList()),
        changes.stream()
            .map(PlannedChange::name)
            .collect(Collectors.toCollection(LinkedHashSet::new)),
        revision);
  }

  private ConfigurationFile edited(ConfigurationFile file, List<PlannedChange> changes) {
    ConfigurationFile edited = file;
    for (PlannedChange change : changes) {
      try {
        edited = change.in(edited);
      } catch (IllegalArgumentException e) {
        throw new ConfigurationException(
            memory.origin() + ", variable \"" + change.name() + "\": " + e.getMessage(), e);
      }
    }
    return edited;
  }

  private void write(Optional<ConfigurationFile> after, AuditEntry entry) throws IOException {
    if (!after.isPresent()) {
      return;
    }
    try {
      after.get().write();
    } catch (IOException e) {
      try {
        journal.append(entry.failed(e.toString()));
      } catch (IOException second) {
        e.addSuppressed(second); // the next change finds out by the file that nothing came of it
      }
      throw e;
    }
  }

  private ConfigurationOutcome refused(ChangeOrigin by, Map<String, String> wanted, String reason) {
    List<AuditEntry.Value> values = new ArrayList<>();
    wanted.forEach(
        (name, text) ->
            values.add(
                new AuditEntry.Value(
                    shortened(name),
                    Optional.empty(),
                    shortened(text),
                    Optional.empty(),
                    Optional.empty())));
    AuditEntry entry =
        new AuditEntry(
            revision, by, AuditEntry.Outcome.REFUSED, reason, OptionalLong.empty(), values);
    String why = reason;
    try {
      journal.append(entry);
    } catch (IOException e) {
      why += "; nor could that be logged: " + e;
    }
    return new ConfigurationOutcome(Optional.of(why), asked(wanted), Set.of(), revision);
  }

  private String outdated(long seen, ChangeHistory history) {
    String since = history.since(seen);
    return memory.origin()
        + ": is at revision "
        + history.revision()
        + " by now, not "
        + seen
        + (since.isEmpty() ? "" : "; since then " + since)
        + ": nothing was changed";
  }

  /** {@code X.xml, variable "A": cannot be written, the old value stays: }. */
  private String place(Set<String> names) {
    String variables =
        names.stream().map(name -> "\"" + name + "\"").collect(Collectors.joining(", "));
    return memory.origin()
        + (names.isEmpty() ? "" : names.size() == 1 ? ", variable " : ", variables ")
        + variables
        + ": cannot be written, the old "
        + (names.size() == 1 ? "value stays: " : "values stay: ");
  }

  private static List<ConfigurationAssignment> asked(Map<String, String> wanted) {
    List<ConfigurationAssignment> asked = new ArrayList<>();
    wanted.forEach(
        (name, text) -> asked.add(new ConfigurationAssignment().variableName(name).value(text)));
    return asked;
  }

  private static String shortened(String text) {
    return text.length() <= LONGEST_TEXT ? text : text.substring(0, LONGEST_TEXT) + "…";
  }
}
