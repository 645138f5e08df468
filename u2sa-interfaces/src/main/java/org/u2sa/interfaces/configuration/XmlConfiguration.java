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
 * <p>The file is read once. A change edits only the value in the current file text, preserving
 * comments, order and concurrent changes. Several variables change atomically; the audit log in the
 * same folder records who changed what, and changes can be undone. Any number of processes and
 * threads may write.
 */
public final class XmlConfiguration implements Configurator {
  private final Optional<Path> file;
  private final Optional<Path> copy; // changed instead of the file; may not exist yet
  private final Map<String, Path> relocated = new LinkedHashMap<>(); // set before it is shared
  private final LiveValues values;
  private final ConfigurationChanges changes;

  private XmlConfiguration(
      String origin,
      Optional<Path> file,
      Optional<Path> copy,
      Map<String, FileVariable> stated,
      Optional<ConfigurationFile> content) {
    this.file = file;
    this.copy = copy;
    values = new LiveValues(new ConfigurationValues(origin, file.isPresent(), stated));
    changes = new ConfigurationChanges(values, file, copy);
    changes.begin(content);
  }

  private XmlConfiguration(XmlConfiguration predecessor) {
    file = predecessor.file;
    copy = predecessor.copy;
    relocated.putAll(predecessor.relocated);
    values = predecessor.values.forSuccessor();
    changes = predecessor.changes.forSuccessor(values);
  }

  /**
   * Reads a configuration file.
   *
   * @throws ConfigurationException if it is missing or invalid; names file, line, variable, value
   *     and expectation
   */
  public static XmlConfiguration load(Path file) {
    return load(file, Optional.empty(), ConfigurationFile.read(file));
  }

  /**
   * Reads a file that must not be modified, or its copy if that exists: changes go to the copy.
   *
   * @throws ConfigurationException like {@link #load(Path)}
   */
  public static XmlConfiguration load(Path file, Path copy) {
    return load(file, Optional.of(copy), ConfigurationFile.read(Files.exists(copy) ? copy : file));
  }

  private static XmlConfiguration load(Path file, Optional<Path> copy, ConfigurationFile content) {
    return new XmlConfiguration(
        file.toString(), Optional.of(file), copy, content.variables(), Optional.of(content));
  }

  /**
   * Creates a configuration without a file.
   *
   * @param name used in messages
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
   * Overrides a variable for the lifetime of this object, before it is declared; the file is not
   * changed.
   *
   * @param value Integer, Double, Boolean, String or {@link InferredValue}, in the declared unit
   * @throws IllegalArgumentException if the value is of another class
   */
  public void override(String variableName, Object value) {
    values.update(all -> all.override(variableName, value));
  }

  public Map<String, Object> overrides() {
    return values.get(ConfigurationValues::overrides);
  }

  /** Makes {@link #resolve} return another file for a path, before the first service uses it. */
  public void relocate(String path, Path to) {
    relocated.put(path, to);
  }

  /** The file; empty for a configuration in memory. */
  public Optional<Path> file() {
    return file;
  }

  /** Copy that changes go to instead of the file; it exists after the first change. */
  public Optional<Path> copy() {
    return copy;
  }

  /** Whether changes survive a restart: without a file or a copy they are in memory only. */
  public boolean isLasting() {
    return file.isPresent() || copy.isPresent();
  }

  /** Copy for a successor service of another class, which need not declare the same variables. */
  public XmlConfiguration forSuccessor() {
    return new XmlConfiguration(this);
  }

  /** Tolerates variables in the file that are not declared. */
  public void tolerate(Collection<String> variableNames) {
    values.update(all -> all.tolerate(variableNames));
  }

  /** Variables that a successor need not declare: all declared or tolerated so far. */
  public Set<String> tolerated() {
    return values.get(ConfigurationValues::tolerated);
  }

  /** Tolerated variables of the file that are not declared. */
  public List<String> withoutEffect() {
    return values.get(ConfigurationValues::withoutEffect);
  }

  /**
   * Resolves a path relative to the configuration file, or to the working directory without a file.
   */
  public Path resolve(String path) {
    if (relocated.containsKey(path)) {
      return relocated.get(path);
    }
    return file.map(own -> own.resolveSibling(path).normalize()).orElseGet(() -> Paths.get(path));
  }

  /**
   * File that a text variable names, see {@link #resolve}.
   *
   * @throws ConfigurationException if there is no such file; names the variable's file and line
   */
  public Path namedFile(String variableName) {
    String value = (String) getVariable(variableName);
    Path named = resolve(value);
    if (!Files.exists(named)) {
      String what = String.format("\"%s\": there is no file %s", value, named);
      throw values.get(all -> all.error(variableName, what));
    }
    return named;
  }

  /** The file, or the name of a configuration without a file. */
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
   * @throws ConfigurationException if the file has an undeclared variable, usually misspelt: names
   *     the first one and the nearest declared name
   */
  public void refuseUndeclared() {
    values.update(ConfigurationValues::refuseUndeclared);
  }

  /** Declarations so far, in order. */
  public List<VariableDeclaration<?>> declared() {
    return values.get(ConfigurationValues::declared);
  }

  @Override
  public boolean setVariable(String variableName, Object value) {
    return !change(variableName, value).isPresent();
  }

  /** {@link #setVariable}, with the reason for a refusal; empty if the variable was set. */
  public Optional<String> change(String variableName, Object value) {
    return change(
            Collections.singletonMap(variableName, value),
            OptionalLong.empty(),
            ChangeOrigin.here(),
            ConfigurationCheck.NONE)
        .refusal();
  }

  /**
   * Changes several variables atomically, in memory and file.
   *
   * @param wanted values of the variables' types, or their texts, in the declared units
   * @param seen {@link #revision} on which the change relies: if outdated, nothing is changed;
   *     empty if the last writer wins
   * @param check validates the combination before anything is written
   */
  public ConfigurationOutcome change(
      Map<String, ?> wanted, OptionalLong seen, ChangeOrigin by, ConfigurationCheck check) {
    return write(wanted, seen, by, check).takeEffect();
  }

  /**
   * The blocking part of {@link #change(Map, OptionalLong, ChangeOrigin, ConfigurationCheck)},
   * which waits for disk and other writers, up to seconds. Nothing is in memory yet.
   */
  public WrittenChange write(
      Map<String, ?> wanted, OptionalLong seen, ChangeOrigin by, ConfigurationCheck check) {
    return changes.change(wanted, seen, by, check);
  }

  /** Rejects a change unread and without an entry in the audit log. */
  public WrittenChange refuse(String reason) {
    ConfigurationOutcome outcome =
        new ConfigurationOutcome(Optional.of(reason), List.of(), Set.of(), revision());
    return new WrittenChange(outcome, () -> {});
  }

  /**
   * Undoes the latest change not undone yet, by any process; the audit log keeps about a hundred.
   *
   * @param check validates the combination before anything is written
   */
  public ConfigurationOutcome undo(ChangeOrigin by, ConfigurationCheck check) {
    return writeUndo(by, check).takeEffect();
  }

  /** The blocking part of {@link #undo}; see {@link #write}. */
  public WrittenChange writeUndo(ChangeOrigin by, ConfigurationCheck check) {
    return changes.undo(by, check);
  }

  /** Latest revision seen by this object. */
  public long revision() {
    return changes.revision();
  }

  @Override
  public ArrayList<Map.Entry<String, Object>> enumerateFields() {
    return values.get(ConfigurationValues::enumerated);
  }

  /** All variables with type, value, unit, limits and description. */
  public List<ConfigurationVariable> describe() {
    return values.get(ConfigurationValues::described);
  }
}
