package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.contract.ConfigurationAssignment;

/** Plans and validates a change or undo against the current file. */
final class ChangePlanner {
  private final ConfigurationValues memory;
  private final Optional<ConfigurationFile> file;

  /**
   * @param file current content; empty for a configuration without a file
   */
  ChangePlanner(ConfigurationValues memory, Optional<ConfigurationFile> file) {
    this.memory = memory;
    this.file = file;
  }

  /**
   * @param asSeen whether the change is based on the values in memory
   * @throws ConfigurationException if a change is rejected
   */
  List<PlannedChange> set(Map<String, ?> wanted, boolean asSeen) {
    if (wanted.isEmpty()) {
      throw new ConfigurationException(memory.origin() + ": no variable to change is named");
    }
    List<PlannedChange> plan = new ArrayList<>();
    wanted.forEach((name, value) -> plan.add(set(name, value, asSeen)));
    return plan;
  }

  private PlannedChange set(String name, Object value, boolean asSeen) {
    Object inMemory = memory.value(name);
    Optional<FileVariable> before = before(name);
    if (asSeen && !memory.isOverridden(name)) {
      refuseUnseen(name, before);
    }
    BoundVariable bound = memory.bound(name, before);
    FileVariable after;
    try {
      after = bound.restated(bound.checked(value));
    } catch (IllegalArgumentException e) {
      throw error(name, e);
    }
    Object newValue = memory.bound(name, Optional.of(after)).value();
    boolean stands = before.isPresent() && newValue.equals(valueOf(bound).orElse(null));
    return new PlannedChange(
        name,
        before,
        stands ? before : Optional.of(after),
        stands ? before : Optional.of(after),
        memory.isOverridden(name) ? inMemory : valueOf(bound).orElse(inMemory),
        newValue,
        !stands || !newValue.equals(inMemory));
  }

  private void refuseUnseen(String name, Optional<FileVariable> now) {
    Optional<String> seen = memory.stated(name).map(FileVariable::text);
    if (!now.map(FileVariable::text).equals(seen)) {
      throw new ConfigurationException(
          place(name)
              + String.format(
                  "is %s in the file, not %s as the service read it; to overwrite it, omit the revision",
                  now.map(FileVariable::text).orElse("absent"), seen.orElse("absent")));
    }
  }

  /**
   * @throws ConfigurationException if a variable has changed since the entry, or its old value is
   *     rejected
   */
  List<PlannedChange> undo(AuditEntry entry) {
    List<PlannedChange> plan = new ArrayList<>();
    for (AuditEntry.Value value : entry.values()) {
      plan.add(undo(value, entry.revision()));
    }
    return plan;
  }

  private PlannedChange undo(AuditEntry.Value value, long revision) {
    String name = value.variable();
    Object inMemory = memory.value(name);
    Optional<FileVariable> before = before(name);
    if (!before.map(FileVariable::text).equals(value.textAfter())) {
      throw new ConfigurationException(
          place(name)
              + String.format(
                  "is %s, not %s as revision %s left it: not undone",
                  before.map(FileVariable::text).orElse("absent"),
                  value.textAfter().orElse("absent"),
                  revision));
    }
    Optional<FileVariable> after;
    try {
      after = before.flatMap(now -> value.textBefore().map(now::withText));
    } catch (IllegalArgumentException e) {
      throw error(name, e);
    }
    Optional<FileVariable> override = memory.restored(name, value.before());
    Optional<FileVariable> inForce =
        override.isPresent() ? override : after; // Android 9 has no or()
    Object newValue = memory.bound(name, inForce).value();
    return new PlannedChange(name, before, after, inForce, inMemory, newValue, true);
  }

  /** Whether an accepted change was never written, because power failed. */
  boolean wasLost(AuditEntry accepted) {
    return file.isPresent()
        && accepted.values().stream()
            .filter(value -> !value.textBefore().equals(value.textAfter()))
            .map(
                value ->
                    before(value.variable()).map(FileVariable::text).equals(value.textBefore()))
            .reduce(Boolean::logicalAnd)
            .orElse(false);
  }

