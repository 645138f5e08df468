package org.u2sa.interfaces.configuration;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Changes a configuration atomically. While other writers are locked out: the file is re-read,
 * everything is validated, the audit log records the intent, and the file is replaced; memory
 * follows when the {@link WrittenChange} takes effect. If power fails between log and file, the
 * next change detects and logs it.
 *
 * <p>One thread at a time writes. Values in memory belong to {@link LiveValues}, which is never
 * locked during disk access.
 */
final class ConfigurationChanges {
  private final LiveValues live;
  private final Optional<Path> original; // source of the copy; empty if the file itself is changed
  private final Optional<Path> path;
  private final ChangeJournal journal;
  private volatile long revision; // written by one thread at a time

  /**
   * @param file empty if changes stay in memory
   * @param copy changed instead of the file, and created on the first change; empty to change the
   *     file
   */
  ConfigurationChanges(LiveValues live, Optional<Path> file, Optional<Path> copy) {
    this.live = live;
    original = copy.isPresent() ? file : Optional.empty();
    path = copy.isPresent() ? copy : file;
    journal = path.isPresent() ? new AuditFile(path.get()) : new ChangeJournal.InMemory();
  }

  private ConfigurationChanges(LiveValues live, ConfigurationChanges predecessor) {
    this.live = live;
    original = predecessor.original;
    path = predecessor.path;
    journal = predecessor.journal;
    revision = predecessor.revision;
  }

  ConfigurationChanges forSuccessor(LiveValues copy) {
    return new ConfigurationChanges(copy, this);
  }

  private interface Attempt {
    WrittenChange make(
        ConfigurationValues memory, ChangeHistory history, Optional<ConfigurationFile> file)
        throws IOException;
  }

  void begin(Optional<ConfigurationFile> file) {
    try {
      ChangeHistory history = new ChangeHistory(journal.recent());
      boolean lost = lost(live.written(), history, file).isPresent();
      revision = history.revision() - (lost ? 1 : 0);
    } catch (IOException e) {
      revision = 0; // must not prevent startup; a later change is rejected with the reason
    }
  }

  long revision() {
    return revision;
  }

  synchronized WrittenChange change(
      Map<String, ?> wanted, OptionalLong seen, ChangeOrigin by, ConfigurationCheck check) {
    return attempt(
        by,
        ChangePlanner.RefusedTexts.of(wanted),
        (memory, history, file) -> {
          ChangePlanner.RefusedTexts.refuseTooMuch(wanted, live.origin());
          if (seen.isPresent() && seen.getAsLong() != history.revision()) {
            throw new ConfigurationException(outdated(seen.getAsLong(), history));
          }
          List<ChangePlanner.PlannedChange> plan =
              new ChangePlanner(memory, file).set(wanted, seen.isPresent());
          return make(memory, plan, file, by, OptionalLong.empty(), check);
        });
  }

  synchronized WrittenChange undo(ChangeOrigin by, ConfigurationCheck check) {
    return attempt(
        by,
        Map.of(),
        (memory, history, file) -> {
          AuditEntry last =
              history
                  .undoable()
                  .orElseThrow(
                      () ->
                          new ConfigurationException(
                              live.origin() + ": there is no recorded change to undo"));
          List<ChangePlanner.PlannedChange> plan = new ChangePlanner(memory, file).undo(last);
          return make(memory, plan, file, by, OptionalLong.of(last.revision()), check);
        });
  }

  private WrittenChange attempt(ChangeOrigin by, Map<String, String> wanted, Attempt attempt) {
    try {
      copyOriginal();
      Closeable turn = journal.take();
      try {
        Optional<ConfigurationFile> file = path.map(ConfigurationFile::read);
        ConfigurationValues memory = live.written();
        return attempt.make(memory, history(memory, file), file);
      } catch (ConfigurationException e) {
        return refused(by, wanted, e.getMessage());
      } finally {
        turn.close();
      }
    } catch (IOException e) {
      return refusal(place(wanted.keySet()) + e, wanted);
    }
  }

  private void copyOriginal() throws IOException {
    if (original.isPresent() && path.isPresent() && !Files.exists(path.get())) {
      Files.createDirectories(path.get().toAbsolutePath().getParent());
      Files.copy(original.get(), path.get());
    }
  }

