package org.u2sa.interfaces.configuration;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * The configuration of one service in its own XML file (thesis 3.2.1.1, 4.5.1.2, 4.5.3):
 *
 * <pre>{@code
 * <configuration>
 *   <variable name="COMMUNICATION MANAGER IP" type="string" value="localhost"/>
 *   <variable name="BANK LIMIT" type="double" value="30" unit="deg" min="0" max="60"/>
 * </configuration>
 * }</pre>
 *
 * <p>The file is read once. A change rewrites the one value in the text that the file then has: its
 * comments, its order and what others changed meanwhile stay. Several variables change together or
 * not at all; the audit log beside the file says who changed what, and a change can be taken back.
 * Any number of processes and threads may write.
 */
public final class XmlConfiguration implements Configurator {
  private final Optional<Path> file;
  private final LiveValues values;
  private final ConfigurationChanges changes;

  private XmlConfiguration(
      String origin,
      Optional<Path> file,
      Optional<Path> copy,
      Map<String, FileVariable> stated,
      Optional<ConfigurationFile> content) {
    this.file = file;
    values = new LiveValues(new ConfigurationValues(origin, file.isPresent(), stated));
    changes = new ConfigurationChanges(values, file, copy);
    changes.begin(content);
  }

  private XmlConfiguration(XmlConfiguration predecessor) {
    file = predecessor.file;
    values = predecessor.values.forSuccessor();
    changes = predecessor.changes.forSuccessor(values);
  }

  /**
   * Reads a configuration file.
   *
   * @throws ConfigurationException if it is missing, unreadable or not such a file; names file,
   *     line, variable, value and what was expected
   */
  public static XmlConfiguration load(Path file) {
    ConfigurationFile content = ConfigurationFile.read(file);
    return new XmlConfiguration(
        file.toString(),
        Optional.of(file),
        Optional.empty(),
        content.variables(),
        Optional.of(content));
  }

  /**
   * Reads a configuration file that is to stay as it is: changes go to a copy, which is made at the
   * first change. A copy that exists is read in place of the file.
   *
   * @throws ConfigurationException like {@link #load(Path)}
   */
  public static XmlConfiguration load(Path file, Path copy) {
    ConfigurationFile content = ConfigurationFile.read(Files.exists(copy) ? copy : file);
    return new XmlConfiguration(
        file.toString(),
        Optional.of(file),
        Optional.of(copy),
        content.variables(),
        Optional.of(content));
  }

  /**
   * A configuration without a file: changes last as long as the object.
   *
   * @param name how messages name it
   * @param values Integer, Double, Boolean or String by variable, in the declared units
   * @throws IllegalArgumentException if a value is of another class
   */
  public static XmlConfiguration inMemory(String name, Map<String, ?> values) {
    Map<String, FileVariable> stated = new LinkedHashMap<>();
    values.forEach(
        (variable, value) -> stated.put(variable, FileVariable.inMemory(name, variable, value)));
    return new XmlConfiguration(name, Optional.empty(), Optional.empty(), stated, Optional.empty());
  }

  /**
   * Sets a variable for as long as this object lives, whatever the file says, and leaves the file
   * alone. To be called before the variable is declared.
   *
   * @param value Integer, Double, Boolean or String, in the declared unit
   * @throws IllegalArgumentException if the value is of another class
   */
  public void override(String variableName, Object value) {
    values.update(all -> all.override(variableName, value));
  }

  /** The variables that were {@linkplain #override overridden}, with their values. */
  public Map<String, Object> overrides() {
    return values.get(ConfigurationValues::overrides);
  }

  /** Where the configuration stands; empty if it has no file. */
  public Optional<Path> file() {
    return file;
  }

  /**
   * This configuration, as it is now, for a service of another class that takes the place of the
   * present one: what only the present one declares need not be declared again.
   */
  public XmlConfiguration forSuccessor() {
    return new XmlConfiguration(this);
  }

  /** Lets variables of the file be there though nobody declares them. */
  public void tolerate(Collection<String> variableNames) {
    values.update(all -> all.tolerate(variableNames));
  }

  /**
   * The variables that a successor need not declare: all that were declared or tolerated so far.
   */
  public Set<String> tolerated() {
    return values.get(ConfigurationValues::tolerated);
  }

