package org.u2sa.interfaces.configuration;

import java.util.Optional;
import org.u2sa.messages.contract.ConfigurationAssignment;

/**
 * What is to become of one variable; checked, not yet done.
 *
 * @param name of the variable
 * @param before the file's statement; empty if it has none
 * @param after what the file is to state; empty if nothing any longer
 * @param oldValue in the declared unit
 * @param newValue in the declared unit
 * @param changes false if file and memory have the new value already
 */
record PlannedChange(
    String name,
    Optional<FileVariable> before,
    Optional<FileVariable> after,
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

  /** {@code file} after this change. */
  ConfigurationFile in(ConfigurationFile file) {
    return after.isPresent() ? file.with(after.get()) : file.without(name);
  }
}