  private ChangeHistory history(ConfigurationValues memory, Optional<ConfigurationFile> file)
      throws IOException {
    ChangeHistory history = new ChangeHistory(journal.recent());
    Optional<AuditEntry> lost = lost(memory, history, file);
    if (lost.isPresent()) {
      journal.append(lost.get().failed("the process ended before it was written"));
      history = new ChangeHistory(journal.recent());
    }
    revision = history.revision();
    return history;
  }

  private static Optional<AuditEntry> lost(
      ConfigurationValues memory, ChangeHistory history, Optional<ConfigurationFile> file) {
    return history.newest().filter(new ChangePlanner(memory, file)::wasLost);
  }

  private WrittenChange make(
      ConfigurationValues memory,
      List<ChangePlanner.PlannedChange> plan,
      Optional<ConfigurationFile> file,
      ChangeOrigin by,
      OptionalLong undoes,
      ConfigurationCheck check)
      throws IOException {
    Map<String, Object> proposed = memory.all();
    plan.forEach(change -> proposed.put(change.name(), change.newValue()));
    Optional<String> together = memory.refusal(proposed);
    Optional<String> objection = together.isPresent() ? together : check.refusal(proposed);
    if (objection.isPresent()) {
      throw new ConfigurationException(live.origin() + ": " + objection.get());
    }
    List<ChangePlanner.PlannedChange> changes =
        plan.stream().filter(ChangePlanner.PlannedChange::changes).collect(Collectors.toList());
    if (!changes.isEmpty()) {
      Optional<ConfigurationFile> after = file.map(now -> edited(now, changes));
      AuditEntry entry =
          new AuditEntry(
              revision + 1,
              by,
              AuditEntry.Outcome.ACCEPTED,
              "",
              undoes,
              changes.stream()
                  .map(ChangePlanner.PlannedChange::audited)
                  .collect(Collectors.toList()));
      journal.append(entry);
      write(after, entry);
      live.await(changes);
      revision++;
    }
    ConfigurationOutcome outcome =
        new ConfigurationOutcome(
            Optional.empty(),
            plan.stream().map(ChangePlanner.PlannedChange::told).collect(Collectors.toList()),
            changes.stream()
                .map(ChangePlanner.PlannedChange::name)
                .collect(Collectors.toCollection(LinkedHashSet::new)),
            revision);
    return new WrittenChange(outcome, () -> live.takeEffect(changes));
  }

  private ConfigurationFile edited(
      ConfigurationFile file, List<ChangePlanner.PlannedChange> changes) {
    ConfigurationFile edited = file;
    for (ChangePlanner.PlannedChange change : changes) {
      try {
        edited = change.in(edited);
      } catch (IllegalArgumentException e) {
        throw new ConfigurationException(
            live.origin() + ", variable \"" + change.name() + "\": " + e.getMessage(), e);
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
        e.addSuppressed(second); // the next change detects from the file that it was not written
      }
      throw e;
    }
  }

  private WrittenChange refused(ChangeOrigin by, Map<String, String> wanted, String reason) {
    AuditEntry entry =
        new AuditEntry(
            revision,
            by,
            AuditEntry.Outcome.REFUSED,
            ChangePlanner.RefusedTexts.shortened(reason, 1_000),
            OptionalLong.empty(),
            ChangePlanner.RefusedTexts.audited(wanted));
    String why = reason;
    try {
      journal.append(entry);
    } catch (IOException e) {
      why += "; nor could that be logged: " + e;
    }
    return refusal(why, wanted);
  }

  private WrittenChange refusal(String reason, Map<String, String> wanted) {
    ConfigurationOutcome outcome =
        new ConfigurationOutcome(
            Optional.of(reason), ChangePlanner.RefusedTexts.answered(wanted), Set.of(), revision);
    return new WrittenChange(outcome, () -> {});
  }

  private String outdated(long seen, ChangeHistory history) {
    String since = history.since(seen);
    return String.format(
        "%s: is already at revision %s, not %s%s: no change made",
        live.origin(), history.revision(), seen, since.isEmpty() ? "" : "; since then " + since);
  }

  private String place(Set<String> names) {
    String variables =
        names.stream().map(name -> "\"" + name + "\"").collect(Collectors.joining(", "));
    return live.origin()
        + (names.isEmpty() ? "" : names.size() == 1 ? ", variable " : ", variables ")
        + variables
        + ": cannot be written, the old "
        + (names.size() == 1 ? "value stays: " : "values stay: ");
  }
}
