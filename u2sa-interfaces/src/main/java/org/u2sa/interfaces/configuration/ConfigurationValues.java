package org.u2sa.interfaces.configuration;

import java.util.AbstractMap.SimpleImmutableEntry;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.units.NumberText;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * Variables of a configuration in memory: file entries, declarations, and resulting values. Guarded
 * by the owning {@link LiveValues}.
 */
final class ConfigurationValues {
  private final String origin;
  private final boolean typed; // files state types, which must match; programs may pass 1 for 1.0
  private final Map<String, FileVariable> stated;
  private final Overrides overrides = new Overrides();
  private final Set<String> tolerated = new HashSet<>();
  private final Set<String> readByName = new HashSet<>(); // read by name without a declaration
  private final Map<String, VariableDeclaration<?>> declared = new LinkedHashMap<>();
  private final List<RecordBinding<?>> records = new ArrayList<>();
  private final Map<String, Object> values = new LinkedHashMap<>();

  ConfigurationValues(String origin, boolean typed, Map<String, FileVariable> stated) {
    this.origin = origin;
    this.typed = typed;
    this.stated = new LinkedHashMap<>(stated);
    stated.forEach((name, variable) -> values.put(name, variable.value()));
  }

  /** The file, or the name of a configuration without a file. */
  String origin() {
    return origin;
  }

  void override(String name, Object value) {
    FileVariable statement = FileVariable.inMemory(origin, name, value);
    overrides.put(statement, value);
    stated.put(name, statement);
    values.put(name, statement.value());
  }

  /** Current values of overridden variables, as {@link #override} takes them. */
  Map<String, Object> overrides() {
    return overrides.current(stated, values);
  }

  boolean isOverridden(String name) {
    return overrides.contains(name);
  }

  /**
   * The override to which undoing a change returns: it is in force, or was when the change was
   * made. Empty if the value is that of the file.
   *
   * @param before value before the change, as text
   */
  Optional<FileVariable> restored(String name, Optional<String> before) {
    return overrides
        .statement(name)
        .filter(
            override ->
                override.equals(stated.get(name))
                    || before.equals(
                        Optional.of(String.valueOf(bound(name, Optional.of(override)).value()))));
  }

  /**
   * @throws ConfigurationException if the variable is unknown
   */
  Object value(String name) {
    Object value = values.get(name);
    if (value == null) {
      throw new ConfigurationException(
          String.format(
              "%s, variable \"%s\": not found%s",
              origin, name, NearestNames.didYouMean(name, values.keySet())));
    }
    readByName.add(name);
    return value;
  }

  Map<String, Object> all() {
    return new LinkedHashMap<>(values);
  }

  /** File entry of a variable; empty if absent. */
  Optional<FileVariable> stated(String name) {
    return Optional.ofNullable(stated.get(name));
  }

  ConfigurationException error(String name, String what) {
    return stated(name)
        .map(statement -> statement.error(what))
        .orElseGet(
            () -> new ConfigurationException(origin + ", variable \"" + name + "\": " + what));
  }

  <T> T declare(VariableDeclaration<T> variable) {
    String name = variable.name();
    if (declared.get(name) != variable) {
      FileVariable statement = stated.get(name);
      if (statement != null && (!typed || overrides.contains(name))) {
        statement = overrides.asText(statement.withType(variable.type()), variable.type());
      }
      BoundVariable bound =
          new BoundVariable(origin, name, Optional.of(variable), Optional.ofNullable(statement));
      values.put(name, bound.value());
      declared.put(name, variable);
      if (statement != null) {
        overrides.declared(stated.put(name, statement), statement);
      }
    }
    return variable.cast(values.get(name));
  }

  void declare(RecordBinding<?> binding) {
    binding.declarations().forEach(this::declare);
    records.add(binding);
  }

  /**
   * @throws ConfigurationException if the record rejects the combination
   */
  <T> T bind(RecordBinding<T> binding) {
    try {
      return binding.bind(values);
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(origin + ": " + told(binding, values, e), e);
    }
  }