  /** Variables of the file that are tolerated and that nobody declares: they have no effect. */
  public List<String> withoutEffect() {
    return values.get(ConfigurationValues::withoutEffect);
  }

  /**
   * The file that a variable names: a relative path is relative to the configuration file, so that
   * a system runs from any working directory; without a file, to the working directory.
   */
  public Path resolve(String path) {
    return file.map(own -> own.resolveSibling(path).normalize()).orElseGet(() -> Paths.get(path));
  }

  /** The file, or the name of a configuration without one. */
  public String origin() {
    return values.origin();
  }

  @Override
  public Object getVariable(String variableName) {
    return values.get(all -> all.value(variableName));
  }

  @Override
  public <T> T getVariable(VariableDeclaration<T> variable) {
    return values.get(all -> all.declare(variable));
  }

  @Override
  public <T> Settings<T> settings(Class<T> record, String prefix) {
    return new Settings<>(values, RecordBinding.of(record, prefix));
  }

  /**
   * Refuses variables of the file that no service declared: most are misspelt.
   *
   * @throws ConfigurationException naming the first of them and the nearest declared name
   */
  public void refuseUndeclared() {
    values.update(ConfigurationValues::refuseUndeclared);
  }

  /** What has been declared so far, in that order; the list is the caller's own. */
  public List<VariableDeclaration<?>> declared() {
    return values.get(ConfigurationValues::declared);
  }

  @Override
  public boolean setVariable(String variableName, Object value) {
    return !change(variableName, value).isPresent();
  }

  /**
   * {@link #setVariable} that says why not.
   *
   * @return empty if the variable has the new value, in memory and on file; otherwise the reason
   *     for the log, and the old value stays
   */
  public Optional<String> change(String variableName, Object value) {
    return change(
            Collections.singletonMap(variableName, value),
            OptionalLong.empty(),
            ChangeOrigin.here(),
            ConfigurationCheck.NONE)
        .refusal();
  }

  /**
   * Changes several variables at once, in memory and on file: all of them or none.
   *
   * @param wanted values of the variables' types, or their texts, in the declared units
   * @param seen the {@link #revision} that the author relies on: if it is another one by now,
   *     nothing is changed; empty: the last one wins
   * @param check judges the values together, before anything is written
   */
  public ConfigurationOutcome change(
      Map<String, ?> wanted, OptionalLong seen, ChangeOrigin by, ConfigurationCheck check) {
    return write(wanted, seen, by, check).takeEffect();
  }

  /**
   * The part of {@link #change(Map, OptionalLong, ChangeOrigin, ConfigurationCheck)} that waits for
   * the disk and for other writers: up to some seconds. What it has written is not in memory yet.
   */
  public WrittenChange write(
      Map<String, ?> wanted, OptionalLong seen, ChangeOrigin by, ConfigurationCheck check) {
    return changes.change(wanted, seen, by, check);
  }

  /** The refusal of a change that is not even looked at; the audit log does not tell of it. */
  public WrittenChange refuse(String reason) {
    ConfigurationOutcome outcome =
        new ConfigurationOutcome(Optional.of(reason), List.of(), Set.of(), revision());
    return new WrittenChange(outcome, () -> {});
  }

  /**
   * Takes the newest change back that was not taken back yet; the next undo takes back the one
   * before it. The audit log remembers some hundred, whichever process made them.
   *
   * @param check judges the values together, before anything is written
   */
  public ConfigurationOutcome undo(ChangeOrigin by, ConfigurationCheck check) {
    return writeUndo(by, check).takeEffect();
  }

  /** The part of {@link #undo} that waits for the disk, as {@link #write}. */
  public WrittenChange writeUndo(ChangeOrigin by, ConfigurationCheck check) {
    return changes.undo(by, check);
  }

  /** Counts the changes of the configuration, as far as this object has seen them. */
  public long revision() {
    return changes.revision();
  }

  @Override
  public ArrayList<Map.Entry<String, Object>> enumerateFields() {
    return values.get(ConfigurationValues::enumerated);
  }

  /** Every variable with type, value, unit, limits and meaning, for a configuration response. */
  public List<ConfigurationVariable> describe() {
    return values.get(ConfigurationValues::described);
  }
}