  private Optional<FileVariable> before(String name) {
    return file.isPresent() ? file.get().variable(name) : memory.stated(name);
  }

  private static Optional<Object> valueOf(BoundVariable bound) {
    try {
      return Optional.of(bound.value());
    } catch (ConfigurationException e) {
      return Optional.empty(); // the file's current entry is invalid and may be replaced
    }
  }

  private String place(String name) {
    return memory.origin() + ", variable \"" + name + "\": ";
  }

  private ConfigurationException error(String name, IllegalArgumentException e) {
    return new ConfigurationException(place(name) + e.getMessage(), e);
  }

  /**
   * A validated change of a variable, not yet applied.
   *
   * @param before current file entry; empty if absent
   * @param after new file entry; empty to remove it
   * @param inForce entry that the new value is from: the new file entry, or an override
   * @param oldValue in the declared unit
   * @param newValue in the declared unit
   * @param changes false if file and memory already have the new value
   */
  record PlannedChange(
      String name,
      Optional<FileVariable> before,
      Optional<FileVariable> after,
      Optional<FileVariable> inForce,
      Object oldValue,
      Object newValue,
      boolean changes) {

    ConfigurationAssignment told() {
      return new ConfigurationAssignment()
          .variableName(name)
          .value(String.valueOf(newValue))
          .previous(String.valueOf(oldValue));
    }

    AuditEntry.Value audited() {
      return new AuditEntry.Value(
          name,
          Optional.of(String.valueOf(oldValue)),
          String.valueOf(newValue),
          before.map(FileVariable::text),
          after.map(FileVariable::text));
    }

    ConfigurationFile in(ConfigurationFile file) {
      return after.isPresent() ? file.with(after.get()) : file.without(name);
    }
  }

  /** The request as repeated in response and audit log, truncated because it may be anything. */
  static final class RefusedTexts {
    private static final int LONGEST = 200;
    private static final int SHOWN = 16;
    private static final int MAX_VARIABLES = 256;
    private static final int LONGEST_VALUE = 2_000;

    private RefusedTexts() {}

    /**
     * @throws ConfigurationException if there are too many variables, or texts are too long
     */
    static void refuseTooMuch(Map<String, ?> wanted, String origin) {
      if (wanted.size() > MAX_VARIABLES) {
        throw new ConfigurationException(
            String.format(
                "%s: %s variables in one change, expected at most %s",
                origin, wanted.size(), MAX_VARIABLES));
      }
      wanted.forEach(
          (name, value) -> {
            int length = Math.max(name.length(), String.valueOf(value).length());
            if (length > LONGEST_VALUE) {
              throw new ConfigurationException(
                  String.format(
                      "%s, variable \"%s\": %s characters, expected %s at most",
                      origin, shortened(name), length, LONGEST_VALUE));
            }
          });
    }

    /** The first variables with their values, truncated. */
    static Map<String, String> of(Map<String, ?> wanted) {
      Map<String, String> texts = new LinkedHashMap<>();
      for (Map.Entry<String, ?> entry : wanted.entrySet()) {
        if (texts.size() == SHOWN) {
          break;
        }
        texts.put(shortened(entry.getKey()), shortened(String.valueOf(entry.getValue())));
      }
      return texts;
    }

    static List<AuditEntry.Value> audited(Map<String, String> texts) {
      List<AuditEntry.Value> values = new ArrayList<>();
      texts.forEach(
          (name, text) ->
              values.add(
                  new AuditEntry.Value(
                      name, Optional.empty(), text, Optional.empty(), Optional.empty())));
      return values;
    }

    static List<ConfigurationAssignment> answered(Map<String, String> texts) {
      List<ConfigurationAssignment> asked = new ArrayList<>();
      texts.forEach(
          (name, text) -> asked.add(new ConfigurationAssignment().variableName(name).value(text)));
      return asked;
    }

    private static String shortened(String text) {
      return shortened(text, LONGEST);
    }

    static String shortened(String text, int longest) {
      return text.length() <= longest ? text : text.substring(0, longest) + "…";
    }
  }
}