  /** Reason for which a declared record rejects this combination; empty if none does. */
  Optional<String> refusal(Map<String, Object> proposed) {
    for (RecordBinding<?> binding : records) {
      try {
        binding.bind(proposed);
      } catch (IllegalArgumentException e) {
        return Optional.of(told(binding, proposed, e));
      }
    }
    return Optional.empty();
  }

  /** The rejection, with values and lines of the variables it names, or of all. */
  private String told(
      RecordBinding<?> binding, Map<String, Object> refused, IllegalArgumentException refusal) {
    String why = String.valueOf(refusal.getMessage());
    List<VariableDeclaration<?>> meant = new ArrayList<>(binding.declarations());
    if (meant.stream().anyMatch(variable -> why.contains(variable.name()))) {
      meant.removeIf(variable -> !why.contains(variable.name()));
    }
    List<String> words = new ArrayList<>();
    for (VariableDeclaration<?> variable : meant) {
      FileVariable statement = stated.get(variable.name());
      String value = NumberText.withUnit(refused.get(variable.name()), variable.unit());
      words.add(
          (statement == null ? "" : statement.place().replace(origin + ", ", "") + ": ")
              + String.format("variable \"%s\" is %s", variable.name(), value));
    }
    return why + " (" + String.join("; ", words) + ")";
  }

  List<VariableDeclaration<?>> declared() {
    return new ArrayList<>(declared.values());
  }

  void refuseUndeclared() {
    for (FileVariable variable : stated.values()) {
      if (!isUsed(variable.name()) && !tolerated.contains(variable.name())) {
        throw variable.error(
            "no service declares it" + NearestNames.didYouMean(variable.name(), declared.keySet()));
      }
    }
  }

  private boolean isUsed(String name) {
    return declared.containsKey(name) || readByName.contains(name);
  }

  ConfigurationValues copy() {
    ConfigurationValues copy = new ConfigurationValues(origin, typed, stated);
    copy.overrides.putAll(overrides);
    copy.tolerated.addAll(tolerated);
    copy.readByName.addAll(readByName);
    copy.declared.putAll(declared);
    copy.records.addAll(records);
    copy.values.clear();
    copy.values.putAll(values);
    return copy;
  }

  /** Copy of the entries without declarations. */
  ConfigurationValues forSuccessor() {
    ConfigurationValues copy = new ConfigurationValues(origin, typed, stated);
    copy.overrides.putAll(overrides);
    copy.tolerate(tolerated());
    return copy;
  }

  void tolerate(Collection<String> names) {
    tolerated.addAll(names);
  }

  Set<String> tolerated() {
    Set<String> names = new LinkedHashSet<>(tolerated);
    names.addAll(declared.keySet());
    names.addAll(readByName);
    return names;
  }

  List<String> withoutEffect() {
    List<String> names = new ArrayList<>(stated.keySet());
    names.removeIf(name -> isUsed(name) || !tolerated.contains(name));
    return names;
  }

  BoundVariable bound(String name, Optional<FileVariable> statement) {
    Optional<VariableDeclaration<?>> declaration = Optional.ofNullable(declared.get(name));
    if (!declaration.isPresent() && !statement.isPresent()) {
      throw new ConfigurationException(
          origin + ", variable \"" + name + "\": is no longer in the file");
    }
    return new BoundVariable(origin, name, declaration, statement);
  }

  void adopt(ChangePlanner.PlannedChange change) {
    overrides.replaced(change.name());
    if (change.inForce().isPresent()) {
      stated.put(change.name(), change.inForce().get());
    } else {
      stated.remove(change.name());
    }
    values.put(change.name(), change.newValue());
  }

  ArrayList<Map.Entry<String, Object>> enumerated() {
    ArrayList<Map.Entry<String, Object>> fields = new ArrayList<>();
    values.forEach((name, value) -> fields.add(new SimpleImmutableEntry<>(name, value)));
    return fields;
  }

  List<ConfigurationVariable> described() {
    List<ConfigurationVariable> all = new ArrayList<>();
    values.forEach((name, value) -> all.add(bound(name, stated(name)).described(value)));
    return all;
  }
}
